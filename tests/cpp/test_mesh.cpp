#include "geometry/mesh.hpp"

#include "geometry/mesh_edges.hpp"
#include "support/gates.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace knotwork {
namespace {

using test::Corners;
using test::cubeMesh;
using test::FaceLists;
using test::fanMesh;
using test::gridMesh;
using test::meshOf;
using test::scannedMesh;
using test::tetrahedronMesh;
using test::triangleGrid;

std::vector<Vec3> somePoints(std::size_t count) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(i, i * i, i % 3);
    return points;
}

// ---- Edges -------------------------------------------------------------------------------------

TEST(Mesh, HasTheEdgesInTheOrderOfItsFaces) {
    const Mesh mesh = *meshOf(somePoints(5), {{0, 1, 2, 3}, {2, 1, 4}});
    const std::vector<MeshEdge> expected{{0, 1, 0, noFace}, {1, 2, 0, 1},      {2, 3, 0, noFace},
                                         {3, 0, 0, noFace}, {1, 4, 1, noFace}, {4, 2, 1, noFace}};
    EXPECT_EQ(std::vector<MeshEdge>(mesh.edges().begin(), mesh.edges().end()), expected);
    const auto numbers = mesh.cornerEdges();
    EXPECT_EQ(Corners(numbers.begin(), numbers.end()), (Corners{0, 1, 2, 3, 1, 4, 5}));
    EXPECT_EQ(mesh.counts(), (MeshCounts{5, 6, 2, 5}));
}

TEST(Mesh, OfTheSolidsHasEulersCharacteristicTwo) {
    EXPECT_EQ(cubeMesh().counts(), (MeshCounts{8, 12, 6, 0}));
    EXPECT_EQ(tetrahedronMesh().counts(), (MeshCounts{4, 6, 4, 0}));
    EXPECT_EQ(eulerCharacteristic(cubeMesh().counts()), 2);
    EXPECT_EQ(eulerCharacteristic(gridMesh(4, 7).counts()), 1);
    EXPECT_EQ(eulerCharacteristic({1, 3, 1, 0}), -1);
}

/// Whether every corner's edge joins it with the next, and every edge has the faces it names.
void expectEdgesAreRight(const Mesh& mesh) {
    const auto edges = mesh.edges();
    std::vector<int> met(edges.size(), 0);
    std::size_t corner = 0;
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        const auto face = mesh.faces()[f];
        for (std::size_t j = 0; j < face.size(); ++j, ++corner) {
            const std::uint32_t e = mesh.cornerEdges()[corner];
            ASSERT_LT(e, edges.size());
            const bool first = met[e]++ == 0;
            const std::uint32_t from = face[j];
            const std::uint32_t to = face[(j + 1) % face.size()];
            ASSERT_EQ(first ? edges[e].v0 : edges[e].v1, from);
            ASSERT_EQ(first ? edges[e].v1 : edges[e].v0, to);
            ASSERT_EQ(first ? edges[e].f0 : edges[e].f1, f);
        }
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
        ASSERT_EQ(met[e], edges[e].onBoundary() ? 1 : 2) << e;
    }
}

TEST(Mesh, EveryEdgeJoinsTheCornersOfItsFaces) {
    for (const Mesh& mesh : {cubeMesh(), tetrahedronMesh(), gridMesh(5, 3), triangleGrid(4, 4),
                             fanMesh(17), scannedMesh(30, 10, 1)}) {
        expectEdgesAreRight(mesh);
    }
}

TEST(Mesh, TheSameEdgesAreFoundInAMeshThatWasTrusted) {
    const Mesh checked = scannedMesh(20, 5, 2);
    const Mesh trusted = Mesh::trusted({checked.points().begin(), checked.points().end()},
                                       {checked.corners().begin(), checked.corners().end()}, 3);
    EXPECT_TRUE(std::equal(checked.edges().begin(), checked.edges().end(),
                           trusted.edges().begin(), trusted.edges().end()));
    const Mesh copy = trusted;
    EXPECT_EQ(copy.edges().data(), trusted.edges().data());
}

TEST(Mesh, FacesThatAreAlikeNeedNoStarts) {
    EXPECT_EQ(cubeMesh().uniformSize(), 4U);
    EXPECT_TRUE(cubeMesh().faceStarts().empty());
    const Mesh mixed = *meshOf(somePoints(5), {{0, 1, 2, 3}, {2, 1, 4}});
    EXPECT_EQ(mixed.uniformSize(), 0U);
    EXPECT_EQ(mixed.faces().count(), 2U);
    EXPECT_EQ(mixed.faces()[1].size(), 3U);
    const Mesh trusted = Mesh::trusted(somePoints(5), {0, 1, 2, 3, 2, 1, 4}, Corners{0, 4, 7});
    EXPECT_EQ(trusted.faces()[1][2], 4U);
    EXPECT_EQ(Mesh::trusted(somePoints(3), {0, 1, 2}, Corners{0, 3}).uniformSize(), 3U);
}

// ---- Cost --------------------------------------------------------------------------------------

struct Steps {
    std::size_t count = 0;
    void step() noexcept { ++count; }
};

std::size_t stepsOf(const Mesh& mesh) {
    Steps steps;
    const auto matched = EdgeMatcher<Steps>(mesh.faces(), mesh.points().size(), steps).match();
    EXPECT_FALSE(matched.clash);
    return steps.count;
}

TEST(MeshCost, EdgesTakeFourStepsACornerAndOneAVertexWhateverTheValences) {
    for (const Mesh& mesh : {gridMesh(10, 10), gridMesh(200, 100), triangleGrid(100, 50),
                             fanMesh(10), fanMesh(100'000), scannedMesh(100, 3, 3)}) {
        EXPECT_EQ(stepsOf(mesh), 4 * mesh.corners().size() + mesh.points().size());
    }
}

TEST(MeshCost, AScannedMeshOfAHundredThousandFacesIsMadeAndEveryEdgeIsRight) {
    const Mesh mesh = scannedMesh(230, 3, 4);
    EXPECT_GT(mesh.faces().count(), 100'000U);
    expectEdgesAreRight(mesh);
    EXPECT_GT(mesh.counts().boundaryEdges, 4 * 230U);
    std::vector<double> normals(3 * mesh.points().size());
    vertexNormals(mesh, normals);
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const double length = glm::length(Vec3{normals[i], normals[i + 1], normals[i + 2]});
        EXPECT_TRUE(length == 0 || std::abs(length - 1) < test::gates::exact) << i / 3;
    }
}

// ---- What is not a mesh ------------------------------------------------------------------------

void expectRefusal(const Result<Mesh>& made, Code code, const std::string& path,
                   const std::string& words) {
    ASSERT_FALSE(made.ok()) << path;
    EXPECT_EQ(codeName(made.error().code), codeName(code)) << path;
    EXPECT_EQ(made.error().path, path);
    EXPECT_NE(made.error().message.find(words), std::string::npos) << made.error().message;
}

TEST(MeshRefusals, AnEdgeWithThreeFacesIsNamedByItsVertices) {
    expectRefusal(meshOf(somePoints(8), {{3, 7, 0}, {7, 3, 1}, {3, 7, 2}}), Code::notManifold,
                  "edges[3,7]", "has 3 faces, 0 and 2 among them");
    expectRefusal(meshOf(somePoints(8), {{3, 7, 0}, {3, 7, 1}, {7, 3, 2}, {7, 3, 4}}),
                  Code::notManifold, "edges[3,7]", "has 4 faces, 0 and 1 among them");
}

TEST(MeshRefusals, AFaceThatRunsAgainstItsNeighbourIsNamedWithTheirEdge) {
    expectRefusal(meshOf(somePoints(4), {{0, 2, 1}, {2, 1, 3}}), Code::notManifold, "edges[1,2]",
                  "The faces 0 and 1 go along the edge between the vertices 1 and 2");
    const Mesh cube = cubeMesh();
    FaceLists faces;
    for (std::size_t f = 0; f < 6; ++f) {
        faces.emplace_back(cube.faces()[f].begin(), cube.faces()[f].end());
    }
    std::reverse(faces[5].begin(), faces[5].end());
    const auto made = meshOf({cube.points().begin(), cube.points().end()}, faces);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, Code::notManifold);
    EXPECT_NE(made.error().message.find("and 5 go along"), std::string::npos);
}

TEST(MeshRefusals, FacesOfDifferentSizesAreNamedRightlyToo) {
    expectRefusal(meshOf(somePoints(9), {{0, 1, 2, 3, 4}, {4, 5, 6}, {5, 6, 7, 8}, {6, 5, 0, 2}}),
                  Code::notManifold, "edges[5,6]", "has 3 faces, 1 and 2 among them");
    expectRefusal(meshOf(somePoints(9), {{0, 1, 2, 3, 4}, {4, 5, 6}, {6, 7, 8, 4}, {7, 1, 2}}),
                  Code::notManifold, "edges[1,2]", "The faces 0 and 3 go along");
}

TEST(MeshRefusals, TheSameFaceTwiceIsNoMeshButTheSameTurnedRoundIsAPillow) {
    expectRefusal(meshOf(somePoints(3), {{0, 1, 2}, {1, 2, 0}}), Code::notManifold, "edges[0,2]",
                  "faces 0 and 1");
    const Mesh pillow = *meshOf(somePoints(3), {{0, 1, 2}, {2, 1, 0}});
    EXPECT_EQ(pillow.counts(), (MeshCounts{3, 3, 2, 0}));
}

TEST(MeshRefusals, FacesNameVerticesThatThereAreEachOnce) {
    expectRefusal(meshOf(somePoints(4), {{0, 1, 2}, {0, 2, 4}}), Code::outOfRange, "faces[1][2]",
                  "There is no vertex 4; there are 0 to 3");
    expectRefusal(meshOf(somePoints(4), {{0, 1, 0xffffffffU}}), Code::outOfRange, "faces[0][2]",
                  "4294967295");
    expectRefusal(meshOf(somePoints(4), {{0, 1, 2}, {0, 2, 3, 2}}), Code::outOfRange, "faces[1]",
                  "The vertex 2 comes twice");
    expectRefusal(meshOf(somePoints(4), {{0, 1, 2}, {0, 2}}), Code::wrongLength, "faces[1]",
                  "has 2 vertices");
    expectRefusal(meshOf(somePoints(4), {{}}), Code::wrongLength, "faces[0]", "has 0 vertices");
    expectRefusal(Mesh::make(somePoints(4), {0, 1, 2, 3}, 2), Code::wrongLength, "faces[0]",
                  "has 2 vertices");
    expectRefusal(Mesh::make(somePoints(4), {0, 1, 2, 3}, 3), Code::wrongLength, "faces", "add up");
    expectRefusal(Mesh::make(somePoints(4), {0, 1, 2, 3}, 0), Code::wrongLength, "faces",
                  "0 faces");
    expectRefusal(Mesh::make(somePoints(4), {0, 1, 2, 3}, Corners{0, 3}), Code::wrongLength,
                  "faces", "add up");
    expectRefusal(Mesh::make(somePoints(4), {0, 1, 2, 3}, Corners{0, 5, 4}), Code::wrongLength,
                  "faces", "add up");
}

TEST(MeshRefusals, PointsAreFiniteAndNotTooFarOut) {
    auto points = somePoints(4);
    points[2].y = std::numeric_limits<double>::quiet_NaN();
    expectRefusal(meshOf(points, {{0, 1, 2}}), Code::notFinite, "vertices[2]", "NaN");
    points[2].y = -2e12;
    expectRefusal(meshOf(points, {{0, 1, 2}}), Code::outOfRange, "vertices[2]", "-2e+12");
}

TEST(MeshRefusals, ThereAreVerticesAndFacesAndNotTooManyOfThem) {
    expectRefusal(meshOf({}, {{0, 1, 2}}), Code::wrongLength, "vertices", "0 vertices");
    expectRefusal(meshOf(somePoints(4), {}), Code::wrongLength, "faces", "0 faces");
    expectRefusal(Mesh::make(somePoints(4), {}, Corners{}), Code::wrongLength, "faces", "0 faces");
    expectRefusal(meshOf(std::vector<Vec3>(maxMeshVertices + 1), {{0, 1, 2}}), Code::tooLarge,
                  "vertices", "4000001 vertices");
    expectRefusal(Mesh::make(somePoints(4), Corners(maxMeshCorners + 1), Corners{0, 3}),
                  Code::tooLarge, "faces", "33554433");
}

TEST(Mesh, TheMostVerticesAreAllowed) {
    std::vector<Vec3> points(maxMeshVertices);
    EXPECT_TRUE(Mesh::make(std::move(points), {0, 1, maxMeshVertices - 1}, 3).ok());
}

// ---- Odd but allowed ---------------------------------------------------------------------------

TEST(Mesh, AVertexWithoutFacesAndABowTieAreAllowed) {
    const Mesh bowTie = *meshOf(somePoints(6), {{0, 1, 2}, {0, 3, 4}});
    EXPECT_EQ(bowTie.counts(), (MeshCounts{6, 6, 2, 6}));
    expectEdgesAreRight(bowTie);
}

// ---- Normals -----------------------------------------------------------------------------------

std::vector<Vec3> normalsOf(const Mesh& mesh) {
    std::vector<double> xyz(3 * mesh.points().size(), 7.0);
    vertexNormals(mesh, xyz);
    std::vector<Vec3> normals;
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
        normals.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    }
    return normals;
}

/// Every quad in two, some along one diagonal and some along the other.
Mesh cutInTwo(const Mesh& quads) {
    Corners corners;
    for (std::size_t f = 0; f < quads.faces().count(); ++f) {
        const auto q = quads.faces()[f];
        const Corners cut = f % 2 == 0 ? Corners{q[0], q[1], q[2], q[0], q[2], q[3]}
                                       : Corners{q[0], q[1], q[3], q[1], q[2], q[3]};
        corners.insert(corners.end(), cut.begin(), cut.end());
    }
    return *Mesh::make({quads.points().begin(), quads.points().end()}, std::move(corners), 3);
}

TEST(MeshNormals, OfACubePointOutwardsAlongItsDiagonalsHoweverItsSidesAreCut) {
    for (const Mesh& mesh : {cubeMesh(), cutInTwo(cubeMesh())}) {
        const auto normals = normalsOf(mesh);
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 outwards = glm::normalize(mesh.points()[i]);
            EXPECT_LT(glm::length(normals[i] - outwards), test::gates::exact);
        }
    }
}

TEST(MeshNormals, DoNotDependOnHowLargeAMeshIsOrWhereItLies) {
    const auto expected = normalsOf(scannedMesh(10, 0, 5));
    for (const double factor : {1e-300, 1e-3, 1e11}) {
        const Mesh mesh = scannedMesh(10, 0, 5);
        std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
        for (Vec3& p : points) p *= factor;
        const auto normals =
            normalsOf(*Mesh::make(points, {mesh.corners().begin(), mesh.corners().end()}, 3));
        for (std::size_t i = 0; i < normals.size(); ++i) {
            EXPECT_LT(glm::length(normals[i] - expected[i]), 1e-12) << factor << ' ' << i;
        }
    }
}

TEST(MeshNormals, OfAConcaveFaceHaveOneSide) {
    // An arrowhead: at its notch the legs turn the other way.
    const Mesh arrow = *meshOf({{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}}, {{0, 1, 2, 3}});
    for (const Vec3& normal : normalsOf(arrow)) EXPECT_EQ(normal, Vec3(0, 0, 1));
    // Started at the notch, and from the other side.
    const Mesh back = *meshOf({{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}}, {{2, 1, 0, 3}});
    for (const Vec3& normal : normalsOf(back)) EXPECT_EQ(normal, Vec3(0, 0, -1));
}

TEST(MeshNormals, WeighConcaveCornersByTheirInnerAngle) {
    // The notch has an inner angle of 3π/2 in one plane and meets a right angle of another there.
    const Mesh mesh = *meshOf({{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 0, 0},
                               {1, 0, 1}, {0, 0, 1}},
                              {{0, 1, 2, 3, 4, 5}, {0, 5, 6, 7}});
    const Vec3 normal = normalsOf(mesh)[0];
    const Vec3 expected = glm::normalize(3.0 * Vec3(0, 0, 1) + Vec3(0, -1, 0));
    EXPECT_LT(glm::length(normal - expected), test::gates::exact);
}

TEST(MeshNormals, AreZeroWhereThereIsNothingToBeNormalTo) {
    const Mesh mesh = *meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}});
    for (const Vec3& normal : normalsOf(mesh)) EXPECT_EQ(normal, Vec3(0));
}

}  // namespace
}  // namespace knotwork
