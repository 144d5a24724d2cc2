// The pieces of a curve on which it is analytic: what quadrature, tessellation and searches for
// extreme points work on, because only there do derivatives say anything about what lies between.
#pragma once

#include "geometry/curve.hpp"

#include <vector>

namespace knotwork {

/// The parts of `part` between the places where a derivative of some order may jump, ascending,
/// none of them empty: between its breakParameters(), and for a blending curve also where between
/// its knots its B-function is not smooth. What is not a spline is cut further into pieces of at
/// most 1/32 of the domain, so that a turn is not taken for a point. The part may reach outside the
/// domain; an empty one is its own piece. O(pieces log pieces).
[[nodiscard]] std::vector<Interval> smoothPieces(const Curve& curve, const Interval& part);
/// Those of the whole domain.
[[nodiscard]] std::vector<Interval> smoothPieces(const Curve& curve);

/// Whether every piece is a polynomial or a quotient of two, of which no sampling misses anything.
[[nodiscard]] bool isPiecewiseRational(const Curve& curve) noexcept;

}  // namespace knotwork
