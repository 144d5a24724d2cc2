#include "geometry/mesh_fans.hpp"
#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

// L. Kobbelt, √3-subdivision, 2000.
//
// Every triangle gets its centre, every old inner edge is turned to join the centres of its two
// triangles, and a vertex of n triangles moves by α to the mean of its neighbours. Half-edge h from
// v with the centres c before and C behind it becomes the triangle v, C, c: number h again, so that
// all that lies together is known by counting.
//
// Boundary edges are not turned. In every second level they are cut in three by the rule of the
// uniform cubic B-spline, (1, 4, 10, 16, 19, 16, 10, 4, 1)/27: the triangle a, b, s on the edge a b
// has no centre then but the new points p next to a and q next to b; its other edges look at that
// one which is nearer, and p, q, s is its own triangle. In the level before, no vertex of the
// boundary moves, and no triangle keeps more than one boundary edge.

namespace knotwork {

double sqrt3Weight(std::uint32_t valence) noexcept {
    if (valence == 0) return 0;
    if (valence == 6) return 1.0 / 3;
    return (4 - 2 * std::cos(2 * std::numbers::pi / valence)) / 9;
}

namespace {

using simd::load;
using simd::middle;
using simd::PointLanes;
using simd::store;

/// Marks, among the corners' twins, that there is none; the other bits say which boundary edge it
/// is.
constexpr std::uint32_t boundaryMark = 0x80000000U;

struct Triangles {
    RawArray<Vec3> points;
    RawArray<std::uint32_t> corners;
    RawArray<std::uint32_t> twins;
    std::vector<std::uint32_t> valences;
    std::vector<BoundaryEdge> boundary;

    [[nodiscard]] std::size_t faces() const noexcept { return corners.size() / 3; }
    [[nodiscard]] bool onBoundary(std::uint32_t corner) const noexcept {
        step();
        return (twins[corner] & boundaryMark) != 0;
    }
    [[nodiscard]] std::uint32_t from(const BoundaryEdge& edge) const noexcept {
        return corners[edge.corner];
    }
    [[nodiscard]] std::uint32_t to(const BoundaryEdge& edge) const noexcept {
        return from(boundary[edge.after]);
    }
};

std::uint32_t next(std::uint32_t corner) noexcept {
    step();
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::uint32_t previous(std::uint32_t corner) noexcept {
    step();
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

Triangles trianglesOf(const Mesh& mesh) {
    Triangles t;
    t.points = RawArray<Vec3>(mesh.points().size());
    t.corners = RawArray<std::uint32_t>(mesh.corners().size());
    std::copy(mesh.points().begin(), mesh.points().end(), t.points.begin());
    std::copy(mesh.corners().begin(), mesh.corners().end(), t.corners.begin());
    t.boundary = boundaryOf(mesh);
    const CornerWalk walk(mesh.faces(), mesh.cornerEdges(), mesh.edges().size());
    t.twins = RawArray<std::uint32_t>(t.corners.size());
    for (std::size_t c = 0; c < t.corners.size(); ++c) t.twins[c] = walk.twin(c);
    for (std::uint32_t b = 0; b < t.boundary.size(); ++b) {
        t.twins[t.boundary[b].corner] = boundaryMark | b;
    }
    t.valences.assign(t.points.size(), 0);
    for (const std::uint32_t vertex : t.corners) ++t.valences[vertex];
    return t;
}

// ---- Points ------------------------------------------------------------------------------------

/// Moved vertices and centres, as if there were no boundary.
RawArray<Vec3> innerPoints(const Triangles& t, std::size_t extra) {
    const std::size_t vertices = t.points.size();
    RawArray<Vec3> finer(vertices + t.faces() + extra);
    std::fill_n(finer.data(), vertices, Vec3{0});
    for (std::size_t f = 0; f < t.faces(); ++f) {
        const std::uint32_t* c = t.corners.data() + 3 * f;
        const std::array<PointLanes, 3> v{load(t.points[c[0]]), load(t.points[c[1]]),
                                          load(t.points[c[2]])};
        store(finer[vertices + f], v[0] + (1.0 / 3) * ((v[1] - v[0]) + (v[2] - v[0])));
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3& sum = finer[c[k]];
            store(sum, load(sum) + (middle(v[(k + 1) % 3], v[(k + 2) % 3]) - v[k]));
        }
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        const std::uint32_t n = t.valences[i];
        const double weight = n == 6 ? 1.0 / 18 : n > 0 ? sqrt3Weight(n) / n : 0.0;
        store(finer[i], load(t.points[i]) + weight * load(finer[i]));
    }
    for (const BoundaryEdge& edge : t.boundary) finer[t.from(edge)] = t.points[t.from(edge)];
    return finer;
}

/// The boundary cut in three: p takes the place of its triangle's centre, q comes behind all
/// others.
void refineBoundary(const Triangles& t, RawArray<Vec3>& finer) noexcept {
    const std::size_t vertices = t.points.size();
    for (std::size_t b = 0; b < t.boundary.size(); ++b) {
        const BoundaryEdge& edge = t.boundary[b];
        const Vec3 v = t.points[t.from(edge)];
        const Vec3 w = t.points[t.to(edge)];
        const Vec3 before = t.points[t.from(t.boundary[edge.before])];
        const Vec3 after = t.points[t.to(t.boundary[edge.after])];
        finer[t.from(edge)] += ((before - v) + (w - v)) * (4.0 / (27.0 * edge.fans));
        finer[vertices + edge.corner / 3] = v + (10.0 * (w - v) + (before - v)) / 27.0;
        finer[vertices + t.faces() + b] = w + (10.0 * (v - w) + (after - w)) / 27.0;
    }
}

// ---- Levels that leave the boundary as it is ---------------------------------------------------

RawArray<std::uint32_t> turnedCorners(const Triangles& t) {
    const auto firstFace = static_cast<std::uint32_t>(t.points.size());
    RawArray<std::uint32_t> finer(3 * t.corners.size());
    std::uint32_t* to = finer.data();
    for (std::uint32_t c = 0; c < t.corners.size(); ++c, to += 3) {
        to[0] = t.corners[c];
        to[1] = t.onBoundary(c) ? t.corners[next(c)] : firstFace + t.twins[c] / 3;
        to[2] = firstFace + c / 3;
    }
    return finer;
}

RawArray<std::uint32_t> turnedTwins(const Triangles& t) {
    RawArray<std::uint32_t> finer(3 * t.corners.size());
    std::uint32_t* to = finer.data();
    for (std::uint32_t c = 0; c < t.corners.size(); ++c, to += 3) {
        const std::uint32_t twin = t.twins[c];
        const std::uint32_t behind = previous(c);
        to[0] = t.onBoundary(c) ? twin : 3 * next(twin) + 2;
        to[1] = t.onBoundary(c) ? 3 * next(c) + 2 : 3 * twin + 1;
        to[2] = t.onBoundary(behind) ? 3 * behind + 1 : 3 * t.twins[behind];
    }
    return finer;
}

Triangles turned(const Triangles& t) {
    Triangles finer;
    finer.points = innerPoints(t, 0);
    finer.corners = turnedCorners(t);
    finer.twins = turnedTwins(t);
    finer.valences = t.valences;
    finer.valences.resize(finer.points.size(), 6);
    finer.boundary = t.boundary;
    for (BoundaryEdge& edge : finer.boundary) {
        --finer.valences[t.points.size() + edge.corner / 3];  // one triangle there, not two
        edge.corner *= 3;
    }
    return finer;
}

// ---- Levels that cut it in three ---------------------------------------------------------------

/// What an inner half-edge sees for the centre of its triangle.
std::uint32_t centreAt(const Triangles& t, std::uint32_t corner) noexcept {
    const auto vertices = static_cast<std::uint32_t>(t.points.size());
    const std::uint32_t before = t.twins[previous(corner)];
    if ((before & boundaryMark) == 0) return vertices + corner / 3;
    return static_cast<std::uint32_t>(vertices + t.faces()) + (before & ~boundaryMark);
}

RawArray<std::uint32_t> cutCorners(const Triangles& t) {
    RawArray<std::uint32_t> finer(3 * t.corners.size());
    std::uint32_t* to = finer.data();
    for (std::uint32_t c = 0; c < t.corners.size(); ++c, to += 3) {
        const bool cut = t.onBoundary(c);
        to[0] = cut ? centreAt(t, previous(c)) : t.corners[c];
        to[1] = cut ? centreAt(t, next(c)) : centreAt(t, t.twins[c]);
        to[2] = cut ? t.corners[previous(c)] : centreAt(t, c);
    }
    return finer;
}

/// The three parts of boundary edge b begin at these corners.
std::array<std::uint32_t, 3> cutParts(const Triangles& t, const BoundaryEdge& edge) noexcept {
    return {3 * t.twins[previous(edge.corner)], 3 * edge.corner, 3 * next(edge.corner) + 2};
}

RawArray<std::uint32_t> cutTwins(const Triangles& t) {
    RawArray<std::uint32_t> finer = turnedTwins(t);
    for (std::uint32_t b = 0; b < t.boundary.size(); ++b) {
        const std::uint32_t edge = t.boundary[b].corner;
        const std::uint32_t after = next(edge);
        const std::uint32_t behind = previous(edge);
        finer[3 * edge + 1] = 3 * t.twins[after];
        finer[3 * t.twins[after]] = 3 * edge + 1;
        finer[3 * edge + 2] = 3 * behind + 2;
        finer[3 * behind + 2] = 3 * edge + 2;
        const auto parts = cutParts(t, t.boundary[b]);
        for (std::uint32_t i = 0; i < 3; ++i) finer[parts[i]] = boundaryMark | (3 * b + i);
    }
    return finer;
}

std::vector<BoundaryEdge> cutBoundary(const Triangles& t) {
    std::vector<BoundaryEdge> finer;
    finer.reserve(3 * t.boundary.size());
    for (std::uint32_t b = 0; b < t.boundary.size(); ++b) {
        const BoundaryEdge& edge = t.boundary[b];
        const auto parts = cutParts(t, edge);
        finer.push_back({parts[0], 3 * edge.before + 2, 3 * b + 1, edge.fans});
        finer.push_back({parts[1], 3 * b, 3 * b + 2, 1});
        finer.push_back({parts[2], 3 * b + 1, 3 * edge.after, 1});
    }
    return finer;
}

/// Boundary edges in the order of their corners again, as their points are.
void sortBoundary(Triangles& t) {
    std::vector<std::uint32_t> places(t.boundary.size());
    std::uint32_t place = 0;
    for (std::uint32_t& twin : t.twins) {
        if ((twin & boundaryMark) == 0) continue;
        places[twin & ~boundaryMark] = place;
        twin = boundaryMark | place++;
    }
    std::vector<BoundaryEdge> sorted(t.boundary.size());
    for (std::size_t b = 0; b < sorted.size(); ++b) {
        const BoundaryEdge& edge = t.boundary[b];
        sorted[places[b]] = {edge.corner, places[edge.before], places[edge.after], edge.fans};
    }
    t.boundary = std::move(sorted);
}

Triangles cut(const Triangles& t) {
    Triangles finer;
    finer.points = innerPoints(t, t.boundary.size());
    refineBoundary(t, finer.points);
    finer.corners = cutCorners(t);
    finer.twins = cutTwins(t);
    finer.valences = t.valences;
    finer.valences.resize(finer.points.size(), 6);
    for (const BoundaryEdge& edge : t.boundary) {
        ++finer.valences[t.corners[previous(edge.corner)]];  // the triangle p, q, s
    }
    finer.boundary = cutBoundary(t);
    sortBoundary(finer);
    return finer;
}

}  // namespace

Mesh subdivideSqrt3(const Mesh& mesh, int levels) {
    Triangles t = trianglesOf(mesh);
    const auto cuts = [&](int level) { return level % 2 == 0 && !t.boundary.empty(); };
    for (int level = 1; level < levels; ++level) t = cuts(level) ? cut(t) : turned(t);
    if (!cuts(levels)) return Mesh::trusted(innerPoints(t, 0), turnedCorners(t), 3U);
    RawArray<Vec3> points = innerPoints(t, t.boundary.size());
    refineBoundary(t, points);
    return Mesh::trusted(std::move(points), cutCorners(t), 3U);
}

}  // namespace knotwork
