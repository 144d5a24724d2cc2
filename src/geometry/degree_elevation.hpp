// Degree elevation: the same curve, written as one of a higher degree.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

namespace knotwork {

/// The same curve of degree d + `by`. Each step by one raises every multiplicity by one, so that the
/// curve is as smooth as it was, and takes the means of the blossom with one argument left out,
///     b_j = 1/(d+1) sum_i c[u_1, …, u_{i-1}, u_{i+1}, …, u_{d+1}],  u = t'_{j+1} … t'_{j+d+1},
/// exactly, as sums with weights that are not negative (L. Ramshaw, Blossoming, 1987). Of an open
/// vector, as many knots are kept outside the domain as the new degree needs. A closed vector keeps
/// its period. O(by · m d³). Refusals: OUT_OF_RANGE `by` (at least 1), TOO_LARGE `by` beyond degree
/// 25 or 100 000 points.
[[nodiscard]] Result<BsplineCurve> elevateDegree(const BsplineCurve& curve, int by);

}  // namespace knotwork
