#include "geometry/triangulation.hpp"

#include "geometry/solids.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::Corners;
using test::meshOf;

TEST(Triangulation, CutsAFaceOfNVerticesIntoNMinusTwo) {
    for (const SolidDescription& description : solids()) {
        const Mesh mesh = *makeSolid(description.name);
        const auto triangles = triangulated(mesh);
        ASSERT_TRUE(triangles.ok()) << description.name;
        const std::size_t expected = mesh.corners().size() - 2 * mesh.faces().count();
        EXPECT_EQ(triangles->faces().count(), expected) << description.name;
        EXPECT_EQ(triangles->uniformSize(), 3U);
        EXPECT_EQ(triangles->counts().boundaryEdges, mesh.counts().boundaryEdges);
        EXPECT_EQ(eulerCharacteristic(triangles->counts()), eulerCharacteristic(mesh.counts()));
    }
}

TEST(Triangulation, LeavesTrianglesAsTheyAre) {
    const Mesh mesh = *makeSolid("icosahedron");
    EXPECT_EQ(triangulated(mesh)->points().data(), mesh.points().data());
    EXPECT_EQ(triangleIndices(mesh), Corners(mesh.corners().begin(), mesh.corners().end()));
}

TEST(Triangulation, CutsAQuadAlongItsShorterDiagonal) {
    const std::vector<Vec3> wide{{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(triangleIndices(*meshOf(wide, {{0, 1, 2, 3}})), (Corners{1, 2, 3, 1, 3, 0}));
    EXPECT_EQ(triangleIndices(*meshOf(wide, {{1, 2, 3, 0}})), (Corners{1, 2, 3, 1, 3, 0}));
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(triangleIndices(*meshOf(square, {{0, 1, 2, 3}})), (Corners{0, 1, 2, 0, 2, 3}));
}

TEST(Triangulation, CutsAConcaveQuadFromItsNotch) {
    // The line between the two wings is the shorter one, but it lies outside.
    const std::vector<Vec3> arrow{{0, 0, 0}, {4, -0.5, 0}, {1, 0, 0}, {4, 0.5, 0}};
    EXPECT_EQ(triangleIndices(*meshOf(arrow, {{0, 1, 2, 3}})), (Corners{0, 1, 2, 0, 2, 3}));
    const std::vector<Vec3> turned{{4, -0.5, 0}, {1, 0, 0}, {4, 0.5, 0}, {0, 0, 0}};
    EXPECT_EQ(triangleIndices(*meshOf(turned, {{0, 1, 2, 3}})), (Corners{1, 2, 3, 1, 3, 0}));
}

TEST(Triangulation, OfTwoFacesCutAlongTheSameLineIsNoMesh) {
    const Mesh pillow = *meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                {{0, 1, 2, 3}, {3, 2, 1, 0}});
    const auto made = triangulated(pillow);
    // One is cut from 0 to 2, the other from 3 to 1.
    EXPECT_TRUE(made.ok());
    const Mesh narrow = *meshOf({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}},
                                {{0, 1, 2, 3}, {3, 2, 1, 0}});
    const auto refused = triangulated(narrow);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, Code::notManifold);
    EXPECT_EQ(refused.error().path, "edges[1,3]");
}

}  // namespace
}  // namespace knotwork
