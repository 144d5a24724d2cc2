// One local patch of a blending surface as a surface by itself.
#pragma once

#include "geometry/surface.hpp"

namespace knotwork {

/// Patch (i, j) over the rectangle where it takes part, posed.
///
/// A plane or a Bézier patch is one piece of a clamped B-spline of its degrees. A sub-surface that
/// is not posed, of a model that is not closed and over all of it, is that model; any other is a
/// blending surface between four copies of it, which is the same surface. OUT_OF_RANGE where the
/// rectangle or the points are beyond the limits of surfaces.
[[nodiscard]] Result<Surface> patchSurface(const BlendingSurface& surface, std::size_t i,
                                           std::size_t j);

}  // namespace knotwork
