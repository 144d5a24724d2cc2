// Parameters for points that come without them, and knots that suit parameters.
//
// u_k - u_{k-1} is proportional to |Q_k - Q_{k-1}|^a: a = 0 uniform, 1/2 centripetal, 1 chord
// length. A closed list does not repeat its first point, and the chord that closes it counts too.
// (E. T. Y. Lee, Choosing nodes in parametric curve interpolation, 1989; Piegl and Tiller, The
// NURBS Book, 9.2.1.)
#pragma once

#include "geometry/interval.hpp"
#include "geometry/knot_vector.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>
#include <vector>

namespace knotwork {

enum class Parametrisation { uniform, centripetal, chord };

/// One parameter a point, not decreasing, from 0 to 1 exactly; of a closed list from 0 to less
/// than 1, where the first point comes again. Equal points in a row have equal parameters, but for
/// the uniform ones. Coordinates must be finite. Refusals: WRONG_LENGTH `points` for fewer than 2
/// of them; OUT_OF_RANGE `points` where all are equal and their distances say nothing. O(m).
[[nodiscard]] Result<std::vector<double>> parametersOf(std::span<const Vec3> points,
                                                       Parametrisation how, bool closed);

/// What default knots span: from the first parameter to the last. A closed curve needs a period
/// beyond its last parameter: [0, 1] where all parameters lie in [0, 1), as those of
/// parametersOf() do, otherwise one mean step more than their range. Needs two or more parameters
/// that do not decrease.
[[nodiscard]] Interval parameterRange(std::span<const double> parameters, bool closed);

/// The knots of `count` points with spans of equal length over the range, as KnotVector::make()
/// wants them: one period of a closed vector; those of an open one go on beyond the range.
[[nodiscard]] std::vector<double> uniformKnots(const Interval& range, int degree, int count,
                                               Form form);

/// Knots for as many points as parameters, so that every basis function has a parameter of its
/// own. Clamped and open: t_{j+d} = (u_j + … + u_{j+d-1}) / d between the ends (C. de Boor, A
/// Practical Guide to Splines, ch. XIII), beyond which open ones go on uniformly. Closed: the
/// parameters themselves for an odd degree, the middles between them for an even one, for which
/// the parameters themselves would not do.
[[nodiscard]] std::vector<double> averagedKnots(std::span<const double> parameters, int degree,
                                                Form form);

}  // namespace knotwork
