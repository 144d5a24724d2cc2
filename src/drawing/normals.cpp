#include "drawing/normals.hpp"

#include <algorithm>
#include <cstddef>

namespace knotwork::drawing {

bool mirrors(const Mat3& map) noexcept {
    return glm::dot(glm::cross(map[0], map[1]), map[2]) < 0;
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
