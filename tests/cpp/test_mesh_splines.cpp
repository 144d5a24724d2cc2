// On regular grids the schemes are known refinements of splines, exactly: all numbers here are
// multiples of powers of two small enough that nothing is rounded.
#include "support/mesh_zoo.hpp"
#include "support/polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace knotwork {
namespace {

using test::finer;

using Spot = std::pair<int, int>;

/// Heights of a bumpy landscape, whole numbers.
double height(int i, int j) { return (7 * i * i + 3 * i * j * j + 11 * j + 5 * i) % 17; }

/// The mesh of a grid with that landscape over it, the point over (i, j) also moved aside by whole
/// numbers.
Mesh landscape(const Mesh& grid) {
    std::vector<Vec3> points;
    for (const Vec3& p : grid.points()) {
        const int i = static_cast<int>(p.x);
        const int j = static_cast<int>(p.y);
        points.push_back({8 * p.x + height(j, i), 8 * p.y + height(i + 1, j), height(i, j)});
    }
    return *Mesh::make(std::move(points), {grid.corners().begin(), grid.corners().end()},
                       grid.uniformSize());
}

/// Which place of the finer lattice each vertex has, lattice lines twice as dense, after
/// Catmull–Clark or a scheme that quarters triangles.
std::map<Spot, Vec3> onLattice(const Mesh& grid, const Mesh& found) {
    std::map<Spot, Vec3> spots;
    std::size_t at = 0;
    const auto place = [&](const Vec3& position) {
        spots[{static_cast<int>(std::lround(2 * position.x)),
               static_cast<int>(std::lround(2 * position.y))}] = found.points()[at++];
    };
    const auto p = grid.points();
    for (const Vec3& point : p) place(point);
    if (grid.uniformSize() == 4) {
        for (std::size_t f = 0; f < grid.faces().count(); ++f) {
            const auto face = grid.faces()[f];
            place(0.5 * (p[face[0]] + p[face[2]]));
        }
    }
    for (const MeshEdge& edge : grid.edges()) place(0.5 * (p[edge.v0] + p[edge.v1]));
    EXPECT_EQ(at, found.points().size());
    return spots;
}

using Rows = std::vector<std::vector<Vec3>>;

Rows transposed(const Rows& rows) {
    Rows found(rows[0].size());
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) found[i].push_back(row[i]);
    }
    return found;
}

/// Control points of the same uniform B-spline surface on twice as dense knots.
Rows refinedSpline(int degree, const Mesh& mesh, std::size_t columns, std::size_t rows) {
    Rows points(rows);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            points[j].push_back(mesh.points()[j * columns + i]);
        }
    }
    for (int direction = 0; direction < 2; ++direction) {
        for (auto& row : points) {
            row = test::subdivided(test::laneRiesenfeld(degree, row, false, 1));
        }
        points = transposed(points);
    }
    return points;
}

TEST(MeshSplines, CatmullClarkOnAGridIsTheRefinementOfABicubicBSpline) {
    const Mesh grid = test::gridMesh(6, 5);
    const Mesh mesh = landscape(grid);
    const Rows expected = refinedSpline(3, mesh, 7, 6);
    auto spots = onLattice(grid, finer(mesh, MeshScheme::catmullClark, 1));
    for (std::size_t j = 0; j < expected.size(); ++j) {
        for (std::size_t i = 0; i < expected[j].size(); ++i) {
            const Spot spot(static_cast<int>(i) + 1, static_cast<int>(j) + 1);
            EXPECT_EQ(spots.at(spot), expected[j][i]) << i << ' ' << j;
        }
    }
}

TEST(MeshSplines, TheBoundaryOfCatmullClarkIsTheRefinementOfACubicBSpline) {
    const Mesh grid = test::gridMesh(6, 5);
    const Mesh mesh = landscape(grid);
    auto spots = onLattice(grid, finer(mesh, MeshScheme::catmullClark, 1));
    const std::vector<Vec3> side(mesh.points().begin(), mesh.points().begin() + 7);
    const auto expected = test::subdivided(test::laneRiesenfeld(3, side, false, 1));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(spots.at({static_cast<int>(i) + 1, 0}), expected[i]) << i;
    }
}

TEST(MeshSplines, DooSabinOnAGridIsTheRefinementOfABiquadraticBSpline) {
    const Mesh grid = test::gridMesh(6, 5);
    const Mesh mesh = landscape(grid);
    const Rows expected = refinedSpline(2, mesh, 7, 6);
    const Mesh found = finer(mesh, MeshScheme::dooSabin, 1);
    for (std::size_t c = 0; c < grid.corners().size(); ++c) {
        const std::size_t i = c / 4 % 6;
        const std::size_t j = c / 4 / 6;
        const std::size_t right = c % 4 == 1 || c % 4 == 2 ? 1 : 0;
        const std::size_t up = c % 4 >= 2 ? 1 : 0;
        EXPECT_EQ(found.points()[c], expected[2 * j + up][2 * i + right]);
    }
}

/// (1 + x)² (1 + y)² (1 + xy)² / 16: the box spline of three directions, each twice.
std::array<std::array<double, 5>, 5> boxSplineMask() {
    std::array<std::array<double, 5>, 5> mask{};
    mask[0][0] = 1.0 / 16;
    for (const auto& [dx, dy] : {Spot(1, 0), Spot(1, 0), Spot(0, 1), Spot(0, 1), Spot(1, 1),
                                 Spot(1, 1)}) {
        const auto before = mask;
        for (int y = 4; y >= dy; --y) {
            for (int x = 4; x >= dx; --x) {
                mask[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] +=
                    before[static_cast<std::size_t>(y - dy)][static_cast<std::size_t>(x - dx)];
            }
        }
    }
    return mask;
}

TEST(MeshSplines, LoopOnAGridIsTheRefinementOfItsBoxSpline) {
    const int columns = 7;
    const Mesh grid = test::triangleGrid(6, 6);
    const Mesh mesh = landscape(grid);
    const auto mask = boxSplineMask();
    auto spots = onLattice(grid, finer(mesh, MeshScheme::loop, 1));
    for (int y = 1; y < 12; ++y) {
        for (int x = 1; x < 12; ++x) {
            Vec3 expected{0};
            for (int j = 0; j < columns; ++j) {
                for (int i = 0; i < columns; ++i) {
                    const int a = x + 2 - 2 * i;
                    const int b = y + 2 - 2 * j;
                    if (a < 0 || a > 4 || b < 0 || b > 4) continue;
                    expected += mask[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] *
                                mesh.points()[static_cast<std::size_t>(j * columns + i)];
                }
            }
            EXPECT_EQ(spots.at({x, y}), expected) << x << ' ' << y;
        }
    }
}

/// A grid of triangles with a polynomial in whole numbers over it.
template <class Polynomial>
Mesh graphOf(const Mesh& grid, Polynomial polynomial) {
    std::vector<Vec3> points;
    for (const Vec3& p : grid.points()) points.emplace_back(p.x, p.y, polynomial(p.x, p.y));
    return *Mesh::make(std::move(points), {grid.corners().begin(), grid.corners().end()}, 3);
}

TEST(MeshSplines, TheButterflyOnAGridReproducesCubics) {
    const auto cubic = [](double x, double y) {
        return 3 * x * x * x - 5 * x * x * y + 2 * x * y * y - 7 * y * y * y + x * y - 4 * x * x;
    };
    const Mesh found = finer(graphOf(test::triangleGrid(8, 8), cubic), MeshScheme::butterfly, 1);
    std::size_t inside = 0;
    for (const Vec3& p : found.points()) {
        if (p.x < 1 || p.y < 1 || p.x > 7 || p.y > 7) continue;
        EXPECT_EQ(p.z, cubic(p.x, p.y)) << p.x << ' ' << p.y;
        ++inside;
    }
    EXPECT_EQ(inside, 13U * 13U);
}

TEST(MeshSplines, EveryTriangleSchemeReproducesPlanesOnAGrid) {
    const auto plane = [](double x, double y) { return 3 * x - 2 * y; };
    for (const MeshScheme scheme : {MeshScheme::loop, MeshScheme::butterfly, MeshScheme::sqrt3}) {
        const Mesh found = finer(graphOf(test::triangleGrid(8, 8), plane), scheme, 2);
        for (const Vec3& p : found.points()) EXPECT_NEAR(p.z, plane(p.x, p.y), 1e-13);
    }
}

TEST(MeshSplines, TwoLevelsOfSqrt3OnAGridAreTheGridOfAThirdOfTheSize) {
    const Mesh found = finer(test::triangleGrid(8, 8), MeshScheme::sqrt3, 2);
    const auto isWhole = [](double a) { return std::abs(a - std::round(a)) < 1e-13; };
    std::size_t inside = 0;
    for (const MeshEdge& edge : found.edges()) {
        const Vec3 a = found.points()[edge.v0];
        const Vec3 b = found.points()[edge.v1];
        if (std::min({a.x, a.y, b.x, b.y}) < 2 || std::max({a.x, a.y, b.x, b.y}) > 6) continue;
        ++inside;
        EXPECT_TRUE(isWhole(3 * a.x) && isWhole(3 * a.y));
        const long dx = std::lround(3 * (b.x - a.x));
        const long dy = std::lround(3 * (b.y - a.y));
        EXPECT_TRUE(std::abs(dx) <= 1 && std::abs(dy) <= 1 && dx * dy >= 0) << dx << ' ' << dy;
    }
    EXPECT_GT(inside, 300U);
}

}  // namespace
}  // namespace knotwork
