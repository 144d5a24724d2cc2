// Refinement: more knots, the same curve.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

namespace knotwork {

/// The same curve (within 5e-14 of the size of its points) with the knot t `times` times more:
/// b_i = (1 - a_i) c_{i-1} + a_i c_i, a_i = (t - t_i) / (t_{i+d} - t_i) in d blended points per
/// insertion (W. Boehm, Inserting new knots into B-spline curves, 1980). A closed curve takes any
/// t and wraps it. Weights come out as they must, so that a rational curve does not move either.
/// Refusals: OUT_OF_RANGE `t` (outside the domain, or nearer to a knot than 1e-12 of the domain)
/// and `times` (at least 1); NOT_FINITE `t`; KNOTS_MULTIPLICITY `t` beyond d equal knots;
/// TOO_LARGE `times` beyond 100 000 points.
[[nodiscard]] Result<BsplineCurve> insertKnot(const BsplineCurve& curve, double t, int times);

}  // namespace knotwork
