// Triangles of a mesh, for drawing and for the schemes that need them.
#pragma once

#include "geometry/mesh.hpp"

#include <cstdint>
#include <vector>

namespace knotwork {

/// Three vertices a triangle, face by face and round as the faces go: n − 2 triangles of a face of
/// n vertices. A quad is cut along its shorter diagonal (the first on a tie), unless the triangles
/// would then face opposite ways and those along the other would not. A larger face is cut from
/// its first vertex, which is right for convex ones. O(n).
[[nodiscard]] std::vector<std::uint32_t> triangleIndices(const Mesh& mesh);

/// The mesh of these triangles; the same where it has no other faces. NOT_MANIFOLD as Mesh::make()
/// where two faces that share more than an edge are cut along the same line.
[[nodiscard]] Result<Mesh> triangulated(const Mesh& mesh);

}  // namespace knotwork
