#include "drawing/normals.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace knotwork::drawing {

bool mirrors(const Mat3& map) noexcept {
    return glm::dot(glm::cross(map[0], map[1]), map[2]) < 0;
}

namespace {

/// A corner's share: the normal of its two legs, the less the longer they are. A corner without one
/// of its legs has none.
Vec3 shareOf(const Vec3& back, const Vec3& forward) noexcept {
    const double size = glm::dot(back, back) * glm::dot(forward, forward);
    return size > 0 ? glm::cross(forward, back) / size : Vec3(0);
}

template <std::uint32_t Size>
void addShares(std::span<const Vec3> points, std::span<const std::uint32_t> corners, double scale,
               std::vector<Vec3>& sums) {
    for (std::size_t first = 0; first + Size <= corners.size(); first += Size) {
        const std::uint32_t* face = &corners[first];
        std::array<Vec3, Size> legs;
        for (std::uint32_t j = 0; j < Size; ++j) {
            legs[j] = (points[face[(j + 1) % Size]] - points[face[j]]) * scale;
        }
        for (std::uint32_t j = 0; j < Size; ++j) {
            sums[face[j]] += shareOf(-legs[(j + Size - 1) % Size], legs[j]);
        }
    }
}

}  // namespace

// N. Max, Weights for computing vertex normals from facet normals, 1999.
std::vector<double> shadingNormals(const Mesh& mesh) {
    std::vector<double> xyz(3 * mesh.points().size());
    const std::uint32_t size = mesh.uniformSize();
    if (size != 3 && size != 4) {
        vertexNormals(mesh, xyz);
        completeNormals(xyz);
        return xyz;
    }
    Vec3 low = mesh.points().front();
    Vec3 high = low;
    for (const Vec3& p : mesh.points()) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double extent = glm::length(high - low);
    std::vector<Vec3> sums(mesh.points().size(), Vec3(0));
    const auto add = size == 3 ? addShares<3> : addShares<4>;
    add(mesh.points(), mesh.corners(), extent > 0 ? 1 / extent : 1, sums);
    double* to = xyz.data();
    for (const Vec3& sum : sums) {
        const double length = glm::length(sum);
        const Vec3 normal = length > 0 ? sum / length : Vec3(0, 0, 1);
        *to++ = normal.x;
        *to++ = normal.y;
        *to++ = normal.z;
    }
    return xyz;
}

void turnNormals(std::span<double> normals, const Mat3& map) noexcept {
    const double way = mirrors(map) ? -1 : 1;
    const Mat3 turn(way * glm::cross(map[1], map[2]), way * glm::cross(map[2], map[0]),
                    way * glm::cross(map[0], map[1]));
    for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
        const Vec3 turned = turn * Vec3(normals[i], normals[i + 1], normals[i + 2]);
        const double length = glm::length(turned);
        if (!(length > 0)) continue;
        normals[i] = turned.x / length;
        normals[i + 1] = turned.y / length;
        normals[i + 2] = turned.z / length;
    }
}

void completeNormals(std::span<double> normals) noexcept {
    for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
        const double square = normals[i] * normals[i] + normals[i + 1] * normals[i + 1] +
                              normals[i + 2] * normals[i + 2];
        if (square > 0.5) continue;
        normals[i] = normals[i + 1] = 0;
        normals[i + 2] = 1;
    }
}

}  // namespace knotwork::drawing
