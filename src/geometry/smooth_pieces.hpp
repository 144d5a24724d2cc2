// The pieces of a curve on which it is analytic: what quadrature, tessellation and searches for
// extreme points work on, because only there do derivatives say anything about what lies between.
#pragma once

#include "geometry/curve.hpp"

#include <vector>

namespace knotwork {

/// The parts of `part` between the places where a derivative of some order may jump, ascending,
/// none of them empty: between the curve's own knots, and for a blending curve also between the
/// knots of its local curves and where its B-function is not smooth. What is not a B-spline is cut
/// further into pieces of at most 1/32 of the domain, so that a turn is not taken for a point. The
/// part may reach outside the domain. O(pieces log pieces).
[[nodiscard]] std::vector<Interval> smoothPieces(const Curve& curve, const Interval& part);
/// Those of the whole domain.
[[nodiscard]] std::vector<Interval> smoothPieces(const Curve& curve);

}  // namespace knotwork
