// Curves between curves; that every query of curves holds for them too is the zoo's business.
#include "geometry/curve.hpp"
#include "support/calculus.hpp"
#include "support/gates.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <array>

namespace knotwork {
namespace {

Curve rose() { return Curve(test::make("rose")); }

TEST(Morph, WeightsZeroAndOneAreTheTwoCurvesToTheBit) {
    const Curve from = test::rationalCircle();
    const Curve to = rose();
    const Curve start = morphed(from, to, 0);
    const Curve end = morphed(from, to, 1);
    for (double t = 0; t <= 4; t += 0.25) {
        EXPECT_EQ(pointAt(start, t), pointAt(from, t));
        const double there = domain(to).length() / 4 * t;
        EXPECT_EQ(pointAt(end, t), pointAt(to, there)) << t;
    }
}

TEST(Morph, DerivativesAreThoseOfTheMixture) {
    const Curve from(test::make("butterfly"));
    const Curve to = rose();
    const Curve between = morphed(from, to, 0.3);
    const double rate = domain(to).length() / domain(from).length();
    std::array<Vec3, 4> rows;
    std::array<Vec3, 4> first;
    std::array<Vec3, 4> second;
    evaluate(between, 7.7, Side::right, rows);
    evaluate(from, 7.7, Side::right, first);
    evaluate(to, 7.7 * rate, Side::right, second);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 expected = 0.7 * first[k] + 0.3 * std::pow(rate, k) * second[k];
        EXPECT_LE(glm::length(rows[k] - expected), 1e-12 * (1 + glm::length(expected))) << k;
    }
}

TEST(Morph, IsClosedWhereBothAreAndFlatWhereBothAre) {
    const Curve circle(test::make("circle"));
    EXPECT_TRUE(isClosed(morphed(circle, rose(), 0.5)));
    EXPECT_FALSE(isClosed(morphed(circle, Curve(test::make("helix")), 0.5)));
    EXPECT_EQ(dimension(morphed(circle, rose(), 0.5)), 2);
    EXPECT_EQ(dimension(morphed(circle, Curve(test::make("helix")), 0.5)), 3);
}

TEST(Morph, KnowsTheKnotsOfBoth) {
    const Curve from = test::rationalCircle();
    const Curve to = test::spline(1, Form::clamped, {0, 0, 3, 5, 8, 8},
                                  {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
    const auto breaks = breakParameters(morphed(from, to, 0.5), {0, 4});
    const std::array expected{1.0, 1.5, 2.0, 2.5, 3.0};
    ASSERT_EQ(breaks.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(breaks[i], expected[i]);
}

TEST(Morph, LocalCurvesOfABlendGoTheirOwnWays) {
    const Curve model(test::make("circle"));
    const auto blend = BlendingCurve::fromModel(model, 6, BlendForm::closed,
                                                BFunction::makeTrigonometric().value(), {}, {},
                                                {LocalKind::bezier, 3})
                           .value();
    const Curve other = rose();
    const Curve whole = morphed(Curve(blend), other, 1);
    const auto& locals = whole.as<BlendingCurve>()->locals();
    for (std::size_t j = 0; j < 6; ++j) {
        const double t = blend.knots()[j];
        EXPECT_LE(glm::length(locals[j].point(t) - pointAt(other, t)), 1e-14) << j;
    }
    // A posed one is posed about where it has come to.
    std::vector<Pose> poses(6);
    poses[2].angle = 1;
    const Curve posed = morphed(Curve(blend.withPoses(poses)), other, 1);
    const double t = blend.knots()[2];
    EXPECT_LE(glm::length(pointAt(posed, t) - pointAt(other, t)), 1e-14);
}

}  // namespace
}  // namespace knotwork
