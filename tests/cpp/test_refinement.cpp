#include "geometry/refinement.hpp"

#include "support/gates.hpp"
#include "support/splines.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::SplineKind;

void expectPoints(std::span<const Vec3> found, const std::vector<Vec3>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LE(glm::length(found[i] - expected[i]), test::gates::exact) << "point " << i;
    }
}

double farthest(const BsplineCurve& a, const BsplineCurve& b, RandomSplines& random) {
    double largest = 0;
    for (const double t : test::telltaleParameters(b.knotVector(), random)) {
        largest = std::max(largest, glm::length(a.point(t) - b.point(t)));
    }
    return largest;
}

TEST(KnotInsertion, OneByOneGivesTheRefinedPolygonOfTheTruth) {
    const auto& quad = test::truth("quad_curve");
    const auto& refined = test::truth("oslo_quad");
    const auto knots = test::doubles(test::rationals(quad["knots"]));
    auto curve = BsplineCurve::make(KnotVector::make(knots, 2, 5, Form::clamped).value(),
                                    test::planarPoints(quad["ctrl"]), 2)
                     .value();
    for (const double t : {2.0, 0.5, 3.5, 1.0}) curve = insertKnot(curve, t, 1).value();
    const auto expected = test::doubles(test::rationals(refined["to"]));
    const auto found = curve.knotVector().knots();
    EXPECT_EQ(std::vector<double>(found.begin(), found.end()), expected);
    expectPoints(curve.points(), test::planarPoints(refined["ctrl"]));
}

// Piegl and Tiller, The NURBS Book, Ex. 5.1.
TEST(KnotInsertion, AgreesWithThePublishedCubicExample) {
    RandomSplines random(41);
    std::vector<Vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(random.real(-1, 1), random.real(-1, 1), 0);
    const auto curve = BsplineCurve::make(
        KnotVector::make({0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}, 3, 8, Form::clamped).value(), p, 2);
    const auto refined = insertKnot(*curve, 2.5, 1).value();
    expectPoints(refined.points(),
                 {p[0], p[1], p[2], p[2] / 6.0 + 5.0 / 6 * p[3], (p[3] + p[4]) / 2.0,
                  5.0 / 6 * p[4] + p[5] / 6.0, p[5], p[6], p[7]});
}

TEST(KnotInsertion, DoesNotMoveTheCurve) {
    RandomSplines random(42);
    for (int round = 0; round < 1000; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const double t = random.real(curve.domain().start, curve.domain().end);
        const int times = random.integer(1, curve.degree());
        const auto refined = insertKnot(curve, t, times);
        ASSERT_TRUE(refined.ok()) << refined.error().message;
        ASSERT_EQ(refined->points().size(),
                  curve.points().size() + static_cast<std::size_t>(times));
        ASSERT_EQ(refined->knotVector().multiplicity(t), times);
        ASSERT_EQ(refined->domain(), curve.domain());
        ASSERT_LE(farthest(curve, *refined, random), test::gates::refinement);
    }
}

TEST(KnotInsertion, AtEveryKnotAndEndItFillsUpToTheDegreeWithoutMovingTheCurve) {
    RandomSplines random(43);
    int filled = 0;
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        for (const double t : curve.knotVector().knots()) {
            const int missing = curve.degree() - curve.knotVector().multiplicity(t);
            if (missing < 1 || !curve.domain().contains(t)) continue;
            const auto refined = insertKnot(curve, t, missing);
            ASSERT_TRUE(refined.ok()) << refined.error().message;
            ASSERT_EQ(refined->knotVector().multiplicity(t), curve.degree());
            ASSERT_LE(farthest(curve, *refined, random), test::gates::refinement);
            ++filled;
        }
    }
    EXPECT_GT(filled, 500);
}

TEST(KnotInsertion, KnotOfFullMultiplicityIsAControlPointOfTheCurve) {
    RandomSplines random(44);
    for (int round = 0; round < 100; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const double t = random.real(curve.domain().start, curve.domain().end);
        const auto refined = insertKnot(curve, t, curve.degree()).value();
        const Vec3 point = curve.point(t);
        const auto meets = [&](const Vec3& control) {
            return glm::length(control - point) <= test::gates::refinement;
        };
        EXPECT_TRUE(std::any_of(refined.points().begin(), refined.points().end(), meets));
    }
}

TEST(KnotInsertion, SeamOfAClosedCurveIsOneKnotAtBothEnds) {
    const auto knots = KnotVector::uniform(3, 5, Form::closed).value();
    const auto curve =
        BsplineCurve::make(knots, {{0, 0, 0}, {4, 0, 0}, {5, 3, 0}, {2, 5, 0}, {-1, 3, 0}}, 2)
            .value();
    const auto atStart = insertKnot(curve, 0, 2).value();
    const auto atEnd = insertKnot(curve, 5, 2).value();
    EXPECT_EQ(atStart, atEnd);
    EXPECT_EQ(atStart, insertKnot(curve, -10, 2).value());
    RandomSplines random(45);
    EXPECT_LE(farthest(curve, atStart, random), 5 * test::gates::refinement);
}

TEST(KnotInsertion, KeepsTheWeightsOnlyWhereThereAreAny) {
    RandomSplines random(46);
    const BsplineCurve plain = random.curve(Form::clamped);
    EXPECT_TRUE(insertKnot(plain, plain.domain().start + 0.1, 1)->weights().empty());
    const BsplineCurve rational = random.curve(Form::clamped, SplineKind{.rational = true});
    const auto refined = insertKnot(rational, rational.domain().start + 0.1, 1).value();
    EXPECT_EQ(refined.weights().size(), refined.points().size());
}

void expectRefusal(const BsplineCurve& curve, double t, int times, Code code, const char* path) {
    const auto made = insertKnot(curve, t, times);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(codeName(made.error().code), codeName(code));
    EXPECT_EQ(made.error().path, path);
    EXPECT_FALSE(made.error().message.empty());
}

TEST(KnotInsertion, RefusesWithCodeAndPath) {
    const auto knots =
        KnotVector::make({0, 0, 0, 0, 1, 1, 2, 2, 2, 2}, 3, 6, Form::clamped).value();
    const auto curve = BsplineCurve::make(knots, std::vector<Vec3>(6), 2).value();
    expectRefusal(curve, 1, 2, Code::knotsMultiplicity, "t");
    expectRefusal(curve, 0, 1, Code::knotsMultiplicity, "t");
    expectRefusal(curve, 0.5, 4, Code::knotsMultiplicity, "t");
    expectRefusal(curve, -0.001, 1, Code::outOfRange, "t");
    expectRefusal(curve, 2.001, 1, Code::outOfRange, "t");
    expectRefusal(curve, 1 + 1e-13, 1, Code::outOfRange, "t");
    expectRefusal(curve, std::numeric_limits<double>::quiet_NaN(), 1, Code::notFinite, "t");
    expectRefusal(curve, 0.5, 0, Code::outOfRange, "times");
    expectRefusal(curve, 0.5, -7, Code::outOfRange, "times");
    expectRefusal(curve, 0.5, 2'000'000'000, Code::tooLarge, "times");
}

}  // namespace
}  // namespace knotwork
