#include "geometry/tessellation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knotwork {
namespace {

Curve model(std::string_view name) { return Curve(ParametricCurve::make(name).value()); }

Vec3 vertex(const Polyline& line, std::size_t i) {
    return {line.xyz[3 * i], line.xyz[3 * i + 1], line.xyz[3 * i + 2]};
}

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double squared = glm::dot(d, d);
    const double along =
        squared > 0 ? std::clamp(glm::dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
    return glm::length(p - a - along * d);
}

/// The greatest distance of the curve from the chord over the same parameters.
double chordError(const Curve& curve, const Polyline& line) {
    double worst = 0;
    for (std::size_t i = 1; i < line.parameters.size(); ++i) {
        for (int k = 1; k < 32; ++k) {
            const double t = line.parameters[i - 1] +
                             (line.parameters[i] - line.parameters[i - 1]) * k / 32.0;
            worst = std::max(worst,
                             distanceToSegment(pointAt(curve, t), vertex(line, i - 1), vertex(line, i)));
        }
    }
    return worst;
}

TEST(Polyline, HonoursItsToleranceFromOneToTenBillionths) {
    for (const char* name : {"circle", "butterfly", "rose", "hypotrochoid", "trefoil"}) {
        const Curve curve = model(name);
        for (double tolerance = 1; tolerance >= 1e-5; tolerance /= 10) {
            const Polyline line = polyline(curve, tolerance);
            EXPECT_LE(chordError(curve, line), tolerance) << name << " at " << tolerance;
        }
    }
}

TEST(Polyline, SpendsPointsAsTheSquareRootOfTheTolerance) {
    const Curve circle = model("circle");
    const auto coarse = polyline(circle, 1e-3).parameters.size();
    const auto fine = polyline(circle, 1e-7).parameters.size();
    EXPECT_LE(fine, 250 * coarse);
    // A circle needs π/√(2ε) chords; halving overshoots by at most a factor of two.
    const double needed = std::numbers::pi / std::sqrt(2e-7);
    EXPECT_GE(static_cast<double>(fine), needed);
    EXPECT_LE(static_cast<double>(fine), 2.3 * needed);
}

TEST(Polyline, EveryKnotIsAVertexAndTheEndsAreExact) {
    const auto knots = KnotVector::make({0, 0, 0, 0.3, 1.7, 2, 2, 2}, 2, 5, Form::clamped).value();
    const Curve curve(BsplineCurve::make(knots, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 0}}, 2)
                          .value());
    const Polyline line = polyline(curve, 0.5);
    for (const double knot : {0.0, 0.3, 1.7, 2.0}) {
        EXPECT_NE(std::find(line.parameters.begin(), line.parameters.end(), knot),
                  line.parameters.end());
    }
    EXPECT_EQ(vertex(line, 0), Vec3(0, 0, 0));
    EXPECT_EQ(vertex(line, line.parameters.size() - 1), Vec3(4, 0, 0));
    EXPECT_TRUE(std::is_sorted(line.parameters.begin(), line.parameters.end()));
}

TEST(Polyline, ShowsAJumpAsTwoVerticesAtOneParameter) {
    std::vector<Pose> poses(4);
    poses[2].translate = {5, 0, 0};
    const Curve curve(BlendingCurve::fromModel(model("circle"), 4, BlendForm::open, BFunction(),
                                               {0, 1, 1, 2}, poses)
                          .value());
    const Polyline line = polyline(curve, 1e-3);
    EXPECT_EQ(std::count(line.parameters.begin(), line.parameters.end(), 1.0), 2);
}

TEST(Polyline, APartMayLieOutsideTheDomainOfAClosedSpline) {
    const auto knots = KnotVector::uniform(3, 6, Form::closed).value();
    const Curve curve(
        BsplineCurve::make(knots, {{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {2, 4, 0}, {0, 4, 0}, {-1, 2, 0}}, 2)
            .value());
    const Polyline line = polyline(curve, Interval{-1.5, 1.5}, 1e-4);
    EXPECT_EQ(line.parameters.front(), -1.5);
    EXPECT_LE(glm::length(vertex(line, 0) - pointAt(curve, 4.5)), 1e-14);
    EXPECT_LE(chordError(curve, line), 1e-4);
}

}  // namespace
}  // namespace knotwork
