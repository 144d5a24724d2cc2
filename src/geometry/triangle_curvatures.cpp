#include "geometry/triangle_curvatures.hpp"

#include "geometry/vec.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace knotwork {

namespace {

Vec3 tripleAt(std::span<const double> xyz, std::uint32_t i) noexcept {
    const double* p = xyz.data() + 3 * static_cast<std::size_t>(i);
    return {p[0], p[1], p[2]};
}

/// Twice the integrals over a triangle.
struct Measures {
    double area = 0;
    double mean = 0;
    double gaussian = 0;
};

/// Positions relative to the first corner: far from the origin M would cancel.
Measures measuresOf(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& u) noexcept {
    const Vec3 n = (u[0] + u[1] + u[2]) / 3.0;
    const Vec3 b = p[1] - p[0];
    const Vec3 c = p[2] - p[0];
    return {glm::dot(n, glm::cross(b, c)),
            glm::dot(n, glm::cross(u[0] - u[2], b) + glm::cross(u[1] - u[0], c)),
            glm::dot(u[0], glm::cross(u[1], u[2]))};
}

}  // namespace

VertexCurvatures triangleCurvatures(std::span<const double> positions,
                                    std::span<const double> normals,
                                    std::span<const std::uint32_t> triangles) {
    const std::size_t count = positions.size() / 3;
    std::vector<double> areas(count);
    VertexCurvatures sums{std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const std::uint32_t* t = &triangles[i];
        const Measures measures = measuresOf(
            {tripleAt(positions, t[0]), tripleAt(positions, t[1]), tripleAt(positions, t[2])},
            {tripleAt(normals, t[0]), tripleAt(normals, t[1]), tripleAt(normals, t[2])});
        for (std::size_t k = 0; k < 3; ++k) {
            areas[t[k]] += measures.area;
            sums.mean[t[k]] += measures.mean;
            sums.gaussian[t[k]] += measures.gaussian;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const bool known = areas[i] > 0;
        sums.mean[i] = known ? -0.5 * sums.mean[i] / areas[i] : 0;
        sums.gaussian[i] = known ? sums.gaussian[i] / areas[i] : 0;
    }
    return sums;
}

}  // namespace knotwork
