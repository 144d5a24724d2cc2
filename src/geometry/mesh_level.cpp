#include "geometry/mesh_level.hpp"

#include "geometry/mesh_creases.hpp"
#include "geometry/mesh_fans.hpp"

#include <algorithm>
#include <utility>

namespace knotwork {

MeshLevel firstLevel(const Mesh& mesh) {
    MeshLevel level;
    level.points = mesh.points();
    level.faces = mesh.faces();
    level.cornerEdges = mesh.cornerEdges();
    level.edges = mesh.edges().size();
    level.boundary = boundaryOf(mesh);
    level.creases = creasesOf(mesh);
    level.valences.assign(level.points.size(), 0);
    for (const std::uint32_t vertex : level.faces.corners) ++level.valences[vertex];
    return level;
}

MeshLevel ownLevel(RawArray<Vec3> points, RawArray<std::uint32_t> corners,
                   std::uint32_t size) {
    MeshLevel level;
    level.ownPoints = std::move(points);
    level.ownCorners = std::move(corners);
    level.points = level.ownPoints;
    level.faces = {level.ownCorners, {}, size};
    return level;
}

std::vector<BoundaryEdge> boundaryOf(const Mesh& mesh) {
    const auto edges = mesh.edges();
    std::vector<BoundaryEdge> boundary;
    if (std::none_of(edges.begin(), edges.end(),
                     [](const MeshEdge& edge) { return edge.onBoundary(); })) {
        return boundary;
    }
    const CornerWalk walk(mesh.faces(), mesh.cornerEdges(), edges.size());
    std::vector<std::uint32_t> numbers(edges.size());  // of the boundary edges
    std::vector<std::uint32_t> fans(mesh.points().size(), 0);
    for (std::uint32_t c = 0; c < walk.corners(); ++c) {
        if (walk.twin(c) != noCorner) continue;
        numbers[mesh.cornerEdges()[c]] = static_cast<std::uint32_t>(boundary.size());
        boundary.push_back({c, 0, 0, 1});
        ++fans[walk.vertex(c)];
    }
    std::vector<std::uint32_t> corners;
    for (std::uint32_t b = 0; b < boundary.size(); ++b) {
        BoundaryEdge& edge = boundary[b];
        edge.fans = fans[walk.vertex(edge.corner)];
        walkFan(walk, edge.corner, corners);
        edge.before = numbers[mesh.cornerEdges()[walk.previous(corners.back())]];
        boundary[edge.before].after = b;
    }
    return boundary;
}

void refineCubicBoundary(const MeshLevel& level, std::span<Vec3> vertexPoints,
                         std::span<Vec3> edgePoints) noexcept {
    const auto points = level.points;
    for (const BoundaryEdge& edge : level.boundary) {
        const std::uint32_t v = level.from(edge);
        vertexPoints[v] = points[v];
        edgePoints[level.cornerEdges[edge.corner]] = 0.5 * (points[v] + points[level.to(edge)]);
    }
    for (const BoundaryEdge& edge : level.boundary) {
        const std::uint32_t v = level.from(edge);
        const Vec3 before = points[level.from(level.boundary[edge.before])] - points[v];
        const Vec3 after = points[level.to(edge)] - points[v];
        vertexPoints[v] += (before + after) * (0.125 / edge.fans);
    }
}

}  // namespace knotwork
