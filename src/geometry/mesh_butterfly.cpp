#include "geometry/mesh_fans.hpp"
#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

// D. Zorin, P. Schröder, W. Sweldens, Interpolating subdivision for meshes with arbitrary topology,
// 1996; the rules on boundaries from D. Zorin, P. Schröder, Subdivision for modeling and animation
// (course notes), 2000, section 4.3.
//
// Vertices stay. Between two vertices of valence 6 an edge's point is
//     (a + b)/2 + (c + d)/8 − (w_1 + w_2 + w_3 + w_4)/16,
// c and d the vertices across the edge, w those across the other edges of its two triangles. A
// vertex of another valence K has stencils of its own for the edges around it, v + Σ_j s_{j−i} (x_j
// − v), as has one on the boundary. Between two such vertices the point is the mean of what both
// say. Edges on a boundary have the four-point rule.

namespace knotwork {

namespace {

using simd::load;
using simd::middle;
using simd::PointLanes;

// ---- Where all is regular ----------------------------------------------------------------------

void gatherTriangle(const MeshLevel& level, const CornerWalk& walk, std::size_t begin,
                    EdgePoints& edgePoints) noexcept {
    const auto& corners = level.faces.corners;
    std::array<PointLanes, 3> v;
    std::array<PointLanes, 3> across;  // beyond the edge that begins at the corner
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = load(level.points[corners[begin + k]]);
        const std::uint32_t twin = walk.twin(begin + k);
        // On a boundary anything will do: what is made of it is made again.
        across[k] = twin == noCorner ? v[k] : load(level.points[corners[walk.previous(twin)]]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const PointLanes m = middle(v[k], v[(k + 1) % 3]);
        const PointLanes wings = middle(across[(k + 1) % 3], across[(k + 2) % 3]);
        edgePoints.add(level.cornerEdges[begin + k],
                       m + 0.25 * (v[(k + 2) % 3] - wings));
    }
}

// ---- Around other vertices ---------------------------------------------------------------------

/// A vertex with its neighbours in order, seen from it.
struct Ring {
    Vec3 centre{0};
    std::vector<Vec3> rays{};
    std::vector<std::uint32_t> edges{};
    std::vector<std::uint32_t> corners{};
};

bool gatherRing(const MeshLevel& level, const CornerWalk& walk, std::uint32_t first, Ring& ring) {
    const bool closed = walkFan(walk, first, ring.corners);
    ring.centre = level.points[walk.vertex(first)];
    ring.rays.clear();
    ring.edges.clear();
    for (const std::uint32_t corner : ring.corners) {
        ring.rays.push_back(level.points[walk.neighbour(corner)] - ring.centre);
        ring.edges.push_back(level.cornerEdges[corner]);
    }
    if (!closed) {
        const std::uint32_t last = walk.previous(ring.corners.back());
        ring.rays.push_back(level.points[walk.vertex(last)] - ring.centre);
        ring.edges.push_back(level.cornerEdges[last]);
    }
    return closed;
}

/// The stencils of valences below 5, from the edge at hand on.
std::array<double, 4> fewStencil(std::size_t valence) noexcept {
    if (valence == 2) return {3.0 / 8, -1.0 / 8, 0, 0};
    if (valence == 3) return {5.0 / 12, -1.0 / 12, -1.0 / 12, 0};
    return {3.0 / 8, 0, -1.0 / 8, 0};
}

/// Calls set(i, point) for the edges around an inner vertex. O(K).
template <class Set>
void aroundInner(const Ring& ring, Set set) {
    const std::size_t valence = ring.rays.size();
    if (valence < 5) {
        const std::array<double, 4> stencil = fewStencil(valence);
        for (std::size_t i = 0; i < valence; ++i) {
            Vec3 sum{0};
            for (std::size_t j = 0; j < valence; ++j) {
                sum += stencil[j] * ring.rays[(i + j) % valence];
            }
            set(i, ring.centre + sum);
        }
        return;
    }
    // s_j = (1/4 + cos φ_j + cos(2 φ_j)/2) / K, φ_j = 2πj/K: the first waves of the ring.
    const double step = 2 * std::numbers::pi / static_cast<double>(valence);
    const double share = 1 / static_cast<double>(valence);
    Vec3 mean{0};
    std::array<Vec3, 4> waves{Vec3{0}, Vec3{0}, Vec3{0}, Vec3{0}};
    for (std::size_t j = 0; j < valence; ++j) {
        const double angle = step * static_cast<double>(j);
        const Vec3 ray = ring.rays[j] * share;
        mean += ray;
        waves[0] += std::cos(angle) * ray;
        waves[1] += std::sin(angle) * ray;
        waves[2] += std::cos(2 * angle) * ray;
        waves[3] += std::sin(2 * angle) * ray;
    }
    for (std::size_t i = 0; i < valence; ++i) {
        const double angle = step * static_cast<double>(i);
        set(i, ring.centre + 0.25 * mean + std::cos(angle) * waves[0] + std::sin(angle) * waves[1] +
                   0.5 * (std::cos(2 * angle) * waves[2] + std::sin(2 * angle) * waves[3]));
    }
}

/// The same for the inner edges at a vertex of k triangles on the boundary, θ = π/k. O(k).
template <class Set>
void aroundOuter(const Ring& ring, Set set) {
    const std::size_t k = ring.rays.size() - 1;
    if (k < 2) return;
    const double step = std::numbers::pi / static_cast<double>(k);
    const double share = 1 / static_cast<double>(k);
    std::array<Vec3, 2> waves{Vec3{0}, Vec3{0}};
    for (std::size_t j = 1; j < k; ++j) {
        const double angle = step * static_cast<double>(j);
        waves[0] += std::sin(angle) * share * ring.rays[j];
        waves[1] += std::sin(2 * angle) * share * ring.rays[j];
    }
    const Vec3 along = ring.rays[0] - ring.rays[k];
    const double bend = 0.25 * share * std::sin(2 * step) / (std::cos(step) - std::cos(2 * step));
    for (std::size_t i = 1; i < k; ++i) {
        const double angle = step * static_cast<double>(i);
        const double outer = 0.25 * std::cos(angle) - bend * std::sin(2 * angle);
        set(i, ring.centre + outer * along + std::sin(angle) * waves[0] +
                   0.5 * std::sin(2 * angle) * waves[1]);
    }
}

/// Puts the points around irregular vertices and those on the boundary in place.
class IrregularPoints {
public:
    IrregularPoints(const MeshLevel& level, const CornerWalk& walk, Vec3* edgePoints)
        : level_(level), walk_(walk), points_(edgePoints), said_(level.edges, false) {}

    void add(std::span<const std::uint32_t> innerCorners) {
        const auto set = [this](std::size_t i, const Vec3& point) { say(ring_.edges[i], point); };
        for (const std::uint32_t corner : innerCorners) {
            gatherRing(level_, walk_, corner, ring_);
            aroundInner(ring_, set);
        }
        for (const BoundaryEdge& edge : level_.boundary) {
            gatherRing(level_, walk_, edge.corner, ring_);
            aroundOuter(ring_, set);
        }
        for (const BoundaryEdge& edge : level_.boundary) {
            points_[level_.cornerEdges[edge.corner]] = fourPoint(edge);
        }
    }

private:
    void say(std::uint32_t edge, const Vec3& point) {
        points_[edge] = said_[edge] ? 0.5 * (points_[edge] + point) : point;
        said_[edge] = true;
    }

    [[nodiscard]] Vec3 fourPoint(const BoundaryEdge& edge) const noexcept {
        const auto& boundary = level_.boundary;
        const auto points = level_.points;
        const Vec3 m = 0.5 * (points[level_.from(edge)] + points[level_.to(edge)]);
        const Vec3 outer = 0.5 * (points[level_.from(boundary[edge.before])] +
                                  points[level_.to(boundary[edge.after])]);
        return m + 0.125 * (m - outer);
    }

    const MeshLevel& level_;
    const CornerWalk& walk_;
    Vec3* points_;
    std::vector<bool> said_;
    Ring ring_;
};

// ---- A level -----------------------------------------------------------------------------------

RawArray<Vec3> finerPoints(const MeshLevel& level, std::span<const std::uint32_t> irregular) {
    const std::size_t vertices = level.points.size();
    RawArray<Vec3> finer(vertices + level.edges);
    std::copy(level.points.begin(), level.points.end(), finer.begin());
    Vec3* ofEdges = finer.data() + vertices;
    const CornerWalk walk(level.faces, level.cornerEdges, level.edges);
    EdgePoints edgePoints(ofEdges);
    for (std::size_t c = 0; c < level.faces.corners.size(); c += 3) {
        gatherTriangle(level, walk, c, edgePoints);
    }
    IrregularPoints(level, walk, ofEdges).add(irregular);
    return finer;
}

/// A corner in each closed fan that has not six triangles.
std::vector<std::uint32_t> irregularCorners(const MeshLevel& level) {
    std::vector<std::uint32_t> corners;
    forEachFan(CornerWalk(level.faces, level.cornerEdges, level.edges), [&](const Fan& fan) {
        if (fan.closed && fan.corners.size() != 6) corners.push_back(fan.corners.front());
    });
    return corners;
}

}  // namespace

Mesh subdivideButterfly(const Mesh& mesh, int levels) {
    MeshLevel level = firstLevel(mesh);
    std::vector<std::uint32_t> irregular = irregularCorners(level);
    for (int done = 1; done < levels; ++done) {
        level = quarteredLevel(level, finerPoints(level, irregular));
        for (std::uint32_t& corner : irregular) corner = 12 * (corner / 3) + 3 * (corner % 3);
    }
    RawArray<Vec3> points = finerPoints(level, irregular);
    return Mesh::trusted(std::move(points), quarteredTriangles(level), 3U);
}

}  // namespace knotwork
