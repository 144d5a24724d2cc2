// One function a scheme: a checked number of levels of a mesh that the scheme can work on.
#pragma once

#include "geometry/mesh_level.hpp"
#include "geometry/mesh_subdivision.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace knotwork {

/// What subdivide() refuses of a mesh.
[[nodiscard]] std::optional<Error> checkMeshFor(const Mesh& mesh, MeshScheme scheme, int levels);

// levels ≥ 1. O(size of the result).
[[nodiscard]] Mesh subdivideCatmullClark(const Mesh& mesh, int levels);
[[nodiscard]] Mesh subdivideDooSabin(const Mesh& mesh, int levels);
[[nodiscard]] Mesh subdivideLoop(const Mesh& mesh, int levels);
[[nodiscard]] Mesh subdivideButterfly(const Mesh& mesh, int levels);
[[nodiscard]] Mesh subdivideSqrt3(const Mesh& mesh, int levels);

// Triangles cut in four at the middles of their edges, as Loop's and the Butterfly's are.

/// The corners of the finer triangles.
[[nodiscard]] RawArray<std::uint32_t> quarteredTriangles(const MeshLevel& level);
/// The finer level with these points.
[[nodiscard]] MeshLevel quarteredLevel(const MeshLevel& level, RawArray<Vec3> points);

/// What Loop's scheme adds to a vertex of so many triangles for each neighbour: β of v + β Σ (v_j −
/// v).
[[nodiscard]] double loopWeight(std::uint32_t valence) noexcept;
/// How far √3 moves a vertex of so many triangles to the mean of its neighbours.
[[nodiscard]] double sqrt3Weight(std::uint32_t valence) noexcept;

}  // namespace knotwork
