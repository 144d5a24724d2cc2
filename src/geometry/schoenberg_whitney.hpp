// Whether data determine a spline: the condition of Schoenberg and Whitney.
//
// Least squares at the parameters u has one answer if every basis function i can be given a
// parameter of its own, no two the same, at which it is not zero: t_i < u < t_{i+d+1} but for full
// knots. (I. J. Schoenberg and A. Whitney, On Pólya frequency functions III, 1953; L. L. Schumaker,
// Spline Functions, 4.8.) For a periodic spline it is necessary, and all that is wrong but for
// data that stand in a rare symmetry.
#pragma once

#include "geometry/knot_vector.hpp"
#include "geometry/result.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace knotwork {

/// The first basis function (the first control point) with too little data: one with no parameter
/// at all where it is not zero, if there is one, otherwise the first for which none is left. The
/// parameters lie in the domain and do not decrease. O(m + n).
[[nodiscard]] std::optional<std::size_t> starvedFunction(const KnotVector& knots,
                                                         std::span<const double> parameters);

/// RANK_DEFICIENT `controlPoints[i]`.
[[nodiscard]] Error refuseStarved(std::size_t function);

}  // namespace knotwork
