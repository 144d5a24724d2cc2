// The schemes of subdivision as textbooks have them: one level, with maps and rings, nothing shared
// with the kernels. Vertices and faces come in the order that mesh_subdivision.hpp promises.
#pragma once

#include "support/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace knotwork::test {

struct PlainMesh {
    std::vector<Vec3> points;
    FaceLists faces;
};

inline PlainMesh plain(const Mesh& mesh) {
    PlainMesh result{{mesh.points().begin(), mesh.points().end()}, {}};
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        const auto face = mesh.faces()[f];
        result.faces.emplace_back(face.begin(), face.end());
    }
    return result;
}

/// Who lies beside whom, by maps.
class Neighbourhood {
public:
    explicit Neighbourhood(const PlainMesh& mesh) : mesh_(mesh), around_(mesh.points.size()) {
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
            const Corners& face = mesh.faces[f];
            for (std::size_t k = 0; k < face.size(); ++k) {
                const std::uint32_t a = face[k];
                const std::uint32_t b = face[(k + 1) % face.size()];
                faceOf_[{a, b}] = f;
                if (numbers_.emplace(std::minmax(a, b), numbers_.size()).second) {
                    edges_.push_back({a, b});
                }
                around_[a].push_back(f);
            }
        }
    }

    const std::vector<std::array<std::uint32_t, 2>>& edges() const { return edges_; }
    std::uint32_t edge(std::uint32_t a, std::uint32_t b) const {
        return static_cast<std::uint32_t>(numbers_.at(std::minmax(a, b)));
    }
    /// The face that goes from a to b, or −1.
    int face(std::uint32_t a, std::uint32_t b) const {
        const auto found = faceOf_.find({a, b});
        return found == faceOf_.end() ? -1 : static_cast<int>(found->second);
    }
    bool onBoundary(std::uint32_t a, std::uint32_t b) const {
        return face(a, b) < 0 || face(b, a) < 0;
    }
    const std::vector<std::uint32_t>& facesAt(std::uint32_t v) const { return around_[v]; }
    std::set<std::uint32_t> neighbours(std::uint32_t v) const {
        std::set<std::uint32_t> found;
        for (const std::uint32_t f : around_[v]) {
            const Corners& face = mesh_.faces[f];
            const std::size_t k = place(face, v);
            found.insert(face[(k + 1) % face.size()]);
            found.insert(face[(k + face.size() - 1) % face.size()]);
        }
        return found;
    }
    std::vector<std::uint32_t> boundaryNeighbours(std::uint32_t v) const {
        std::vector<std::uint32_t> found;
        for (const std::uint32_t w : neighbours(v)) {
            if (onBoundary(v, w)) found.push_back(w);
        }
        return found;
    }
    /// The vertex before (by = −1) or after v in the face from a to b.
    std::uint32_t inFace(std::uint32_t a, std::uint32_t b, std::uint32_t v, int by) const {
        const Corners& corners = mesh_.faces[static_cast<std::size_t>(face(a, b))];
        const std::size_t n = corners.size();
        return corners[(place(corners, v) + (by > 0 ? 1 : n - 1)) % n];
    }
    /// Neighbours of v, counter-clockwise, from w on; of an open fan only as far as it goes.
    std::vector<std::uint32_t> ring(std::uint32_t v, std::uint32_t w) const {
        std::vector<std::uint32_t> found{w};
        while (face(v, found.back()) >= 0) {
            const std::uint32_t next = inFace(v, found.back(), v, -1);
            if (next == w) break;
            found.push_back(next);
        }
        return found;
    }
    /// The first neighbour of the open fan around v with w in it, or w itself of a closed one.
    std::uint32_t ringStart(std::uint32_t v, std::uint32_t w) const {
        std::uint32_t first = w;
        while (face(first, v) >= 0) {
            first = inFace(first, v, v, 1);
            if (first == w) break;
        }
        return first;
    }

    static std::size_t place(const Corners& face, std::uint32_t v) {
        return static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
    }

private:
    const PlainMesh& mesh_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> faceOf_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers_;
    std::vector<std::array<std::uint32_t, 2>> edges_;
    std::vector<std::vector<std::uint32_t>> around_;
};

inline Vec3 meanOf(const std::vector<Vec3>& points) {
    Vec3 sum{0};
    for (const Vec3& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

inline Vec3 centroid(const PlainMesh& mesh, std::uint32_t face) {
    std::vector<Vec3> points;
    for (const std::uint32_t v : mesh.faces[face]) points.push_back(mesh.points[v]);
    return meanOf(points);
}

/// 3/4 of a vertex on the boundary and 1/4 of the mean of those beside it there.
inline Vec3 cubicBoundaryPoint(const PlainMesh& mesh, const std::vector<std::uint32_t>& beside,
                               std::uint32_t v) {
    std::vector<Vec3> points;
    for (const std::uint32_t w : beside) points.push_back(mesh.points[w]);
    return 0.75 * mesh.points[v] + 0.25 * meanOf(points);
}

inline PlainMesh plainCatmullClark(const PlainMesh& mesh) {
    const Neighbourhood near(mesh);
    const auto& p = mesh.points;
    PlainMesh finer;
    for (std::uint32_t v = 0; v < p.size(); ++v) {
        const auto beside = near.boundaryNeighbours(v);
        const double n = static_cast<double>(near.facesAt(v).size());
        if (n == 0) {
            finer.points.push_back(p[v]);
        } else if (!beside.empty()) {
            finer.points.push_back(cubicBoundaryPoint(mesh, beside, v));
        } else {
            std::vector<Vec3> faces;
            std::vector<Vec3> middles;
            for (const std::uint32_t f : near.facesAt(v)) faces.push_back(centroid(mesh, f));
            for (const std::uint32_t w : near.neighbours(v)) middles.push_back(0.5 * (p[v] + p[w]));
            finer.points.push_back((meanOf(faces) + 2.0 * meanOf(middles) + (n - 3) * p[v]) / n);
        }
    }
    const auto firstFace = static_cast<std::uint32_t>(p.size());
    const auto firstEdge = static_cast<std::uint32_t>(p.size() + mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        finer.points.push_back(centroid(mesh, f));
    }
    for (const auto& [a, b] : near.edges()) {
        const Vec3 m = 0.5 * (p[a] + p[b]);
        finer.points.push_back(
            near.onBoundary(a, b)
                ? m
                : 0.5 * m + 0.25 * (centroid(mesh, static_cast<std::uint32_t>(near.face(a, b))) +
                                    centroid(mesh, static_cast<std::uint32_t>(near.face(b, a)))));
    }
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        const Corners& face = mesh.faces[f];
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k) {
            finer.faces.push_back({face[k], firstEdge + near.edge(face[k], face[(k + 1) % n]),
                                   firstFace + f,
                                   firstEdge + near.edge(face[k], face[(k + n - 1) % n])});
        }
    }
    return finer;
}

inline FaceLists plainQuarters(const PlainMesh& mesh, const Neighbourhood& near) {
    FaceLists faces;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Corners& f : mesh.faces) {
        const std::uint32_t e0 = first + near.edge(f[0], f[1]);
        const std::uint32_t e1 = first + near.edge(f[1], f[2]);
        const std::uint32_t e2 = first + near.edge(f[2], f[0]);
        faces.insert(faces.end(), {{f[0], e0, e2}, {f[1], e1, e0}, {f[2], e2, e1}, {e0, e1, e2}});
    }
    return faces;
}

inline PlainMesh plainLoop(const PlainMesh& mesh) {
    const Neighbourhood near(mesh);
    const auto& p = mesh.points;
    PlainMesh finer{{}, plainQuarters(mesh, near)};
    for (std::uint32_t v = 0; v < p.size(); ++v) {
        const auto around = near.neighbours(v);
        const auto beside = near.boundaryNeighbours(v);
        const double n = static_cast<double>(near.facesAt(v).size());
        if (n == 0) {
            finer.points.push_back(p[v]);
        } else if (!beside.empty()) {
            finer.points.push_back(cubicBoundaryPoint(mesh, beside, v));
        } else {
            const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
            const double beta = (5.0 / 8 - c * c) / n;
            // Of cones tip to tip every neighbour counts once, also one of valence 2.
            Vec3 sum{0};
            for (const std::uint32_t f : near.facesAt(v)) {
                const Corners& face = mesh.faces[f];
                sum += p[face[(Neighbourhood::place(face, v) + 1) % 3]];
            }
            finer.points.push_back((1 - n * beta) * p[v] + beta * sum);
        }
    }
    for (const auto& [a, b] : near.edges()) {
        finer.points.push_back(near.onBoundary(a, b)
                                   ? 0.5 * (p[a] + p[b])
                                   : 0.375 * (p[a] + p[b]) +
                                         0.125 * (p[near.inFace(a, b, a, -1)] +
                                                  p[near.inFace(b, a, b, -1)]));
    }
    return finer;
}

/// What the modified Butterfly says of the edge from v to w for the sake of v, or nothing where v
/// is regular.
inline std::vector<Vec3> butterflyOpinion(const PlainMesh& mesh, const Neighbourhood& near,
                                          std::uint32_t v, std::uint32_t w) {
    const auto& p = mesh.points;
    const std::uint32_t start = near.ringStart(v, w);
    const bool closed = near.face(start, v) >= 0;
    const auto ring = near.ring(v, closed ? w : start);
    const double pi = std::numbers::pi;
    Vec3 sum{0};
    if (closed) {
        const std::size_t n = ring.size();
        const double K = static_cast<double>(n);
        if (n == 6) return {};
        for (std::size_t j = 0; j < n; ++j) {
            const double at = static_cast<double>(j) / K;
            double s = (0.25 + std::cos(2 * pi * at) + 0.5 * std::cos(4 * pi * at)) / K;
            if (n == 3) s = j == 0 ? 5.0 / 12 : -1.0 / 12;
            if (n == 4) s = std::array{3.0 / 8, 0.0, -1.0 / 8, 0.0}[j];
            if (n == 2) s = std::array{3.0 / 8, -1.0 / 8}[j];
            sum += s * p[ring[j]];
        }
        return {0.75 * p[v] + sum};
    }
    const std::size_t k = ring.size() - 1;
    const double i = static_cast<double>(std::find(ring.begin(), ring.end(), w) - ring.begin());
    const double K = static_cast<double>(k);
    const double t = pi / K;
    const double outer =
        0.25 * std::cos(i * t) -
        std::sin(2 * t) * std::sin(2 * t * i) / (4 * K * (std::cos(t) - std::cos(2 * t)));
    for (std::size_t j = 1; j < k; ++j) {
        const double at = static_cast<double>(j);
        sum += (std::sin(i * t) * std::sin(at * t) +
                0.5 * std::sin(2 * i * t) * std::sin(2 * at * t)) / K * p[ring[j]];
    }
    const double own = 1 - std::sin(t) * std::sin(i * t) / (K * (1 - std::cos(t)));
    return {own * p[v] + outer * (p[ring[0]] - p[ring[k]]) + sum};
}

inline PlainMesh plainButterfly(const PlainMesh& mesh) {
    const Neighbourhood near(mesh);
    const auto& p = mesh.points;
    PlainMesh finer{p, plainQuarters(mesh, near)};
    for (const auto& [a, b] : near.edges()) {
        if (near.onBoundary(a, b)) {
            const std::uint32_t before = near.ring(a, near.ringStart(a, b)).back();
            const std::uint32_t after = near.ringStart(b, a);
            finer.points.push_back((9.0 * (p[a] + p[b]) - p[before] - p[after]) / 16.0);
            continue;
        }
        std::vector<Vec3> said = butterflyOpinion(mesh, near, a, b);
        for (const Vec3& point : butterflyOpinion(mesh, near, b, a)) said.push_back(point);
        if (said.empty()) {
            const std::uint32_t c = near.inFace(a, b, a, -1);
            const std::uint32_t d = near.inFace(b, a, b, -1);
            const Vec3 wings = p[near.inFace(c, b, b, 1)] + p[near.inFace(a, c, a, -1)] +
                               p[near.inFace(d, a, d, -1)] + p[near.inFace(b, d, b, -1)];
            said.push_back(0.5 * (p[a] + p[b]) + 0.125 * (p[c] + p[d]) - wings / 16.0);
        }
        finer.points.push_back(meanOf(said));
    }
    return finer;
}

/// One level, in which no boundary is cut.
inline PlainMesh plainSqrt3(const PlainMesh& mesh) {
    const Neighbourhood near(mesh);
    const auto& p = mesh.points;
    PlainMesh finer;
    for (std::uint32_t v = 0; v < p.size(); ++v) {
        const double n = static_cast<double>(near.facesAt(v).size());
        if (n == 0 || !near.boundaryNeighbours(v).empty()) {
            finer.points.push_back(p[v]);
            continue;
        }
        const double a = (4 - 2 * std::cos(2 * std::numbers::pi / n)) / 9;
        Vec3 sum{0};
        for (const std::uint32_t f : near.facesAt(v)) {
            const Corners& face = mesh.faces[f];
            sum += p[face[(Neighbourhood::place(face, v) + 1) % 3]];
        }
        finer.points.push_back((1 - a) * p[v] + a / n * sum);
    }
    const auto first = static_cast<std::uint32_t>(p.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        finer.points.push_back(centroid(mesh, f));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.faces[f][k];
            const std::uint32_t b = mesh.faces[f][(k + 1) % 3];
            const int behind = near.face(b, a);
            finer.faces.push_back(
                {a, behind < 0 ? b : first + static_cast<std::uint32_t>(behind), first + f});
        }
    }
    return finer;
}

}  // namespace knotwork::test
