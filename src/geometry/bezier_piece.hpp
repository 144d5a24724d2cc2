// The Bézier form of single spans of a B-spline curve, in homogeneous coordinates.
#pragma once

#include "geometry/homogeneous.hpp"
#include "geometry/interval.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

/// The weights of the d+1 points of a span in Bézier point j of its part [u, v], the blossom's value
/// with d-j arguments u and j arguments v; they are not negative and sum to 1. `knots` are those of
/// which span `span` needs 2d, tau_span ≤ u ≤ v ≤ tau_{span+1}. `weights` has room for d+1. O(d²).
void bezierWeights(std::span<const double> knots, std::size_t degree, std::size_t span,
                   const Interval& part, std::size_t j, std::span<double> weights) noexcept;

/// A piece of a curve: b_0 … b_d over its interval.
struct BezierPiece {
    Interval interval;
    std::vector<Homogeneous> points;
};

/// One piece for each span of the domain that is not empty, in order. O(n d³).
[[nodiscard]] std::vector<BezierPiece> bezierPieces(const BsplineCurve& curve);

}  // namespace knotwork
