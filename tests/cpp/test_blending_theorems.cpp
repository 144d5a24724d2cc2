// The theorems of blending splines, for local curves of every kind and B-functions of most.
#include "support/blends.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork {
namespace {

using test::expectNear;

constexpr double pi = std::numbers::pi;
// Rounding of sums of a few terms of size 1 to 10, and of derivatives relative to what they are
// made of: the k-th grows with (degree/h)^k.
constexpr double pointGate = 2e-13;
constexpr double rowGate = 2e-12;

struct Specimen {
    std::string name;
    BlendingCurve curve;
};

BlendingCurve cutFrom(const Curve& model, std::size_t count, BlendForm form, const BFunction& blend,
                      const LocalCut& cut, bool posed = true) {
    const Interval whole = domain(model);
    const bool flat = dimension(model) == 2;
    return BlendingCurve::fromModel(
               model, count, form, blend,
               test::unevenKnots(whole.start, whole.end, blendingKnotCount(count, form), 5),
               posed ? test::somePoses(count, 7, flat) : std::vector<Pose>{}, cut)
        .value();
}

/// Every kind of local curve, open and closed, in the plane and in space, under one B-function. The
/// butterfly over one turn does not return to where it began.
std::vector<Specimen> specimens(const BFunction& blend) {
    const Curve heart(test::make("lissajous", {{"kx", 2}, {"ky", 3}}));
    const Curve knot(test::make("trefoil"));
    const Curve wings(test::make("butterfly", {}, Interval{0, 2 * pi}));
    std::vector<Specimen> all;
    for (const auto& [name, cut] : test::allCuts()) {
        all.push_back({name + " of a Lissajous curve",
                       cutFrom(heart, 8, BlendForm::closed, blend, cut)});
        all.push_back({name + " of a trefoil", cutFrom(knot, 9, BlendForm::open, blend, cut)});
        all.push_back({name + " of the wings", cutFrom(wings, 24, BlendForm::closed, blend, cut)});
    }
    return all;
}

/// What the rows of a curve near t may be rounded by.
double scaleOf(const BlendingCurve& curve, std::size_t i, std::size_t k) {
    const double h = curve.knots()[i + 1] - curve.knots()[i];
    double largest = 1;
    for (const LocalCurve& local : curve.locals()) {
        const Interval over = local.domain();
        for (const double t : {over.start, (over.start + over.end) / 2, over.end}) {
            largest = std::max(largest, glm::length(local.point(t)));
        }
    }
    return largest * std::pow(std::max(1.0, 9 / h), static_cast<double>(k));
}

/// The rows at knot i of the local curve that is centred there; a closed curve's last knot has its
/// first local curve, one period earlier.
template <std::size_t N>
std::array<Vec3, N> localRows(const BlendingCurve& curve, std::size_t i, Side side) {
    const bool wraps = i == curve.locals().size();
    std::array<Vec3, N> rows;
    curve.locals()[wraps ? 0 : i].evaluate(curve.knots()[wraps ? 0 : i], side, rows);
    return rows;
}

TEST(BlendingTheorem, AtAKnotTheCurveHasItsLocalCurveUpToTheHermiteOrder) {
    for (const auto& [blendName, blend] : test::someBlends()) {
        const auto [orderAt0, orderAt1] = blend.order();
        for (const auto& [name, curve] : specimens(blend)) {
            for (std::size_t i = 0; i < curve.knots().size(); ++i) {
                for (const Side side : test::bothSides) {
                    const bool last = i + 1 == curve.knots().size();
                    if (side == Side::left ? i == 0 : last) continue;
                    const auto got = test::rowsOf<4>(Curve(curve), curve.knots()[i], side);
                    const auto expected = localRows<4>(curve, i, side);
                    const double order = side == Side::right ? orderAt0 : orderAt1;
                    for (std::size_t k = 0; k < 4 && static_cast<double>(k) <= order; ++k) {
                        expectNear(got[k], expected[k],
                                   rowGate * scaleOf(curve, last ? i - 1 : i, k),
                                   name + " by " + blendName + ", knot " + std::to_string(i));
                    }
                }
            }
        }
    }
}

TEST(BlendingTheorem, TheFirstDerivativeThatJumpsJumpsByTheFormula) {
    for (const auto& [blendName, blend] : test::someBlends()) {
        const auto order = blend.order();
        const double least = std::min(order[0], order[1]);
        if (least > 3) continue;
        const auto s = static_cast<std::size_t>(least) + 1;
        std::array<double, 6> atZero{};
        std::array<double, 6> atOne{};
        blend.derivatives(0, atZero);
        blend.derivatives(1, atOne);
        for (const auto& [name, curve] : specimens(blend)) {
            if (name.find("B-spline 1") != std::string::npos) continue;  // breaks of its own
            double largest = 0;
            for (std::size_t i = 1; i + 1 < curve.knots().size(); ++i) {
                const double t = curve.knots()[i];
                const double left = t - curve.knots()[i - 1];
                const double right = curve.knots()[i + 1] - t;
                const auto& locals = curve.locals();
                const bool wraps = i + 1 == locals.size();
                const double period = curve.domain().length();
                const Vec3 next = wraps ? locals[0].point(t - period) : locals[i + 1].point(t);
                const Vec3 gapRight = next - locals[i].point(t);
                const Vec3 gapLeft = locals[i].point(t) - locals[i - 1].point(t);
                const double power = static_cast<double>(s);
                const Vec3 expected = atZero[s] * gapRight / std::pow(right, power) -
                                      atOne[s] * gapLeft / std::pow(left, power);
                const Vec3 jump = test::rowsOf<6>(Curve(curve), t, Side::right)[s] -
                                  test::rowsOf<6>(Curve(curve), t, Side::left)[s];
                largest = std::max(largest, glm::length(expected));
                // Cubic B-splines and their like have jumps of their own from the third on.
                const bool ownJump = name.find("B-spline 3") != std::string::npos && s > 2;
                if (ownJump) continue;
                expectNear(jump, expected,
                           rowGate * scaleOf(curve, left < right ? i - 1 : i, s) +
                               1e-11 * glm::length(expected),
                           name + " by " + blendName + ", knot " + std::to_string(i));
            }
            EXPECT_GT(largest, 0.1) << name;
        }
    }
}

/// One curve of every kind over [0, 4] or so, to be all the local curves of a blend.
std::vector<std::pair<std::string, Curve>> oneOfEach() {
    test::RandomSplines random(61);
    const auto points = [&](int count) {
        std::vector<Vec3> made;
        for (int i = 0; i < count; ++i) {
            made.emplace_back(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
        }
        return made;
    };
    const Interval over{0, 4};
    const auto nested = BlendingCurve::fromModel(Curve(test::make("circle")), 5, BlendForm::open,
                                                 BFunction::makeExpoRational().value(),
                                                 {0, 1, 2, 2, 4}, test::somePoses(5, 3));
    return {{"line", Curve(LineCurve::make({0, 1, 2}, {3, 1, 0}, over).value())},
            {"arc", Curve(ArcCurve::make(1, {0, 1, 0}, {1, 0, 1}, {0, 1, 1}, over).value())},
            {"Bézier", Curve(BezierCurve::make(points(6), {}, over).value())},
            {"rational Bézier", Curve(BezierCurve::make(points(4), {1, 2, 1, 3}, over).value())},
            {"B-spline", Curve(random.curve(Form::clamped, {}))},
            {"rational B-spline", Curve(random.curve(Form::open, {.rational = true}))},
            {"model", Curve(test::make("heart"))},
            {"blending curve", Curve(*nested)}};
}

TEST(BlendingTheorem, LocalsThatAreAllOneCurveReproduceItForEveryBFunctionAndEveryKnots) {
    for (const auto& [name, source] : oneOfEach()) {
        for (const auto& [blendName, blend] : test::someBlends()) {
            const Interval whole = domain(source);
            const auto knots = test::unevenKnots(whole.start, whole.end, 6, 11);
            const auto curve = BlendingCurve::fromLocals(std::vector<Curve>(6, source),
                                                         BlendForm::open, blend, knots, false, {})
                                   .value();
            std::vector<double> ts = knots;
            for (int i = 0; i <= 60; ++i) ts.push_back(whole.start + whole.length() * i / 60);
            for (const double t : ts) {
                for (const Side side : test::bothSides) {
                    const auto got = test::rowsOf<4>(Curve(curve), t, side);
                    const auto expected = test::rowsOf<4>(source, t, side);
                    for (std::size_t k = 0; k < 4; ++k) {
                        // Each derivative of B weighs differences that are exactly 0.
                        expectNear(got[k], expected[k], 1e-15 * (1 + 4 * glm::length(expected[k])),
                                   name + " by " + blendName + " at " + std::to_string(t));
                    }
                }
            }
        }
    }
}

TEST(BlendingTheorem, AnAffineMapOfTheLocalsIsThatOfTheCurve) {
    test::RandomSplines random(62);
    const Mat3 linear(1.5, 0.3, -0.2, 0.4, -0.8, 0.1, 0.3, 0.5, 1.1);
    const Affine map{linear, {3, -2, 1}};
    const Interval over{0, 3};
    for (const auto& [blendName, blend] : test::someBlends()) {
        std::vector<Curve> plain;
        std::vector<Curve> mapped;
        for (int j = 0; j < 4; ++j) {
            std::vector<Vec3> points;
            std::vector<Vec3> images;
            for (int i = 0; i < 4; ++i) {
                points.emplace_back(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
                images.push_back(map.point(points.back()));
            }
            const std::vector<double> weights = j % 2 == 0 ? std::vector<double>{}
                                                           : std::vector<double>{1, 2, 0.5, 1};
            plain.emplace_back(BezierCurve::make(points, weights, over).value());
            mapped.emplace_back(BezierCurve::make(images, weights, over).value());
        }
        const auto before = BlendingCurve::fromLocals(plain, BlendForm::closed, blend,
                                                      {0, 1, 1.5, 2.5, 3}, false, {})
                                .value();
        const auto after = BlendingCurve::fromLocals(mapped, BlendForm::closed, blend,
                                                     {0, 1, 1.5, 2.5, 3}, false, {})
                               .value();
        for (int i = 0; i <= 60; ++i) {
            const double t = 3.0 * i / 60;
            const auto got = test::rowsOf<3>(Curve(after), t);
            const auto from = test::rowsOf<3>(Curve(before), t);
            expectNear(got[0], map.point(from[0]), pointGate, blendName);
            expectNear(got[1], map.vector(from[1]), 100 * pointGate, blendName);
            expectNear(got[2], map.vector(from[2]), 10000 * pointGate, blendName);
        }
    }
}

TEST(BlendingTheorem, ALocalCurveChangesTheCurveOnItsSupportAndNowhereElse) {
    for (const auto& [name, curve] : specimens(BFunction::makeExpoRational().value())) {
        const std::size_t count = curve.locals().size();
        for (const std::size_t j : {std::size_t{0}, std::size_t{3}, count - 1}) {
            std::vector<Pose> poses;
            for (const LocalCurve& local : curve.locals()) poses.push_back(local.pose());
            poses[j].translate += Vec3(1, 2, 0);
            const auto moved = curve.withPoses(poses);
            const Interval support = curve.support(j);
            const double period = curve.closed() ? curve.domain().length() : 0;
            for (int i = 0; i <= 200; ++i) {
                const double t = uniformParameter(curve.domain(), static_cast<std::size_t>(i), 201);
                const bool end = !curve.closed() && t == curve.knots()[j];
                const bool inside = end || (t > support.start && t < support.end) ||
                                    (t - period > support.start && t - period < support.end);
                const Vec3 a = test::rowsOf<1>(Curve(curve), t)[0];
                const Vec3 b = test::rowsOf<1>(Curve(moved), t)[0];
                if (!inside) {
                    EXPECT_EQ(a, b) << name << ' ' << t;
                } else {
                    expectNear(b - a, curve.blendBasis(t)[j] * Vec3(1, 2, 0), 1e-14, name);
                }
            }
        }
    }
}

TEST(BlendingTheorem, TheLinearBFunctionGivesAContinuousCurveWithCorners) {
    for (const auto& [name, curve] : specimens(BFunction())) {
        for (std::size_t i = 1; i + 1 < curve.knots().size(); ++i) {
            const double t = curve.knots()[i];
            const auto left = test::rowsOf<2>(Curve(curve), t, Side::left);
            const auto right = test::rowsOf<2>(Curve(curve), t, Side::right);
            expectNear(left[0], right[0], pointGate, name);
            EXPECT_GT(glm::length(left[1] - right[1]), 1e-3) << name << " knot " << i;
        }
    }
}

double errorOf(const Curve& model, std::size_t count, const LocalCut& cut) {
    const auto curve = BlendingCurve::fromModel(model, count, BlendForm::closed,
                                                BFunction::makePolynomial(2, 2).value(), {}, {}, cut)
                           .value();
    double largest = 0;
    for (int i = 0; i < 1000; ++i) {
        const double t = 2 * pi * (i + 0.5) / 1000;
        largest = std::max(largest,
                           glm::length(test::rowsOf<1>(Curve(curve), t)[0] - pointAt(model, t)));
    }
    return largest;
}

TEST(BlendingTheorem, TaylorLocalsOfDegreeMConvergeWithOrderMPlusOne) {
    const Curve model(test::make("trefoil"));
    for (const std::size_t degree : {1U, 2U, 3U, 4U, 5U}) {
        const LocalCut cut{LocalKind::bezier, degree};
        const double order = std::log2(errorOf(model, 64, cut) / errorOf(model, 128, cut));
        EXPECT_NEAR(order, static_cast<double>(degree) + 1, 0.1) << degree;
    }
    const LocalCut line{LocalKind::line, 1};
    EXPECT_NEAR(std::log2(errorOf(model, 64, line) / errorOf(model, 128, line)), 2, 0.1);
    // A circle's arcs are the circle.
    EXPECT_LT(errorOf(Curve(test::make("circle")), 5, {LocalKind::arc, 1}), 1e-15);
}

}  // namespace
}  // namespace knotwork
