#include "geometry/mesh_fans.hpp"
#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

// Positions: the left eigenvector of the eigenvalue 1 of the matrix that maps a vertex and what is
// around it to the same one level finer; normals: the cross product of those of the two next
// largest. Inside they are the first cosine and sine around the vertex (E. Catmull, J. Clark, 1978;
// C. Loop, 1987; D. Zorin et al., 1996; L. Kobbelt, 2000; see the schemes). At a vertex of k faces
// on the boundary there are the direction of the boundary, x_0 − x_k with the outer neighbours (8
// times that, less the difference of the next two, of a four-point curve), and a sine of θ = π/k
// across it,
//     Σ sin(jθ) x_j + b (x_0 + x_k) + a v   (and diagonals with Catmull–Clark),
// whose a and b follow from the rows of v and of x_0. A single face has no such sine: what is next
// to the boundary's direction is its curvature, and the normal is that of v, x_0 and x_1.

namespace knotwork {

namespace {

// ---- Positions ---------------------------------------------------------------------------------

/// Positions inside: v + w Σ said, where every face says 4 ((p + q)/2 − v) + (d − v) with d
/// opposite in a quad, and (p + q)/2 − v in a triangle.
std::vector<Vec3> sumsAround(const Mesh& mesh, std::size_t wanted) {
    const auto points = mesh.points();
    const FaceRows faces = mesh.faces();
    std::vector<Vec3> sums(wanted, Vec3{0});
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto face = faces[f];
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k) {
            if (face[k] >= wanted) continue;
            const Vec3 v = points[face[k]];
            const Vec3 beside = 0.5 * (points[face[(k + 1) % n]] + points[face[(k + n - 1) % n]]);
            sums[face[k]] += n == 4 ? 4.0 * (beside - v) + (points[face[(k + 2) % n]] - v)
                                    : beside - v;
        }
    }
    return sums;
}

double limitWeight(MeshScheme scheme, std::uint32_t valence) noexcept {
    const double n = valence;
    if (valence == 0) return 0;
    if (scheme == MeshScheme::catmullClark) return 1 / (n * (n + 5));
    if (scheme == MeshScheme::loop) return 1 / (n + 0.375 / loopWeight(valence));
    const double a = sqrt3Weight(valence);
    return 3 * a / (1 + 3 * a) / n;
}

std::vector<Vec3> limitPositions(const Mesh& mesh, MeshScheme scheme, std::size_t wanted) {
    const auto points = mesh.points();
    if (scheme == MeshScheme::butterfly) {
        return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(wanted)};
    }
    std::vector<std::uint32_t> valences(points.size(), 0);
    for (const std::uint32_t vertex : mesh.corners()) ++valences[vertex];
    std::vector<Vec3> found = sumsAround(mesh, wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        found[i] = points[i] + found[i] * limitWeight(scheme, valences[i]);
    }
    const std::vector<BoundaryEdge> boundary = boundaryOf(mesh);
    const auto from = [&](std::uint32_t b) { return mesh.corners()[boundary[b].corner]; };
    for (std::uint32_t b = 0; b < boundary.size(); ++b) {
        if (from(b) < wanted) found[from(b)] = points[from(b)];
    }
    for (std::uint32_t b = 0; b < boundary.size(); ++b) {  // (p + 4v + q) / 6 of a cubic B-spline
        if (from(b) >= wanted) continue;
        const Vec3 v = points[from(b)];
        found[from(b)] +=
            ((points[from(boundary[b].before)] - v) + (points[from(boundary[b].after)] - v)) /
            (6.0 * boundary[b].fans);
    }
    return found;
}

// ---- What is around a vertex -------------------------------------------------------------------

/// Seen from the vertex, and scaled to at most 1.
struct Surroundings {
    std::vector<Vec3> neighbours;
    std::vector<Vec3> between;  ///< per face: opposite in the quad, or beyond the triangle
    /// Straight on behind each neighbour at regular triangles, or behind the two on a boundary.
    std::vector<Vec3> beyond;
};

class Looker {
public:
    Looker(const Mesh& mesh, const CornerWalk& walk) : points_(mesh.points()), walk_(walk) {}

    void neighbours(const Fan& fan, Surroundings& around) const {
        around.neighbours.clear();
        for (const std::uint32_t corner : fan.corners) {
            around.neighbours.push_back(ray(fan, walk_.neighbour(corner)));
        }
        if (!fan.closed) {
            around.neighbours.push_back(
                ray(fan, walk_.vertex(walk_.previous(fan.corners.back()))));
        }
    }
    void opposites(const Fan& fan, Surroundings& around) const {
        around.between.clear();
        for (const std::uint32_t corner : fan.corners) {
            around.between.push_back(ray(fan, walk_.neighbour(walk_.next(corner))));
        }
    }
    /// The second ring of a regular vertex whose neighbours are regular too.
    void secondRing(const Fan& fan, Surroundings& around) const {
        around.between.clear();
        around.beyond.clear();
        for (const std::uint32_t corner : fan.corners) {
            const std::uint32_t outer = walk_.twin(walk_.next(corner));
            around.between.push_back(ray(fan, walk_.vertex(walk_.previous(outer))));
            std::uint32_t straight = walk_.twin(corner);
            for (int turn = 0; turn < 3; ++turn) straight = walk_.turned(straight);
            around.beyond.push_back(ray(fan, walk_.neighbour(straight)));
        }
    }

    /// The boundary on both sides behind the neighbours of an open fan.
    void alongBoundary(const Fan& fan, Surroundings& around) const {
        around.beyond.clear();
        std::uint32_t ahead = walk_.next(fan.corners.front());
        while (walk_.twin(ahead) != noCorner) ahead = walk_.next(walk_.twin(ahead));
        around.beyond.push_back(ray(fan, walk_.neighbour(ahead)));
        std::uint32_t back = walk_.previous(fan.corners.back());
        while (walk_.turned(back) != noCorner) back = walk_.turned(back);
        around.beyond.push_back(ray(fan, walk_.vertex(walk_.previous(back))));
    }

private:
    [[nodiscard]] Vec3 ray(const Fan& fan, std::uint32_t to) const noexcept {
        return points_[to] - points_[fan.vertex];
    }

    std::span<const Vec3> points_;
    const CornerWalk& walk_;
};

double largestOf(std::span<const Vec3> rays) noexcept {
    double largest = 0;
    for (const Vec3& r : rays) {
        largest = std::max({largest, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
    }
    return largest;
}

/// So that products of small rays do not vanish.
void normalise(Surroundings& around) noexcept {
    const double largest = std::max({largestOf(around.neighbours), largestOf(around.between),
                                     largestOf(around.beyond)});
    if (largest == 0) return;
    for (auto* rays : {&around.neighbours, &around.between, &around.beyond}) {
        for (Vec3& r : *rays) r = r / largest;
    }
}

// ---- Tangents ----------------------------------------------------------------------------------

struct Tangents {
    Vec3 first{0};
    Vec3 second{0};
};

/// The direction in which the angle is 0, and that in which it is 90°.
void addWave(Tangents& to, double angle, const Vec3& ray) noexcept {
    to.first += std::cos(angle) * ray;
    to.second += std::sin(angle) * ray;
}

/// How much more the neighbours count than the opposite vertices, at n quads around or n/2 on a
/// boundary.
double quadRatio(double step) noexcept {
    const double c = std::cos(step);
    return 1 + c + std::cos(0.5 * step) * std::sqrt(2 * (9 + c));
}

Tangents innerTangents(const Surroundings& around, MeshScheme scheme) noexcept {
    const std::size_t n = around.neighbours.size();
    const double step = 2 * std::numbers::pi / static_cast<double>(n);
    const bool quads = scheme == MeshScheme::catmullClark;
    const bool twoRings = !around.beyond.empty();
    const double own = quads ? quadRatio(step) : 1.0;
    const double root3 = std::numbers::sqrt3;
    Tangents t;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = step * static_cast<double>(i);
        addWave(t, angle, own * around.neighbours[i]);
        if (quads) {
            addWave(t, angle, around.between[i]);
            addWave(t, angle + step, around.between[i]);
        } else if (twoRings) {
            addWave(t, angle, around.beyond[i] / 16.0);
            addWave(t, angle + 0.5 * step, around.between[i] * (-root3 / 6));
        }
    }
    return t;
}

/// The weight b of the outer neighbours, for sines of θ = π/k. With W the sum of all other weights
/// but that of v, a = −W − 2b makes the sum 0, and the row of x_0 then gives b.
double outerWeight(MeshScheme scheme, double step) noexcept {
    const double sine = std::sin(step);
    const double sum = 1 / std::tan(0.5 * step);  // of sin(jθ), 0 < j < k
    const double c = std::cos(step);
    switch (scheme) {
        case MeshScheme::catmullClark: {
            const double ratio = quadRatio(step);
            const double eigenvalue =
                (5 + c + std::cos(0.5 * step) * std::sqrt(2 * (9 + c))) / 16;
            return ((ratio / 16 + 0.25) * sine - (ratio + 2) * sum / 8) / (eigenvalue - 0.25);
        }
        case MeshScheme::loop: return (sine - sum) / (1 + 2 * c);
        case MeshScheme::sqrt3: return (sine - sum * 4 / 3) / (1 + 2 * c);
        case MeshScheme::butterfly:
        case MeshScheme::dooSabin: break;
    }
    return 0;
}

Tangents outerTangents(const Surroundings& around, MeshScheme scheme) noexcept {
    const auto& x = around.neighbours;
    const std::size_t k = x.size() - 1;
    if (k == 1) return {x[0], x[1]};
    const double step = std::numbers::pi / static_cast<double>(k);
    const bool quads = scheme == MeshScheme::catmullClark;
    const double own = quads ? quadRatio(step) : 1.0;
    const double outer = outerWeight(scheme, step);
    Tangents t{x[0] - x[k], outer * (x[0] + x[k])};
    if (scheme == MeshScheme::butterfly) {
        t.first = 8.0 * t.first - (around.beyond[0] - around.beyond[1]);
    }
    for (std::size_t j = 0; j <= k; ++j) {
        const double sine = j == 0 || j == k ? 0.0 : std::sin(step * static_cast<double>(j));
        t.second += own * sine * x[j];
        if (!quads) continue;
        if (j < k) t.second += sine * around.between[j];
        if (j > 0) t.second += sine * around.between[j - 1];
    }
    return t;
}

// ---- Normals -----------------------------------------------------------------------------------

/// The unit vector, or zero where there is hardly any length left beside `size`.
Vec3 unitOf(const Vec3& v, double size) noexcept {
    const double length = glm::length(v);
    return length > 1e-14 * size ? v / length : Vec3{0};
}

/// Of tangents, or where they are one direction, of the faces.
Vec3 fanNormal(const Fan& fan, const Tangents& tangents, const Surroundings& around) noexcept {
    const double size = glm::length(tangents.first) * glm::length(tangents.second);
    const Vec3 normal = unitOf(glm::cross(tangents.first, tangents.second), size);
    if (size > 1e-20 && normal != Vec3{0}) return normal;
    Vec3 sum{0};
    const auto& x = around.neighbours;
    for (std::size_t i = 0; i < fan.corners.size(); ++i) {
        sum += glm::cross(x[i], x[(i + 1) % x.size()]);
    }
    return unitOf(sum, 1);
}

std::vector<Vec3> limitNormals(const Mesh& mesh, MeshScheme scheme, std::size_t wanted) {
    std::vector<Vec3> normals(wanted, Vec3{0});
    const CornerWalk walk(mesh.faces(), mesh.cornerEdges(), mesh.edges().size());
    const Looker look(mesh, walk);
    Surroundings around;
    forEachFan(walk, [&](const Fan& fan) {
        if (fan.vertex >= wanted) return;
        look.neighbours(fan, around);
        around.between.clear();
        around.beyond.clear();
        if (scheme == MeshScheme::catmullClark) look.opposites(fan, around);
        if (scheme == MeshScheme::butterfly && !fan.closed) look.alongBoundary(fan, around);
        if (scheme == MeshScheme::butterfly && fan.closed && fan.corners.size() == 6) {
            look.secondRing(fan, around);
        }
        normalise(around);
        const Tangents tangents =
            fan.closed ? innerTangents(around, scheme) : outerTangents(around, scheme);
        normals[fan.vertex] += fanNormal(fan, tangents, around);
    });
    for (Vec3& normal : normals) normal = unitOf(normal, 1);
    return normals;
}

/// Masks look at a mesh of quads, or one where nothing but the vertex itself is irregular.
bool needsFinerMesh(const Mesh& mesh, MeshScheme scheme) noexcept {
    if (scheme == MeshScheme::catmullClark) return mesh.uniformSize() != 4;
    return scheme == MeshScheme::butterfly;
}

}  // namespace

Result<MeshLimit> limit(const Mesh& mesh, MeshScheme scheme) {
    if (scheme == MeshScheme::dooSabin) {
        return refuse(Code::notSupported, "scheme",
                      "The limit points of doo-sabin belong to faces, not to vertices. Take "
                      "another scheme, or subdivide.");
    }
    if (!mesh.creases().empty()) {
        return refuse(Code::notSupported, "creases",
                      "The limit of a mesh with creases is not known by a formula here. Subdivide "
                      "until they are smooth, or often enough.");
    }
    const bool needsFiner = needsFinerMesh(mesh, scheme);
    if (auto wrong = checkMeshFor(mesh, scheme, needsFiner ? 1 : 0)) {
        if (wrong->code == Code::tooLarge) wrong->path.clear();
        return *std::move(wrong);
    }
    const std::size_t wanted = mesh.points().size();
    Mesh used = mesh;
    if (needsFiner) {
        used = scheme == MeshScheme::catmullClark ? subdivideCatmullClark(mesh, 1)
                                                  : subdivideButterfly(mesh, 1);
    }
    return MeshLimit{limitPositions(used, scheme, wanted), limitNormals(used, scheme, wanted)};
}

}  // namespace knotwork
