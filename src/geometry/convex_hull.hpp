// Convex hulls of points in a plane and in space.
//
// In a plane: monotone chain (A. M. Andrew, Another efficient algorithm for convex hulls in two
// dimensions, 1979). In space: quickhull (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The quickhull
// algorithm for convex hulls, 1996). On which side of a line or plane a point lies is decided
// exactly, for points rounded to 2⁻³⁸ of their extent; so no order of points, no duplicates and no
// degenerate position lead astray.
#pragma once

#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork {

/// The corners of the hull of the points' x and y, by index, counter-clockwise; points inside an
/// edge are no corners. Two for points in a line, one for a single place, none for none. Every point
/// is inside to 1e-11 of the extent. Coordinates must be finite. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> planeHull(std::span<const Vec3> points);

/// The edges of the hull in space, each once, by index of its ends: of points in a plane (to 1e-9 of
/// the extent) those of their polygon there, of points in a line one. Where several triangles make
/// a flat face there are no edges inside it. O(n log n) as a rule.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> hullEdges(std::span<const Vec3> points);

}  // namespace knotwork
