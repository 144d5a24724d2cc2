// Stencils: which vertices make a point of the finer mesh, and how much each of them counts.
//
// One level is linear: every new point is Σ w_i P_i with Σ w_i = 1, where the weights depend on the
// faces around it and not on where the points lie. They are those that subdivide() really uses:
// unit vectors in the places of the points have the weights as their images.
#pragma once

#include "geometry/mesh_subdivision.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knotwork {

/// What of a mesh a new point belongs to; a corner is a vertex as seen from one face (Doo–Sabin).
enum class MeshElement { vertex, edge, face, corner };

struct StencilWeight {
    std::uint32_t vertex = 0;
    double weight = 0;
};

struct MeshStencil {
    Vec3 point{0.0};                     ///< of the finer mesh
    std::vector<StencilWeight> weights;  ///< those that are not 0, by the numbers of the vertices
};

/// Elements with more vertices around them have no stencil that anybody could read.
inline constexpr std::size_t mostAround = 400;

[[nodiscard]] bool hasStencil(MeshScheme scheme, MeshElement element) noexcept;

/// How many elements of this kind a mesh has.
[[nodiscard]] std::size_t elementCount(const Mesh& mesh, MeshElement element);

/// The stencil of the element's point one level finer: of vertices, faces and corners (face by face)
/// by their numbers, of edges by those of Mesh::edges(). Weights are exact to a few ulp. Refusals:
/// NOT_SUPPORTED `of` for elements of which the scheme makes no points, OUT_OF_RANGE `index`,
/// TOO_LARGE `index` for more than mostAround vertices around the element, and those of subdivide().
/// O(corners of the mesh + (vertices around)²).
[[nodiscard]] Result<MeshStencil> stencil(const Mesh& mesh, MeshScheme scheme, MeshElement element,
                                          std::size_t index);

}  // namespace knotwork
