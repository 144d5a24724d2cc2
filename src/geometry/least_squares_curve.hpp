// B-splines nearest to points at given parameters: least squares and smoothing.
//
// The control points c minimise  Σ_k |C(u_k) - Q_k|² + λ Σ_i |c_{i-1} - 2 c_i + c_{i+1}|²,  the
// second sum over all neighbouring triples, around the seam where the curve is closed; λ is the
// smoothing. It is not scaled: with twice as many points of one curve, λ counts half as much. What
// it pulls towards is a polygon with equal steps along a straight line (closed: a single point).
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/knot_vector.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace knotwork {

/// More data than that are TOO_LARGE.
inline constexpr std::size_t maxDataCount = 1'000'000;
inline constexpr double maxSmoothing = 1e12;

struct LeastSquares {
    /// The curve begins exactly in the first point and ends in the last. A closed one has no ends.
    bool interpolateEnds = false;
    double smoothing = 0;
};

/// The spline of these knots nearest to the points at the parameters. Refusals: WRONG_LENGTH or
/// TOO_LARGE `points` (1 … 10⁶); NOT_FINITE and OUT_OF_RANGE `points[i]` (|coordinate| ≤ 1e12);
/// WRONG_LENGTH `parameters` (one a point); NOT_FINITE and OUT_OF_RANGE `parameters[i]` (not
/// decreasing, in the domain); OUT_OF_RANGE `smoothing` (0 … 1e12); NOT_SUPPORTED
/// `interpolateEnds` of a closed curve; RANK_DEFICIENT `controlPoints[i]` where data do not
/// determine that control point; OUT_OF_RANGE `controlPoints[i]` where one lies beyond 1e12.
/// O(m d + n d²). Data that lie on a spline of these knots give it back within 1e-12 of their size
/// up to degree 9.
[[nodiscard]] Result<BsplineCurve> leastSquaresCurve(std::span<const Vec3> points,
                                                     std::span<const double> parameters,
                                                     const KnotVector& knots,
                                                     const LeastSquares& options = {});

// What leastSquaresCurve() does, in steps, for those who find parameters and knots between them.
/// What is wrong with the points and the options.
[[nodiscard]] std::optional<Error> checkFit(std::span<const Vec3> points,
                                            const LeastSquares& options, bool closed);
/// What is wrong with the parameters of so many points: their number, a value, their order.
[[nodiscard]] std::optional<Error> checkParameters(std::span<const double> parameters,
                                                   std::size_t pointCount);
/// The first of them outside the domain.
[[nodiscard]] std::optional<Error> checkInside(std::span<const double> parameters,
                                               const Interval& domain);
/// Of data that have been checked.
[[nodiscard]] Result<BsplineCurve> checkedLeastSquares(std::span<const Vec3> points,
                                                       std::span<const double> parameters,
                                                       const KnotVector& knots,
                                                       const LeastSquares& options);

/// Of the distances |C(u_k) - Q_k|.
struct Residuals {
    double sumOfSquares = 0;
    double rms = 0;  ///< square root of their mean square
    double max = 0;
};

/// The parameters lie in the domain, one a point, and do not decrease. O(m d).
[[nodiscard]] Residuals residualsOf(const BsplineCurve& curve, std::span<const Vec3> points,
                                    std::span<const double> parameters);

}  // namespace knotwork
