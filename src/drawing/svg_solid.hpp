// Surfaces as SVG: triangles and the lines on them, what is farther away painted first (M. Newell,
// R. Newell, T. Sancha, A solution to the hidden surface problem, 1972, without cutting).
#pragma once

#include "drawing/svg_shapes.hpp"

#include <span>

namespace knotwork::drawing {

/// Whether a shape is painted among the triangles of its object: those, and the lines on them.
[[nodiscard]] bool belongsToSolid(const Shape& shape) noexcept;

/// Has the shapes of one object that belong to its solid written, in one group. Triangles are
/// positions three by three, shaded by how they face the light, from either side alike. What it is
/// given by reference must outlive the work.
void planSolid(SlicedWork& work, XmlWriter& xml, std::span<const Shape> shapes,
               const PanePicture& picture);

}  // namespace knotwork::drawing
