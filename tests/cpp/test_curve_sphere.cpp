#include "geometry/curve_sphere.hpp"

#include "geometry/smooth_pieces.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

namespace knotwork::test {
namespace {

constexpr double rounding = 1e-15;  // of the points themselves, of their distance from 0

TEST(CurveSphere, ContainsEveryCurveAndIsNotLargerThanThatOfManySamples) {
    for (const Animal& animal : wholeZoo()) {
        const Sphere sphere = enclosingSphere(animal.curve);
        std::vector<Vec3> points;
        for (const Interval& piece : smoothPieces(animal.curve)) {
            for (std::size_t i = 0; i <= 200; ++i) {
                Vec3 point;
                evaluate(animal.curve, uniformParameter(piece, i, 201),
                         i == 200 ? Side::left : Side::right, {&point, 1});
                points.push_back(point);
                EXPECT_LE(glm::length(point - sphere.center),
                          sphere.radius * (1 + 1e-12) + rounding * glm::length(point))
                    << animal.name;
            }
        }
        // Samples miss the points that hold the sphere by less than (1/200)² of a piece.
        const double ofSamples = enclosingSphere(points)->radius;
        EXPECT_GE(sphere.radius, ofSamples * (1 - 1e-12) - rounding * glm::length(sphere.center))
            << animal.name;
        EXPECT_LE(sphere.radius, ofSamples * (1 + 2e-4) + 1e-12) << animal.name;
        if (dimension(animal.curve) == 2) {
            EXPECT_EQ(sphere.center.z, 0) << animal.name;
        }
    }
}

TEST(CurveSphere, OfModelsWithClosedForms) {
    const auto expectSphere = [](const Curve& curve, const Vec3& centre, double radius) {
        const Sphere sphere = enclosingSphere(curve);
        EXPECT_NEAR(sphere.radius, radius, 1e-12 * radius);
        EXPECT_LE(glm::length(sphere.center - centre), 1e-6 * radius);
    };
    expectSphere(Curve(make("circle", {{"radius", 2.0}})), {0, 0, 0}, 2);
    expectSphere(Curve(make("ellipse", {{"a", 3.0}, {"b", 1.0}})), {0, 0, 0}, 3);
    expectSphere(Curve(make("astroid", {{"a", 2.0}})), {0, 0, 0}, 2);
    expectSphere(Curve(make("viviani")), {0, 0, 0}, 2);
    expectSphere(Curve(make("torus-knot")), {0, 0, 0}, 3);
    expectSphere(rationalCircle(), {0, 0, 0}, 1);
    expectSphere(spline(1, Form::clamped, {}, {{0, 0, 0}, {2, 2, 1}}), {1, 1, 0.5}, 1.5);
}

TEST(CurveSphere, OfASinglePointIsThatPoint) {
    const Curve still = spline(3, Form::clamped, {}, std::vector<Vec3>(5, Vec3(1, 2, 3)));
    EXPECT_LE(enclosingSphere(still).radius, 1e-15);
}

}  // namespace
}  // namespace knotwork::test
