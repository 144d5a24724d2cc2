#include "geometry/knot_removal.hpp"

#include "geometry/refinement.hpp"
#include "support/gates.hpp"
#include "support/refinements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::SplineKind;

/// A knot of the domain that may be removed.
std::optional<double> removable(const BsplineCurve& curve, RandomSplines& random) {
    std::vector<double> candidates;
    for (const double t : curve.knotVector().knots()) {
        if (removeKnotAnyway(curve, t).ok()) candidates.push_back(t);
    }
    if (candidates.empty()) return std::nullopt;
    return candidates[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(candidates.size()) - 1))];
}

TEST(KnotRemoval, OfAnInsertedKnotGivesTheCurveBack) {
    RandomSplines random(71);
    for (int round = 0; round < 1000; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const auto ts = test::telltaleParameters(curve.knotVector(), random, 6);
        const double t =
            ts[static_cast<std::size_t>(random.integer(0, static_cast<int>(ts.size()) - 1))];
        const auto refined = insertKnot(curve, t, 1);
        if (!refined) continue;
        const auto removal = removeKnot(*refined, t, 1e-9);
        ASSERT_TRUE(removal.ok()) << removal.error().message;
        ASSERT_TRUE(removal->removed) << removal->deviation;
        ASSERT_LE(removal->deviation, test::gates::removal);
        ASSERT_EQ(removal->curve.points().size(), curve.points().size());
        ASSERT_LE(test::farthest(curve, removal->curve, random), test::gates::removal);
        if (curve.closed()) continue;  // the seam may be repeated at its other end
        ASSERT_EQ(removal->curve.knotVector(), curve.knotVector());
        for (std::size_t i = 0; i < curve.points().size(); ++i) {
            ASSERT_LE(glm::length(removal->curve.points()[i] - curve.points()[i]),
                      test::gates::removal);
        }
    }
}

double sampledDeviation(const BsplineCurve& a, const BsplineCurve& b) {
    double largest = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double t = uniformParameter(a.domain(), static_cast<std::size_t>(i), 2001);
        for (const Side side : test::bothSides) {
            const Vec3 apart = test::pointOf(a, t, side) - test::pointOf(b, t, side);
            largest = std::max(largest, glm::length(apart));
        }
    }
    return largest;
}

TEST(KnotRemoval, DeviationIsABoundOnWhatTheCurveMovesAndATightOne) {
    RandomSplines random(72);
    int removed = 0;
    for (int round = 0; round < 400; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 2 == 0});
        const auto t = removable(curve, random);
        if (!t) continue;
        const KnotRemoval removal = removeKnotAnyway(curve, *t).value();
        if (!removal.removed) {
            EXPECT_EQ(removal.deviation, std::numeric_limits<double>::infinity());
            EXPECT_EQ(removal.curve, curve);
            continue;
        }
        ++removed;
        EXPECT_EQ(removal.curve.knotVector().multiplicity(*t),
                  curve.knotVector().multiplicity(*t) - 1);
        const double moved = std::max(sampledDeviation(curve, removal.curve),
                                      test::farthest(curve, removal.curve, random));
        EXPECT_LE(moved, removal.deviation + 1e-14);
        EXPECT_LE(removal.deviation, 1.05 * moved + 1e-14);
    }
    EXPECT_GT(removed, 200);
}

TEST(KnotRemoval, MovesNothingBeyondTheTolerance) {
    RandomSplines random(73);
    for (int round = 0; round < 200; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const auto t = removable(curve, random);
        if (!t) continue;
        const KnotRemoval anyway = removeKnotAnyway(curve, *t).value();
        const KnotRemoval at = removeKnot(curve, *t, anyway.deviation).value();
        EXPECT_TRUE(at.removed);
        EXPECT_EQ(at.curve, anyway.curve);
        if (!(anyway.deviation > 1e-12)) continue;
        const KnotRemoval below = removeKnot(curve, *t, 0.99 * anyway.deviation).value();
        EXPECT_FALSE(below.removed);
        EXPECT_EQ(below.curve, curve);
        EXPECT_EQ(below.deviation, anyway.deviation);
    }
}

TEST(KnotRemoval, IsTheBestEvenSpreadOfTheLeftoverOverThePoints) {
    // Uniform cubic, knot 3 of 0 … 8, all points 0 but one: the leftover of the three equations is
    // (1, -1, 1)/7 times 3 of the middle point, which rounds the spike off.
    const auto knots = KnotVector::uniform(3, 9, Form::open).value();
    std::vector<Vec3> points(9, Vec3(0));
    points[4] = {0, 1, 0};
    const auto curve = BsplineCurve::make(knots, points, 2).value();
    const KnotRemoval removal = removeKnotAnyway(curve, 6).value();
    ASSERT_TRUE(removal.removed);
    const auto again = insertKnot(removal.curve, 6, 1).value();
    std::vector<double> left;
    for (std::size_t i = 0; i < 9; ++i) left.push_back(points[i].y - again.points()[i].y);
    const std::vector<double> expected{0, 0, 0, -3.0 / 7, 3.0 / 7, -3.0 / 7, 0, 0, 0};
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(left[i], expected[i], 1e-14) << i;
}

TEST(KnotRemoval, JoinsAGapInTheMiddle) {
    const auto knots =
        KnotVector::make({0, 0, 0, 1, 1, 1, 2, 2, 2}, 2, 6, Form::clamped).value();
    const auto curve = BsplineCurve::make(
        knots, {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 2, 0}, {3, 1, 0}, {4, 0, 0}}, 2);
    const KnotRemoval removal = removeKnotAnyway(*curve, 1).value();
    EXPECT_EQ(removal.curve.points()[2], Vec3(2, 1, 0));
    EXPECT_NEAR(removal.deviation, 1, 1e-14);
}

TEST(KnotRemoval, KeepsTheWeightsPositiveOrTheKnot) {
    const auto knots = KnotVector::uniform(2, 4, Form::clamped).value();
    const auto curve = BsplineCurve::make(
        knots, {{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 0, 0}}, 2, {1, 1e-6, 1, 1});
    const KnotRemoval removal = removeKnotAnyway(*curve, 1).value();
    EXPECT_TRUE(!removal.removed || removal.curve.weights()[1] > 0);
}

void expectRefusal(const BsplineCurve& curve, double t, double tolerance, Code code,
                   const std::string& path) {
    const auto made = removeKnot(curve, t, tolerance);
    ASSERT_FALSE(made.ok()) << t;
    EXPECT_EQ(codeName(made.error().code), codeName(code)) << made.error().message;
    EXPECT_EQ(made.error().path, path);
    EXPECT_GT(made.error().message.size(), 20U);
}

TEST(KnotRemoval, RefusesWhatIsNoKnotInside) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto clamped = BsplineCurve::make(KnotVector::uniform(2, 5, Form::clamped).value(),
                                            std::vector<Vec3>(5), 2)
                             .value();
    expectRefusal(clamped, 0.5, 1, Code::outOfRange, "t");
    expectRefusal(clamped, 0, 1, Code::outOfRange, "t");
    expectRefusal(clamped, 3, 1, Code::outOfRange, "t");
    expectRefusal(clamped, 7, 1, Code::outOfRange, "t");
    expectRefusal(clamped, nan, 1, Code::notFinite, "t");
    expectRefusal(clamped, 1, -1, Code::outOfRange, "tolerance");
    expectRefusal(clamped, 1, nan, Code::notFinite, "tolerance");
    const auto open = BsplineCurve::make(KnotVector::uniform(2, 5, Form::open).value(),
                                         std::vector<Vec3>(5), 2)
                          .value();
    expectRefusal(open, 1, 1, Code::outOfRange, "t");
    expectRefusal(open, 2, 1, Code::outOfRange, "t");
    expectRefusal(open, 5, 1, Code::outOfRange, "t");
    const auto closed = BsplineCurve::make(KnotVector::uniform(2, 4, Form::closed).value(),
                                           std::vector<Vec3>(4), 2)
                            .value();
    expectRefusal(closed, 0, 1, Code::outOfRange, "t");
    expectRefusal(closed, 4, 1, Code::outOfRange, "t");
    const auto least = BsplineCurve::make(KnotVector::uniform(2, 3, Form::closed).value(),
                                          std::vector<Vec3>(3), 2)
                           .value();
    expectRefusal(least, 1, 1, Code::knotsCount, "t");
}

}  // namespace
}  // namespace knotwork
