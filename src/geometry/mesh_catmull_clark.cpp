#include "geometry/mesh_creases.hpp"
#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <array>

// E. Catmull, J. Clark, Recursively generated B-spline surfaces on arbitrary topological meshes,
// 1978.
//
// With the face points f (centroids), an edge's point is (a + b + f + g) / 4, and a vertex v of n
// faces moves to (F + 2R + (n − 3) v) / n, F the mean of its face points and R that of the middles
// of its edges. With what each face says of the vertex v between p and q,
//     v + Σ (f + (p + q)/2 − 2v) / n²,
// and of its edge, ((a + b)/2 + f) / 2, everything is gathered in one walk along the faces.

namespace knotwork {

namespace {

using simd::load;
using simd::middle;
using simd::PointLanes;
using simd::store;

/// The three parts of the finer points; those of vertices hold sums at first.
struct Parts {
    Vec3* vertices;
    Vec3* faces;
    EdgePoints edges;
};

void addTo(Vec3& sum, const PointLanes& said) noexcept { store(sum, load(sum) + said); }

void gatherQuad(const Vec3* points, const std::uint32_t* corners, const std::uint32_t* edges,
                std::size_t face, Parts& to) noexcept {
    const std::array<PointLanes, 4> v{load(points[corners[0]]), load(points[corners[1]]),
                                      load(points[corners[2]]), load(points[corners[3]])};
    const std::array<PointLanes, 4> middles{middle(v[0], v[1]), middle(v[1], v[2]),
                                            middle(v[2], v[3]), middle(v[3], v[0])};
    const PointLanes f = middle(middles[0], middles[2]);
    store(to.faces[face], f);
    for (std::size_t k = 0; k < 4; ++k) to.edges.add(edges[k], middle(middles[k], f));
    const PointLanes even = f + middle(v[1], v[3]);
    const PointLanes odd = f + middle(v[0], v[2]);
    addTo(to.vertices[corners[0]], even - 2.0 * v[0]);
    addTo(to.vertices[corners[1]], odd - 2.0 * v[1]);
    addTo(to.vertices[corners[2]], even - 2.0 * v[2]);
    addTo(to.vertices[corners[3]], odd - 2.0 * v[3]);
}

void gatherFace(const Vec3* points, const std::uint32_t* corners, const std::uint32_t* edges,
                std::size_t size, std::size_t face, Parts& to) noexcept {
    const PointLanes first = load(points[corners[0]]);
    PointLanes sum = load(Vec3{0});
    for (std::size_t k = 1; k < size; ++k) sum = sum + (load(points[corners[k]]) - first);
    const PointLanes f = first + (1.0 / static_cast<double>(size)) * sum;
    store(to.faces[face], f);
    PointLanes before = load(points[corners[size - 1]]);
    PointLanes v = first;
    for (std::size_t k = 0; k < size; ++k) {
        const PointLanes after = load(points[corners[k + 1 < size ? k + 1 : 0]]);
        to.edges.add(edges[k], middle(middle(v, after), f));
        addTo(to.vertices[corners[k]], f + middle(before, after) - 2.0 * v);
        before = v;
        v = after;
    }
}

/// Turns the sums into points.
void moveVertices(const MeshLevel& level, Vec3* vertices) noexcept {
    const std::size_t special = level.valences.size();
    for (std::size_t i = 0; i < special; ++i) {
        const double n = level.valences[i];
        vertices[i] = level.points[i] + vertices[i] * (n > 0 ? 1 / (n * n) : 0.0);
    }
    for (std::size_t i = special; i < level.points.size(); ++i) {
        store(vertices[i], load(level.points[i]) + 0.0625 * load(vertices[i]));
    }
}

RawArray<Vec3> finerPoints(const MeshLevel& level) {
    const std::size_t vertices = level.points.size();
    const std::size_t faces = level.faces.count();
    RawArray<Vec3> finer(vertices + faces + level.edges);
    std::fill_n(finer.data(), vertices, Vec3{0});
    Vec3* edgePoints = finer.data() + vertices + faces;
    Parts to{finer.data(), finer.data() + vertices, EdgePoints(edgePoints)};
    const Vec3* points = level.points.data();
    visitFaces(level.faces, [&](std::size_t face, std::size_t begin, auto size) {
        const std::uint32_t* corners = level.faces.corners.data() + begin;
        const std::uint32_t* edges = level.cornerEdges.data() + begin;
        if (size == 4) {
            gatherQuad(points, corners, edges, face, to);
        } else {
            gatherFace(points, corners, edges, size, face, to);
        }
    });
    moveVertices(level, finer.data());
    refineCubicBoundary(level, {finer.data(), vertices}, {edgePoints, level.edges});
    refineCreases(level, {finer.data(), vertices}, {edgePoints, level.edges});
    return finer;
}

std::uint32_t firstEdgePoint(const MeshLevel& level) noexcept {
    return static_cast<std::uint32_t>(level.points.size() + level.faces.count());
}

/// Corner k of a face becomes the quad v_k, e_k, f, e_{k−1}.
RawArray<std::uint32_t> finerCorners(const MeshLevel& level) {
    const auto firstFace = static_cast<std::uint32_t>(level.points.size());
    const std::uint32_t firstEdge = firstEdgePoint(level);
    RawArray<std::uint32_t> finer(4 * level.faces.corners.size());
    std::uint32_t* to = finer.data();
    visitFaces(level.faces, [&](std::size_t face, std::size_t begin, auto size) {
        const std::uint32_t* corners = level.faces.corners.data() + begin;
        const std::uint32_t* edges = level.cornerEdges.data() + begin;
        std::uint32_t before = firstEdge + edges[size - 1];
        for (std::size_t k = 0; k < size; ++k, to += 4) {
            const std::uint32_t after = firstEdge + edges[k];
            to[0] = corners[k];
            to[1] = after;
            to[2] = firstFace + static_cast<std::uint32_t>(face);
            to[3] = before;
            before = after;
        }
    });
    return finer;
}

/// The edges of those quads: half of e_k, the edge inside from e_k, that from e_{k−1}, half of it.
RawArray<std::uint32_t> finerCornerEdges(const MeshLevel& level, FinerEdges& numbers) {
    RawArray<std::uint32_t> finer(4 * level.faces.corners.size());
    std::uint32_t* to = finer.data();
    visitFaces(level.faces, [&](std::size_t, std::size_t begin, auto size) {
        const std::uint32_t* edges = level.cornerEdges.data() + begin;
        to[0] = numbers.firstHalf(edges[0]);
        to[1] = numbers.inside();
        const std::uint32_t last = numbers.inside();
        to[2] = last;
        to[3] = numbers.secondHalf(edges[size - 1]);
        for (std::size_t k = 1; k < size; ++k) {
            to[4] = numbers.firstHalf(edges[k]);
            to[5] = k + 1 < size ? numbers.inside() : last;
            to[6] = to[1];
            to[7] = numbers.secondHalf(edges[k - 1]);
            to += 4;
        }
        to += 4;
        numbers.endFace();
    });
    return finer;
}

/// The valences of a level whose faces are not all quads: their points have as many faces as they
/// have corners.
std::vector<std::uint32_t> finerValences(const MeshLevel& level) {
    std::vector<std::uint32_t> valences = level.valences;
    if (level.faces.uniformSize == 4) return valences;
    for (std::size_t f = 0; f < level.faces.count(); ++f) {
        valences.push_back(static_cast<std::uint32_t>(level.faces[f].size()));
    }
    return valences;
}

/// The corner after a corner in its face.
std::uint32_t following(const FaceRows& faces, std::uint32_t corner) noexcept {
    if (faces.uniformSize != 0) {
        const std::uint32_t size = faces.uniformSize;
        return corner % size + 1 < size ? corner + 1 : corner + 1 - size;
    }
    const auto end = std::upper_bound(faces.starts.begin(), faces.starts.end(), corner);
    return corner + 1 < *end ? corner + 1 : *(end - 1);
}

MeshLevel finerLevel(const MeshLevel& level) {
    MeshLevel finer = ownLevel(finerPoints(level), finerCorners(level), 4);
    FinerEdges numbers(level.edges);
    finer.ownCornerEdges = finerCornerEdges(level, numbers);
    finer.cornerEdges = finer.ownCornerEdges;
    finer.edges = numbers.count();
    finer.valences = finerValences(level);
    finer.creases = halvedCreases(level, firstEdgePoint(level), numbers);
    finer.boundary = halvedBoundary(
        level.boundary, [](std::uint32_t corner) { return 4 * corner; },
        [&](std::uint32_t corner) { return 4 * following(level.faces, corner) + 3; });
    return finer;
}

}  // namespace

Mesh subdivideCatmullClark(const Mesh& mesh, int levels) {
    MeshLevel level = firstLevel(mesh);
    for (int done = 1; done < levels; ++done) level = finerLevel(level);
    const Mesh finer = Mesh::trusted(finerPoints(level), finerCorners(level), 4U);
    return withHalvedCreases(finer, level, firstEdgePoint(level));
}

}  // namespace knotwork
