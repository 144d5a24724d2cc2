#include "geometry/degree_elevation.hpp"

#include "support/gates.hpp"
#include "support/refinements.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::SplineKind;

TEST(DegreeElevation, OfTheQuadraticIsTheTruth) {
    const auto& quad = test::truth("quad_curve");
    const auto& raised = test::truth("degree_elev");
    const auto knots = test::doubles(test::rationals(quad["knots"]));
    const auto curve = BsplineCurve::make(KnotVector::make(knots, 2, 5, Form::clamped).value(),
                                          test::planarPoints(quad["ctrl"]), 2);
    const auto cubic = elevateDegree(*curve, 1).value();
    const auto found = cubic.knotVector().knots();
    EXPECT_EQ(std::vector<double>(found.begin(), found.end()),
              test::doubles(test::rationals(raised["to_knots"])));
    const auto expected = test::planarPoints(raised["ctrl"]);
    ASSERT_EQ(cubic.points().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LE(glm::length(cubic.points()[i] - expected[i]), test::gates::exact) << i;
    }
}

TEST(DegreeElevation, DoesNotMoveTheCurveNorRoughenIt) {
    RandomSplines random(81);
    for (int round = 0; round < 600; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const int by = random.integer(1, 3);
        const auto raised = elevateDegree(curve, by);
        ASSERT_TRUE(raised.ok()) << raised.error().path << ": " << raised.error().message;
        ASSERT_EQ(raised->degree(), curve.degree() + by);
        ASSERT_EQ(raised->domain(), curve.domain());
        ASSERT_EQ(raised->knotVector().form(), curve.knotVector().form());
        ASSERT_EQ(raised->weights().empty(), curve.weights().empty());
        for (const double t : curve.knotVector().knots()) {
            if (!(curve.domain().start < t && t < curve.domain().end)) continue;
            ASSERT_EQ(raised->knotVector().multiplicity(t),
                      curve.knotVector().multiplicity(t) + by);
        }
        ASSERT_LE(test::farthest(curve, *raised, random), test::gates::refinement);
    }
}

TEST(DegreeElevation, ReachesTheHighestDegree) {
    RandomSplines random(82);
    for (const Form form : test::allForms) {
        const BsplineCurve curve = random.curve(form, SplineKind{.minDegree = 3, .maxDegree = 3});
        const auto raised = elevateDegree(curve, 22);
        ASSERT_TRUE(raised.ok()) << raised.error().message;
        EXPECT_LE(test::farthest(curve, *raised, random), 10 * test::gates::refinement);
    }
}

TEST(DegreeElevation, RefusesWithCodeAndPath) {
    RandomSplines random(83);
    const BsplineCurve curve =
        random.curve(Form::clamped, SplineKind{.minDegree = 3, .maxDegree = 3});
    EXPECT_EQ(elevateDegree(curve, 0).error().code, Code::outOfRange);
    EXPECT_EQ(elevateDegree(curve, -2).error().path, "by");
    EXPECT_EQ(elevateDegree(curve, 23).error().code, Code::tooLarge);
    EXPECT_EQ(elevateDegree(curve, 23).error().path, "by");
}

}  // namespace
}  // namespace knotwork
