// Subdivision and limits cost no more than their meshes are large: counts of what their own sources
// do, compiled in a namespace of their own over points and steps that count (geometry/ beside this).
// The edges that they begin with have counts of their own, in test_mesh.cpp.
#include "geometry/mesh_subdivision.hpp"
#include "support/mesh_zoo.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::allSchemes;
using test::nameOf;

std::size_t total(const Counts& counts) { return counts.arithmetic + counts.steps; }

template <class Work>
Counts countsOf(const Mesh& mesh, Work work) {
    (void)mesh.edges();
    counted = {};
    EXPECT_TRUE(work(mesh).ok());
    return counted;
}

Counts countsOf(const Mesh& mesh, MeshScheme scheme, int levels = 1) {
    return countsOf(mesh, [&](const Mesh& of) { return subdivide(of, scheme, levels); });
}

bool ofTriangles(MeshScheme scheme) { return classification(scheme).mesh == "triangles"; }

/// A torus of n × n quads, or twice as many triangles: all of it regular.
Mesh torusMesh(std::uint32_t n, bool triangles) {
    std::vector<Vec3> points(std::size_t{n} * n, Vec3{1});
    test::Corners corners;
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t right = (i + 1) % n;
            const std::uint32_t above = n * ((j + 1) % n);
            const std::uint32_t q[4] = {n * j + i, n * j + right, above + right, above + i};
            if (triangles) {
                corners.insert(corners.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
            } else {
                corners.insert(corners.end(), {q[0], q[1], q[2], q[3]});
            }
        }
    }
    return *Mesh::make(std::move(points), std::move(corners), triangles ? 3U : 4U);
}

/// One face of n vertices.
Mesh polygon(std::uint32_t n) {
    test::Corners corners(n);
    for (std::uint32_t i = 0; i < n; ++i) corners[i] = i;
    return *Mesh::make(std::vector<Vec3>(n, Vec3{1}), std::move(corners), n);
}

/// n triangles that meet in vertex 0 and nowhere else.
Mesh propeller(std::uint32_t n) {
    test::Corners corners;
    for (std::uint32_t i = 0; i < n; ++i) {
        corners.insert(corners.end(), {0, 2 * i + 1, 2 * i + 2});
    }
    return *Mesh::make(std::vector<Vec3>(2 * n + 1, Vec3{1}), std::move(corners), 3);
}

// ---- Subdivision -------------------------------------------------------------------------------

TEST(MeshOperations, FourTimesTheFacesTakeFourTimesTheOperationsExactly) {
    for (const MeshScheme scheme : allSchemes()) {
        for (const int levels : {1, 3}) {
            const bool triangles = ofTriangles(scheme);
            const Counts small = countsOf(torusMesh(12, triangles), scheme, levels);
            const Counts large = countsOf(torusMesh(24, triangles), scheme, levels);
            EXPECT_GT(small.arithmetic, 0U) << nameOf(scheme);
            // Of the last level nobody needs to know how it lies together.
            EXPECT_TRUE(levels == 1 || small.steps > 0) << nameOf(scheme);
            EXPECT_EQ(large.arithmetic, 4 * small.arithmetic) << nameOf(scheme);
            EXPECT_EQ(large.steps, 4 * small.steps) << nameOf(scheme);
        }
    }
}

TEST(MeshOperations, EveryLevelTakesSoManyTimesItsPredecessorAsItHasTimesTheFaces) {
    for (const MeshScheme scheme : allSchemes()) {
        const Mesh mesh = torusMesh(6, ofTriangles(scheme));
        const double times = scheme == MeshScheme::sqrt3 ? 3 : 4;
        std::vector<double> sums;
        for (int levels = 0; levels <= 5; ++levels) {
            sums.push_back(static_cast<double>(total(countsOf(mesh, scheme, levels))));
        }
        for (std::size_t level = 3; level <= 5; ++level) {
            const double here = sums[level] - sums[level - 1];
            const double before = sums[level - 1] - sums[level - 2];
            EXPECT_NEAR(here / before, times, 0.01 * times) << nameOf(scheme) << ' ' << level;
        }
    }
}

/// Ten times the size takes at most ten times the operations, and hardly less.
template <class Of, class Work>
void expectLinear(Of of, Work work, const std::string& what) {
    double before = static_cast<double>(total(countsOf(of(1'000U), work)));
    for (const std::uint32_t size : {10'000U, 100'000U}) {
        const double here = static_cast<double>(total(countsOf(of(size), work)));
        EXPECT_LE(here, 10.01 * before) << what << ' ' << size;
        EXPECT_GE(here, 9.8 * before) << what << ' ' << size;
        before = here;
    }
}

template <class Work>
void expectLinearWhateverTheShape(bool triangles, Work work, const std::string& what) {
    expectLinear(test::fanMesh, work, what + ", a fan all round");
    expectLinear(test::openFan, work, what + ", an open fan");
    expectLinear(propeller, work, what + ", fans that meet in one vertex");
    expectLinear([](std::uint32_t n) { return test::triangleGrid(n / 2, 1); }, work,
                 what + ", a strip");
    if (triangles) return;
    expectLinear(polygon, work, what + ", one face");
    expectLinear([](std::uint32_t n) { return test::gridMesh(n, 1); }, work,
                 what + ", a strip of quads");
}

TEST(MeshOperations, ALevelIsLinearInTheCornersWhateverTheValencesAndBoundaries) {
    for (const MeshScheme scheme : allSchemes()) {
        expectLinearWhateverTheShape(
            ofTriangles(scheme), [&](const Mesh& mesh) { return subdivide(mesh, scheme, 1); },
            nameOf(scheme));
    }
}

TEST(MeshOperations, TwoLevelsAreLinearToo) {
    for (const MeshScheme scheme : allSchemes()) {
        expectLinear(
            test::openFan, [&](const Mesh& mesh) { return subdivide(mesh, scheme, 2); },
            nameOf(scheme));
    }
}

TEST(MeshOperations, NoiseHolesAndIsolatedVerticesCostNoMore) {
    for (const MeshScheme scheme : allSchemes()) {
        const auto perCorner = [&](std::uint32_t size, unsigned holes) {
            const Mesh mesh = test::scannedMesh(size, holes, 3);
            return static_cast<double>(total(countsOf(mesh, scheme))) /
                   static_cast<double>(mesh.corners().size());
        };
        const double small = perCorner(40, 3);
        EXPECT_NEAR(perCorner(160, 3) / small, 1, 0.05) << nameOf(scheme);
        // Boundaries everywhere: each of their edges once more.
        EXPECT_LE(perCorner(160, 30), 2 * small) << nameOf(scheme);
    }
}

// ---- Limits ------------------------------------------------------------------------------------

TEST(MeshOperations, LimitsAreLinearWhateverTheValencesAndBoundaries) {
    for (const MeshScheme scheme : allSchemes()) {
        if (scheme == MeshScheme::dooSabin) continue;
        expectLinearWhateverTheShape(
            ofTriangles(scheme), [&](const Mesh& mesh) { return limit(mesh, scheme); },
            nameOf(scheme));
    }
}

}  // namespace
}  // namespace knotwork
