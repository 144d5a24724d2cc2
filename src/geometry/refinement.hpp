// Refinement: more knots, the same curve (within 5e-14 of the size of its points). Weights come out
// as they must, so that a rational curve does not move either.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

#include <vector>

namespace knotwork {

/// The same curve with the knot t `times` times more: b_i = (1 - a_i) c_{i-1} + a_i c_i,
/// a_i = (t - t_i) / (t_{i+d} - t_i) in d blended points per insertion (W. Boehm, Inserting new
/// knots into B-spline curves, 1980). A closed curve takes any t and wraps it. O(n) per insertion.
/// Refusals: OUT_OF_RANGE `t` (outside the domain, or nearer to a knot than 1e-12 of the domain)
/// and `times` (at least 1); NOT_FINITE `t`; KNOTS_MULTIPLICITY `t` beyond d equal knots;
/// TOO_LARGE `times` beyond 100 000 points.
[[nodiscard]] Result<BsplineCurve> insertKnot(const BsplineCurve& curve, double t, int times);

/// The checked vector of a refinement: `refined` is the whole new vector in the form of the old one
/// (one period where closed), with every old knot at least as often as before, and new ones, up to
/// d+1 equal, in the domain. At the seam of a closed vector it does not matter at which end of the
/// period a knot is repeated. O(n + m). Refusals: KNOTS_COUNT and TOO_LARGE `knots` (fewer than
/// before, more than for 100 000 points); `knots[i]` KNOTS_MULTIPLICITY where an old knot is missing
/// (the place where it should stand) and OUT_OF_RANGE for a new one outside the domain; and those
/// of KnotVector::make().
[[nodiscard]] Result<KnotVector> refinedKnots(const KnotVector& knots, std::vector<double> refined);

// The curve over such a vector, by algorithms that give the same points; refusals as above.

/// The quickest: refinedCubic() (cubic_refinement.hpp) for clamped cubics without weights, Oslo 1
/// for all others.
[[nodiscard]] Result<BsplineCurve> refineByOslo(const BsplineCurve& curve,
                                                std::vector<double> refined);
/// Rows of discrete B-splines, O(n + m d²) (oslo.hpp).
[[nodiscard]] Result<BsplineCurve> refineByOslo1(const BsplineCurve& curve,
                                                 std::vector<double> refined);
/// Blossoms, O(n + m d²) (oslo.hpp).
[[nodiscard]] Result<BsplineCurve> refineByOslo2(const BsplineCurve& curve,
                                                 std::vector<double> refined);
/// One knot after the other in ascending order: each changes only the d points before it, so that
/// what lies behind is done. O(n + m + d (m - n)).
[[nodiscard]] Result<BsplineCurve> refineByBoehm(const BsplineCurve& curve,
                                                 std::vector<double> refined);

}  // namespace knotwork
