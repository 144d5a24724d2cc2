// A B-spline curve as a product of matrices: c(t) = T_1(t) T_2(t) … T_d(t) c.
#pragma once

#include "geometry/bspline_curve.hpp"

#include <vector>

namespace knotwork {

/// The matrices T_1 … T_d at t; T_k is k × (k+1), row by row, with the rows
///     (… 0, 1 - w_{k,i}, w_{k,i}, 0 …),  w_{k,i} = (t - t_i) / (t_{i+k} - t_i),  i = s-k+1 … s
/// of the span s of t, right of a knot and left of the end of the domain; c are the d+1 active
/// points s-d … s. Derivatives are c^(j) = d!/(d-j)! T_1 … T_{d-j} T'_{d-j+1} … T'_d c, where T'_k
/// has ∓1 / (t_{i+k} - t_i) in place of 1 - w and w. Any t, continued as the curve. O(d³).
[[nodiscard]] std::vector<std::vector<double>> factorMatrices(const KnotVector& knots, double t);

}  // namespace knotwork
