// How large a scene is, about: for tolerances that are a share of it, and for what a view has to show.
#pragma once

#include "drawing/drawing.hpp"
#include "geometry/enclosing_sphere.hpp"

#include <cstddef>
#include <span>

namespace knotwork::drawing {

// To a box some points of what is placed so; those that are not finite are left out.
void addPoints(Bounds& bounds, std::span<const Vec3> points, const Affine& placement);
/// `samples` ≥ 2 of them, uniform in the parameter with both ends.
void addCurve(Bounds& bounds, const Curve& curve, const Affine& placement, std::size_t samples);
/// The same in each direction.
void addSurface(Bounds& bounds, const Surface& surface, const Affine& placement,
                std::size_t samples);
/// The great circles across the axes, of which there is one in a plane.
void addSphere(Bounds& bounds, const Sphere& sphere, bool inPlane, const Affine& placement);
/// Its square.
void addGraph(Bounds& bounds, const scene::FunctionGraph& graph, const Affine& placement);

/// A box round some points of every object as it stands: never larger than the scene, and seldom
/// much smaller.
[[nodiscard]] Bounds roughBounds(const scene::State& state, const scene::Moment& moment);

/// The longest side of that box, 1 where it has none.
[[nodiscard]] double roughSize(const scene::State& state, const scene::Moment& moment);

}  // namespace knotwork::drawing
