// One level of a mesh on its way through subdivision: with the edge at every corner, which the next
// level gets by counting, without any search.
//
// Edges have the numbers of Mesh::edges(): in the order in which one meets them walking along the
// faces. An edge is thus met for the first time exactly where its number is that of edges met
// before, and what belongs to edges is written nearly in order.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/point_lanes.hpp"
#include "geometry/steps.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace knotwork {

/// An edge with one face, along which it runs as that face does.
struct BoundaryEdge {
    std::uint32_t corner = 0;  ///< where it begins
    std::uint32_t before = 0;  ///< the boundary edge that ends there, in the same fan of faces
    std::uint32_t after = 0;   ///< the one that begins where this one ends
    std::uint32_t fans = 1;    ///< how many open fans meet where it begins
};

/// An inner edge that is kept sharp, from v0 to v1 as the first of its faces goes along it.
struct LevelCrease {
    std::uint32_t edge = 0;
    std::uint32_t v0 = 0;
    std::uint32_t v1 = 0;
    double sharpness = 0;
};

struct MeshLevel {
    std::span<const Vec3> points;
    FaceRows faces;
    std::span<const std::uint32_t> cornerEdges;
    std::size_t edges = 0;
    std::vector<BoundaryEdge> boundary;
    std::vector<LevelCrease> creases;
    /// How many faces each of the first vertices has; all others inside are regular.
    std::vector<std::uint32_t> valences;

    // What the spans show, unless it is a mesh's.
    RawArray<Vec3> ownPoints;
    RawArray<std::uint32_t> ownCorners;
    RawArray<std::uint32_t> ownCornerEdges;

    [[nodiscard]] std::uint32_t from(const BoundaryEdge& edge) const noexcept {
        return faces.corners[edge.corner];
    }
    [[nodiscard]] std::uint32_t to(const BoundaryEdge& edge) const noexcept {
        return from(boundary[edge.after]);
    }
};

/// Of a mesh that outlives the level. O(corners).
[[nodiscard]] MeshLevel firstLevel(const Mesh& mesh);

/// A level that owns its points and its faces of `size` corners.
[[nodiscard]] MeshLevel ownLevel(RawArray<Vec3> points, RawArray<std::uint32_t> corners,
                                 std::uint32_t size);

/// The boundary edges of a mesh in the order of their corners, each with those beside it.
[[nodiscard]] std::vector<BoundaryEdge> boundaryOf(const Mesh& mesh);

/// The boundary after each edge is cut in two, whose halves begin at the corners that `firstHalf`
/// and `secondHalf` answer for its corner.
template <class First, class Second>
[[nodiscard]] std::vector<BoundaryEdge> halvedBoundary(std::span<const BoundaryEdge> boundary,
                                                       First firstHalf, Second secondHalf) {
    std::vector<BoundaryEdge> halves;
    halves.reserve(2 * boundary.size());
    for (std::uint32_t b = 0; b < boundary.size(); ++b) {
        const BoundaryEdge& edge = boundary[b];
        halves.push_back({firstHalf(edge.corner), 2 * edge.before + 1, 2 * b + 1, edge.fans});
        halves.push_back({secondHalf(edge.corner), 2 * b, 2 * edge.after, 1});
    }
    return halves;
}

/// The boundary curve one level finer, a uniform cubic B-spline: the middles of its edges, and
/// (p + 6 v + q) / 8 for a vertex v between p and q.
void refineCubicBoundary(const MeshLevel& level, std::span<Vec3> vertexPoints,
                         std::span<Vec3> edgePoints) noexcept;

/// Numbers the edges of the finer faces while one walks along them: halves of edges, and edges
/// inside a face.
class FinerEdges {
public:
    explicit FinerEdges(std::size_t edges) : halves_(2 * edges) {}

    /// The half where the face at hand begins to go along the edge; asked once for each edge.
    [[nodiscard]] std::uint32_t firstHalf(std::uint32_t edge) noexcept {
        const bool isNew = edge >= met_;
        metHere_ += isNew ? 1 : 0;
        return half(2 * std::size_t{edge} + (isNew ? 0 : 1), isNew);
    }
    [[nodiscard]] std::uint32_t secondHalf(std::uint32_t edge) noexcept {
        const bool isNew = edge >= met_;
        return half(2 * std::size_t{edge} + (isNew ? 1 : 0), isNew);
    }
    [[nodiscard]] std::uint32_t inside() noexcept {
        step();
        return count_++;
    }
    void endFace() noexcept { met_ = metHere_; }
    /// The number of the half of an edge at which its first face begins to go along it, or of the
    /// other; both have been met.
    [[nodiscard]] std::uint32_t half(std::uint32_t edge, bool other) const noexcept {
        return halves_[2 * std::size_t{edge} + (other ? 1 : 0)];
    }

    [[nodiscard]] std::size_t count() const noexcept { return count_; }

private:
    [[nodiscard]] std::uint32_t half(std::size_t at, bool isNew) noexcept {
        step();
        const std::uint32_t number = isNew ? count_ : halves_[at];
        count_ += isNew ? 1 : 0;
        halves_[at] = number;
        return number;
    }

    std::vector<std::uint32_t> halves_;
    std::uint32_t count_ = 0;
    std::uint32_t met_ = 0;
    std::uint32_t metHere_ = 0;
};

/// Calls visit(face, first corner, size) for every face, the size being a constant for triangles
/// and for quads.
template <class Visit>
void visitFaces(const FaceRows& faces, Visit visit) {
    const std::size_t count = faces.count();
    if (faces.uniformSize == 4) {
        for (std::size_t f = 0; f < count; ++f) {
            visit(f, 4 * f, std::integral_constant<std::size_t, 4>{});
        }
    } else if (faces.uniformSize == 3) {
        for (std::size_t f = 0; f < count; ++f) {
            visit(f, 3 * f, std::integral_constant<std::size_t, 3>{});
        }
    } else {
        for (std::size_t f = 0; f < count; ++f) {
            const std::size_t begin = faces.begin(f);
            visit(f, begin, faces.begin(f + 1) - begin);
        }
    }
}

/// Where what the two faces of an edge say about its point is brought together: their middle.
class EdgePoints {
public:
    explicit EdgePoints(Vec3* points) noexcept : points_(points) {}

    void add(std::uint32_t edge, const simd::PointLanes& said) noexcept {
        Vec3& point = points_[edge];
        if (edge == met_) {
            ++met_;
            simd::store(point, said);
        } else {
            simd::store(point, simd::middle(simd::load(point), said));
        }
    }

private:
    Vec3* points_;
    std::uint32_t met_ = 0;
};

}  // namespace knotwork
