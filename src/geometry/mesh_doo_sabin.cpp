#include "geometry/mesh_fans.hpp"
#include "geometry/mesh_schemes.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

// D. Doo, M. Sabin, Behaviour of recursive division surfaces near extraordinary points, 1978.
//
// Every corner of a face of n vertices becomes a point, Σ a_j v_j from that corner on, with a_0 =
// 1/4 + 5/(4n) and a_j = (3 + 2 cos(2πj/n)) / (4n): with the centroid c and the rays r = v − c,
//     c + r_k/4 + Σ cos(2π(j − k)/n) r_j / (2n).
// The points of a face are a face again, those around an edge too, and those around a vertex. On a
// boundary edge from a to b lie two points more, (3a + b)/4 and (a + 3b)/4, as if there were a face
// beyond it without any area.

namespace knotwork {

namespace {

/// (9, 3, 1, 3)/16 of four, (4, 1, 1)/6 of three.
Vec3 fewPoint(const std::array<Vec3, 4>& v, std::size_t size, std::size_t k) noexcept {
    const Vec3 own = v[k];
    const Vec3 beside = (v[(k + 1) % size] - own) + (v[(k + size - 1) % size] - own);
    if (size == 3) return own + beside * (1.0 / 6);
    return own + (3.0 * beside + (v[(k + 2) % size] - own)) * 0.0625;
}

void addFacePoints(std::span<const Vec3> points, std::span<const std::uint32_t> face, Vec3* to) {
    const std::size_t size = face.size();
    if (size <= 4) {
        std::array<Vec3, 4> v{};
        for (std::size_t k = 0; k < size; ++k) v[k] = points[face[k]];
        for (std::size_t k = 0; k < size; ++k) to[k] = fewPoint(v, size, k);
        return;
    }
    const double n = static_cast<double>(size);
    const Vec3 first = points[face[0]];
    Vec3 sum{0};
    for (const std::uint32_t vertex : face) sum += points[vertex] - first;
    const Vec3 centroid = first + sum / n;
    const double step = 2 * std::numbers::pi / n;
    Vec3 cosines{0};
    Vec3 sines{0};
    for (std::size_t j = 0; j < size; ++j) {
        const Vec3 ray = points[face[j]] - centroid;
        cosines += std::cos(step * static_cast<double>(j)) * ray;
        sines += std::sin(step * static_cast<double>(j)) * ray;
    }
    for (std::size_t k = 0; k < size; ++k) {
        const double angle = step * static_cast<double>(k);
        to[k] = centroid + 0.25 * (points[face[k]] - centroid) +
                (std::cos(angle) * cosines + std::sin(angle) * sines) / (2 * n);
    }
}

std::vector<Vec3> finerPoints(const Mesh& mesh, std::span<const BoundaryEdge> boundary) {
    const auto points = mesh.points();
    const FaceRows faces = mesh.faces();
    const std::size_t corners = faces.corners.size();
    std::vector<Vec3> finer(corners + 2 * boundary.size());
    for (std::size_t f = 0; f < faces.count(); ++f) {
        addFacePoints(points, faces[f], finer.data() + faces.begin(f));
    }
    Vec3* to = finer.data() + corners;
    for (const BoundaryEdge& edge : boundary) {
        const Vec3 a = points[faces.corners[edge.corner]];
        const Vec3 b = points[faces.corners[boundary[edge.after].corner]];
        *to++ = a + 0.25 * (b - a);
        *to++ = b + 0.25 * (a - b);
    }
    return finer;
}

/// Face after face.
struct Rows {
    std::vector<std::uint32_t> corners{};
    std::vector<std::uint32_t> starts{0};

    void end() { starts.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Quads around the edges, in the order of the edges.
void addEdgeFaces(const Mesh& mesh, const CornerWalk& walk, Rows& rows) {
    const auto edges = mesh.cornerEdges();
    std::size_t met = 0;
    auto boundaryPoint = static_cast<std::uint32_t>(edges.size());
    for (std::uint32_t c = 0; c < edges.size(); ++c) {
        if (edges[c] != met) continue;
        ++met;
        const std::uint32_t twin = walk.twin(c);
        if (twin == noCorner) {
            rows.corners.insert(rows.corners.end(),
                                {c, boundaryPoint, boundaryPoint + 1, walk.next(c)});
            boundaryPoint += 2;
        } else {
            rows.corners.insert(rows.corners.end(), {c, walk.next(twin), twin, walk.next(c)});
        }
        rows.end();
    }
}

/// A corner to begin each fan with, fans in the order of their vertices.
std::vector<std::uint32_t> fanStarts(const CornerWalk& walk, std::size_t vertices) {
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> places(vertices + 1, 0);
    forEachFan(walk, [&](const Fan& fan) {
        found.push_back(fan.corners.front());
        ++places[fan.vertex + 1];
    });
    for (std::size_t v = 0; v < vertices; ++v) places[v + 1] += places[v];
    std::vector<std::uint32_t> sorted(found.size());
    for (const std::uint32_t corner : found) sorted[places[walk.vertex(corner)]++] = corner;
    return sorted;
}

/// Faces around the vertices, fan by fan; open ones end with the points on the boundary. Two faces
/// around a vertex leave nothing between them.
void addVertexFaces(const Mesh& mesh, const CornerWalk& walk,
                    std::span<const BoundaryEdge> boundary, Rows& rows) {
    const auto edges = mesh.cornerEdges();
    std::vector<std::uint32_t> numbers(boundary.empty() ? 0 : mesh.edges().size());
    for (std::uint32_t b = 0; b < boundary.size(); ++b) numbers[edges[boundary[b].corner]] = b;
    const auto firstBoundary = static_cast<std::uint32_t>(edges.size());
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t start : fanStarts(walk, mesh.points().size())) {
        const bool closed = walkFan(walk, start, corners);
        if (closed && corners.size() < 3) continue;
        rows.corners.insert(rows.corners.end(), corners.begin(), corners.end());
        if (!closed) {
            const std::uint32_t edge = numbers[edges[start]];
            rows.corners.push_back(firstBoundary + 2 * boundary[edge].before + 1);
            rows.corners.push_back(firstBoundary + 2 * edge);
        }
        rows.end();
    }
}

Mesh finerMesh(const Mesh& mesh) {
    const std::vector<BoundaryEdge> boundary = boundaryOf(mesh);
    const FaceRows faces = mesh.faces();
    const CornerWalk walk(faces, mesh.cornerEdges(), mesh.edges().size());
    Rows rows;
    rows.corners.reserve(4 * (faces.corners.size() + boundary.size()));
    rows.starts.reserve(faces.count() + mesh.edges().size() + mesh.points().size() + 1);
    for (std::uint32_t f = 0; f < faces.count(); ++f) {
        for (std::size_t c = faces.begin(f); c < faces.begin(f + 1); ++c) {
            rows.corners.push_back(static_cast<std::uint32_t>(c));
        }
        rows.end();
    }
    addEdgeFaces(mesh, walk, rows);
    addVertexFaces(mesh, walk, boundary, rows);
    return Mesh::trusted(finerPoints(mesh, boundary), std::move(rows.corners),
                         std::move(rows.starts));
}

}  // namespace

Mesh subdivideDooSabin(const Mesh& mesh, int levels) {
    Mesh finer = mesh;
    for (int done = 0; done < levels; ++done) finer = finerMesh(finer);
    return finer;
}

}  // namespace knotwork
