#include "geometry/mesh_subdivision.hpp"

#include "geometry/mesh_fans.hpp"
#include "support/mesh_gates.hpp"
#include "support/mesh_schemes.hpp"
#include "support/mesh_zoo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace knotwork {
namespace {

using test::allSchemes;
using test::Corners;
using test::finer;
using test::nameOf;
using test::plain;
using test::PlainMesh;
using test::zooFor;

double farthestPoint(std::span<const Vec3> a, std::span<const Vec3> b) {
    double farthest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        farthest = std::max(farthest, glm::length(a[i] - b[i]));
    }
    return farthest;
}

void expectSameFaces(const PlainMesh& found, const PlainMesh& expected, const std::string& name) {
    EXPECT_EQ(found.faces, expected.faces) << name;
    ASSERT_EQ(found.points.size(), expected.points.size()) << name;
}

/// Bit for bit.
void expectSame(const Mesh& a, const Mesh& b, const std::string& name) {
    ASSERT_EQ(a.points().size(), b.points().size()) << name;
    EXPECT_TRUE(std::equal(a.points().begin(), a.points().end(), b.points().begin())) << name;
    EXPECT_EQ(plain(a).faces, plain(b).faces) << name;
}

// ---- Rules -------------------------------------------------------------------------------------

void expectOneLevel(MeshScheme scheme, PlainMesh (*reference)(const PlainMesh&)) {
    for (const auto& [name, mesh] : zooFor(scheme)) {
        const PlainMesh found = plain(finer(mesh, scheme, 1));
        const PlainMesh expected = reference(plain(mesh));
        expectSameFaces(found, expected, name);
        EXPECT_LT(farthestPoint(found.points, expected.points), test::gates::subdivided) << name;
    }
}

TEST(MeshSubdivision, CatmullClarkIsTheTextbooks) {
    expectOneLevel(MeshScheme::catmullClark, test::plainCatmullClark);
}

TEST(MeshSubdivision, LoopIsTheTextbooks) { expectOneLevel(MeshScheme::loop, test::plainLoop); }

TEST(MeshSubdivision, ButterflyIsTheTextbooks) {
    expectOneLevel(MeshScheme::butterfly, test::plainButterfly);
}

TEST(MeshSubdivision, Sqrt3IsTheTextbooks) { expectOneLevel(MeshScheme::sqrt3, test::plainSqrt3); }

TEST(MeshSubdivision, DooSabinTakesItsWeightsFromTheFace) {
    for (const auto& [name, mesh] : zooFor(MeshScheme::dooSabin)) {
        const Mesh found = finer(mesh, MeshScheme::dooSabin, 1);
        for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
            const auto face = mesh.faces()[f];
            const double n = static_cast<double>(face.size());
            for (std::size_t k = 0; k < face.size(); ++k) {
                Vec3 expected{0};
                for (std::size_t j = 0; j < face.size(); ++j) {
                    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / n;
                    const double weight =
                        j == 0 ? 0.25 + 5 / (4 * n) : (3 + 2 * std::cos(angle)) / (4 * n);
                    expected += weight * mesh.points()[face[(k + j) % face.size()]];
                }
                const Vec3 point = found.points()[mesh.faces().begin(f) + k];
                EXPECT_LT(glm::length(point - expected), test::gates::subdivided) << name;
            }
        }
    }
}

TEST(MeshSubdivision, DooSabinJoinsFacesThenEdgesThenVertices) {
    const Mesh mesh = test::cubeMesh();
    const PlainMesh found = plain(finer(mesh, MeshScheme::dooSabin, 1));
    ASSERT_EQ(found.faces.size(), 6U + 12U + 8U);
    for (std::uint32_t f = 0; f < 6; ++f) {
        EXPECT_EQ(found.faces[f], (Corners{4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3}));
    }
    const auto from = [&](std::uint32_t corner) { return mesh.corners()[corner]; };
    for (std::size_t e = 0; e < 12; ++e) {
        const Corners& quad = found.faces[6 + e];
        ASSERT_EQ(quad.size(), 4U);
        EXPECT_EQ((std::pair{from(quad[0]), from(quad[1])}),
                  (std::pair{mesh.edges()[e].v0, mesh.edges()[e].v0}));
        EXPECT_EQ((std::pair{from(quad[2]), from(quad[3])}),
                  (std::pair{mesh.edges()[e].v1, mesh.edges()[e].v1}));
    }
    for (std::uint32_t v = 0; v < 8; ++v) {
        const Corners& triangle = found.faces[18 + v];
        ASSERT_EQ(triangle.size(), 3U);
        for (const std::uint32_t corner : triangle) EXPECT_EQ(from(corner), v);
    }
}

// ---- Levels ------------------------------------------------------------------------------------

TEST(MeshSubdivision, NoLevelIsTheMeshItself) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            expectSame(finer(mesh, scheme, 0), mesh, name);
        }
    }
}

TEST(MeshSubdivision, LevelsAtOnceAreLevelsOneByOneToTheBit) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            // √3 cuts boundaries in every second level of a call, so pairs of levels are one step.
            const int step = scheme == MeshScheme::sqrt3 && mesh.counts().boundaryEdges > 0 ? 2 : 1;
            Mesh one = finer(mesh, scheme, step);
            for (int level = 2 * step; level <= 4; level += step) {
                one = finer(one, scheme, step);
                expectSame(finer(mesh, scheme, level), one, name + ' ' + nameOf(scheme));
            }
        }
    }
}

TEST(MeshSubdivision, EveryLevelIsAMesh) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            for (int levels = 1; levels <= 4; ++levels) {
                const Mesh found = finer(mesh, scheme, levels);
                const PlainMesh lists = plain(found);
                const auto checked = test::meshOf(lists.points, lists.faces);
                EXPECT_TRUE(checked.ok()) << name << ' ' << nameOf(scheme) << ' ' << levels;
                EXPECT_TRUE(!checked.ok() ||
                            std::equal(found.edges().begin(), found.edges().end(),
                                       checked->edges().begin(), checked->edges().end()));
            }
        }
    }
}

std::vector<Vec3> moved(std::span<const Vec3> points, const Mat3& by, const Vec3& shift) {
    std::vector<Vec3> found;
    for (const Vec3& p : points) found.push_back(by * p + shift);
    return found;
}

TEST(MeshSubdivision, IsAffinelyInvariant) {
    const Mat3 by{1.5, 0.25, -0.5, 0.75, -2, 1, 0.1, 0.3, 0.9};
    const Vec3 shift{3, -1, 2};
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            PlainMesh lists = plain(mesh);
            lists.points = moved(lists.points, by, shift);
            const Mesh after = finer(*test::meshOf(lists.points, lists.faces), scheme, 3);
            const auto before = moved(finer(mesh, scheme, 3).points(), by, shift);
            EXPECT_LT(farthestPoint(after.points(), before), test::gates::affineLevels)
                << name << ' ' << nameOf(scheme);
        }
    }
}

TEST(MeshSubdivision, KeepsEqualCoordinatesToTheBit) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            PlainMesh lists = plain(mesh);
            for (Vec3& p : lists.points) p.z = 0.1;
            const Mesh found = finer(*test::meshOf(lists.points, lists.faces), scheme, 3);
            EXPECT_TRUE(std::all_of(found.points().begin(), found.points().end(),
                                    [](const Vec3& p) { return p.z == 0.1; }))
                << name << ' ' << nameOf(scheme);
        }
    }
}

TEST(MeshSubdivision, TheButterflyKeepsAllPoints) {
    for (const auto& [name, mesh] : zooFor(MeshScheme::butterfly)) {
        const Mesh found = finer(mesh, MeshScheme::butterfly, 3);
        EXPECT_TRUE(std::equal(mesh.points().begin(), mesh.points().end(), found.points().begin()))
            << name;
    }
}

// ---- Counts ------------------------------------------------------------------------------------

TEST(MeshSubdivisionCounts, AreThoseOfTheLaws) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            const MeshCounts c = mesh.counts();
            const std::size_t corners = mesh.corners().size();
            const MeshCounts found = finer(mesh, scheme, 1).counts();
            const std::string what = name + ' ' + nameOf(scheme);
            switch (scheme) {
                case MeshScheme::catmullClark:
                    EXPECT_EQ(found, (MeshCounts{c.vertices + c.edges + c.faces,
                                                 2 * c.edges + corners, corners,
                                                 2 * c.boundaryEdges})) << what;
                    break;
                case MeshScheme::dooSabin:
                    EXPECT_EQ(found.vertices, corners + 2 * c.boundaryEdges) << what;
                    // between two faces around a vertex there is no room for a third
                    EXPECT_EQ(found.edges + (name == "pillow" ? 3 : 0),
                              2 * corners + 3 * c.boundaryEdges) << what;
                    EXPECT_EQ(found.boundaryEdges, 2 * c.boundaryEdges) << what;
                    break;
                case MeshScheme::sqrt3:
                    EXPECT_EQ(found, (MeshCounts{c.vertices + c.faces, c.edges + 3 * c.faces,
                                                 3 * c.faces, c.boundaryEdges})) << what;
                    break;
                default:
                    EXPECT_EQ(found, (MeshCounts{c.vertices + c.edges, 2 * c.edges + 3 * c.faces,
                                                 4 * c.faces, 2 * c.boundaryEdges})) << what;
            }
        }
    }
}

TEST(MeshSubdivisionCounts, TwoLevelsOfSqrt3CutEveryTriangleInNineAndEveryEdgeInThree) {
    for (const auto& [name, mesh] : zooFor(MeshScheme::sqrt3)) {
        const MeshCounts c = mesh.counts();
        EXPECT_EQ(finer(mesh, MeshScheme::sqrt3, 2).counts(),
                  (MeshCounts{c.vertices + 2 * c.edges + c.faces, 3 * c.edges + 9 * c.faces,
                              9 * c.faces, 3 * c.boundaryEdges})) << name;
    }
}

TEST(MeshSubdivisionCounts, EulersCharacteristicStays) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const auto& [name, mesh] : zooFor(scheme)) {
            // Doo–Sabin drops vertices without faces, and parts fans that meet in one.
            if (scheme == MeshScheme::dooSabin && (name == "scanned" || name == "cones" ||
                                                   name == "bow tie" || name == "open house")) {
                continue;
            }
            for (int levels = 1; levels <= 3; ++levels) {
                EXPECT_EQ(eulerCharacteristic(finer(mesh, scheme, levels).counts()),
                          eulerCharacteristic(mesh.counts()))
                    << name << ' ' << nameOf(scheme);
            }
        }
    }
}

// ---- Boundaries --------------------------------------------------------------------------------

TEST(MeshSubdivisionBoundaries, AreCurvesThatKnowNothingOfTheInside) {
    for (const MeshScheme scheme : allSchemes()) {
        const Mesh mesh = test::shaken(test::triangleGrid(4, 4), 5);
        std::vector<Vec3> inner(mesh.points().begin(), mesh.points().end());
        inner[6] += Vec3{0, 0, 9};
        inner[12] += Vec3{5, 0, 9};
        const Mesh other = *Mesh::make(inner, {mesh.corners().begin(), mesh.corners().end()}, 3);
        const Mesh a = finer(mesh, scheme, 4);
        const Mesh b = finer(other, scheme, 4);
        for (const MeshEdge& edge : a.edges()) {
            if (!edge.onBoundary()) continue;
            EXPECT_EQ(a.points()[edge.v0], b.points()[edge.v0]) << nameOf(scheme);
        }
    }
}

TEST(MeshSubdivisionBoundaries, OfDooSabinAreChaikins) {
    const Mesh mesh = test::openFan(4);
    const Mesh found = finer(mesh, MeshScheme::dooSabin, 1);
    std::size_t near = 0;
    for (const MeshEdge& edge : found.edges()) {
        if (!edge.onBoundary()) continue;
        const Vec3 p = found.points()[edge.v0];
        for (const MeshEdge& old : mesh.edges()) {
            if (!old.onBoundary()) continue;
            const Vec3 a = mesh.points()[old.v0];
            const Vec3 b = mesh.points()[old.v1];
            near += glm::length(p - (0.75 * a + 0.25 * b)) < 1e-15 ? 1U : 0U;
            near += glm::length(p - (0.25 * a + 0.75 * b)) < 1e-15 ? 1U : 0U;
        }
    }
    EXPECT_EQ(near, 2 * mesh.counts().boundaryEdges);
}

TEST(MeshSubdivisionBoundaries, OfSqrt3AreCutByTheTernaryRule) {
    const Mesh mesh = test::openFan(5);
    const Mesh found = finer(mesh, MeshScheme::sqrt3, 2);
    const auto p = mesh.points();
    const auto has = [&](const Vec3& expected) {
        return std::any_of(found.points().begin(), found.points().end(), [&](const Vec3& q) {
            return glm::length(q - expected) < test::gates::subdivided;
        });
    };
    for (std::size_t i = 0; i < p.size(); ++i) {  // all lie on the boundary, in this order
        const Vec3 a = p[(i + p.size() - 1) % p.size()];
        const Vec3 b = p[i];
        const Vec3 c = p[(i + 1) % p.size()];
        EXPECT_TRUE(has((4.0 * a + 19.0 * b + 4.0 * c) / 27.0));
        EXPECT_TRUE(has((10.0 * a + 16.0 * b + c) / 27.0));
        EXPECT_TRUE(has((a + 16.0 * b + 10.0 * c) / 27.0));
    }
}

TEST(MeshSubdivisionBoundaries, VerticesWithoutFacesStayWhereTheyAre) {
    const Mesh mesh = test::scannedMesh(9, 12, 3);
    std::vector<bool> used(mesh.points().size(), false);
    for (const std::uint32_t v : mesh.corners()) used[v] = true;
    for (const MeshScheme scheme : allSchemes()) {
        if (scheme == MeshScheme::dooSabin) continue;
        const Mesh found = finer(mesh, scheme, 3);
        for (std::size_t v = 0; v < used.size(); ++v) {
            EXPECT_TRUE(used[v] || found.points()[v] == mesh.points()[v]) << nameOf(scheme);
        }
    }
}

// ---- Large and odd -----------------------------------------------------------------------------

TEST(MeshSubdivisionCost, AllFansTogetherHaveAsManyCornersAsTheMesh) {
    for (const auto& [name, mesh] : zooFor(MeshScheme::catmullClark)) {
        const CornerWalk walk(mesh.faces(), mesh.cornerEdges(), mesh.edges().size());
        std::size_t corners = 0;
        forEachFan(walk, [&](const Fan& fan) { corners += fan.corners.size(); });
        EXPECT_EQ(corners, mesh.corners().size()) << name;
    }
}

TEST(MeshSubdivisionCost, AVertexOfAHundredThousandFacesIsNoTrouble) {
    const Mesh wheel = test::fanMesh(100'000);
    for (const MeshScheme scheme : allSchemes()) {
        const Mesh found = finer(wheel, scheme, 2);
        EXPECT_GT(found.points().size(), 500'000U) << nameOf(scheme);
        EXPECT_TRUE(std::all_of(found.points().begin(), found.points().end(),
                                [](const Vec3& p) { return isFinite(p); }));
    }
}

TEST(MeshSubdivisionCost, ScannedMeshesOfAHundredThousandFacesAreNoTrouble) {
    const Mesh scanned = test::scannedMesh(225, 3, 1);
    ASSERT_GT(scanned.faces().count(), 95'000U);
    for (const MeshScheme scheme : allSchemes()) {
        const Mesh found = finer(scanned, scheme, 2);
        EXPECT_GT(found.faces().count(), 800'000U) << nameOf(scheme);
        EXPECT_TRUE(std::all_of(found.points().begin(), found.points().end(),
                                [](const Vec3& p) { return isFinite(p); }));
        if (scheme == MeshScheme::dooSabin) continue;
        EXPECT_EQ(limit(scanned, scheme)->normals.size(), scanned.points().size());
    }
}

// ---- Refusals ----------------------------------------------------------------------------------

TEST(MeshSubdivisionRefusals, NameTheFaceThatIsNoTriangle) {
    const Mesh house = *test::meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 0}},
                                     {{1, 4, 2}, {0, 1, 2, 3}});
    for (const MeshScheme scheme : {MeshScheme::loop, MeshScheme::butterfly, MeshScheme::sqrt3}) {
        for (const auto& result : {subdivide(house, scheme, 1), subdivide(house, scheme, 0)}) {
            ASSERT_FALSE(result.ok());
            EXPECT_EQ(result.error().code, Code::notSupported);
            EXPECT_EQ(result.error().path, "faces[1]");
        }
        EXPECT_EQ(limit(house, scheme).error().path, "faces[1]");
    }
    EXPECT_TRUE(subdivide(house, MeshScheme::catmullClark, 1).ok());
}

TEST(MeshSubdivisionRefusals, NameTheTriangleThatHasAnotherOnItsBack) {
    for (const MeshScheme scheme : {MeshScheme::loop, MeshScheme::butterfly, MeshScheme::sqrt3}) {
        const auto result = subdivide(test::pillowMesh(), scheme, 1);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, Code::notSupported);
        EXPECT_EQ(result.error().path, "faces[0]");
    }
}

TEST(MeshSubdivisionRefusals, ComeBeforeAnyMemoryIsTaken) {
    for (const MeshScheme scheme : allSchemes()) {
        const Mesh mesh = test::tetrahedronMesh();
        for (const int levels : {20, 31, 1'000'000, 2'147'483'647}) {
            const auto result = subdivide(mesh, scheme, levels);
            ASSERT_FALSE(result.ok());
            EXPECT_EQ(result.error().code, Code::tooLarge);
            EXPECT_EQ(result.error().path, "levels");
        }
        const auto negative = subdivide(mesh, scheme, -1);
        EXPECT_EQ(negative.error().code, Code::outOfRange);
        EXPECT_EQ(negative.error().path, "levels");
    }
}

TEST(MeshSubdivisionRefusals, BeginWhereAMeshWouldBeTooLarge) {
    // 6 · 4^9 + 2 vertices are fewer than 4 million, 6 · 4^10 + 2 more.
    EXPECT_TRUE(subdivide(test::cubeMesh(), MeshScheme::catmullClark, 9).ok());
    EXPECT_EQ(subdivide(test::cubeMesh(), MeshScheme::catmullClark, 10).error().code,
              Code::tooLarge);
}

TEST(MeshSubdivisionRefusals, CountWhatBoundariesAdd) {
    // Four levels of √3 make 55 vertices of each lonely triangle, nine of them on its sides in
    // level 4.
    std::vector<Vec3> points;
    Corners corners;
    for (std::uint32_t i = 0; i < 3 * 75'000; ++i) {
        points.emplace_back(i / 3, i % 3 == 1 ? 1 : 0, i % 3 == 2 ? 1 : 0);
        corners.push_back(i);
    }
    const Mesh lonely = *Mesh::make(std::move(points), std::move(corners), 3);
    EXPECT_EQ(finer(lonely, MeshScheme::sqrt3, 3).points().size(), 75'000U * 19);
    EXPECT_EQ(subdivide(lonely, MeshScheme::sqrt3, 4).error().code, Code::tooLarge);
}

TEST(MeshSubdivisionClassification, IsThatOfTheBooks) {
    for (const MeshScheme scheme : allSchemes()) {
        const MeshClassification found = classification(scheme);
        EXPECT_EQ(found.approximating, scheme != MeshScheme::butterfly);
        EXPECT_EQ(found.extraordinary, "C1");
        EXPECT_EQ(found.mesh, scheme == MeshScheme::catmullClark || scheme == MeshScheme::dooSabin
                                  ? "any" : "triangles");
        EXPECT_EQ(found.regular,
                  scheme == MeshScheme::dooSabin || scheme == MeshScheme::butterfly ? "C1" : "C2");
    }
}

}  // namespace
}  // namespace knotwork
