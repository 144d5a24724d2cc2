#include "geometry/mesh_creases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

// ---- Creases of a mesh -------------------------------------------------------------------------

constexpr std::uint32_t noEdge = 0xffffffffU;

/// Both ends of an edge, whichever comes first.
std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) noexcept {
    return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

struct Keyed {
    std::uint64_t key = 0;
    std::size_t crease = 0;
};

/// By their ends, and those of one edge in their order.
std::vector<Keyed> sortedKeys(std::span<const MeshCrease> creases) {
    std::vector<Keyed> keys;
    keys.reserve(creases.size());
    for (const MeshCrease& crease : creases) {
        keys.push_back({keyOf(crease.v0, crease.v1), keys.size()});
    }
    std::sort(keys.begin(), keys.end(), [](const Keyed& a, const Keyed& b) {
        return a.key != b.key ? a.key < b.key : a.crease < b.crease;
    });
    return keys;
}

/// The number of the edge of each crease, or noEdge.
std::vector<std::uint32_t> edgesOf(const Mesh& mesh, std::span<const Keyed> keys) {
    std::vector<std::uint32_t> found(keys.size(), noEdge);
    const auto edges = mesh.edges();
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        const std::uint64_t key = keyOf(edges[e].v0, edges[e].v1);
        const auto at = std::lower_bound(keys.begin(), keys.end(), key,
                                         [](const Keyed& a, std::uint64_t b) { return a.key < b; });
        if (at != keys.end() && at->key == key) found[at->crease] = e;
    }
    return found;
}

std::string endsOf(const MeshCrease& crease) {
    return std::to_string(crease.v0) + " and " + std::to_string(crease.v1);
}

Error refuseCrease(Code code, std::size_t crease, const char* field, std::string message) {
    return refuse(code, indexed("creases", crease) + field, std::move(message));
}

std::optional<Error> checkSharpness(std::span<const MeshCrease> creases) {
    for (std::size_t i = 0; i < creases.size(); ++i) {
        const double sharpness = creases[i].sharpness;
        if (sharpness == std::numeric_limits<double>::infinity()) continue;
        if (sharpness > 0 && sharpness <= maxSharpness) continue;
        return refuseCrease(std::isfinite(sharpness) ? Code::outOfRange : Code::notFinite, i,
                            ".sharpness",
                            "The sharpness is " + formatNumber(sharpness) +
                                "; it is positive and at most " + formatNumber(maxSharpness) +
                                ", or infinite.");
    }
    return std::nullopt;
}

// ---- Points ------------------------------------------------------------------------------------

/// A creased edge as one of its ends sees it.
struct Spoke {
    std::uint32_t vertex = 0;
    std::uint32_t other = 0;
    double sharpness = 0;
};

std::vector<Spoke> spokesOf(const MeshLevel& level) {
    std::vector<Spoke> spokes;
    spokes.reserve(2 * level.creases.size());
    for (const LevelCrease& crease : level.creases) {
        spokes.push_back({crease.v0, crease.v1, crease.sharpness});
        spokes.push_back({crease.v1, crease.v0, crease.sharpness});
    }
    std::stable_sort(spokes.begin(), spokes.end(),
                     [](const Spoke& a, const Spoke& b) { return a.vertex < b.vertex; });
    return spokes;
}

/// Where a vertex goes if its edges of more than this sharpness are sharp.
Vec3 sharpPoint(std::span<const Vec3> points, std::span<const Spoke> spokes, double sharper,
                bool onBoundary, const Vec3& smooth) noexcept {
    const Vec3 v = points[spokes[0].vertex];
    Vec3 rays{0};
    std::size_t count = 0;
    for (const Spoke& spoke : spokes) {
        if (!(spoke.sharpness > sharper)) continue;
        rays += points[spoke.other] - v;
        ++count;
    }
    if (count == 0 || (count == 1 && !onBoundary)) return smooth;
    return count == 2 && !onBoundary ? v + rays * 0.125 : v;
}

Vec3 creasedPoint(std::span<const Vec3> points, std::span<const Spoke> spokes, bool onBoundary,
                  const Vec3& smooth) noexcept {
    const Vec3 here = sharpPoint(points, spokes, 0, onBoundary, smooth);
    double sum = 0;
    double ending = 0;
    for (const Spoke& spoke : spokes) {
        if (spoke.sharpness > 1) continue;
        sum += spoke.sharpness;
        ++ending;
    }
    if (sum == ending) return here;  // none of them ends, or all in full
    const Vec3 without = sharpPoint(points, spokes, 1, onBoundary, smooth);
    return without + (sum / ending) * (here - without);
}

}  // namespace

// ---- Of meshes ---------------------------------------------------------------------------------

std::span<const MeshCrease> Mesh::creases() const noexcept {
    return creases_ ? std::span<const MeshCrease>(*creases_) : std::span<const MeshCrease>();
}

Mesh Mesh::withTrustedCreases(std::vector<MeshCrease> creases) const {
    Mesh creased = *this;
    creased.creases_ = creases.empty() ? nullptr
                                       : std::make_shared<const std::vector<MeshCrease>>(
                                             std::move(creases));
    return creased;
}

Result<Mesh> Mesh::withCreases(std::vector<MeshCrease> creases) const {
    if (auto wrong = checkSharpness(creases)) return *std::move(wrong);
    const std::vector<Keyed> keys = sortedKeys(creases);
    for (std::size_t k = 1; k < keys.size(); ++k) {
        if (keys[k].key != keys[k - 1].key) continue;
        return refuseCrease(Code::outOfRange, keys[k].crease, ".edge",
                            "The edge between the vertices " + endsOf(creases[keys[k].crease]) +
                                " comes twice; name it once.");
    }
    const std::vector<std::uint32_t> edges = edgesOf(*this, keys);
    const auto missing = std::find(edges.begin(), edges.end(), noEdge);
    if (missing != edges.end()) {
        const auto at = static_cast<std::size_t>(missing - edges.begin());
        return refuseCrease(Code::outOfRange, at, ".edge",
                            "There is no edge between the vertices " + endsOf(creases[at]) + ".");
    }
    return withTrustedCreases(std::move(creases));
}

std::vector<LevelCrease> creasesOf(const Mesh& mesh) {
    const auto creases = mesh.creases();
    std::vector<LevelCrease> found;
    if (creases.empty()) return found;
    found.reserve(creases.size());
    const std::vector<std::uint32_t> numbers = edgesOf(mesh, sortedKeys(creases));
    for (std::size_t i = 0; i < creases.size(); ++i) {
        const MeshEdge& edge = mesh.edges()[numbers[i]];
        if (edge.onBoundary()) continue;
        found.push_back({numbers[i], edge.v0, edge.v1, creases[i].sharpness});
    }
    return found;
}

// ---- Of levels ---------------------------------------------------------------------------------

void refineCreases(const MeshLevel& level, std::span<Vec3> vertexPoints,
                   std::span<Vec3> edgePoints) {
    if (level.creases.empty()) return;
    const auto points = level.points;
    for (const LevelCrease& crease : level.creases) {
        Vec3& point = edgePoints[crease.edge];
        const Vec3 middle = 0.5 * (points[crease.v0] + points[crease.v1]);
        point = crease.sharpness < 1 ? point + crease.sharpness * (middle - point) : middle;
    }
    std::vector<bool> onBoundary(points.size(), false);
    for (const BoundaryEdge& edge : level.boundary) onBoundary[level.from(edge)] = true;
    const std::vector<Spoke> spokes = spokesOf(level);
    for (std::size_t from = 0, to = 0; from < spokes.size(); from = to) {
        const std::uint32_t v = spokes[from].vertex;
        while (to < spokes.size() && spokes[to].vertex == v) ++to;
        vertexPoints[v] = creasedPoint(points, std::span(spokes).subspan(from, to - from),
                                       onBoundary[v], vertexPoints[v]);
    }
}

std::vector<LevelCrease> halvedCreases(const MeshLevel& level, std::uint32_t firstEdgePoint,
                                       const FinerEdges& numbers) {
    std::vector<LevelCrease> halves;
    for (const LevelCrease& crease : level.creases) {
        const double sharpness = crease.sharpness - 1;
        if (!(sharpness > 0)) continue;
        const std::uint32_t middle = firstEdgePoint + crease.edge;
        halves.push_back({numbers.half(crease.edge, false), crease.v0, middle, sharpness});
        halves.push_back({numbers.half(crease.edge, true), middle, crease.v1, sharpness});
    }
    return halves;
}

Mesh withHalvedCreases(const Mesh& finer, const MeshLevel& level, std::uint32_t firstEdgePoint) {
    if (level.creases.empty()) return finer;
    std::vector<MeshCrease> halves;
    for (const LevelCrease& crease : level.creases) {
        const double sharpness = crease.sharpness - 1;
        if (!(sharpness > 0)) continue;
        const std::uint32_t middle = firstEdgePoint + crease.edge;
        halves.push_back({crease.v0, middle, sharpness});
        halves.push_back({middle, crease.v1, sharpness});
    }
    return finer.withTrustedCreases(std::move(halves));
}

}  // namespace knotwork
