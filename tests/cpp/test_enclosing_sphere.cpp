#include "geometry/enclosing_sphere.hpp"

#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using Points = std::vector<Vec3>;

constexpr SphereMethod allMethods[] = {SphereMethod::minimal, SphereMethod::ritter,
                                       SphereMethod::incremental};

Points ball(RandomSplines& random, int count, bool planar = false) {
    Points points;
    while (static_cast<int>(points.size()) < count) {
        const Vec3 p(random.real(-1, 1), random.real(-1, 1), planar ? 0 : random.real(-1, 1));
        if (glm::length(p) <= 1) points.push_back(p);
    }
    return points;
}

double outside(const Sphere& sphere, const Points& points) {
    double most = -1;
    for (const Vec3& p : points) most = std::max(most, glm::length(p - sphere.center));
    return most - sphere.radius;
}

/// The centre of the sphere through these points, in their span, from the normal equations of the
/// span: independent of what is tested.
bool circumcenter(const Points& p, Vec3& center) {
    const std::size_t k = p.size() - 1;
    double a[3][4] = {};
    for (std::size_t i = 0; i < k; ++i) {
        const Vec3 di = p[i + 1] - p[0];
        for (std::size_t j = 0; j < k; ++j) a[i][j] = glm::dot(di, p[j + 1] - p[0]);
        a[i][3] = glm::dot(di, di) / 2;
    }
    for (std::size_t c = 0; c < k; ++c) {
        if (std::abs(a[c][c]) < 1e-10) return false;
        for (std::size_t i = 0; i < k; ++i) {
            if (i == c) continue;
            const double f = a[i][c] / a[c][c];
            for (std::size_t j = 0; j < 4; ++j) a[i][j] -= f * a[c][j];
        }
    }
    center = p[0];
    for (std::size_t i = 0; i < k; ++i) center += a[i][3] / a[i][i] * (p[i + 1] - p[0]);
    return true;
}

void tryAll(const Points& points, std::size_t from, Points& chosen, double& best) {
    if (!chosen.empty()) {
        Vec3 center;
        if (circumcenter(chosen, center)) {
            const double radius = outside({center, 0}, points);
            best = std::min(best, radius);
        }
    }
    if (chosen.size() == 4) return;
    for (std::size_t i = from; i < points.size(); ++i) {
        chosen.push_back(points[i]);
        tryAll(points, i + 1, chosen, best);
        chosen.pop_back();
    }
}

/// The least radius of all spheres through up to four of the points that hold all.
double bruteForce(const Points& points) {
    double best = 1e300;
    Points chosen;
    tryAll(points, 0, chosen, best);
    return best;
}

TEST(EnclosingSphere, SmallestIsTheBestOfAllSupports) {
    RandomSplines random(91);
    for (int round = 0; round < 300; ++round) {
        const Points points = ball(random, random.integer(1, 14), round % 3 == 0);
        const Sphere sphere = enclosingSphere(points).value();
        ASSERT_LE(outside(sphere, points), 1e-15);
        ASSERT_NEAR(sphere.radius, bruteForce(points), 1e-12) << "round " << round;
    }
}

TEST(EnclosingSphere, ThatOfKnownShapesIsExact) {
    const Sphere cube = *enclosingSphere(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                                {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    EXPECT_LE(glm::length(cube.center - Vec3(0.5)), 1e-15);
    EXPECT_NEAR(cube.radius, std::sqrt(3.0) / 2, 1e-15);
    const Sphere tetrahedron =
        *enclosingSphere(Points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0.1, 0.2, 0}});
    EXPECT_LE(glm::length(tetrahedron.center), 1e-15);
    EXPECT_NEAR(tetrahedron.radius, std::sqrt(3.0), 1e-15);
    // Obtuse: its longest side is the diameter.
    const Sphere obtuse = *enclosingSphere(Points{{-2, 0, 0}, {2, 0, 0}, {0.5, 1, 0}});
    EXPECT_EQ(obtuse, (Sphere{{0, 0, 0}, 2}));
}

TEST(EnclosingSphere, EveryMethodHoldsAllPointsWithinItsBound) {
    RandomSplines random(92);
    double worst = 1;
    for (int round = 0; round < 400; ++round) {
        const Points points = ball(random, random.integer(2, 200), round % 2 == 0);
        const double least = enclosingSphere(points)->radius;
        for (const SphereMethod method : allMethods) {
            const Sphere sphere = enclosingSphere(points, method).value();
            ASSERT_LE(outside(sphere, points), 1e-15 * sphere.radius);
            ASSERT_GE(sphere.radius, least * (1 - 1e-12));
            ASSERT_LE(sphere.radius, least * 1.5);
            if (method == SphereMethod::ritter) worst = std::max(worst, sphere.radius / least);
        }
    }
    EXPECT_LE(worst, 1.2);
    EXPECT_GT(worst, 1.01);
}

TEST(EnclosingSphere, IncrementalOneGrowsOverThePointsInTheirOrder) {
    const Points points{{0, 0, 0}, {2, 0, 0}, {1, 3, 0}};
    // (1, 0, 0) with 1, and then half of the distance 3 and that radius.
    EXPECT_EQ(*enclosingSphere(points, SphereMethod::incremental), (Sphere{{1, 1, 0}, 2}));
    const Points three{{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}};
    EXPECT_EQ(*enclosingSphere(three, SphereMethod::incremental), (Sphere{{1, 0, 0}, 1}));
}

TEST(EnclosingSphere, DegenerateSupportsAreNoObstacle) {
    RandomSplines random(93);
    Points line, circle, sphere, twice;
    for (int i = 0; i <= 20; ++i) line.push_back(Vec3(1, 2, 3) + (i / 20.0) * Vec3(3, -6, 2));
    for (int i = 0; i < 64; ++i) {
        circle.emplace_back(5 + 2 * std::cos(i * 0.3), 2 * std::sin(i * 0.3), 7);
    }
    while (sphere.size() < 2000) {
        const Vec3 p(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
        if (glm::length(p) > 0.1) sphere.push_back(Vec3(10, 20, 30) + 3.0 * glm::normalize(p));
    }
    for (const Vec3& p : ball(random, 10)) twice.insert(twice.end(), 3, p);
    EXPECT_NEAR(enclosingSphere(line)->radius, 3.5, 1e-14);
    EXPECT_NEAR(enclosingSphere(circle)->radius, 2, 1e-3);
    EXPECT_LE(enclosingSphere(circle)->radius, 2 + 1e-14);
    EXPECT_NEAR(enclosingSphere(sphere)->radius, 3, 1e-12);
    EXPECT_NEAR(enclosingSphere(twice)->radius, bruteForce(Points(twice.begin(), twice.end())),
                1e-12);
    for (const Points& points : {line, circle, sphere, twice}) {
        for (const SphereMethod method : allMethods) {
            const Sphere found = enclosingSphere(points, method).value();
            EXPECT_LE(outside(found, points), 1e-14 * found.radius);
        }
    }
}

TEST(EnclosingSphere, NearlyFlatAndNearlyEqualPointsAreHeld) {
    RandomSplines random(94);
    for (const double thickness : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-300}) {
        for (const bool flat : {false, true}) {
            Points points;
            for (Vec3 p : ball(random, 40)) {
                p.z *= thickness;
                if (!flat) p.y *= thickness;
                points.push_back(p);
            }
            const Sphere sphere = enclosingSphere(points).value();
            EXPECT_LE(outside(sphere, points), 1e-15) << thickness;
            EXPECT_LE(sphere.radius, 1 + 1e-12) << thickness;
            EXPECT_LE(sphere.radius, bruteForce(points) * (1 + 1e-9)) << thickness;
        }
    }
}

TEST(EnclosingSphere, SizeDoesNotMatter) {
    RandomSplines random(95);
    const Points points = ball(random, 50);
    const double radius = enclosingSphere(points)->radius;
    for (const double size : {1e-290, 1e-150, 1e-30, 1e-5, 1e11}) {
        Points scaled;
        for (const Vec3& p : points) scaled.push_back(size * p);
        for (const SphereMethod method : allMethods) {
            const Sphere sphere = enclosingSphere(scaled, method).value();
            EXPECT_NEAR(sphere.radius / size, enclosingSphere(points, method)->radius,
                        1e-12 * radius)
                << size;
        }
    }
}

TEST(EnclosingSphere, OnePointHasRadiusZeroAndManyAreFast) {
    EXPECT_EQ(*enclosingSphere(Points{{1, 2, 3}}), (Sphere{{1, 2, 3}, 0}));
    EXPECT_EQ(*enclosingSphere(Points(1000, Vec3(1, 2, 3))), (Sphere{{1, 2, 3}, 0}));
    RandomSplines random(96);
    const Points points = ball(random, 100'000);
    const Sphere sphere = enclosingSphere(points).value();
    EXPECT_LE(outside(sphere, points), 1e-15);
    EXPECT_NEAR(sphere.radius, 1, 0.01);
    EXPECT_EQ(sphere, *enclosingSphere(points));
}

TEST(EnclosingSphere, RefusesWhatIsNoPoint) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(enclosingSphere(Points{}).error().code, Code::wrongLength);
    EXPECT_EQ(enclosingSphere(Points{{0, 0, 0}, {0, nan, 0}}).error().path, "points[1]");
    EXPECT_EQ(enclosingSphere(Points{{0, 0, 0}, {0, nan, 0}}).error().code, Code::notFinite);
    EXPECT_EQ(enclosingSphere(Points{{0, 0, 2e12}}).error().code, Code::outOfRange);
}

TEST(SphereUnion, IsTheLargerOneOrTouchesBoth) {
    const Sphere large{{0, 0, 0}, 3};
    EXPECT_EQ(sphereUnion(large, {{1, 0, 0}, 1}), large);
    EXPECT_EQ(sphereUnion({{1, 0, 0}, 1}, large), large);
    EXPECT_EQ(sphereUnion(large, large), large);
    EXPECT_EQ(sphereUnion({{0, 0, 0}, 1}, {{6, 0, 0}, 3}), (Sphere{{4, 0, 0}, 5}));
    EXPECT_EQ(sphereUnion({{2, 2, 2}, 0}, {{2, 2, 4}, 0}), (Sphere{{2, 2, 3}, 1}));
}

}  // namespace
}  // namespace knotwork
