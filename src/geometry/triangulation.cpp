#include "geometry/triangulation.hpp"

#include <cstddef>
#include <utility>

namespace knotwork {

namespace {

using Quad = std::span<const std::uint32_t>;

/// Whether the triangles a, b, c and a, c, d of a quad face the same way.
bool agree(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
    return glm::dot(glm::cross(b - a, c - a), glm::cross(c - a, d - a)) >= 0;
}

/// Whether to cut from the second corner to the fourth.
bool cutsFromSecond(std::span<const Vec3> points, Quad quad) noexcept {
    const Vec3& a = points[quad[0]];
    const Vec3& b = points[quad[1]];
    const Vec3& c = points[quad[2]];
    const Vec3& d = points[quad[3]];
    const bool fromFirst = agree(a, b, c, d);
    const bool fromSecond = agree(b, c, d, a);
    if (fromFirst != fromSecond) return fromSecond;
    return glm::dot(d - b, d - b) < glm::dot(c - a, c - a);
}

}  // namespace

std::vector<std::uint32_t> triangleIndices(const Mesh& mesh) {
    const FaceRows faces = mesh.faces();
    if (mesh.uniformSize() == 3) return {faces.corners.begin(), faces.corners.end()};
    std::vector<std::uint32_t> indices(3 * (faces.corners.size() - 2 * faces.count()));
    const std::span<const Vec3> points = mesh.points();
    std::uint32_t* to = indices.data();
    const std::size_t count = faces.count();
    for (std::size_t f = 0; f < count; ++f) {
        const auto face = faces[f];
        const std::size_t first = face.size() == 4 && cutsFromSecond(points, face) ? 1 : 0;
        for (std::size_t j = 2; j < face.size(); ++j, to += 3) {
            const std::size_t last = first + j;
            to[0] = face[first];
            to[1] = face[last - 1];
            to[2] = face[last < face.size() ? last : 0];
        }
    }
    return indices;
}

Result<Mesh> triangulated(const Mesh& mesh) {
    if (mesh.uniformSize() == 3) return mesh;
    auto cut = Mesh::make({mesh.points().begin(), mesh.points().end()}, triangleIndices(mesh), 3);
    if (!cut || mesh.creases().empty()) return cut;
    return cut->withTrustedCreases({mesh.creases().begin(), mesh.creases().end()});
}

}  // namespace knotwork
