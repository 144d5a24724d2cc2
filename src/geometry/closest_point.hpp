// The points of a curve that are nearest to a place and farthest from it, all of the curve searched.
//
// Each smooth piece has a lower bound of the squared distance from Taylor series at its ends and
// its middle. Pieces are taken in the order of their bounds and halved until the bound rules them
// out or the squared distance is convex on them, and then Newton's method finds its one minimum.
#pragma once

#include "geometry/curve.hpp"

namespace knotwork {

struct PointOnCurve {
    double t = 0;
    Vec3 point{0};
    double distance = 0;
};

/// The point of the curve nearest to p; of several that are equally near (to rounding) the one with
/// the smallest parameter. NOT_FINITE or OUT_OF_RANGE (beyond 1e12) at `p[i]`. The distance is exact
/// to rounding, t as far as the curve tells parameters apart at that distance. O(pieces) and a few
/// dozen evaluations.
[[nodiscard]] Result<PointOnCurve> closestPoint(const Curve& curve, const Vec3& p);

/// The point farthest from p, found in the same way; p is finite.
[[nodiscard]] PointOnCurve farthestPoint(const Curve& curve, const Vec3& p);

}  // namespace knotwork
