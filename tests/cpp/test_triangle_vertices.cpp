#include "render/point_vertices.hpp"
#include "render/triangle_vertices.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::render {
namespace {

using drawing::toByte;
using drawing::toBytes;

constexpr Rect pane{0, 0, 200, 100};

Projection pixels() { return Projection::flat(pane, Vec3(0.0), 1, 1); }

/// Twice the signed area of a triangle whose corners' x and y start at `at`.
double doubleArea(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
}

double coveredArea(const std::vector<double>& triangles) {
    double area = 0;
    for (std::size_t i = 0; i + 8 < triangles.size(); i += 9) {
        area += 0.5 * std::abs(doubleArea(triangles[i], triangles[i + 1], triangles[i + 3],
                                          triangles[i + 4], triangles[i + 6], triangles[i + 7]));
    }
    return area;
}

double coveredArea(const std::vector<TriangleVertex>& v) {
    double area = 0;
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) {
        area += 0.5 * std::abs(doubleArea(v[i].x, v[i].y, v[i + 1].x, v[i + 1].y, v[i + 2].x,
                                          v[i + 2].y));
    }
    return area;
}

TEST(AreaUnder, AGraphCoversItsIntegral) {
    std::vector<double> triangles;
    appendAreaUnder(std::vector<double>{0, 1, 0, 1, 3, 0, 3, 0, 0}, 0, triangles);
    EXPECT_DOUBLE_EQ(coveredArea(triangles), 2 + 3);
}

TEST(AreaUnder, AGraphThatCrossesTheLineIsCutThere) {
    std::vector<double> triangles;
    appendAreaUnder(std::vector<double>{0, 1, 0, 2, -1, 0}, 0, triangles);
    EXPECT_DOUBLE_EQ(coveredArea(triangles), 1);
}

TEST(AreaUnder, TheLineNeedNotBeZero) {
    std::vector<double> triangles;
    appendAreaUnder(std::vector<double>{0, 1, 0, 2, 1, 0}, -1, triangles);
    EXPECT_DOUBLE_EQ(coveredArea(triangles), 4);
}

TEST(AreaUnder, AGraphOnTheLineCoversNothing) {
    std::vector<double> triangles;
    appendAreaUnder(std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0}, 0, triangles);
    EXPECT_TRUE(triangles.empty());
}

TEST(TriangleVertices, ATriangleInsideIsKeptAsItIs) {
    TriangleVertices vertices;
    vertices.add(pixels(), std::vector<double>{0, 0, 0, 10, 0, 0, 0, 10, 0}, {1, 2, 3, 4});
    ASSERT_EQ(vertices.records().size(), 3U);
    EXPECT_DOUBLE_EQ(coveredArea(vertices.records()), 50);
    EXPECT_EQ(vertices.records()[0].colour, (ColourBytes{1, 2, 3, 4}));
}

TEST(TriangleVertices, AHugeTriangleIsCutToThePaneBeforeItBecomesFloat) {
    TriangleVertices vertices;
    vertices.add(pixels(), std::vector<double>{-1e12, -1e12, 0, 1e12, -1e12, 0, 0, 1e12, 0}, {});
    EXPECT_NEAR(coveredArea(vertices.records()), 204.0 * 104.0, 0.1);
}

TEST(TriangleVertices, ATriangleOutsideCostsNothing) {
    TriangleVertices vertices;
    vertices.add(pixels(), std::vector<double>{300, 0, 0, 310, 0, 0, 300, 10, 0}, {});
    EXPECT_TRUE(vertices.empty());
}

TEST(PointVertices, APointIsKeptWhileAnyOfItCanBeSeen) {
    PointVertices vertices;
    PointVertex looks;
    looks.radius = 5;
    vertices.add(pixels(), {104, 0, 0}, looks);
    EXPECT_EQ(vertices.records().size(), 1U);
    vertices.add(pixels(), {120, 0, 0}, looks);
    vertices.add(pixels(), {std::nan(""), 0, 0}, looks);
    EXPECT_EQ(vertices.records().size(), 1U);
    EXPECT_EQ(vertices.records()[0].x, 104);
}

TEST(ColourBytes, ComponentsAreRoundedAndClamped) {
    EXPECT_EQ(toBytes({0.5, 1.7, -2, 1}), (ColourBytes{128, 255, 0, 255}));
    EXPECT_EQ(toBytes({0, 0, 0, 1}, 0.5)[3], 128);
    EXPECT_EQ(toByte(std::nan("")), 0);
}

}  // namespace
}  // namespace knotwork::render
