// Boehm's algorithm, knot by knot, for one knot or for all the knots of a refinement.
#pragma once

#include "geometry/homogeneous.hpp"
#include "geometry/knot_vector.hpp"

#include <span>
#include <vector>

namespace knotwork {

/// The points after t (in the domain) has been inserted once. O(n).
[[nodiscard]] std::vector<Homogeneous> boehmOnce(const KnotVector& knots,
                                                 std::span<const Homogeneous> points, double t);

/// The points over `refined`, a result of refinedKnots() (refinement.hpp). The knots are inserted
/// in ascending order, each into d points. O(n + m + d (m - n)).
[[nodiscard]] std::vector<Homogeneous> boehm(const KnotVector& knots, const KnotVector& refined,
                                             std::span<const Homogeneous> points);

}  // namespace knotwork
