#include "geometry/tessellation.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/smooth_pieces.hpp"
#include "support/zoo.hpp"

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

/// The greatest distance of the curve from the chord over the same parameters, in up to 2 000 of
/// the chords.
double chordError(const Curve& curve, const Polyline& line) {
    double worst = 0;
    const std::size_t chords = line.parameters.size() - 1;
    const std::size_t stride = 1 + chords / 2000;
    for (std::size_t i = 1 + chords % stride / 2; i <= chords; i += stride) {
        for (int k = 1; k < 16; ++k) {
            const double t = line.parameters[i - 1] +
                             (line.parameters[i] - line.parameters[i - 1]) * k / 16.0;
            worst = std::max(worst,
                             distanceToSegment(pointAt(curve, t), vertex(line, i - 1), vertex(line, i)));
        }
    }
    return worst;
}

double largestCoordinate(const Polyline& line) {
    double largest = 0;
    for (const double x : line.xyz) largest = std::max(largest, std::abs(x));
    return largest;
}

TEST(Polyline, HonoursItsToleranceFromOneToTenBillionthsOnEveryCurve) {
    for (const test::Animal& animal : test::wholeZoo()) {
        for (double tolerance = 1; tolerance > 0.9e-10; tolerance /= 10) {
            const auto line = polylineWithin(animal.curve, tolerance);
            if (!line) {
                EXPECT_EQ(line.error().code, Code::tooLarge);
                EXPECT_LE(tolerance, 1.1e-9) << animal.name;
                continue;
            }
            const double rounding = 8e-16 * largestCoordinate(*line);
            EXPECT_LE(chordError(animal.curve, *line), tolerance + rounding)
                << animal.name << " at " << tolerance;
            const auto& ts = line->parameters;
            EXPECT_TRUE(std::is_sorted(ts.begin(), ts.end())) << animal.name;
            EXPECT_EQ(ts.front(), domain(animal.curve).start) << animal.name;
            EXPECT_EQ(ts.back(), domain(animal.curve).end) << animal.name;
            EXPECT_EQ(line->xyz.size(), 3 * ts.size()) << animal.name;
        }
    }
}

/// ∫ √(κ|C′|²/8ε) dt: as few chords as a small tolerance allows.
double leastChords(const Curve& curve, double tolerance) {
    double sum = 0;
    for (const Interval& piece : smoothPieces(curve)) {
        constexpr int panels = 32;
        for (int i = 0; i < panels; ++i) {
            sum += integrateGauss<8>(
                [&](double t) {
                    std::array<Vec3, 3> rows;
                    evaluate(curve, t, Side::right, rows);
                    const double turn = glm::length(glm::cross(rows[1], rows[2]));
                    return std::sqrt(turn / glm::length(rows[1]) / (8 * tolerance));
                },
                piece.start + piece.length() * i / panels,
                piece.start + piece.length() * (i + 1) / panels);
        }
    }
    return sum;
}

TEST(Polyline, TakesFewMorePointsThanItMust) {
    for (const test::Animal& animal : test::models()) {
        const double least = leastChords(animal.curve, 1e-7);
        const auto line = polylineWithin(animal.curve, 1e-7);
        ASSERT_TRUE(line.ok());
        const auto points = static_cast<double>(line->parameters.size());
        EXPECT_GE(points, 0.99 * least) << animal.name;
        EXPECT_LE(points, 1.2 * least) << animal.name;
    }
}

TEST(Polyline, AlsoTakesFewPointsForAPicture) {
    double points = 0;
    double least = 0;
    for (const test::Animal& animal : test::models()) {
        least += leastChords(animal.curve, 1e-3);
        points += static_cast<double>(polyline(animal.curve, 1e-3).parameters.size());
    }
    EXPECT_LE(points, 1.35 * least);
}

TEST(Polyline, NeverTakesALoopOrAnSForAChord) {
    // The middle of the S, and the ends and the middle of the loop, lie on a chord.
    const Curve s = test::spline(3, Form::clamped, {}, test::sShape());
    EXPECT_GE(polyline(s, 1e-2).parameters.size(), 8U);
    const Curve turn(ParametricCurve::make("circle", {}, Interval{0, 200 * std::numbers::pi}).value());
    EXPECT_LE(chordError(turn, polyline(turn, 1e-2)), 1e-2);
    const Curve fast(test::make("lissajous", {{"kx", 97.0}, {"ky", 31.0}}));
    EXPECT_LE(chordError(fast, polyline(fast, 1e-2)), 1e-2);
}

TEST(Polyline, RefusesWhatTakesTooManyPointsAndAPictureStopsThere) {
    const Curve circle(test::make("circle", {{"radius", 1000.0}}));
    const auto line = polylineWithin(circle, 1e-10);
    ASSERT_FALSE(line.ok());
    EXPECT_EQ(line.error().code, Code::tooLarge);
    EXPECT_EQ(line.error().path, "tolerance");
    const Polyline drawn = polyline(circle, 1e-10);
    EXPECT_LE(drawn.parameters.size(), mostDrawnPoints + 64);
    EXPECT_GE(drawn.parameters.size(), mostDrawnPoints / 4);
}

TEST(Polyline, OfAStraightLineIsItsEndsAndOfAPointIsThePoint) {
    const Curve line = test::spline(3, Form::clamped, {}, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
    EXPECT_EQ(polyline(line, 1e-10).parameters.size(), 2U);
    const Curve still = test::spline(3, Form::clamped, {}, std::vector<Vec3>(4, Vec3(1, 2, 3)));
    EXPECT_EQ(polyline(still, 1e-10).parameters.size(), 2U);
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
