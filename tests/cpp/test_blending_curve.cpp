#include "geometry/blending_curve.hpp"

#include "geometry/curve.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace knotwork {
namespace {

constexpr double pi = std::numbers::pi;

Curve model(std::string_view name, std::vector<NamedValue> parameters = {},
            std::optional<Interval> over = std::nullopt) {
    return Curve(ParametricCurve::make(name, parameters, over).value());
}

std::vector<Pose> randomPoses(std::size_t count, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> share(-1, 1);
    std::vector<Pose> poses(count);
    for (Pose& pose : poses) {
        pose.translate = {share(engine), share(engine), 0};
        pose.angle = share(engine);
        pose.scale = {1 + 0.3 * share(engine), 1 + 0.3 * share(engine), 1};
    }
    return poses;
}

BlendingCurve cut(const Curve& from, std::size_t count, BlendForm form, const BFunction& blend,
                  std::vector<double> knots = {}, const std::vector<Pose>& poses = {}) {
    return BlendingCurve::fromModel(from, count, form, blend, std::move(knots), poses).value();
}

std::array<Vec3, 4> rows(const BlendingCurve& curve, double t, Side side) {
    std::array<Vec3, 4> made{};
    curve.evaluate(t, side, made);
    return made;
}

std::array<Vec3, 4> rows(const LocalCurve& local, double t) {
    std::array<Vec3, 4> made{};
    local.evaluate(t, Side::right, made);
    return made;
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

/// c0 = (cos t, sin t), c1 = (1 + 2cos(t + π/6), 2 sin(t + π/6)) over [0, 2].
BlendingCurve twoArcs(const BFunction& blend) {
    std::vector<Curve> locals{model("circle"), model("circle", {{"radius", 2}})};
    std::vector<Pose> poses(2);
    poses[1].angle = pi / 6;
    // The turn is about the local's own origin, its point at t = 2; what it moves is put back.
    const Vec3 origin(2 * std::cos(2.0), 2 * std::sin(2.0), 0);
    poses[1].translate = Vec3(1, 0, 0) - origin + rotation({0, 0, 1}, pi / 6) * origin;
    return BlendingCurve::fromLocals(std::move(locals), BlendForm::open, blend, {0, 2}, false,
                                     poses)
        .value();
}

void expectTruth(const BFunction& blend, const char* name, std::size_t derivatives,
                 double tolerance) {
    const auto& expected = test::truth("blend_two_arcs")[name];
    const auto got = rows(twoArcs(blend), 0.7, Side::right);
    for (std::size_t k = 0; k < derivatives; ++k) {
        const auto& row = derivatives == 1 ? expected : expected[k];
        EXPECT_NEAR(got[k].x, std::stod(row[0].get<std::string>()), tolerance) << name << k;
        EXPECT_NEAR(got[k].y, std::stod(row[1].get<std::string>()), tolerance) << name << k;
    }
}

TEST(BlendingCurve, TwoArcsAreBlendedAsComputedToTwentyDigits) {
    expectTruth(BFunction::makeExpoRational().value(), "ERB", 3, 2e-12);
    expectTruth(BFunction::makePolynomial(1, 1).value(), "poly1", 3, 4e-15);
    expectTruth(BFunction::makeLogistic().value(), "logistic", 1, 4e-15);
    expectTruth(BFunction(), "linear", 1, 4e-15);
}

TEST(BlendingCurve, AtAKnotItHasTheDerivativesOfItsLocalCurveUpToTheHermiteOrder) {
    const auto blend = BFunction::makePolynomial(3, 3).value();
    const auto curve = cut(model("lissajous"), 6, BlendForm::open, blend, {0, 1, 1.8, 3, 4.4, 6},
                           randomPoses(6, 1));
    for (std::size_t j = 0; j < 6; ++j) {
        const double t = curve.knots()[j];
        const auto local = rows(curve.locals()[j], t);
        for (const Side side : {Side::left, Side::right}) {
            const auto got = rows(curve, t, side);
            for (std::size_t k = 0; k < 4; ++k) expectNear(got[k], local[k], 1e-11);
        }
    }
}

TEST(BlendingCurve, TheFirstDerivativeThatJumpsJumpsByTheFormula) {
    const auto blend = BFunction::makePolynomial(1, 1).value();  // order 1: C″ jumps
    const auto curve = cut(model("ellipse"), 5, BlendForm::open, blend, {0, 1, 2.5, 3.1, 5},
                           randomPoses(5, 2));
    std::array<double, 3> atZero{};
    std::array<double, 3> atOne{};
    blend.derivatives(0, atZero);
    blend.derivatives(1, atOne);
    for (std::size_t j = 1; j + 1 < 5; ++j) {
        const double t = curve.knots()[j];
        const double left = t - curve.knots()[j - 1];
        const double right = curve.knots()[j + 1] - t;
        const Vec3 gapRight = curve.locals()[j + 1].point(t) - curve.locals()[j].point(t);
        const Vec3 gapLeft = curve.locals()[j].point(t) - curve.locals()[j - 1].point(t);
        const Vec3 expected =
            atZero[2] * gapRight / (right * right) - atOne[2] * gapLeft / (left * left);
        const Vec3 jump = rows(curve, t, Side::right)[2] - rows(curve, t, Side::left)[2];
        EXPECT_GT(glm::length(expected), 0.1);
        expectNear(jump, expected, 1e-10);
    }
}

TEST(BlendingCurve, LocalsThatAreAllOneCurveReproduceIt) {
    const Curve circle = model("circle", {{"radius", 3}});
    for (const auto& blend : {BFunction(), BFunction::makeExpoRational(2, 3, 0.5, 0.3).value(),
                              BFunction::makeRational(3, 4).value()}) {
        const auto curve = cut(circle, 7, BlendForm::closed, blend);
        for (int i = 0; i <= 100; ++i) {
            const double t = 2 * pi * i / 100;
            std::array<Vec3, 4> expected{};
            evaluate(circle, t, Side::right, expected);
            const auto got = rows(curve, t, Side::right);
            for (std::size_t k = 0; k < 4; ++k) expectNear(got[k], expected[k], 1e-11);
        }
    }
}

TEST(BlendingCurve, MovingOneLocalChangesTheCurveOnlyOnItsSupport) {
    const auto blend = BFunction::makeExpoRational().value();
    std::vector<Pose> poses(6);
    const auto before = cut(model("circle"), 6, BlendForm::closed, blend, {}, poses);
    poses[2].translate = {1, 1, 0};
    const auto after = before.withPoses(poses);
    const Interval support = before.support(2);
    for (int i = 0; i <= 600; ++i) {
        const double t = 2 * pi * i / 600;
        const Vec3 a = rows(before, t, Side::left)[0];
        const Vec3 b = rows(after, t, Side::left)[0];
        if (t <= support.start || t >= support.end) {
            EXPECT_EQ(a, b) << t;
        }
    }
    const double middle = (support.start + support.end) / 2;
    expectNear(rows(after, middle, Side::right)[0] - rows(before, middle, Side::right)[0],
               {1, 1, 0}, 1e-14);
}

TEST(BlendingCurve, AClosedCurveEvaluatesItsFirstLocalOnePeriodEarlierInTheLastSpan) {
    // On [0, 2π] the butterfly misses its beginning by 1/32: only the shift closes the curve.
    const Curve wings = model("butterfly", {}, Interval{0, 2 * pi});
    const auto curve = cut(wings, 12, BlendForm::closed, BFunction::makePolynomial(2, 2).value());
    const Vec3 start = rows(curve, 0, Side::right)[0];
    const Vec3 end = rows(curve, 2 * pi, Side::left)[0];
    EXPECT_EQ(start, end);
    EXPECT_NEAR(pointAt(wings, 0).y - pointAt(wings, 2 * pi).y, 1.0 / 32, 1e-14);
    const double t = 2 * pi - 0.1;
    const double w = 1 - 0.1 / (2 * pi / 12);
    const double weight = curve.blend().value(w);
    expectNear(rows(curve, t, Side::right)[0],
               (1 - weight) * pointAt(wings, t) + weight * pointAt(wings, t - 2 * pi), 1e-14);
}

TEST(BlendingCurve, AClosedCurveWrapsOutsideItsDomain) {
    const auto curve = cut(model("rose"), 9, BlendForm::closed,
                           BFunction::makeExpoRational().value(), {}, randomPoses(9, 3));
    for (const double t : {0.3, 2.0, 6.0}) {
        expectNear(rows(curve, t + 2 * pi, Side::right)[0], rows(curve, t, Side::right)[0], 1e-13);
        expectNear(rows(curve, t - 4 * pi, Side::right)[0], rows(curve, t, Side::right)[0], 1e-13);
    }
}

TEST(BlendingCurve, TwoEqualKnotsAreABreak) {
    std::vector<Pose> poses(4);
    poses[2].translate = {5, 0, 0};
    const auto curve = cut(model("circle"), 4, BlendForm::open,
                           BFunction::makePolynomial(1, 1).value(), {0, 1, 1, 2}, poses);
    const Vec3 jump = rows(curve, 1, Side::right)[0] - rows(curve, 1, Side::left)[0];
    expectNear(jump, {5, 0, 0}, 1e-14);
}

TEST(BlendingCurve, TheWeightsSumToOneAndNameTheActiveLocals) {
    const auto curve = cut(model("circle"), 5, BlendForm::closed,
                           BFunction::makeExpoRational().value());
    for (int i = 0; i <= 40; ++i) {
        const double t = 2 * pi * i / 40;
        const auto weights = curve.blendBasis(t);
        double sum = 0;
        for (const double weight : weights) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-15);
    }
    EXPECT_EQ(curve.blendBasis(curve.knots()[3])[3], 1);
    EXPECT_EQ(curve.blendBasis(2 * pi)[0], 1);
}

TEST(BlendingCurve, FittedLocalsRunThroughTheirOwnDomainOverTheirSupport) {
    std::vector<Curve> locals(3, model("circle"));
    const auto curve = BlendingCurve::fromLocals(std::move(locals), BlendForm::open,
                                                 BFunction::makePolynomial(2, 2).value(), {0, 1, 3},
                                                 true, {})
                           .value();
    // Local 1 lives on [0, 3]: its knot 1 is a third of the way round.
    expectNear(rows(curve, 1, Side::right)[0], {std::cos(2 * pi / 3), std::sin(2 * pi / 3), 0},
               1e-15);
    // The chain rule: the speed is that of the circle times the rate.
    EXPECT_NEAR(glm::length(rows(curve, 1, Side::right)[1]), 2 * pi / 3, 1e-14);
}

TEST(BlendingCurve, DerivativesAgreeWithDifferences) {
    const auto curve = cut(model("butterfly"), 36, BlendForm::closed,
                           BFunction::makeExpoRational().value(), {}, randomPoses(36, 4));
    constexpr double h = 1e-4;
    for (int i = 1; i < 50; ++i) {
        const double t = 12 * pi * i / 50 + 0.01;
        const auto at = rows(curve, t, Side::right);
        const auto after = rows(curve, t + h, Side::right);
        const auto before = rows(curve, t - h, Side::right);
        for (std::size_t k = 0; k < 3; ++k) {
            const double scale = glm::length(at[k + 1]) + 1;
            expectNear((after[k] - before[k]) / (2 * h), at[k + 1], 1e-3 * scale);
        }
    }
}

TEST(BlendingCurve, TheDimensionIsTwoWhileEverythingStaysInThePlane) {
    std::vector<Pose> poses(4);
    EXPECT_EQ(cut(model("circle"), 4, BlendForm::closed, BFunction(), {}, poses).dimension(), 2);
    poses[1].translate.z = 0.5;
    EXPECT_EQ(cut(model("circle"), 4, BlendForm::closed, BFunction(), {}, poses).dimension(), 3);
    EXPECT_EQ(cut(model("helix"), 4, BlendForm::open, BFunction()).dimension(), 3);
}

struct Refusal {
    std::vector<double> knots;
    BlendForm form;
    Code code;
    const char* path;
};

TEST(BlendingCurve, BadKnotsAreRefusedWithTheirPlace) {
    const double nan = std::nan("");
    const std::vector<Refusal> refusals{
        {{0, 1, 2}, BlendForm::open, Code::knotsCount, "knots"},
        {{0, 1, 2, 3}, BlendForm::closed, Code::knotsCount, "knots"},
        {{0, 2, 1, 3}, BlendForm::open, Code::knotsDecreasing, "knots[2]"},
        {{0, 1, 1, 1}, BlendForm::open, Code::knotsMultiplicity, "knots[3]"},
        {{0, nan, 1, 2}, BlendForm::open, Code::notFinite, "knots[1]"},
        {{0, 1, 2, 3e9}, BlendForm::open, Code::outOfRange, "knots[3]"},
        {{0, 1e-14, 1, 2}, BlendForm::open, Code::outOfRange, "knots[1]"},
        {{0, 0, 1, 2, 2}, BlendForm::closed, Code::knotsMultiplicity, "knots[4]"},
        {{0, 2e-7, 4e-7, 8e-7}, BlendForm::open, Code::outOfRange, "knots"},
        {{1e6, 1e6 + 1e-4, 1e6 + 3e-4, 1e6 + 9e-4}, BlendForm::open, Code::outOfRange, "knots"},
    };
    for (const Refusal& refusal : refusals) {
        const auto made = BlendingCurve::fromModel(model("circle"), 4, refusal.form, BFunction(),
                                                   refusal.knots, {});
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.error().code, refusal.code) << made.error().message;
        EXPECT_EQ(made.error().path, refusal.path) << made.error().message;
    }
    const auto one = BlendingCurve::fromModel(model("circle"), 1, BlendForm::open, BFunction(), {}, {});
    EXPECT_EQ(one.error().path, "locals.count");
}

TEST(BlendingCurve, ThereAreTwoLocalsAtLeastAndAPoseForEach) {
    const auto alone = BlendingCurve::fromLocals({model("circle")}, BlendForm::open, BFunction(), {},
                                                 true, {});
    EXPECT_EQ(alone.error().code, Code::outOfRange);
    EXPECT_EQ(alone.error().path, "locals");
    std::vector<Pose> poses(3);
    const auto posed = [&] {
        return BlendingCurve::fromModel(model("circle"), 4, BlendForm::closed, BFunction(), {}, poses);
    };
    EXPECT_EQ(posed().error().code, Code::wrongLength);
    EXPECT_EQ(posed().error().path, "poses");
    poses.resize(4);
    poses[2].scale.x = 0;
    EXPECT_EQ(posed().error().code, Code::outOfRange);
    EXPECT_EQ(posed().error().path, "poses[2].scale");
    poses[2].scale.x = -1;
    EXPECT_TRUE(posed().ok());
}

}  // namespace
}  // namespace knotwork
