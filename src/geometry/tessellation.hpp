// Polylines that honour a tolerance: adaptive subdivision in the parameter.
#pragma once

#include "geometry/curve.hpp"

#include <vector>

namespace knotwork {

struct Polyline {
    std::vector<double> xyz;         ///< triples
    std::vector<double> parameters;  ///< one a point, ascending
};

/// A polyline whose distance from the curve is at most `tolerance` (> 0, world units), looked at in
/// three points of every chord, its vertices on the curve, every knot a vertex (twice where the
/// curve jumps by more than the tolerance). Refining stops at 2¹⁷ points.
[[nodiscard]] Polyline polyline(const Curve& curve, double tolerance);
/// The same over a part of the parameter, which may lie outside the domain (see evaluate()).
[[nodiscard]] Polyline polyline(const Curve& curve, const Interval& part, double tolerance);

}  // namespace knotwork
