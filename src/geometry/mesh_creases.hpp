// Semi-sharp creases of Catmull–Clark's and Loop's schemes (T. DeRose, M. Kass, T. Truong, Subdivision
// surfaces in character animation, 1998).
//
// An edge of sharpness s ≥ 1 has the boundary's rule: its point is its middle. With 0 < s < 1 that is
// mixed with the smooth rule, s parts to 1 − s. Its halves have the sharpness s − 1. A vertex at one
// sharp edge is smooth, at two it is a point of the cubic B-spline of both, (p + 6 v + q) / 8, and at
// three or more a corner, which stays; edges on a boundary count as sharp for ever. Where edges are
// sharp for the last time (s ≤ 1), the rule with them and the rule without them are mixed by the mean
// of their s, so that a vertex depends on every sharpness continuously.
#pragma once

#include "geometry/mesh_level.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace knotwork {

/// Those of a mesh that do not lie on a boundary, where they would change nothing.
[[nodiscard]] std::vector<LevelCrease> creasesOf(const Mesh& mesh);

/// Puts the points of creased edges and of their ends, smooth so far, in place.
void refineCreases(const MeshLevel& level, std::span<Vec3> vertexPoints,
                   std::span<Vec3> edgePoints);

/// What is left of the creases one level finer, where edge e has the vertex firstEdgePoint + e.
[[nodiscard]] std::vector<LevelCrease> halvedCreases(const MeshLevel& level,
                                                     std::uint32_t firstEdgePoint,
                                                     const FinerEdges& numbers);
/// The finer mesh with them.
[[nodiscard]] Mesh withHalvedCreases(const Mesh& finer, const MeshLevel& level,
                                     std::uint32_t firstEdgePoint);

}  // namespace knotwork
