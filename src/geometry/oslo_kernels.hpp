// The two Oslo algorithms on any scalar: double in the library, exact rationals in the tests.
//
// Both compute the blossom c[u_1, …, u_d] of the polynomial piece on span s of the knots tau: a
// multi-affine function, symmetric in its arguments, that gives the control point c_i at
// tau_{i+1}, …, tau_{i+d}, the curve at t, …, t, and the points of every refinement at their own
// d knots. Each level k takes the argument u_k, and the arguments ascend:
//     tau_s ≤ u_0 ≤ u_1 ≤ … ≤ u_d, u_0 < tau_{s+1} the knot before the arguments, u_k ≤ tau_{s+k}.
// Then no weight of a point is negative: where a factor is, an exact zero stands before it. From
// the points' side the levels come in descending order of k, that is, of the arguments; in
// ascending order everything is lost to cancellation.
// (E. Cohen, T. Lyche and R. Riesenfeld, Discrete B-splines and subdivision techniques, 1980;
// T. Lyche and K. Mørken, Making the Oslo algorithm more efficient, 1986.)
#pragma once

#include "geometry/bspline_kernels.hpp"

#include <cstddef>
#include <span>

namespace knotwork::kernels {

/// Oslo 1: the discrete B-splines alpha_{s-d} … alpha_s, with which the points of the span stand in
/// c[u_1, …, u_d]. They are not negative and sum to 1. `weights` has room for d+1.
template <class Knot>
constexpr void discreteBsplines(std::span<const Knot> knots, std::size_t degree, std::size_t span,
                                std::span<const Knot> arguments, std::span<Knot> weights) {
    weights[0] = Knot{1};
    for (std::size_t k = 1; k <= degree; ++k) {
        raiseBasis<Knot, Knot>(knots, span, k, arguments[k - 1], weights);
    }
}

/// Oslo 2: c[u_1, …, u_d] itself from the d+1 points of the span, which are overwritten.
template <class Knot, class Point>
[[nodiscard]] constexpr Point blossom(std::span<const Knot> knots, std::size_t degree,
                                      std::size_t span, std::span<const Knot> arguments,
                                      std::span<Point> points) {
    for (std::size_t r = 1; r <= degree; ++r) {
        deBoorStep<Knot, Knot, Point>(knots, degree, span, r, arguments[degree - r], points);
    }
    return points[degree];
}

}  // namespace knotwork::kernels
