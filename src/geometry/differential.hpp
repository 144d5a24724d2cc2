// The moving frame of a curve: tangent, normal, binormal, curvature and torsion.
//
//     κ = |C′ × C″| / |C′|³,  τ = det(C′, C″, C‴) / |C′ × C″|²,  and with arc length s
//     dT/ds = κ N,  dN/ds = −κ T + τ B,  dB/ds = −τ N  (Frenet, Serret).
//
// In the plane κ is signed, positive in a left turn, and N is the left normal, so that the same
// formulas hold and N is continuous through inflexions. In space κ ≥ 0 and N points to the centre
// of curvature.
#pragma once

#include "geometry/curve.hpp"

#include <optional>

namespace knotwork {

/// Everything in it is finite, and tangent, normal and binormal are a right-handed orthonormal
/// basis, also where the curve stands still, turns back, is straight or is a single point.
struct Frame {
    Vec3 point{0};
    Vec3 tangent{1, 0, 0};
    Vec3 normal{0, 1, 0};
    Vec3 binormal{0, 0, 1};
    double curvature = 0;
    double torsion = 0;
};

/// The frame at t in the domain, from one side. "Vanishes" below means to rounding.
///
/// - Where C′ vanishes (a cusp, points that coincide), the tangent is the limit from that side; the
///   curvature is its limit where that is finite and 0 where it is not. Of a curve that is a single
///   point the tangent is the x axis.
/// - Where the curvature vanishes in space, κ = τ = 0, and the normal is its limit from that side;
///   on a straight part it is the one with which the curve enters that part, or else leaves it,
///   carried along without rotation about the tangent; where there is none (a straight line, a
///   polygon), one that is fixed at the start of the curve is carried along. (Straight parts have
///   tangents that turn at corners only: there the least rotation from one tangent to the next is
///   what the double reflection of Wang, Jüttler, Zheng and Liu 2008 comes to.)
///
/// One evaluation of three derivatives and a few points as a rule, O(pieces) on a straight part in
/// space.
[[nodiscard]] Frame frameAt(const Curve& curve, double t, Side side);

/// The centre of the osculating circle, a point of the evolute; its radius is 1/|κ|. None where the
/// curvature vanishes.
[[nodiscard]] std::optional<Vec3> centreOfCurvature(const Frame& frame) noexcept;

/// The tip of a tooth of the curvature comb, C − scale · κ · N: on the outer side of a turn.
[[nodiscard]] Vec3 combPoint(const Frame& frame, double scale) noexcept;

}  // namespace knotwork
