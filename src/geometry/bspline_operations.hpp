// A B-spline curve cut in two, run backwards, and differentiated.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

#include <vector>

namespace knotwork {

/// The part before t and the part after it, each with the parameters that it had, in t with d+1
/// equal knots; the other ends stay as they are. A closed curve comes back as one clamped curve over
/// [t, t + T], t moved into the period. At a gap each part gets its own end. O(n + d²). Refusals:
/// NOT_FINITE `t`; OUT_OF_RANGE `t` outside the domain, at an end of it, or nearer to a knot or an
/// end than knots may stand; TOO_LARGE `t` beyond 100 000 points.
[[nodiscard]] Result<std::vector<BsplineCurve>> split(const BsplineCurve& curve, double t);

/// The same curve run through from its end, over the same domain: r(a + b - t) = c(t). O(n).
/// OUT_OF_RANGE `knots` only for knots that are as near to each other as knots can be, and that
/// rounding moves nearer.
[[nodiscard]] Result<BsplineCurve> reversed(const BsplineCurve& curve);

}  // namespace knotwork
