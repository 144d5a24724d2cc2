// Control points in homogeneous form, (w x, w y, w z, w): what holds for polynomial curves holds
// for rational ones in this form.
#pragma once

#include "geometry/bspline_curve.hpp"

#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace knotwork {

using Homogeneous = glm::dvec4;

/// w = 1 for a curve without weights.
[[nodiscard]] std::vector<Homogeneous> homogeneousPoints(const BsplineCurve& curve);

/// The curve of these points, with weights where `weighted`. Refusals are those of
/// BsplineCurve::make().
[[nodiscard]] Result<BsplineCurve> fromHomogeneous(KnotVector knots,
                                                   std::span<const Homogeneous> points,
                                                   int dimension, bool weighted);

}  // namespace knotwork
