#include "geometry/mesh_creases.hpp"
#include "geometry/mesh_schemes.hpp"

#include <utility>

// Triangles cut in four: corner k of a triangle becomes v_k, e_k, e_{k−1}, and the middles of its
// edges are the fourth.

namespace knotwork {

RawArray<std::uint32_t> quarteredTriangles(const MeshLevel& level) {
    const auto firstEdge = static_cast<std::uint32_t>(level.points.size());
    const std::size_t count = level.faces.count();
    RawArray<std::uint32_t> finer(12 * count);
    const std::uint32_t* v = level.faces.corners.data();
    const std::uint32_t* edges = level.cornerEdges.data();
    std::uint32_t* to = finer.data();
    for (std::size_t face = 0; face < count; ++face, v += 3, edges += 3, to += 12) {
        const std::uint32_t e[3] = {firstEdge + edges[0], firstEdge + edges[1],
                                    firstEdge + edges[2]};
        to[0] = v[0], to[1] = e[0], to[2] = e[2];
        to[3] = v[1], to[4] = e[1], to[5] = e[0];
        to[6] = v[2], to[7] = e[2], to[8] = e[1];
        to[9] = e[0], to[10] = e[1], to[11] = e[2];
    }
    return finer;
}

namespace {

/// Of corner triangle k: half of e_k, the edge that cuts the corner off, half of e_{k−1}.
RawArray<std::uint32_t> quarteredEdges(const MeshLevel& level, FinerEdges& numbers) {
    const std::size_t count = level.faces.count();
    RawArray<std::uint32_t> finer(12 * count);
    const std::uint32_t* edges = level.cornerEdges.data();
    std::uint32_t* to = finer.data();
    for (std::size_t face = 0; face < count; ++face, edges += 3, to += 12) {
        for (std::size_t k = 0; k < 3; ++k) {
            to[3 * k] = numbers.firstHalf(edges[k]);
            to[3 * k + 1] = numbers.inside();
            to[3 * k + 2] = numbers.secondHalf(edges[(k + 2) % 3]);
        }
        to[9] = to[4];
        to[10] = to[7];
        to[11] = to[1];
        numbers.endFace();
    }
    return finer;
}

}  // namespace

MeshLevel quarteredLevel(const MeshLevel& level, RawArray<Vec3> points) {
    MeshLevel finer = ownLevel(std::move(points), quarteredTriangles(level), 3);
    FinerEdges numbers(level.edges);
    finer.ownCornerEdges = quarteredEdges(level, numbers);
    finer.cornerEdges = finer.ownCornerEdges;
    finer.edges = numbers.count();
    finer.valences = level.valences;
    finer.creases =
        halvedCreases(level, static_cast<std::uint32_t>(level.points.size()), numbers);
    finer.boundary = halvedBoundary(
        level.boundary,
        [](std::uint32_t corner) { return 12 * (corner / 3) + 3 * (corner % 3); },
        [](std::uint32_t corner) { return 12 * (corner / 3) + 3 * ((corner + 1) % 3) + 2; });
    return finer;
}

}  // namespace knotwork
