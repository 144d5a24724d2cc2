#include "geometry/cubic_refinement.hpp"

#include "geometry/oslo.hpp"
#include "geometry/oslo_kernels.hpp"
#include "geometry/refinement.hpp"
#include "support/gates.hpp"
#include "support/rational.hpp"
#include "support/refinements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::Rational;
using test::SplineKind;

constexpr SplineKind cubic{.minDegree = 3, .maxDegree = 3};

KnotVector clampedCubic(std::vector<double> knots) {
    const int count = static_cast<int>(knots.size()) - 4;
    return KnotVector::make(std::move(knots), 3, count, Form::clamped).value();
}

std::vector<Vec3> randomPoints(int count, RandomSplines& random) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    }
    return points;
}

void expectRowsOfOslo1(const KnotVector& knots, const std::vector<Vec3>& points,
                       std::vector<double> more) {
    const KnotVector refined = refinedKnots(knots, std::move(more)).value();
    const auto found = refinedCubic(knots, points, refined);
    ASSERT_TRUE(found.has_value());
    const std::vector<Vec3> expected = oslo1(knots, refined, points);
    ASSERT_EQ(found->size(), expected.size());
    for (std::size_t j = 0; j < expected.size(); ++j) {
        ASSERT_LE(glm::length((*found)[j] - expected[j]), test::gates::osloAgainstBoehm) << j;
    }
}

TEST(CubicRefinement, IsTheBlossomInExactFractions) {
    RandomSplines random(71);
    for (int round = 0; round < 200; ++round) {
        std::vector<Rational> tau(4, 0);
        for (int i = 0; i < 3; ++i) {
            tau.insert(tau.end(), static_cast<std::size_t>(random.integer(0, 4)), Rational(8 * i + 8));
        }
        tau.insert(tau.end(), 4, 32);
        std::vector<Rational> values;
        std::vector<Vec3> points;
        while (points.size() + 4 < tau.size()) {
            values.emplace_back(random.integer(-8, 8), 8);
            points.emplace_back(values.back().value(), -values.back().value(), 1);
        }
        std::vector<double> knots;
        for (const Rational& t : tau) knots.push_back(t.value());
        std::vector<double> refined = knots;
        for (int i = random.integer(0, 30); i > 0; --i) {
            const double t = random.integer(1, 31);
            if (std::count(refined.begin(), refined.end(), t) < 4) refined.push_back(t);
        }
        std::sort(refined.begin(), refined.end());
        const auto found =
            refinedCubic(clampedCubic(knots), points, clampedCubic(refined)).value();
        for (std::size_t j = 0; j < found.size(); ++j) {
            std::size_t span = 3;
            while (knots[span + 1] <= refined[j]) ++span;
            std::vector<Rational> active(&values[span - 3], &values[span - 3] + 4);
            std::vector<Rational> arguments;
            for (std::size_t k = 1; k <= 3; ++k) {
                arguments.emplace_back(static_cast<long long>(refined[j + k]));
            }
            const double exact = kernels::blossom<Rational, Rational>(tau, 3, span, arguments,
                                                                      active).value();
            ASSERT_NEAR(found[j].x, exact, test::gates::exact) << "point " << j;
            ASSERT_NEAR(found[j].y, -exact, test::gates::exact) << "point " << j;
            ASSERT_NEAR(found[j].z, 1, test::gates::exact) << "point " << j;
        }
    }
}

TEST(CubicRefinement, AgreesWithOslo1ForFewNewKnotsAndForMany) {
    RandomSplines random(72);
    for (int round = 0; round < 1000; ++round) {
        const BsplineCurve curve = random.curve(Form::clamped, cubic);
        expectRowsOfOslo1(curve.knotVector(), {curve.points().begin(), curve.points().end()},
                          test::randomRefinement(curve.knotVector(), random,
                                                 random.integer(0, 100)));
    }
}

TEST(CubicRefinement, AgreesWithOslo1WhereSpansDifferByNineOrdersOfMagnitude) {
    RandomSplines random(73);
    for (int round = 0; round < 500; ++round) {
        std::vector<double> knots(4, random.real(-3, 3));
        for (int i = random.integer(1, 12); i > 0; --i) {
            knots.push_back(knots.back() + std::pow(10, random.real(-9, 0)));
        }
        knots.insert(knots.end(), 4, knots.back() + 1);
        std::vector<double> refined = knots;
        for (std::size_t i = 3; i + 4 < knots.size(); ++i) {
            const int between = random.integer(0, 5);
            for (int k = 1; k <= between; ++k) {
                refined.push_back(knots[i] + k * (knots[i + 1] - knots[i]) / (between + 1));
            }
        }
        std::sort(refined.begin(), refined.end());
        const KnotVector coarse = clampedCubic(knots);
        expectRowsOfOslo1(coarse, randomPoints(coarse.pointCount(), random), refined);
    }
}

TEST(CubicRefinement, MiddleOfASpanOfNineteenUlpsNeedNotBeANumber) {
    const double start = 134'217'728;
    const double ulp = std::nextafter(start, 2 * start) - start;
    std::vector<double> knots(4, start);
    knots.insert(knots.end(), {start + 1, start + 1 + 19 * ulp});
    knots.insert(knots.end(), 4, start + 2);
    RandomSplines random(74);
    for (const int place : {9, 10}) {
        std::vector<double> refined = knots;
        refined.insert(refined.begin() + 5, start + 1 + place * ulp);
        expectRowsOfOslo1(clampedCubic(knots), randomPoints(6, random), refined);
    }
}

TEST(CubicRefinement, LeavesPointsAloneThatStay) {
    RandomSplines random(75);
    const KnotVector knots = clampedCubic({0, 0, 0, 0, 1, 2, 3, 3, 4, 5, 6, 6, 6, 6});
    const std::vector<Vec3> points = randomPoints(10, random);
    EXPECT_EQ(refinedCubic(knots, points, knots).value(), points);
    const KnotVector finer =
        clampedCubic({0, 0, 0, 0, 1, 2, 3, 3, 3.2, 3.4, 3.5, 3.9, 4, 5, 6, 6, 6, 6});
    const auto found = refinedCubic(knots, points, finer).value();
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(found[i], points[i]) << i;
    for (std::size_t i = 8; i < 10; ++i) EXPECT_EQ(found[i + 4], points[i]) << i;
    const KnotVector ends = clampedCubic({0, 0, 0, 0, 0.1, 0.2, 0.3, 1, 2, 3, 3, 4, 5,
                                          5.1, 5.2, 5.3, 6, 6, 6, 6});
    EXPECT_EQ(refinedCubic(knots, points, ends)->front(), points.front());
    EXPECT_EQ(refinedCubic(knots, points, ends)->back(), points.back());
}

void expectTheRefusalOfRefinedKnots(const BsplineCurve& curve, const std::vector<double>& knots) {
    const auto expected = refinedKnots(curve.knotVector(), knots);
    const auto found = refineByOslo(curve, knots);
    ASSERT_FALSE(expected.ok());
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, expected.error().code);
    EXPECT_EQ(found.error().path, expected.error().path);
    EXPECT_EQ(found.error().message, expected.error().message);
}

TEST(CubicRefinement, RefusesAMissingKnotAsRefinedKnotsDoes) {
    RandomSplines random(76);
    int refused = 0;
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve = random.curve(Form::clamped, cubic);
        auto knots = test::randomRefinement(curve.knotVector(), random, random.integer(2, 20));
        const int at = random.integer(0, static_cast<int>(knots.size()) - 1);
        knots[static_cast<std::size_t>(at)] += random.real(-1, 1);
        std::sort(knots.begin(), knots.end());
        if (refineByOslo(curve, knots).ok()) {
            ASSERT_TRUE(refinedKnots(curve.knotVector(), knots).ok());
        } else {
            expectTheRefusalOfRefinedKnots(curve, knots);
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
}

TEST(CubicRefinement, RefusesNewEndsAsRefinedKnotsDoes) {
    RandomSplines random(78);
    const KnotVector knots = clampedCubic({0, 0, 0, 0, 1, 2, 2, 2, 2});
    const auto curve = BsplineCurve::make(knots, randomPoints(5, random), 3).value();
    expectTheRefusalOfRefinedKnots(curve, {-1, -1, -1, -1, 0, 0, 0, 0, 1, 2, 2, 2, 2});
    expectTheRefusalOfRefinedKnots(curve, {0, 0, 0, 0, 1, 2, 2, 2, 2, 3, 3, 3, 3});
    expectTheRefusalOfRefinedKnots(curve, {-1, -1, -1, -1, 0, 0, 1, 1.5, 2, 2, 2, 2});
    expectTheRefusalOfRefinedKnots(curve, {0, 0, 0, 0, 1, 1.5, 2, 2, 3, 3, 3, 3});
}

TEST(CubicRefinement, OtherCurvesAreRefinedByOslo1) {
    RandomSplines random(77);
    for (int round = 0; round < 200; ++round) {
        const BsplineCurve curve = round % 2 == 0
            ? random.curve(Form::clamped, {.minDegree = 3, .maxDegree = 3, .rational = true})
            : random.curve(round % 4 == 1 ? Form::open : Form::closed, cubic);
        const auto knots = test::randomRefinement(curve.knotVector(), random, 20);
        ASSERT_EQ(refineByOslo(curve, knots).value(), refineByOslo1(curve, knots).value());
    }
}

}  // namespace
}  // namespace knotwork
