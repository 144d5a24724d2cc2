// The fast way to many points of a blending curve against the definition.
#include "support/blends.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double samplerGate = 1e-13;  // of coordinates up to 20

std::vector<double> telltales(const BlendingCurve& curve) {
    const Interval whole = curve.domain();
    std::vector<double> ts;
    for (int i = 0; i <= 700; ++i) ts.push_back(uniformParameter(whole, std::size_t(i), 701));
    for (const double knot : curve.knots()) ts.push_back(knot);
    for (const double part : curve.breaks()) ts.push_back(part);
    ts.push_back(whole.start);  // not sorted
    return ts;
}

void expectRowsSampled(const BlendingCurve& curve, const CurveSampler& sampler,
                       std::span<const double> ts, int derivatives, const std::string& name) {
    const auto orders = static_cast<std::size_t>(derivatives) + 1;
    std::vector<double> xyz(3 * ts.size() * orders);
    sampler.at(ts, derivatives, xyz);
    for (std::size_t i = 0; i < ts.size(); i += 7) {
        const Side side = ts[i] == curve.domain().end ? Side::left : Side::right;
        const auto expected = test::rowsOf<4>(Curve(curve), ts[i], side);
        double scale = 1 + glm::length(expected[0]);
        for (std::size_t k = 0; k < orders; ++k) {
            const double* at = &xyz[3 * (k * ts.size() + i)];
            test::expectNear({at[0], at[1], at[2]}, expected[k],
                             samplerGate * (scale + glm::length(expected[k])),
                             name + " at " + std::to_string(ts[i]) + ", order " + std::to_string(k));
            scale *= 40;  // spans of half a parameter and polynomials of degree 9
        }
    }
}

void expectSampled(const BlendingCurve& curve, const std::string& name) {
    const CurveSampler sampler{Curve(curve)};
    const auto ts = telltales(curve);
    std::vector<double> xyz(3 * ts.size());
    sampler.at(ts, 0, xyz);
    for (std::size_t i = 0; i < ts.size(); ++i) {
        const Side side = ts[i] == curve.domain().end ? Side::left : Side::right;
        const Vec3 expected = test::rowsOf<1>(Curve(curve), ts[i], side)[0];
        test::expectNear({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}, expected,
                         samplerGate * (1 + glm::length(expected) / 20),
                         name + " at " + std::to_string(ts[i]));
    }
    for (int derivatives = 1; derivatives <= 3; ++derivatives) {
        expectRowsSampled(curve, sampler, ts, derivatives, name);
    }
    const Vec3 start = test::rowsOf<1>(Curve(curve), curve.domain().start)[0];
    EXPECT_EQ(Vec3(xyz[0], xyz[1], xyz[2]), start) << name;
    std::vector<double> uniform(3 * 701);
    sampler.uniform(0, 701, 701, uniform);
    EXPECT_TRUE(std::equal(uniform.begin(), uniform.end(), xyz.begin())) << name;
}

TEST(BlendingSampler, AgreesWithTheDefinitionForLocalsOfEveryKind) {
    const Curve flat(test::make("heart", {{"scale", 0.5}}));
    const Curve space(test::make("torus-knot"));
    for (const auto& [blendName, blend] : test::someBlends()) {
        for (const auto& [name, cut] : test::allCuts()) {
            for (const BlendForm form : {BlendForm::open, BlendForm::closed}) {
                for (const Curve& model : {flat, space}) {
                    const auto knots = test::unevenKnots(0, 2 * pi, blendingKnotCount(7, form), 3);
                    const bool plane = dimension(model) == 2;
                    const auto posed = BlendingCurve::fromModel(model, 7, form, blend, knots,
                                                                test::somePoses(7, 9, plane), cut);
                    expectSampled(*posed, name + " by " + blendName);
                    const auto plain = BlendingCurve::fromModel(model, 7, form, blend, knots, {}, cut);
                    expectSampled(*plain, name + " by " + blendName + ", not posed");
                }
            }
        }
    }
}

TEST(BlendingSampler, AgreesForMixedLocalsFittedOnesBreaksAndNests) {
    const auto erb = BFunction::makeExpoRational().value();
    test::RandomSplines random(71);
    const Curve spline(random.curve(Form::closed, {}));
    const auto inner = BlendingCurve::fromModel(Curve(test::make("rose")), 5, BlendForm::closed, erb,
                                                {}, test::somePoses(5, 1));
    const std::vector<Curve> mixed{
        spline,
        spline,
        Curve(*inner),
        Curve(LineCurve::make({0, 0, 0}, {1, 2, 0}, {0, 2}).value()),
        Curve(BezierCurve::make({{0, 0, 1}, {1, 0, 0}, {2, 1, 0}, {1, 3, 0}}, {}, {-1, 2}).value()),
        Curve(BezierCurve::make({{0, 0, 1}, {1, 0, 0}, {2, 1, 0}}, {1, 3, 2}, {0, 1}).value()),
        Curve(ArcCurve::make(0, {0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, 1}).value()),
        Curve(test::make("circle"))};
    for (const bool fit : {false, true}) {
        for (const BlendForm form : {BlendForm::open, BlendForm::closed}) {
            std::vector<double> knots{0, 0.7, 0.7, 1.5, 2, 3.1, 4, 4};
            if (form == BlendForm::closed) knots.push_back(5);
            const auto curve = BlendingCurve::fromLocals(mixed, form, erb, knots, fit,
                                                         test::somePoses(8, 2, false));
            ASSERT_TRUE(curve.ok()) << curve.error().message;
            expectSampled(*curve, fit ? "fitted" : "mixed");
            const auto outer = BlendingCurve::fromModel(Curve(*curve), 4, form, erb, {},
                                                        test::somePoses(4, 3));
            expectSampled(*outer, "nested");
        }
    }
}

TEST(BlendingSampler, WrapsOutsideAClosedCurveAndContinuesAnOpenOne) {
    for (const BlendForm form : {BlendForm::open, BlendForm::closed}) {
        const auto curve = BlendingCurve::fromModel(Curve(test::make("rose")), 6, form,
                                                    BFunction::makePolynomial(1, 1).value(), {},
                                                    test::somePoses(6, 4), {LocalKind::bezier, 3});
        const CurveSampler sampler{Curve(*curve)};
        const std::array ts{-1.0, -0.2, 6.5, 7.0, 20.0};
        std::array<double, 15> xyz{};
        sampler.at(ts, 0, xyz);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            const Vec3 expected = test::rowsOf<1>(Curve(*curve), ts[i])[0];
            test::expectNear({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}, expected,
                             samplerGate * (1 + glm::length(expected)), std::to_string(ts[i]));
        }
    }
}

}  // namespace
}  // namespace knotwork
