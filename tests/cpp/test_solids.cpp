#include "geometry/solids.hpp"

#include "support/gates.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace knotwork {
namespace {

/// As a stranger would give it: the checks of Mesh::make() apply.
Result<Mesh> madeAgain(const Mesh& mesh) {
    test::FaceLists faces;
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        faces.emplace_back(mesh.faces()[f].begin(), mesh.faces()[f].end());
    }
    return test::meshOf({mesh.points().begin(), mesh.points().end()}, faces);
}

Mesh solid(const std::string& name, const std::vector<NamedValue>& parameters = {}) {
    return *makeSolid(name, parameters);
}

double volume(const Mesh& mesh) {
    double six = 0;
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        const auto face = mesh.faces()[f];
        for (std::size_t j = 2; j < face.size(); ++j) {
            six += glm::dot(mesh.points()[face[0]],
                            glm::cross(mesh.points()[face[j - 1]], mesh.points()[face[j]]));
        }
    }
    return six / 6;
}

TEST(Solids, AreMeshesWithTheirCounts) {
    const std::map<std::string, MeshCounts> expected{
        {"tetrahedron", {4, 6, 4, 0}},     {"cube", {8, 12, 6, 0}},
        {"octahedron", {6, 12, 8, 0}},     {"dodecahedron", {20, 30, 12, 0}},
        {"icosahedron", {12, 30, 20, 0}},  {"cuboctahedron", {12, 24, 14, 0}},
        {"prism", {12, 18, 8, 0}},         {"torus", {288, 576, 288, 0}},
        {"sphere", {266, 552, 288, 0}},    {"grid", {81, 144, 64, 32}}};
    ASSERT_EQ(solids().size(), expected.size());
    for (const SolidDescription& description : solids()) {
        const std::string name(description.name);
        const Mesh mesh = solid(name);
        const auto again = madeAgain(mesh);
        ASSERT_TRUE(again.ok()) << name << ": " << again.error().message;
        EXPECT_EQ(mesh.counts(), expected.at(name)) << name;
        const std::ptrdiff_t characteristic = name == "torus" ? 0 : name == "grid" ? 1 : 2;
        EXPECT_EQ(eulerCharacteristic(mesh.counts()), characteristic) << name;
    }
}

TEST(Solids, HaveTheCornersThatPeopleExpect) {
    const auto expectCorners = [](const std::string& name, const std::vector<Vec3>& corners) {
        const Mesh mesh = solid(name);
        ASSERT_EQ(mesh.points().size(), corners.size()) << name;
        for (const Vec3& corner : corners) {
            EXPECT_EQ(std::count(mesh.points().begin(), mesh.points().end(), corner), 1) << name;
        }
    };
    expectCorners("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
    expectCorners("octahedron",
                  {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
    expectCorners("cube", {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1},
                           {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}});
}

TEST(Solids, AreInscribedInTheUnitSphere) {
    for (const std::string name :
         {"dodecahedron", "icosahedron", "cuboctahedron", "prism", "sphere"}) {
        const Mesh mesh = solid(name);
        for (const Vec3& p : mesh.points()) {
            EXPECT_NEAR(glm::length(p), 1, test::gates::exact) << name;
        }
    }
    for (const std::string name : {"torus", "grid"}) {
        double farthest = 0;
        const Mesh mesh = solid(name);
        for (const Vec3& p : mesh.points()) farthest = std::max(farthest, glm::length(p));
        EXPECT_NEAR(farthest, 1, test::gates::exact) << name;
    }
}

TEST(Solids, RunCounterClockwiseSeenFromOutside) {
    for (const SolidDescription& description : solids()) {
        const std::string name(description.name);
        if (name == "torus" || name == "grid") continue;  // not star-shaped about the origin
        const Mesh mesh = solid(name);
        for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
            const auto face = mesh.faces()[f];
            const auto p = mesh.points();
            const Vec3 normal = glm::cross(p[face[1]] - p[face[0]], p[face[2]] - p[face[0]]);
            EXPECT_GT(glm::dot(normal, p[face[0]]), 0) << name << ' ' << f;
        }
    }
    EXPECT_GT(volume(solid("torus")), 0);
    const Mesh grid = solid("grid");
    std::vector<double> normals(3 * grid.points().size());
    vertexNormals(grid, normals);
    for (std::size_t i = 2; i < normals.size(); i += 3) EXPECT_EQ(normals[i], 1);
}

TEST(Solids, HaveTheVolumesOfTheBooks) {
    const auto expectVolume = [](const std::string& name, double expected) {
        EXPECT_NEAR(volume(solid(name)), expected, 1e-13) << name;
    };
    const double sqrt5 = std::sqrt(5.0);
    expectVolume("tetrahedron", 8.0 / 3);
    expectVolume("cube", 8);
    expectVolume("octahedron", 4.0 / 3);
    expectVolume("dodecahedron", 2 * std::sqrt(3.0) / 9 * (5 + sqrt5));
    expectVolume("icosahedron", 2.0 / 3 * std::sqrt(10 + 2 * sqrt5));
    expectVolume("cuboctahedron", 5 * std::sqrt(2.0) / 3);
    // Fine ones come near the smooth ones.
    const double tube = 0.3;
    EXPECT_NEAR(volume(solid("torus", {{"around", 500}, {"across", 500}})),
                2 * M_PI * M_PI * (1 - tube) * tube * tube, 1e-4);
    EXPECT_NEAR(volume(solid("sphere", {{"around", 500}, {"across", 500}})), 4 * M_PI / 3, 1e-3);
}

TEST(Solids, FacesOfRegularOnesAreFlatAndAlike) {
    for (const std::string name : {"dodecahedron", "icosahedron", "cube", "octahedron",
                                   "tetrahedron", "cuboctahedron", "prism"}) {
        const Mesh mesh = solid(name);
        const auto p = mesh.points();
        const MeshEdge first = mesh.edges()[0];
        const double length = glm::length(p[first.v0] - p[first.v1]);
        for (const MeshEdge& edge : mesh.edges()) {
            EXPECT_NEAR(glm::length(p[edge.v0] - p[edge.v1]), length, test::gates::exact) << name;
        }
        for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
            const auto face = mesh.faces()[f];
            const Vec3 normal = glm::cross(p[face[1]] - p[face[0]], p[face[2]] - p[face[0]]);
            for (const std::uint32_t v : face) {
                EXPECT_NEAR(glm::dot(normal, p[v] - p[face[0]]), 0, test::gates::exact) << name;
            }
        }
    }
}

TEST(Solids, AreMeshesForEveryNumberOfFaces) {
    for (const double n : {3, 4, 5, 50}) {
        for (const double m : {3, 4, 9}) {
            EXPECT_TRUE(madeAgain(solid("torus", {{"around", n}, {"across", m}})).ok());
            EXPECT_TRUE(madeAgain(solid("sphere", {{"around", n}, {"across", m}})).ok());
            EXPECT_TRUE(madeAgain(solid("grid", {{"columns", n}, {"rows", m}})).ok());
        }
        EXPECT_TRUE(madeAgain(solid("prism", {{"sides", n}})).ok());
        EXPECT_TRUE(madeAgain(solid("sphere", {{"around", n}, {"across", 2}})).ok());
    }
    EXPECT_EQ(solid("grid", {{"columns", 1}, {"rows", 1}}).counts(), (MeshCounts{4, 4, 1, 4}));
}

TEST(Solids, RefuseNamesAndParametersThatThereAreNot) {
    const auto expectRefusal = [](const Result<Mesh>& made, Code code, const std::string& path) {
        ASSERT_FALSE(made.ok()) << path;
        EXPECT_EQ(made.error().code, code) << path;
        EXPECT_EQ(made.error().path, path);
    };
    const auto with = [](const std::string& name, const std::string& parameter, double value) {
        return makeSolid(name, std::vector<NamedValue>{{parameter, value}});
    };
    expectRefusal(makeSolid("teapot"), Code::unknownName, "solid");
    expectRefusal(with("cube", "sides", 4), Code::unknownField, "parameters.sides");
    expectRefusal(with("prism", "sides", 2), Code::outOfRange, "parameters.sides");
    expectRefusal(with("prism", "sides", 3.5), Code::notInteger, "parameters.sides");
    expectRefusal(with("torus", "tube", 0.5), Code::outOfRange, "parameters.tube");
    expectRefusal(with("torus", "tube", std::numeric_limits<double>::quiet_NaN()), Code::notFinite,
                  "parameters.tube");
    EXPECT_EQ(findSolid("teapot"), nullptr);
    EXPECT_EQ(findSolid("torus")->parameters.size(), 3U);
}

}  // namespace
}  // namespace knotwork
