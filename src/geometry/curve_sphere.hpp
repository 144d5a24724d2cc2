// The smallest sphere around a curve.
#pragma once

#include "geometry/curve.hpp"
#include "geometry/enclosing_sphere.hpp"

namespace knotwork {

/// The smallest sphere around the whole curve, not around samples of it: the sphere of some points
/// of the curve is enlarged by the point that lies farthest from its centre until none lies outside.
/// The curve is inside to 1e-13 of the radius, which is at most 1e-9 of itself larger than the
/// smallest. Ten or so searches for a farthest point. The centre of a plane curve lies in its plane.
[[nodiscard]] Sphere enclosingSphere(const Curve& curve);

}  // namespace knotwork
