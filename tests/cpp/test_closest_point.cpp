#include "geometry/closest_point.hpp"

#include "geometry/smooth_pieces.hpp"
#include "support/measure_gates.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork::test {
namespace {

constexpr double pi = std::numbers::pi;

PointOnCurve closest(const Curve& curve, const Vec3& p) { return closestPoint(curve, p).value(); }

/// The nearest and farthest of many samples of every piece.
std::pair<double, double> bruteForce(const Curve& curve, const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const Interval& piece : smoothPieces(curve)) {
        for (int i = 0; i <= 400; ++i) {
            Vec3 point;
            const Side side = i == 400 ? Side::left : Side::right;
            evaluate(curve, uniformParameter(piece, static_cast<std::size_t>(i), 401), side,
                     {&point, 1});
            least = std::min(least, glm::length(point - p));
            most = std::max(most, glm::length(point - p));
        }
    }
    return {least, most};
}

double reachOf(const Curve& curve) {
    return bruteForce(curve, Vec3(0)).second;
}

TEST(ClosestPoint, IsNearerThanEverySampleOfEveryCurve) {
    RandomSplines random(29);
    for (const Animal& animal : wholeZoo()) {
        const double reach = reachOf(animal.curve);
        for (int i = 0; i < 12; ++i) {
            const double size = i < 8 ? 1.2 * reach : 50 * reach;
            const Vec3 p(random.real(-size, size), random.real(-size, size),
                         i % 3 == 0 ? random.real(-size, size) : 0);
            const PointOnCurve found = closest(animal.curve, p);
            const PointOnCurve far = farthestPoint(animal.curve, p);
            const auto [least, most] = bruteForce(animal.curve, p);
            const double rounding = 1e-15 * (reach + glm::length(p));
            EXPECT_LE(found.distance, least + rounding) << animal.name;
            EXPECT_GE(far.distance, most - rounding) << animal.name;
            EXPECT_EQ(found.distance, glm::length(found.point - p));
            EXPECT_TRUE(domain(animal.curve).contains(found.t));
        }
    }
}

TEST(ClosestPoint, LooksAlongTheNormalUnlessItIsAnEnd) {
    RandomSplines random(31);
    for (const Animal& animal : models()) {
        for (int i = 0; i < 6; ++i) {
            const Vec3 p(random.real(-3, 3), random.real(-3, 3), random.real(-3, 3));
            const PointOnCurve found = closest(animal.curve, p);
            const Interval whole = domain(animal.curve);
            if (found.t == whole.start || found.t == whole.end) continue;
            std::array<Vec3, 2> rows;
            evaluate(animal.curve, found.t, Side::right, rows);
            if (glm::length(rows[1]) < 1e-6) continue;  // at a cusp
            EXPECT_NEAR(glm::dot(glm::normalize(rows[1]), found.point - p), 0,
                        2e-13 * (1 + glm::length(rows[0]))) << animal.name;
        }
    }
}

TEST(ClosestPoint, OfAPointOnTheCurveIsItself) {
    RandomSplines random(37);
    for (const Animal& animal : wholeZoo()) {
        const double reach = reachOf(animal.curve);
        const Interval whole = domain(animal.curve);
        for (int i = 0; i < 8; ++i) {
            const double t = i == 0 ? whole.start : random.real(whole.start, whole.end);
            const PointOnCurve found = closest(animal.curve, pointAt(animal.curve, t));
            EXPECT_LE(found.distance, 4e-15 * (1 + reach)) << animal.name << " at " << t;
        }
    }
    // A cubic that does not meet itself gives the parameter back.
    const Curve s = spline(3, Form::clamped, {}, sShape());
    for (const double t : {0.0, 0.123, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(closest(s, pointAt(s, t)).t, t, 1e-14);
    }
}

TEST(ClosestPoint, OnAnEllipseIsOneOfTheKnownOnes) {
    const Curve ellipse(make("ellipse", {{"a", 3.0}, {"b", 1.0}}));
    // (x, 0) with |x| < (a² − b²)/a: cos t = a x / (a² − b²), of the two the first.
    const PointOnCurve found = closest(ellipse, {2, 0, 0});
    EXPECT_NEAR(found.t, std::acos(0.75), 1e-15);
    EXPECT_NEAR(closest(ellipse, {2.9, 0, 0}).t, 0, 1e-7);
    EXPECT_NEAR(closest(ellipse, {0, 0, 0}).t, pi / 2, 1e-15);
    EXPECT_NEAR(closest(ellipse, {0, 0, 5}).distance, std::sqrt(26.0), 1e-14);
    EXPECT_NEAR(farthestPoint(ellipse, {0, 0, 0}).distance, 3, 1e-15);
}

TEST(ClosestPoint, OfTheCentreOfACircleIsItsStart) {
    for (const double radius : {1e-3, 1.0, 1000.0}) {
        const PointOnCurve found = closest(Curve(make("circle", {{"radius", radius}})), {0, 0, 0});
        EXPECT_EQ(found.t, 0);
        EXPECT_NEAR(found.distance, radius, 1e-15 * radius);
    }
    EXPECT_EQ(closest(rationalCircle(), {0, 0, 0}).t, 0);
    EXPECT_NEAR(closest(Curve(make("circle")), {-1e12, 0, 0}).t, pi, 1e-3);
    EXPECT_NEAR(closest(Curve(make("circle")), {-1e6, 0, 0}).t, pi, 1e-9);
}

TEST(ClosestPoint, OfACurveThatIsAPointOrALine) {
    const Curve still = spline(3, Form::clamped, {}, std::vector<Vec3>(5, Vec3(1, 2, 3)));
    EXPECT_NEAR(closest(still, {1, 2, 5}).distance, 2, 1e-15);
    EXPECT_EQ(closest(still, {1, 2, 5}).t, 0);
    const Curve line = spline(1, Form::clamped, {}, {{0, 0, 0}, {4, 0, 0}});
    EXPECT_NEAR(closest(line, {1, 7, 0}).t, 0.25, 1e-16);
    EXPECT_EQ(closest(line, {-1, 7, 0}).t, 0);
    EXPECT_EQ(closest(line, {9, 7, 0}).t, 1);
}

TEST(ClosestPoint, RefusesPlacesThatAreNone) {
    const Curve circle(make("circle"));
    EXPECT_EQ(closestPoint(circle, {0, std::nan(""), 0}).error().path, "p[1]");
    EXPECT_EQ(closestPoint(circle, {0, 0, std::nan("")}).error().code, Code::notFinite);
    EXPECT_EQ(closestPoint(circle, {2e12, 0, 0}).error().code, Code::outOfRange);
}

}  // namespace
}  // namespace knotwork::test
