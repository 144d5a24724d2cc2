#include "geometry/mesh_subdivision.hpp"
#include "support/mesh_gates.hpp"
#include "support/mesh_zoo.hpp"

#include "geometry/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::finer;
using test::nameOf;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr MeshScheme schemes[] = {MeshScheme::catmullClark, MeshScheme::loop};

/// Every edge of the mesh as sharp as this.
std::vector<MeshCrease> everyEdge(const Mesh& mesh, double sharpness) {
    std::vector<MeshCrease> creases;
    for (const MeshEdge& edge : mesh.edges()) creases.push_back({edge.v1, edge.v0, sharpness});
    return creases;
}

Mesh creased(const Mesh& mesh, std::vector<MeshCrease> creases) {
    return *mesh.withCreases(std::move(creases));
}

bool samePoints(const Mesh& a, const Mesh& b) {
    return a.points().size() == b.points().size() &&
           std::equal(a.points().begin(), a.points().end(), b.points().begin());
}

/// A shaken grid with a crease along its middle column, from one boundary to the other.
struct Ridge {
    Mesh mesh;
    std::vector<std::uint32_t> line;

    [[nodiscard]] std::vector<MeshCrease> creases(double sharpness) const {
        std::vector<MeshCrease> all;
        for (std::size_t i = 1; i < line.size(); ++i) {
            all.push_back({line[i - 1], line[i], sharpness});
        }
        return all;
    }
};

Ridge ridge(MeshScheme scheme) {
    constexpr std::uint32_t size = 6;
    const bool triangles = scheme == MeshScheme::loop;
    Ridge made{test::shaken(triangles ? test::triangleGrid(size, size)
                                      : test::gridMesh(size, size), 5),
               {}};
    for (std::uint32_t j = 0; j <= size; ++j) made.line.push_back((size + 1) * j + size / 2);
    return made;
}

/// One level of the uniform cubic B-spline with fixed ends: v, middle, v, …
std::vector<Vec3> refinedLine(const std::vector<Vec3>& line) {
    std::vector<Vec3> finer;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool end = i == 0 || i + 1 == line.size();
        finer.push_back(end ? line[i] : (line[i - 1] + 6.0 * line[i] + line[i + 1]) / 8.0);
        if (i + 1 < line.size()) finer.push_back((line[i] + line[i + 1]) / 2.0);
    }
    return finer;
}

/// The vertices of the creases of a mesh, where they are one line from `first` on.
std::vector<Vec3> creaseLine(const Mesh& mesh, std::uint32_t first) {
    std::vector<Vec3> line{mesh.points()[first]};
    std::vector<bool> used(mesh.creases().size(), false);
    for (std::size_t found = 0; found < used.size(); ++found) {
        for (std::size_t k = 0; k < used.size(); ++k) {
            const MeshCrease& crease = mesh.creases()[k];
            if (used[k] || (crease.v0 != first && crease.v1 != first)) continue;
            used[k] = true;
            first = crease.v0 == first ? crease.v1 : crease.v0;
            line.push_back(mesh.points()[first]);
            break;
        }
    }
    return line;
}

TEST(MeshCreases, AnInfiniteOneIsTheCubicBSplineOfItsEdgesBetweenCorners) {
    for (const MeshScheme scheme : schemes) {
        const Ridge given = ridge(scheme);
        Mesh mesh = creased(given.mesh, given.creases(infinite));
        std::vector<Vec3> expected;
        for (const std::uint32_t v : given.line) expected.push_back(mesh.points()[v]);
        for (int level = 1; level <= 4; ++level) {
            mesh = finer(mesh, scheme, 1);
            expected = refinedLine(expected);
            const std::vector<Vec3> found = creaseLine(mesh, given.line.front());
            ASSERT_EQ(found.size(), expected.size()) << nameOf(scheme);
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_LT(glm::length(found[i] - expected[i]), test::gates::subdivided)
                    << nameOf(scheme) << ' ' << level << ' ' << i;
            }
        }
    }
}

TEST(MeshCreases, OneOfSharpnessNIsAsAnInfiniteOneForNLevelsAndThenSmooth) {
    for (const MeshScheme scheme : schemes) {
        const Ridge given = ridge(scheme);
        const Mesh sharp = creased(given.mesh, given.creases(infinite));
        for (int n = 1; n <= 3; ++n) {
            const Mesh mesh = creased(given.mesh, given.creases(n));
            EXPECT_TRUE(samePoints(finer(mesh, scheme, n), finer(sharp, scheme, n)));
            EXPECT_TRUE(finer(mesh, scheme, n).creases().empty());
            const Mesh last = finer(mesh, scheme, n);
            const Mesh bare = last.withTrustedCreases({});
            EXPECT_TRUE(samePoints(finer(mesh, scheme, n + 1), finer(bare, scheme, 1)));
            EXPECT_FALSE(samePoints(finer(mesh, scheme, n + 1), finer(sharp, scheme, n + 1)));
        }
    }
}

TEST(MeshCreases, OneOfSharpnessBelowOneLiesBetweenSmoothAndSharpInProportion) {
    for (const MeshScheme scheme : schemes) {
        const Ridge given = ridge(scheme);
        const Mesh smooth = finer(given.mesh, scheme, 1);
        const Mesh sharp = finer(creased(given.mesh, given.creases(1)), scheme, 1);
        for (const double s : {1e-9, 0.25, 0.5, 0.9}) {
            const Mesh found = finer(creased(given.mesh, given.creases(s)), scheme, 1);
            double moved = 0;
            for (std::size_t i = 0; i < found.points().size(); ++i) {
                const Vec3 way = sharp.points()[i] - smooth.points()[i];
                moved = std::max(moved, glm::length(way));
                const Vec3 gap = found.points()[i] - (smooth.points()[i] + s * way);
                EXPECT_LT(glm::length(gap), test::gates::subdivided) << nameOf(scheme) << ' ' << i;
            }
            EXPECT_GT(moved, 0.01);
        }
    }
}

TEST(MeshCreases, OfSharpnessTwoAndAHalfAreSharpForTwoLevelsAndHalfSharpInTheThird) {
    for (const MeshScheme scheme : schemes) {
        const Ridge given = ridge(scheme);
        const Mesh two = finer(creased(given.mesh, given.creases(2.5)), scheme, 2);
        ASSERT_FALSE(two.creases().empty());
        for (const MeshCrease& crease : two.creases()) EXPECT_EQ(crease.sharpness, 0.5);
        EXPECT_EQ(two.creases().size(), 4 * (given.line.size() - 1));
        EXPECT_TRUE(samePoints(two, finer(creased(given.mesh, given.creases(2)), scheme, 2)));
    }
}

TEST(MeshCreases, ACubeWhoseEdgesAreAllInfinitelySharpStaysACube) {
    const Mesh cube = test::cubeMesh();
    const Mesh fine = finer(creased(cube, everyEdge(cube, infinite)), MeshScheme::catmullClark, 4);
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(fine.points()[v], cube.points()[v]);
    for (const Vec3& p : fine.points()) {
        EXPECT_EQ(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1);
    }
    EXPECT_EQ(fine.creases().size(), 12U * 16);
}

TEST(MeshCreases, WhereThreeMeetThereIsACornerAndOneAloneEndsSmoothly) {
    for (const MeshScheme scheme : schemes) {
        const Mesh mesh = test::shaken(test::rosette(6), 3);
        const Vec3 tip = mesh.points()[0];
        const auto tipWith = [&](std::vector<MeshCrease> creases) {
            return finer(creased(mesh, std::move(creases)), scheme, 1).points()[0];
        };
        const Vec3 smooth = finer(mesh, scheme, 1).points()[0];
        const Vec3 p = mesh.points()[1];
        const Vec3 q = mesh.points()[3];
        EXPECT_EQ(tipWith({{0, 1, infinite}}), smooth);
        const Vec3 two = tipWith({{0, 1, infinite}, {3, 0, infinite}});
        EXPECT_LT(glm::length(two - (p + 6.0 * tip + q) / 8.0), test::gates::subdivided);
        EXPECT_EQ(tipWith({{0, 1, infinite}, {0, 3, infinite}, {5, 0, 1}}), tip);
        // The third fades out: between the corner and the curve of the other two.
        const Vec3 fading = tipWith({{0, 1, infinite}, {0, 3, infinite}, {0, 5, 0.25}});
        EXPECT_LT(glm::length(fading - (0.75 * two + 0.25 * tip)), test::gates::subdivided);
        // Two fade out by different sharpnesses: by their mean.
        const Vec3 both = tipWith({{0, 1, 0.5}, {0, 3, 0.1}});
        EXPECT_LT(glm::length(both - (0.7 * smooth + 0.3 * two)), test::gates::subdivided);
    }
}

TEST(MeshCreases, EndInACornerOfTheBoundaryAndChangeNothingOnIt) {
    for (const MeshScheme scheme : schemes) {
        const Ridge given = ridge(scheme);
        const Mesh smooth = finer(given.mesh, scheme, 1);
        const Mesh sharp = finer(creased(given.mesh, given.creases(infinite)), scheme, 1);
        const std::uint32_t end = given.line.front();
        EXPECT_EQ(sharp.points()[end], given.mesh.points()[end]);
        EXPECT_NE(smooth.points()[end], given.mesh.points()[end]);
        std::vector<MeshCrease> around;
        for (const MeshEdge& edge : given.mesh.edges()) {
            if (edge.onBoundary()) around.push_back({edge.v0, edge.v1, 3});
        }
        EXPECT_TRUE(samePoints(finer(creased(given.mesh, around), scheme, 2),
                               finer(given.mesh, scheme, 2)));
    }
}

TEST(MeshCreases, LevelsOneByOneAndAtOnceAreTheSame) {
    for (const MeshScheme scheme : schemes) {
        for (const auto& [name, mesh] : test::zooFor(scheme)) {
            std::vector<MeshCrease> creases;
            for (std::size_t e = 0; e < mesh.edges().size(); e += 2) {
                const double sharpness = e % 3 == 0 ? infinite : 0.4 * static_cast<double>(e % 7 + 1);
                creases.push_back({mesh.edges()[e].v0, mesh.edges()[e].v1, sharpness});
            }
            const Mesh given = creased(mesh, creases);
            const Mesh one = finer(finer(finer(given, scheme, 1), scheme, 1), scheme, 1);
            const Mesh atOnce = finer(given, scheme, 3);
            EXPECT_TRUE(samePoints(one, atOnce)) << name << ' ' << nameOf(scheme);
            ASSERT_EQ(one.creases().size(), atOnce.creases().size()) << name;
            EXPECT_TRUE(std::equal(one.creases().begin(), one.creases().end(),
                                   atOnce.creases().begin())) << name << ' ' << nameOf(scheme);
        }
    }
}

TEST(MeshCreases, StayOnTheTrianglesThatFacesAreCutInto) {
    const Mesh cube = creased(test::cubeMesh(), everyEdge(test::cubeMesh(), 2));
    const Mesh cut = *triangulated(cube);
    EXPECT_TRUE(std::equal(cube.creases().begin(), cube.creases().end(), cut.creases().begin(),
                           cut.creases().end()));
    EXPECT_EQ(finer(cut, MeshScheme::loop, 2).points()[0], cube.points()[0]);
}

void expectRefusal(const std::vector<MeshCrease>& creases, Code code, const std::string& path,
                   const std::string& words) {
    const auto made = test::cubeMesh().withCreases(creases);
    ASSERT_FALSE(made.ok()) << path;
    EXPECT_EQ(codeName(made.error().code), codeName(code)) << path;
    EXPECT_EQ(made.error().path, path);
    EXPECT_NE(made.error().message.find(words), std::string::npos) << made.error().message;
}

TEST(MeshCreases, ThatCannotBeAreRefusedByTheirPlace) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    expectRefusal({{0, 1, 1}, {0, 2, 1}}, Code::outOfRange, "creases[1].edge", "0 and 2");
    expectRefusal({{0, 1, 1}, {7, 99, 1}}, Code::outOfRange, "creases[1].edge", "no edge");
    expectRefusal({{0, 0, 1}}, Code::outOfRange, "creases[0].edge", "no edge");
    expectRefusal({{0, 1, 1}, {1, 2, 1}, {1, 0, 1}}, Code::outOfRange, "creases[2].edge", "twice");
    expectRefusal({{0, 1, 0}}, Code::outOfRange, "creases[0].sharpness", "is 0");
    expectRefusal({{0, 1, -1}}, Code::outOfRange, "creases[0].sharpness", "at most 10");
    expectRefusal({{0, 1, 10.5}}, Code::outOfRange, "creases[0].sharpness", "10.5");
    expectRefusal({{0, 1, nan}}, Code::notFinite, "creases[0].sharpness", "NaN");
}

TEST(MeshCreases, AreForSchemesThatKnowThemAndHaveNoLimitByAFormula) {
    const Mesh mesh = creased(test::tetrahedronMesh(), {{0, 1, 2}});
    for (const MeshScheme scheme : test::allSchemes()) {
        const bool knows = scheme == MeshScheme::catmullClark || scheme == MeshScheme::loop;
        const auto fine = subdivide(mesh, scheme, 1);
        EXPECT_EQ(fine.ok(), knows) << nameOf(scheme);
        if (!knows) {
            EXPECT_EQ(fine.error().code, Code::notSupported);
            EXPECT_EQ(fine.error().path, "scheme");
            continue;
        }
        EXPECT_EQ(limit(mesh, scheme).error().code, Code::notSupported);
        EXPECT_EQ(limit(mesh, scheme).error().path, "creases");
        EXPECT_TRUE(limit(finer(mesh, scheme, 2), scheme).ok());
    }
}

}  // namespace
}  // namespace knotwork
