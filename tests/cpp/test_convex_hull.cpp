#include "geometry/convex_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace knotwork {
namespace {

std::vector<Vec3> cloud(std::size_t count, int seed, bool flat) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> spread(-3, 5);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.emplace_back(spread(random), spread(random), flat ? 0 : spread(random));
    }
    return points;
}

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(ConvexHull, APolygonTurnsLeftOnlyAndHasEveryPointInside) {
    for (int seed = 0; seed < 40; ++seed) {
        const auto points = cloud(3 + static_cast<std::size_t>(seed) * 5, seed, true);
        const auto hull = planeHull(points);
        ASSERT_GE(hull.size(), 3U);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec3& a = points[hull[i]];
            const Vec3& b = points[hull[(i + 1) % hull.size()]];
            const Vec3& c = points[hull[(i + 2) % hull.size()]];
            EXPECT_GT(turn(a, b, c), 0);
            for (const Vec3& p : points) EXPECT_GE(turn(a, b, p), -1e-9);
        }
    }
}

TEST(ConvexHull, PointsOnItsEdgesAndTwiceTheSameAreNoCorners) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0},
                                   {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(planeHull(square), (std::vector<std::uint32_t>{0, 2, 3, 6}));
    EXPECT_EQ(planeHull(std::vector<Vec3>{{1, 1, 0}, {3, 3, 0}, {2, 2, 0}}).size(), 2U);
    EXPECT_EQ(planeHull(std::vector<Vec3>{{1, 1, 0}, {1, 1, 0}}).size(), 1U);
    EXPECT_TRUE(planeHull({}).empty());
}

/// Whether every edge of the hull has all points on one side of some plane through it.
void expectSupported(const std::vector<Vec3>& points,
                     const std::vector<std::array<std::uint32_t, 2>>& edges) {
    for (const auto& [a, b] : edges) {
        const Vec3 along = glm::normalize(points[b] - points[a]);
        // Seen along the edge the points must fill less than a half turn round it.
        const Vec3 across = glm::normalize(
            glm::cross(along, std::abs(along.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
        const Vec3 up = glm::cross(along, across);
        std::vector<double> angles;
        for (const Vec3& p : points) {
            const Vec3 from = p - points[a];
            const double x = glm::dot(from, across);
            const double y = glm::dot(from, up);
            if (std::hypot(x, y) > 1e-7) angles.push_back(std::atan2(y, x));
        }
        std::sort(angles.begin(), angles.end());
        double gap = angles.front() + 2 * 3.141592653589793 - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
        EXPECT_GT(gap, 3.141592653589793 - 1e-6);
    }
}

TEST(ConvexHull, EveryEdgeInSpaceLiesOnTheHullAndEulersFormulaHolds) {
    for (int seed = 0; seed < 25; ++seed) {
        const auto points = cloud(4 + static_cast<std::size_t>(seed) * 6, seed, false);
        const auto edges = hullEdges(points);
        expectSupported(points, edges);
        std::set<std::uint32_t> corners;
        for (const auto& edge : edges) corners.insert(edge.begin(), edge.end());
        EXPECT_EQ(edges.size(), 3 * corners.size() - 6);  // all faces are triangles
    }
}

TEST(ConvexHull, FlatFacesHaveNoEdgesInside) {
    std::vector<Vec3> lattice;
    for (int i = 0; i < 64; ++i) lattice.emplace_back(i % 4, i / 4 % 4, i / 16);
    const auto edges = hullEdges(lattice);
    std::set<std::uint32_t> corners;
    for (const auto& edge : edges) corners.insert(edge.begin(), edge.end());
    // The twelve edges of the cube, each in one piece or in pieces between points on it.
    double length = 0;
    for (const auto& [a, b] : edges) {
        const Vec3 d = lattice[b] - lattice[a];
        EXPECT_EQ((d.x != 0) + (d.y != 0) + (d.z != 0), 1);
        length += glm::length(d);
    }
    EXPECT_EQ(length, 36);
    for (const std::uint32_t corner : {0U, 3U, 12U, 15U, 48U, 51U, 60U, 63U}) {
        EXPECT_TRUE(corners.contains(corner));
    }
}

TEST(ConvexHull, PointsInAPlaneOrALineOfSpaceHaveTheirPolygonThere) {
    auto points = cloud(30, 3, true);
    const std::size_t corners = planeHull(points).size();
    for (Vec3& p : points) p = {p.x, p.y, 0.3 * p.x - 2 * p.y + 1};
    EXPECT_EQ(hullEdges(points).size(), corners);
    for (Vec3& p : points) p = {p.x, 0.1 * p.x, -p.x};
    EXPECT_EQ(hullEdges(points).size(), 1U);
    EXPECT_TRUE(hullEdges(std::vector<Vec3>(5, Vec3(1, 2, 3))).empty());
    EXPECT_TRUE(hullEdges({}).empty());
}

}  // namespace
}  // namespace knotwork
