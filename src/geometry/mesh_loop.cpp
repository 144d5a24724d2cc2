#include "geometry/mesh_creases.hpp"
#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

// C. Loop, Smooth subdivision surfaces based on triangles, 1987.
//
// An edge's point is 3/8 (a + b) + 1/8 (c + d), c and d the vertices across it: each of its faces
// says m + (c − m)/4 with m = (a + b)/2. A vertex of n faces moves by β Σ (v_j − v), of which each
// face says (p + q)/2 − v, p and q being its other two vertices.

namespace knotwork {

double loopWeight(std::uint32_t valence) noexcept {
    if (valence == 0) return 0;
    if (valence == 6) return 0.0625;
    const double n = valence;
    const double a = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    return (0.625 - a * a) / n;
}

namespace {

using simd::load;
using simd::middle;
using simd::PointLanes;
using simd::store;

void gatherTriangle(const Vec3* points, const std::uint32_t* corners, const std::uint32_t* edges,
                    Vec3* vertices, EdgePoints& edgePoints) noexcept {
    const PointLanes v[3] = {load(points[corners[0]]), load(points[corners[1]]),
                             load(points[corners[2]])};
    const PointLanes middles[3] = {middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
    for (std::size_t k = 0; k < 3; ++k) {
        edgePoints.add(edges[k], middles[k] + 0.25 * (v[(k + 2) % 3] - middles[k]));
        Vec3& sum = vertices[corners[k]];
        store(sum, load(sum) + (middles[(k + 1) % 3] - v[k]));
    }
}

/// Turns the sums into points.
void moveVertices(const MeshLevel& level, Vec3* vertices) noexcept {
    const std::size_t special = level.valences.size();
    for (std::size_t i = 0; i < special; ++i) {
        vertices[i] = level.points[i] + vertices[i] * loopWeight(level.valences[i]);
    }
    for (std::size_t i = special; i < level.points.size(); ++i) {
        store(vertices[i], load(level.points[i]) + 0.0625 * load(vertices[i]));
    }
}

RawArray<Vec3> finerPoints(const MeshLevel& level) {
    const std::size_t vertices = level.points.size();
    RawArray<Vec3> finer(vertices + level.edges);
    std::fill_n(finer.data(), vertices, Vec3{0});
    Vec3* ofEdges = finer.data() + vertices;
    EdgePoints edgePoints(ofEdges);
    const std::uint32_t* corners = level.faces.corners.data();
    const std::uint32_t* edges = level.cornerEdges.data();
    for (std::size_t c = 0; c < level.faces.corners.size(); c += 3) {
        gatherTriangle(level.points.data(), corners + c, edges + c, finer.data(), edgePoints);
    }
    moveVertices(level, finer.data());
    refineCubicBoundary(level, {finer.data(), vertices}, {ofEdges, level.edges});
    refineCreases(level, {finer.data(), vertices}, {ofEdges, level.edges});
    return finer;
}

}  // namespace

Mesh subdivideLoop(const Mesh& mesh, int levels) {
    MeshLevel level = firstLevel(mesh);
    for (int done = 1; done < levels; ++done) level = quarteredLevel(level, finerPoints(level));
    RawArray<Vec3> points = finerPoints(level);
    const Mesh finer = Mesh::trusted(std::move(points), quarteredTriangles(level), 3U);
    return withHalvedCreases(finer, level, static_cast<std::uint32_t>(level.points.size()));
}

}  // namespace knotwork
