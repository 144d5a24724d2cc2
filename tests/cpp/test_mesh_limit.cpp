#include "geometry/mesh_subdivision.hpp"
#include "geometry/mesh_fans.hpp"
#include "support/mesh_gates.hpp"
#include "support/mesh_zoo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::finer;
using test::nameOf;

std::vector<MeshScheme> schemesWithLimits() {
    return {MeshScheme::catmullClark, MeshScheme::loop, MeshScheme::butterfly, MeshScheme::sqrt3};
}

MeshLimit limitOf(const Mesh& mesh, MeshScheme scheme) { return *limit(mesh, scheme); }

/// What a vertex is in the middle of.
struct Around {
    int faces = 0;
    int openFans = 0;
};

std::vector<Around> aroundVertices(const Mesh& mesh) {
    std::vector<Around> around(mesh.points().size());
    for (const std::uint32_t v : mesh.corners()) ++around[v].faces;
    for (const MeshEdge& edge : mesh.edges()) {
        if (edge.onBoundary()) ++around[edge.v0].openFans;
    }
    return around;
}

// ---- Eigenvectors ------------------------------------------------------------------------------

/// Half-size rings one level finer have the same limit: what a left eigenvector is.
TEST(MeshLimit, OfAFinerMeshIsTheSame) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (const auto& [name, mesh] : test::zooFor(scheme)) {
            const MeshLimit coarse = limitOf(mesh, scheme);
            const int levels = scheme == MeshScheme::sqrt3 ? 2 : 1;
            const MeshLimit fine = limitOf(finer(mesh, scheme, levels), scheme);
            const std::vector<Around> around = aroundVertices(mesh);
            for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
                const std::string what = name + ' ' + nameOf(scheme) + ' ' + std::to_string(v);
                EXPECT_LT(glm::length(fine.positions[v] - coarse.positions[v]),
                          test::gates::limitPosition) << what;
                // Open fans that meet pull at one another's vertex, and at a single triangle a
                // four-point curve has no direction next to its tangent.
                if (around[v].openFans > 1) continue;
                const bool single = around[v].openFans == 1 && around[v].faces == 1;
                if (scheme == MeshScheme::butterfly && single) continue;
                EXPECT_LT(glm::length(fine.normals[v] - coarse.normals[v]),
                          test::gates::limitNormal) << what;
            }
        }
    }
}

// ---- Subdivision itself ------------------------------------------------------------------------

/// The normal of the faces around each of the first vertices, weighted by their areas.
std::vector<Vec3> faceNormals(const Mesh& mesh, std::size_t count) {
    std::vector<Vec3> sums(count, Vec3{0});
    const FaceRows faces = mesh.faces();
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto face = faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            if (face[k] >= count) continue;
            const Vec3 v = mesh.points()[face[k]];
            const Vec3 after = mesh.points()[face[(k + 1) % face.size()]] - v;
            const Vec3 before = mesh.points()[face[(k + face.size() - 1) % face.size()]] - v;
            sums[face[k]] += glm::cross(after, before);
        }
    }
    for (Vec3& sum : sums) sum = sum / std::max(glm::length(sum), 1e-300);
    return sums;
}

struct Misses {
    double position = 0;
    double normal = 0;
};

Misses missesOfVertexZero(const Mesh& mesh, MeshScheme scheme, int levels) {
    const MeshLimit found = limitOf(mesh, scheme);
    const Mesh fine = finer(mesh, scheme, levels);
    return {glm::length(fine.points()[0] - found.positions[0]),
            glm::length(faceNormals(fine, 1)[0] - found.normals[0])};
}

/// So many levels come near to the limit of vertex 0, and nearer than two levels less.
void expectLimit(const Mesh& mesh, MeshScheme scheme, int levels, double normal,
                 const std::string& what) {
    const Misses found = missesOfVertexZero(mesh, scheme, levels);
    EXPECT_LT(found.position, 1e-3) << what;
    EXPECT_LT(found.normal, normal) << what;
    const Misses before = missesOfVertexZero(mesh, scheme, levels - 2);
    EXPECT_LE(found.position, 0.5 * before.position) << what;
    EXPECT_LE(found.normal, 0.9 * before.normal + 1e-6) << what;
}

TEST(MeshLimit, IsWhatSevenLevelsComeToAtAnyValenceInside) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (std::uint32_t n = 3; n <= 12; ++n) {
            expectLimit(test::shaken(test::rosette(n), n), scheme, 7, 2e-2,
                        nameOf(scheme) + ' ' + std::to_string(n));
        }
    }
}

TEST(MeshLimit, IsWhatEightLevelsComeToOnABoundary) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (std::uint32_t k = 2; k <= 3; ++k) {
            expectLimit(test::shaken(test::openFan(k), k), scheme, 8, 4e-2,
                        nameOf(scheme) + ' ' + std::to_string(k));
        }
    }
}

/// Half of a rosette: `blades` triangles around the vertex 0 on the boundary and another ring of
/// triangles around those, so that the neighbours inside are regular.
Mesh halfRosette(std::uint32_t blades) {
    std::vector<Vec3> points{{0.05, -0.1, 0.4}};
    test::FaceLists faces;
    for (const double radius : {1.0, 2.0}) {
        const std::uint32_t around = radius > 1 ? 2 * blades : blades;
        for (std::uint32_t i = 0; i <= around; ++i) {
            const double angle = std::numbers::pi * i / around;
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                0.3 * std::cos(2 * angle) / radius);
        }
    }
    const auto outer = [&](std::uint32_t i) { return blades + 2 + i; };
    for (std::uint32_t i = 0; i < blades; ++i) {
        const std::uint32_t a = 1 + i;
        const std::uint32_t b = 2 + i;
        faces.insert(faces.end(), {{0, a, b},
                                   {a, outer(2 * i), outer(2 * i + 1)},
                                   {a, outer(2 * i + 1), b},
                                   {b, outer(2 * i + 1), outer(2 * i + 2)}});
    }
    return *test::meshOf(std::move(points), faces);
}

/// The neighbours of the vertex 0 on the boundary, counter-clockwise and seen from it.
std::vector<Vec3> ringOfVertexZero(const Mesh& mesh) {
    const CornerWalk walk(mesh.faces(), mesh.cornerEdges(), mesh.edges().size());
    std::vector<Vec3> ring;
    const auto add = [&](std::uint32_t to) {
        ring.push_back(mesh.points()[to] - mesh.points()[0]);
    };
    forEachFan(walk, [&](const Fan& fan) {
        if (fan.vertex != 0) return;
        for (const std::uint32_t corner : fan.corners) add(walk.neighbour(corner));
        add(walk.vertex(walk.previous(fan.corners.back())));
    });
    return ring;
}

/// The normal to the boundary's direction and to the ring's first sine. (The normals of the faces
/// themselves may have none in common: at 7 triangles of Loop's scheme or 5 quads the second sine
/// shrinks more slowly than the boundary.)
Vec3 boundaryNormal(const Mesh& mesh) {
    const std::vector<Vec3> ring = ringOfVertexZero(mesh);
    const std::size_t k = ring.size() - 1;
    Vec3 across{0};
    for (std::size_t j = 1; j < k; ++j) {
        across += std::sin(std::numbers::pi * static_cast<double>(j) / static_cast<double>(k)) *
                  ring[j];
    }
    return glm::normalize(glm::cross(ring[0] - ring[k], across));
}

/// Of Butterfly, which interpolates, every boundary ring shrinks by a half; the others have stronger
/// waves beside the two that stay.
double boundaryNormalGate(MeshScheme scheme) {
    switch (scheme) {
        case MeshScheme::catmullClark: return 1e-3;
        case MeshScheme::loop: return 2e-3;
        case MeshScheme::butterfly: return 1e-5;
        default: return 3e-2;  // three levels of cuts only
    }
}

/// The boundary is a cubic B-spline (or interpolates): what is missing of the limit is divided by 4
/// exactly in every level, or by 9 where the boundary is cut in three, in every second one.
void expectBoundaryLimit(const Mesh& mesh, MeshScheme scheme, const std::string& what) {
    const bool inThree = scheme == MeshScheme::sqrt3;
    const Mesh before = finer(mesh, scheme, inThree ? 4 : 6);
    const Mesh last = finer(before, scheme, inThree ? 2 : 1);
    const MeshLimit found = limitOf(mesh, scheme);
    const double ratio = inThree ? 9 : 4;
    const Vec3 end = (ratio * last.points()[0] - before.points()[0]) / (ratio - 1);
    EXPECT_LT(glm::length(found.positions[0] - end), test::gates::limitPosition) << what;
    const double miss = glm::length(boundaryNormal(last) - found.normals[0]);
    EXPECT_LT(miss, boundaryNormalGate(scheme)) << what;
    EXPECT_LT(miss, 0.55 * glm::length(boundaryNormal(before) - found.normals[0]) + 1e-12) << what;
}

TEST(MeshLimit, IsWhatSevenLevelsComeToOnABoundaryOfManyFaces) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (std::uint32_t k = 2; k <= 12; ++k) {
            const std::string what = nameOf(scheme) + ' ' + std::to_string(k);
            expectBoundaryLimit(test::shaken(test::openFan(k), k), scheme, what + " alone");
            if (k % 3 != 1) continue;
            expectBoundaryLimit(test::shaken(halfRosette(k), k), scheme, what + " within");
        }
    }
}

TEST(MeshLimit, OfEveryVertexOnABoundaryIsWhatTwoLevelsPointAt) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (const auto& [name, mesh] : test::zooFor(scheme)) {
            const bool inThree = scheme == MeshScheme::sqrt3;
            const Mesh first = finer(mesh, scheme, inThree ? 2 : 1);
            const Mesh second = finer(first, scheme, inThree ? 2 : 1);
            const MeshLimit found = limitOf(mesh, scheme);
            const double ratio = inThree ? 9 : 4;
            const std::vector<Around> around = aroundVertices(mesh);
            for (std::size_t v = 0; v < around.size(); ++v) {
                if (around[v].openFans == 0) continue;
                const Vec3 end = (ratio * second.points()[v] - first.points()[v]) / (ratio - 1);
                EXPECT_LT(glm::length(found.positions[v] - end), test::gates::limitPosition)
                    << name << ' ' << nameOf(scheme) << ' ' << v;
            }
        }
    }
}

// ---- Known surfaces ----------------------------------------------------------------------------

template <class Height>
Mesh graphOf(const Mesh& grid, Height height) {
    std::vector<Vec3> points;
    for (const Vec3& p : grid.points()) points.emplace_back(p.x, p.y, height(p.x, p.y));
    return *Mesh::make(std::move(points), {grid.corners().begin(), grid.corners().end()},
                       grid.uniformSize());
}

TEST(MeshLimit, OfAGridOfQuadsIsTheBicubicBSpline) {
    const Mesh mesh = test::shaken(test::gridMesh(4, 4), 3);
    const MeshLimit found = limitOf(mesh, MeshScheme::catmullClark);
    const double basis[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    const double slope[3] = {-0.5, 0, 0.5};
    for (const std::size_t v : {6U, 7U, 8U, 11U, 12U, 13U}) {
        Vec3 s{0};
        Vec3 su{0};
        Vec3 sv{0};
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 p = mesh.points()[v - 6 + 5 * j + i];
                s += basis[i] * basis[j] * p;
                su += slope[i] * basis[j] * p;
                sv += basis[i] * slope[j] * p;
            }
        }
        EXPECT_LT(glm::length(found.positions[v] - s), test::gates::limitPosition);
        EXPECT_LT(glm::length(found.normals[v] - glm::normalize(glm::cross(su, sv))),
                  test::gates::limitNormal);
    }
}

TEST(MeshLimit, OnTheBoundaryOfAGridOfQuadsLooksAlongAndAcross) {
    const Mesh mesh = test::shaken(test::gridMesh(4, 4), 3);
    const MeshLimit found = limitOf(mesh, MeshScheme::catmullClark);
    for (const std::size_t v : {1U, 2U, 3U}) {
        const auto row = [&](std::size_t by, double a, double b, double c) {
            return a * mesh.points()[v + by - 1] + b * mesh.points()[v + by] +
                   c * mesh.points()[v + by + 1];
        };
        const Vec3 along = row(0, -1, 0, 1);
        const Vec3 across = row(5, 1, 4, 1) - row(0, 1, 4, 1);
        EXPECT_LT(glm::length(found.positions[v] - row(0, 1, 4, 1) / 6.0),
                  test::gates::limitPosition);
        EXPECT_LT(glm::length(found.normals[v] - glm::normalize(glm::cross(along, across))),
                  test::gates::limitNormal);
    }
}

TEST(MeshLimit, OfTheButterflyOverAGridHasTheNormalsOfTheCubicThatItReproduces) {
    const auto cubic = [](double x, double y) {
        return (x * x * x - 5 * x * x * y + 2 * x * y * y - y * y * y + x * y) / 64;
    };
    const Mesh mesh = graphOf(test::triangleGrid(8, 8), cubic);
    const MeshLimit found = limitOf(mesh, MeshScheme::butterfly);
    std::size_t inside = 0;
    for (std::size_t v = 0; v < found.positions.size(); ++v) {
        const auto [x, y] = std::pair{mesh.points()[v].x, mesh.points()[v].y};
        if (std::min(x, y) < 2 || std::max(x, y) > 6) continue;
        ++inside;
        const Vec3 normal{-(3 * x * x - 10 * x * y + 2 * y * y + y) / 64,
                          -(-5 * x * x + 4 * x * y - 3 * y * y + x) / 64, 1};
        EXPECT_EQ(found.positions[v], mesh.points()[v]);
        EXPECT_LT(glm::length(found.normals[v] - glm::normalize(normal)),
                  test::gates::limitNormal) << x << ' ' << y;
    }
    EXPECT_EQ(inside, 25U);
}

TEST(MeshLimit, OfTriangleSchemesOnAFlatGridIsTheGrid) {
    const Mesh grid = test::triangleGrid(6, 6);
    for (const MeshScheme scheme : {MeshScheme::loop, MeshScheme::butterfly, MeshScheme::sqrt3}) {
        const MeshLimit found = limitOf(grid, scheme);
        for (std::size_t v = 0; v < found.positions.size(); ++v) {
            const Vec3 p = grid.points()[v];
            EXPECT_EQ(found.normals[v], (Vec3{0, 0, 1})) << nameOf(scheme);
            if (std::min(p.x, p.y) < 1 || std::max(p.x, p.y) > 5) continue;
            EXPECT_LT(glm::length(found.positions[v] - p), test::gates::limitPosition);
        }
    }
}

TEST(MeshLimit, NormalsPointOutwards) {
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (const Mesh& mesh : {test::tetrahedronMesh(), test::octahedronMesh()}) {
            const MeshLimit found = limitOf(mesh, scheme);
            for (std::size_t v = 0; v < found.positions.size(); ++v) {
                EXPECT_LT(glm::length(found.normals[v] - glm::normalize(mesh.points()[v])),
                          test::gates::limitNormal) << nameOf(scheme);
            }
        }
    }
}

// ---- Odd ones ----------------------------------------------------------------------------------

TEST(MeshLimit, OfAVertexWithoutFacesIsItselfWithoutANormal) {
    const Mesh mesh = *test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 4, 5}}, {{0, 1, 2}});
    for (const MeshScheme scheme : schemesWithLimits()) {
        const MeshLimit found = limitOf(mesh, scheme);
        EXPECT_EQ(found.positions[3], (Vec3{3, 4, 5}));
        EXPECT_EQ(found.normals[3], (Vec3{0, 0, 0}));
        EXPECT_EQ(found.normals[0], (Vec3{0, 0, 1}));
    }
}

TEST(MeshLimit, OfFacesInALineHasNoNormals) {
    const Mesh mesh = *test::meshOf({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {4, 8, 12}},
                                    {{0, 1, 2}, {2, 1, 3}});
    for (const MeshScheme scheme : schemesWithLimits()) {
        for (const Vec3& normal : limitOf(mesh, scheme).normals) EXPECT_EQ(normal, (Vec3{0, 0, 0}));
    }
}

TEST(MeshLimit, HasNormalsAtAnySize) {
    const Mesh mesh = test::shaken(test::rosette(5), 2);
    for (const MeshScheme scheme : schemesWithLimits()) {
        const MeshLimit expected = limitOf(mesh, scheme);
        for (const double scale : {std::ldexp(1.0, -600), std::ldexp(1.0, 30)}) {
            std::vector<Vec3> points;
            for (const Vec3& p : mesh.points()) points.push_back(scale * p);
            const MeshLimit found = limitOf(
                *Mesh::make(points, {mesh.corners().begin(), mesh.corners().end()}, 3), scheme);
            for (std::size_t v = 0; v < points.size(); ++v) {
                EXPECT_LT(glm::length(found.normals[v] - expected.normals[v]),
                          test::gates::limitNormal) << nameOf(scheme);
            }
        }
    }
}

TEST(MeshLimit, OfDooSabinIsRefused) {
    const auto result = limit(test::cubeMesh(), MeshScheme::dooSabin);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, Code::notSupported);
    EXPECT_EQ(result.error().path, "scheme");
}

}  // namespace
}  // namespace knotwork
