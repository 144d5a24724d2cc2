#include "geometry/surface_grid.hpp"

#include "geometry/surface_differential.hpp"
#include "support/surface_gates.hpp"
#include "support/surface_grids.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::model;
using test::someSurface;

using test::expectGrid;
using test::Grid;
using test::gridOf;

TEST(SurfaceGrid, HasThePointsAndNormalsOfEveryModel) {
    for (const auto& description : surfaceModels()) {
        expectGrid(model(description.name), 9, 13, std::string(description.name));
    }
}

TEST(SurfaceGrid, HasThePointsAndNormalsOfSplinesOfEveryFormAndDegree) {
    for (const auto& [u, v] : {std::pair{1, 1}, {2, 3}, {3, 2}, {4, 5}, {5, 7}, {2, 9}}) {
        for (const BsplineSurface& surface : test::surfacesOfEveryForm(u, v)) {
            expectGrid(surface, 17, 31, std::to_string(u) + " × " + std::to_string(v));
        }
    }
}

TEST(SurfaceGrid, ThatIsMovedIsTheGridOfItsSurface) {
    const Surface torus = model("torus");
    const auto read = [](SurfaceGrid& grid) {
        std::vector<double> positions(3 * 20, 99);
        std::vector<double> normals(3 * 20, 99);
        grid.points(0, 20, positions, normals);
        return positions;
    };
    SurfaceGrid grid(torus, 4, 5);
    const auto expected = read(grid);
    SurfaceGrid moved = std::move(grid);
    EXPECT_EQ(read(moved), expected);
    SurfaceGrid other(model("plane"), 2, 3);
    other = std::move(moved);
    EXPECT_EQ(read(other), expected);
}

TEST(SurfaceGrid, AFewPointsOfAManyPointedNetAreTheSame) {
    expectGrid(someSurface({3, 3, Form::clamped, Form::open, 20, 20}), 3, 4, "few points");
}

TEST(SurfaceGrid, EveryKnotFallsOnAColumnWithoutDoubt) {
    // Unit spans and as many steps: parameters meet knots exactly, and the piece on the right counts.
    const auto knots = KnotVector::make({0, 0, 1, 2, 2, 3, 4, 4}, 1, 6, Form::clamped).value();
    std::vector<Vec3> points;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) points.emplace_back(i, j, i * j % 4);
    }
    const Surface surface = BsplineSurface::make(knots, knots, points).value();
    expectGrid(surface, 9, 17, "jumps");
}

TEST(SurfaceGrid, ClosedSeamsMeetThemselvesToTheBit) {
    std::vector<Surface> closed{model("torus"), model("seashell"), model("cylinder")};
    for (const BsplineSurface& surface : test::surfacesOfEveryForm(3, 3)) {
        closed.emplace_back(surface);
    }
    for (const Surface& surface : closed) {
        const std::size_t nu = 12;
        const std::size_t nv = 90;
        const Grid grid = gridOf(surface, nu, nv);
        for (std::size_t j = 0; closedDirections(surface).u && j < nv; ++j) {
            EXPECT_EQ(grid.points[j], grid.points[(nu - 1) * nv + j]);
            EXPECT_EQ(grid.normals[j], grid.normals[(nu - 1) * nv + j]);
        }
        for (std::size_t i = 0; closedDirections(surface).v && i < nu; ++i) {
            EXPECT_EQ(grid.points[i * nv], grid.points[i * nv + nv - 1]);
            EXPECT_EQ(grid.normals[i * nv], grid.normals[i * nv + nv - 1]);
        }
    }
}

TEST(SurfaceGrid, PolesHaveNormals) {
    const std::size_t nu = 8;
    const std::size_t nv = 5;
    const Grid grid = gridOf(model("sphere"), nu, nv);
    for (std::size_t k = 0; k < nu * nv; ++k) {
        EXPECT_LE(glm::length(grid.normals[k] - grid.points[k]), gates::normal) << k;
    }
    // A net with a collapsed side goes through the polynomial pieces.
    const auto knots = KnotVector::uniform(1, 2, Form::clamped).value();
    const Surface triangle =
        BsplineSurface::make(knots, knots, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}).value();
    for (const Vec3& normal : gridOf(triangle, 40, 40).normals) {
        EXPECT_LE(glm::length(normal - Vec3(0, 0, -1)), gates::normal);
    }
}

// --- triangles -----------------------------------------------------------------------------------

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, int> edgesOf(const std::vector<std::uint32_t>& triangles) {
    std::map<Edge, int> edges;
    for (std::size_t k = 0; k < triangles.size(); k += 3) {
        for (std::size_t c = 0; c < 3; ++c) {
            ++edges[{triangles[k + c], triangles[k + (c + 1) % 3]}];
        }
    }
    return edges;
}

TEST(SurfaceGrid, ATorusIsWatertightAndOriented) {
    const auto edges = edgesOf(gridTriangles(7, 9, {true, true}));
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    // 6 × 8 cells: V − E + F = 0
    EXPECT_EQ(edges.size() / 2, 48u * 3);
}

TEST(SurfaceGrid, ACylinderHasTwoRimsAndAPlaneOne) {
    const auto rims = [](ClosedDirections closed) {
        const auto edges = edgesOf(gridTriangles(6, 4, closed));
        std::size_t count = 0;
        for (const auto& [edge, times] : edges) {
            if (!edges.contains({edge.second, edge.first})) ++count;
        }
        return count;
    };
    EXPECT_EQ(rims({true, false}), 2u * 5);
    EXPECT_EQ(rims({false, true}), 2u * 3);
    EXPECT_EQ(rims({false, false}), 2u * (5 + 3));
}

TEST(SurfaceGrid, TrianglesAreCounterClockwiseSeenFromTheNormals) {
    const Surface surface = model("helicoid");
    const Grid grid = gridOf(surface, 30, 10);
    const auto triangles = gridTriangles(30, 10, closedDirections(surface));
    EXPECT_EQ(triangles.size(), 6u * 29 * 9);
    for (std::size_t k = 0; k < triangles.size(); k += 3) {
        const Vec3 a = grid.points[triangles[k]];
        const Vec3 b = grid.points[triangles[k + 1]];
        const Vec3 c = grid.points[triangles[k + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), grid.normals[triangles[k]]), 0) << k;
    }
}

}  // namespace
}  // namespace knotwork
