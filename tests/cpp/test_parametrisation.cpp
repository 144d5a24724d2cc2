#include "geometry/parametrisation.hpp"

#include "geometry/fitting.hpp"
#include "geometry/schoenberg_whitney.hpp"

#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::allForms;
using test::RandomSplines;

using Numbers = std::vector<double>;

// Chords 9, 16, 0, and 25 back to the start.
const std::vector<Vec3> corner{{0, 0, 0}, {9, 0, 0}, {9, 0, 16}, {9, 0, 16}};
const std::vector<Vec3> triangle{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}};

TEST(Parametrisation, UniformParametersAreEquallySpaced) {
    EXPECT_EQ(*parametersOf(corner, Parametrisation::uniform, false),
              (Numbers{0, 1.0 / 3, 2.0 / 3, 1}));
    EXPECT_EQ(*parametersOf(corner, Parametrisation::uniform, true), (Numbers{0, 0.25, 0.5, 0.75}));
}

TEST(Parametrisation, ChordParametersAreProportionalToDistances) {
    EXPECT_EQ(*parametersOf(corner, Parametrisation::chord, false), (Numbers{0, 9.0 / 25, 1, 1}));
    EXPECT_EQ(*parametersOf(triangle, Parametrisation::chord, true),
              (Numbers{0, 4.0 / 12, 7.0 / 12}));
}

TEST(Parametrisation, CentripetalParametersAreProportionalToTheirRoots) {
    EXPECT_EQ(*parametersOf(corner, Parametrisation::centripetal, false),
              (Numbers{0, 3.0 / 7, 1, 1}));
    const auto closed = *parametersOf(triangle, Parametrisation::centripetal, true);
    const double total = 2 + std::sqrt(3.0) + std::sqrt(5.0);
    EXPECT_EQ(closed, (Numbers{0, 2 / total, (2 + std::sqrt(3.0)) / total}));
}

TEST(Parametrisation, TinyAndHugeDistancesKeepTheirProportions) {
    for (const double size : {1e-320, 1e-200, 1e-160, 1e12}) {
        std::vector<Vec3> points;
        for (const double x : {0.0, 1.0, 4.0}) points.emplace_back(0, x * size, 0);
        const auto u = parametersOf(points, Parametrisation::chord, false).value();
        EXPECT_NEAR(u[1], 0.25, size < 1e-300 ? 1e-3 : 1e-15) << size;
    }
}

TEST(Parametrisation, PointsThatAreAllEqualHaveOnlyUniformParameters) {
    const std::vector<Vec3> same(5, Vec3(1, 2, 3));
    for (const bool closed : {false, true}) {
        EXPECT_EQ(parametersOf(same, Parametrisation::chord, closed).error().code,
                  Code::outOfRange);
        EXPECT_EQ(parametersOf(same, Parametrisation::centripetal, closed).error().path, "points");
        EXPECT_TRUE(parametersOf(same, Parametrisation::uniform, closed).ok());
    }
    EXPECT_EQ(parametersOf({same.data(), 1}, Parametrisation::uniform, false).error().code,
              Code::wrongLength);
}

TEST(Parametrisation, RangeOfAClosedListGoesOnToWhereItBeginsAgain) {
    EXPECT_EQ(parameterRange(Numbers{2, 3, 7}, false), (Interval{2, 7}));
    EXPECT_EQ(parameterRange(Numbers{0, 0.25, 0.5}, true), (Interval{0, 1}));
    EXPECT_EQ(parameterRange(Numbers{0, 1, 2, 3}, true), (Interval{0, 4}));
    EXPECT_EQ(parameterRange(Numbers{-1, 0, 1}, true), (Interval{-1, 2}));
}

TEST(DefaultKnots, UniformOnesSpanTheRange) {
    const Interval range{1, 3};
    EXPECT_EQ(uniformKnots(range, 2, 6, Form::clamped), (Numbers{1, 1, 1, 1.5, 2, 2.5, 3, 3, 3}));
    EXPECT_EQ(uniformKnots(range, 2, 6, Form::open), (Numbers{0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4}));
    EXPECT_EQ(uniformKnots(range, 2, 4, Form::closed), (Numbers{1, 1.5, 2, 2.5, 3}));
}

TEST(DefaultKnots, AveragedOnesFollowTheParameters) {
    const Numbers u{0, 3, 4, 8, 10};
    EXPECT_EQ(averagedKnots(u, 2, Form::clamped), (Numbers{0, 0, 0, 3.5, 6, 10, 10, 10}));
    EXPECT_EQ(averagedKnots(u, 3, Form::clamped), (Numbers{0, 0, 0, 0, 5, 10, 10, 10, 10}));
    EXPECT_EQ(averagedKnots(Numbers{0, 3, 4, 9}, 2, Form::open),
              (Numbers{-9, -4.5, 0, 3.5, 9, 13.5, 18}));
    EXPECT_EQ(averagedKnots(Numbers{0, 3, 4, 9}, 3, Form::closed), (Numbers{0, 3, 4, 9, 12}));
    EXPECT_EQ(averagedKnots(Numbers{0, 3, 4, 9}, 2, Form::closed),
              (Numbers{-1.5, 1.5, 3.5, 6.5, 10.5}));
}

TEST(DefaultKnots, AveragedOnesGiveEveryFunctionAParameter) {
    RandomSplines random(81);
    for (int round = 0; round < 600; ++round) {
        const Form form = allForms[round % 3];
        const int degree = random.integer(1, 9);
        const int count = random.integer(degree + 1, degree + 12);
        Numbers u{0};
        // Distances that differ by up to a thousand.
        for (int k = 1; k < count; ++k) u.push_back(u.back() + std::pow(10, random.real(-3, 0)));
        const auto knots =
            KnotVector::make(averagedKnots(u, degree, form), degree, count, form).value();
        ASSERT_EQ(starvedFunction(knots, u), std::nullopt) << "round " << round;
        for (const double t : u) ASSERT_TRUE(knots.domain().contains(t));
    }
}

struct Refusal {
    std::string name;
    std::vector<Vec3> points;
    FitRequest request;
    Code code;
    std::string path;
};

TEST(FitRefusals, SayWhatWasWrongAndWhere) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> five{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}, {4, 0, 0}};
    auto broken = five;
    broken[3].y = nan;
    auto far = five;
    far[2].z = 2e12;
    std::deque<Numbers> kept;
    const auto keep = [&kept](Numbers u) -> std::span<const double> {
        return kept.emplace_back(std::move(u));
    };
    const auto own = [&keep](Numbers u) { return FitRequest{.parameters = keep(std::move(u))}; };
    const std::vector<Refusal> refusals{
        {"no points", {}, {}, Code::wrongLength, "points"},
        {"NaN", broken, {}, Code::notFinite, "points[3]"},
        {"too far", far, {}, Code::outOfRange, "points[2]"},
        {"all equal", std::vector<Vec3>(9, Vec3(1)), {}, Code::outOfRange, "points"},
        {"one point", {{1, 1, 1}}, {}, Code::wrongLength, "points"},
        {"degree 0", five, {.degree = 0}, Code::outOfRange, "degree"},
        {"degree 26", five, {.degree = 26}, Code::tooLarge, "degree"},
        {"few control points", five, {.degree = 4}, Code::outOfRange, "count"},
        {"many control points", five, {.count = 100'001}, Code::tooLarge, "count"},
        {"too few points", five, {.count = 6}, Code::rankDeficient, "controlPoints[4]"},
        {"length", five, own({0, 1, 2, 3}), Code::wrongLength, "parameters"},
        {"NaN parameter", five, own({0, 1, nan, 3, 4}), Code::notFinite, "parameters[2]"},
        {"decreasing", five, own({0, 1, 2, 1.5, 4}), Code::outOfRange, "parameters[3]"},
        {"far parameter", five, own({0, 1, 2, 3, 2e9}), Code::outOfRange, "parameters[4]"},
        {"no range", five, own({1, 1, 1, 1, 1}), Code::outOfRange, "parameters"},
        {"knots", five, {.knots = {0, 0, 0, 1, 1, 1}}, Code::knotsCount, "knots"},
        {"before the knots", five,
         {.parameters = keep({-1, 0, 1, 2, 3}), .knots = {0, 0, 0, 0, 4, 4, 4, 4}},
         Code::outOfRange, "parameters[0]"},
        {"after the knots", five,
         {.parameters = keep({0, 1, 2, 3, 4}), .knots = {0, 0, 0, 0, 2, 2, 2, 2}},
         Code::outOfRange, "parameters[3]"},
        {"smoothing", five, {.options = {.smoothing = -1}}, Code::outOfRange, "smoothing"},
        {"NaN smoothing", five, {.options = {.smoothing = nan}}, Code::outOfRange, "smoothing"},
        {"ends of a closed one", five,
         {.form = Form::closed, .options = {.interpolateEnds = true}}, Code::notSupported,
         "interpolateEnds"},
    };
    for (const Refusal& refusal : refusals) {
        const auto fit = fitCurve(refusal.points, refusal.request);
        ASSERT_FALSE(fit.ok()) << refusal.name;
        EXPECT_EQ(codeName(fit.error().code), codeName(refusal.code)) << refusal.name;
        EXPECT_EQ(fit.error().path, refusal.path) << refusal.name;
        EXPECT_GT(fit.error().message.size(), 10U) << refusal.name;
    }
}

TEST(FitRefusals, OfInterpolationNameThePoints) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {3, 1, 0}};
    EXPECT_EQ(interpolateCurve(points, 4, Form::clamped).error().path, "points");
    EXPECT_EQ(interpolateCurve(points, 4, Form::clamped).error().code, Code::wrongLength);
    // Two points at one parameter cannot both be met.
    EXPECT_EQ(interpolateCurve(points, 2, Form::clamped).error().code, Code::rankDeficient);
    EXPECT_EQ(interpolateCurve(points, 2, Form::clamped).error().path, "controlPoints[2]");
    EXPECT_TRUE(interpolateCurve(points, 2, Form::clamped, Parametrisation::uniform).ok());
}

TEST(FitRefusals, EqualPointsInARowAreNoObstacleToAFit) {
    std::vector<Vec3> points;
    for (int i = 0; i < 40; ++i) points.emplace_back(i / 4, (i / 4) % 3, 0);
    for (const Form form : allForms) {
        const auto fit = fitCurve(points, {.count = 6, .form = form});
        ASSERT_TRUE(fit.ok()) << fit.error().message;
        EXPECT_TRUE(std::isfinite(fit->residuals.rms));
    }
}

}  // namespace
}  // namespace knotwork
