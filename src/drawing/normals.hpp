// Unit normals as triples of numbers: how they go along with a map, and what stands where there is
// none.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/vec.hpp"

#include <span>
#include <vector>

namespace knotwork::drawing {

/// Whether a map turns faces over.
[[nodiscard]] bool mirrors(const Mat3& map) noexcept;

/// Turns normals with a map of their points: by its cofactors, the other way where it mirrors. One
/// that the map leaves no direction stays as it is.
void turnNormals(std::span<double> normals, const Mat3& map) noexcept;

/// Unit normals of a mesh's vertices as they are lit: exact where all vertices lie on a sphere, and
/// without the angles that vertexNormals() weighs by, which take most of its time. Faces of other
/// than three or four corners, or of several sizes, have those. O(corners).
[[nodiscard]] std::vector<double> shadingNormals(const Mesh& mesh);

/// Poles, cusps and vertices without faces have no normal of their own: any is as good as another.
void completeNormals(std::span<double> normals) noexcept;

}  // namespace knotwork::drawing
