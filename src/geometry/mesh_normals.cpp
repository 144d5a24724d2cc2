#include "geometry/mesh_normals.hpp"

#include <algorithm>
#include <cmath>

// G. Thürmer, C. Wüthrich, Computing vertex normals from polygonal facets, 1998.

namespace knotwork {

namespace {

/// A power of two that brings every coordinate to at most 1, so that no product underflows for the
/// smallness of the whole mesh, and nothing is rounded.
double scaleOf(std::span<const Vec3> points) noexcept {
    double largest = 0;
    for (const Vec3& p : points) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    int exponent = 0;
    if (largest > 0) std::frexp(largest, &exponent);
    return std::ldexp(1.0, std::min(-exponent, 1000));
}

struct FaceGeometry {
    std::span<const Vec3> points;
    double scale;

    /// From the first of two vertices to the second.
    [[nodiscard]] Vec3 leg(std::uint32_t from, std::uint32_t to) const noexcept {
        return (points[to] * scale) - (points[from] * scale);
    }
};

/// Newell's normal, not normalised: seen from the first corner, so that far-off faces lose nothing.
Vec3 faceNormal(const FaceGeometry& geometry, std::span<const std::uint32_t> face) noexcept {
    Vec3 sum{0};
    Vec3 former = geometry.leg(face[0], face[1]);
    for (std::size_t j = 2; j < face.size(); ++j) {
        const Vec3 next = geometry.leg(face[0], face[j]);
        sum += glm::cross(former, next);
        former = next;
    }
    return sum;
}

/// The inner angle at a corner, above π where the face is concave there.
double angleBetween(const Vec3& forward, const Vec3& back, const Vec3& normal) noexcept {
    const Vec3 across = glm::cross(forward, back);
    const double angle = std::atan2(glm::length(across), glm::dot(forward, back));
    constexpr double turn = 6.283185307179586;
    return glm::dot(across, normal) < 0 ? turn - angle : angle;
}

Vec3 unitOrZero(const Vec3& v) noexcept {
    const double length = glm::length(v);
    return length > 0 ? v / length : Vec3{0};
}

}  // namespace

NormalSums::NormalSums(const Mesh& mesh) noexcept : mesh_(mesh), scale_(scaleOf(mesh.points())) {}

void NormalSums::add(std::size_t first, std::size_t last, std::span<double> xyz) const noexcept {
    const FaceGeometry geometry{mesh_.points(), scale_};
    const FaceRows faces = mesh_.faces();
    for (std::size_t f = first; f < last; ++f) {
        const auto face = faces[f];
        const Vec3 normal = unitOrZero(faceNormal(geometry, face));
        std::uint32_t former = face.back();
        for (std::size_t j = 0; j < face.size(); ++j) {
            const std::uint32_t vertex = face[j];
            const std::uint32_t next = face[j + 1 < face.size() ? j + 1 : 0];
            const double angle = angleBetween(geometry.leg(vertex, next),
                                              geometry.leg(vertex, former), normal);
            for (int axis = 0; axis < 3; ++axis) {
                xyz[3 * vertex + static_cast<std::size_t>(axis)] += angle * normal[axis];
            }
            former = vertex;
        }
    }
}

void NormalSums::normalise(std::span<double> xyz) noexcept {
    for (std::size_t at = 0; at < xyz.size(); at += 3) {
        const Vec3 normal = unitOrZero({xyz[at], xyz[at + 1], xyz[at + 2]});
        xyz[at] = normal.x;
        xyz[at + 1] = normal.y;
        xyz[at + 2] = normal.z;
    }
}

void vertexNormals(const Mesh& mesh, std::span<double> xyz) noexcept {
    std::fill(xyz.begin(), xyz.end(), 0.0);
    NormalSums(mesh).add(0, mesh.faces().count(), xyz);
    NormalSums::normalise(xyz);
}

}  // namespace knotwork
