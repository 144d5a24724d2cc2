// How often a line crosses a curve, and how often its control polygon.
//
//     f(t) = n · (C(t) − P),   n the normal of the line through P
//
// changes its sign no more often than its coefficients n · (P_i − P) do, since B-splines are
// totally positive: a curve is crossed at most as often as its control polygon (variation
// diminishing: J. M. Lane, R. F. Riesenfeld, A geometric proof for the variation diminishing
// property of B-spline approximation, 1983).
#pragma once

#include "geometry/curve.hpp"

#include <optional>
#include <vector>

namespace knotwork {

/// A line in the plane z = 0; in space it stands for the plane that is upright on it.
struct PlaneLine {
    Vec3 point{0.0};
    Vec3 direction{1, 0, 0};  ///< of any length but 0, its z does not count
};

struct Crossing {
    double t = 0;
    Vec3 point{0.0};
};

struct LineCrossings {
    std::vector<Crossing> curve;  ///< ascending
    std::vector<Vec3> polygon;    ///< along the polygon
};

/// A distance from the line that counts as none, in parts of the largest distance of a control
/// point from the line's point: some hundred times what rounding makes of it.
inline constexpr double lineTolerance = 1e-12;

/// Of a B-spline, Bézier or subdivision curve; nothing for the others: they have no control polygon.
///
/// A crossing is where the curve comes from one side of the line to the other, by more than the
/// tolerance on each: contact and stretches along the line are none, nor is a jump at a gap. That
/// is decided by the Bézier coefficients of halved pieces, which hold f between them, until a piece
/// has one sign or none, or one change of sign and opposite ends, hence one crossing: none is
/// missed. The parameters are those of f = 0 to rounding. With the tolerance the number of crossings
/// of a spline is still at most that of its polygon.
/// O(n d³) and, for each crossing or contact, some fifty times d².
[[nodiscard]] std::optional<LineCrossings> lineCrossings(const Curve& curve, const PlaneLine& line);

}  // namespace knotwork
