// The quick way to a refined cubic: most of its points are values of the blossom of one polynomial
// piece, a symmetric function of three knots that costs a dozen products once the piece is there.
#pragma once

#include "geometry/knot_vector.hpp"
#include "geometry/vec.hpp"

#include <optional>
#include <span>
#include <vector>

namespace knotwork {

/// The points over `refined` of the cubic with these knots and points, both vectors clamped and of
/// degree 3; nothing where a knot of `knots` is missing. With C on a span expanded at its middle,
///     c[u, v, w] = C_0 + C_1 (u + v + w) + C_2 (u v + u w + v w) + C_3 u v w,
/// where all three knots lie in the span and one inside; other points are rows of Oslo 1, exact
/// where they were points of the curve. The same as oslo1() to 1e-14 of the largest point.
/// O(n + m). (L. Ramshaw, Blossoms are polar forms, 1989.)
[[nodiscard]] std::optional<std::vector<Vec3>> refinedCubic(const KnotVector& knots,
                                                            std::span<const Vec3> points,
                                                            const KnotVector& refined);

}  // namespace knotwork
