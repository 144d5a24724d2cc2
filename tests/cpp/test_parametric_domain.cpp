// Domains, closure and refusals of the model curves.
#include "geometry/parametric_curve.hpp"
#include "support/model_curves.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::Parameters;
using test::make;
using test::rowsOf;

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// --- domains -------------------------------------------------------------------------------------

TEST(ParametricDomain, DefaultsAreThoseOfTheTable) {
    const auto end = [](std::string_view name, const Parameters& parameters = {}) {
        const Interval domain = make(name, parameters).domain();
        EXPECT_EQ(domain.start, 0) << name;
        return domain.end / pi;
    };
    for (const char* name : {"circle", "ellipse", "lissajous", "astroid", "cardioid", "nephroid",
                             "heart", "lemniscate", "trefoil", "torus-knot"}) {
        EXPECT_DOUBLE_EQ(end(name), 2) << name;
    }
    EXPECT_DOUBLE_EQ(end("butterfly"), 12);
    EXPECT_DOUBLE_EQ(end("viviani"), 4);
    EXPECT_DOUBLE_EQ(end("spiral"), 6);
    EXPECT_DOUBLE_EQ(end("helix", {{"turns", 1.5}}), 3);
    EXPECT_DOUBLE_EQ(end("hypotrochoid"), 6);                             // R/r = 5/3
    EXPECT_DOUBLE_EQ(end("epitrochoid"), 2);                              // 3/1
    EXPECT_DOUBLE_EQ(end("hypotrochoid", {{"R", 1.2}, {"r", -0.9}}), 6);  // −4/3
    EXPECT_DOUBLE_EQ(end("epitrochoid", {{"R", 6.4}, {"r", 1.0}}), 10);   // 32/5
}

TEST(ParametricDomain, ARoseHasOnePeriodOfItsFraction) {
    const auto end = [](double k) { return make("rose", {{"k", k}}).domain().end / pi; };
    EXPECT_DOUBLE_EQ(end(4), 2);
    EXPECT_DOUBLE_EQ(end(3), 1);
    EXPECT_DOUBLE_EQ(end(0), 2);
    EXPECT_DOUBLE_EQ(end(-3), 1);
    EXPECT_DOUBLE_EQ(end(4.0 / 3), 6);
    EXPECT_DOUBLE_EQ(end(5.0 / 3), 3);
    EXPECT_DOUBLE_EQ(end(0.5), 4);
    EXPECT_DOUBLE_EQ(end(1.333333333), 6);
    EXPECT_DOUBLE_EQ(end(21.0 / 64), 128);
    EXPECT_DOUBLE_EQ(end(61.0 / 63), 63);
}

TEST(ParametricDomain, ARoseIsPeriodicWithItsDomainAndWithNoHalfOfIt) {
    for (const double k : {4.0, 3.0, 4.0 / 3, 5.0 / 3, 0.5, 7.0 / 2}) {
        const ParametricCurve rose = make("rose", {{"k", k}});
        const double period = rose.domain().length();
        double shift = 0;
        double half = 0;
        for (const double t : {0.1, 0.7, 2.0}) {
            shift = std::max(shift, glm::length(rose.point(t + period) - rose.point(t)));
            half = std::max(half, glm::length(rose.point(t + period / 2) - rose.point(t)));
        }
        EXPECT_LT(shift, 1e-13) << k;
        EXPECT_GT(half, 1e-2) << k;
    }
}

TEST(ParametricDomain, ARatioThatIsRecognisedIsTakenAsItsFraction) {
    const ParametricCurve typed = make("rose", {{"k", 1.3333333333}});
    EXPECT_EQ(typed.point(7.7), make("rose", {{"k", 4.0 / 3}}).point(7.7));
    EXPECT_EQ(typed.parameters()[1], 1.3333333333);
    EXPECT_TRUE(typed.closed());
}

TEST(ParametricDomain, ARatioThatIsNotRecognisedNeedsADomain) {
    const auto path = [](std::string_view name, const Parameters& parameters) {
        const auto made = ParametricCurve::make(name, parameters);
        EXPECT_FALSE(made.ok()) << name;
        if (made.ok()) return std::string("none");
        EXPECT_EQ(codeName(made.error().code), "OUT_OF_RANGE");
        EXPECT_NE(made.error().message.find("domain"), std::string::npos);
        return made.error().path;
    };
    EXPECT_EQ(path("rose", {{"k", std::numbers::sqrt2}}), "parameters.k");
    EXPECT_EQ(path("rose", {{"k", 4.0 / 3 + 3e-9}}), "parameters.k");
    EXPECT_EQ(path("rose", {{"k", 30.0 / 67}}), "parameters.k");
    EXPECT_EQ(path("hypotrochoid", {{"r", pi}}), "parameters.r");
    const ParametricCurve rose = make("rose", {{"k", std::numbers::sqrt2}}, Interval{0, 20});
    EXPECT_EQ(rose.domain(), (Interval{0, 20}));
    EXPECT_FALSE(rose.closed());
}

// --- closure -------------------------------------------------------------------------------------

TEST(ParametricDomain, DefaultsCloseExceptSpiralAndHelix) {
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        const ParametricCurve curve = make(model.name);
        EXPECT_EQ(curve.closed(), model.name != "spiral" && model.name != "helix") << model.name;
        const Interval domain = curve.domain();
        const double gap = glm::length(curve.point(domain.end) - curve.point(domain.start));
        EXPECT_EQ(curve.closed(), gap < 1e-13) << model.name;
        EXPECT_FALSE(curve.hasOwnDomain());
    }
}

TEST(ParametricDomain, TheFirstFourDerivativesOfEveryClosedModelAgreeAcrossTheSeam) {
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        const ParametricCurve curve = make(model.name);
        if (!curve.closed()) continue;
        const auto start = rowsOf(curve, curve.domain().start, 5);
        const auto end = rowsOf(curve, curve.domain().end, 5);
        for (std::size_t k = 0; k < 5; ++k) {
            EXPECT_LE(glm::length(start[k] - end[k]), 2e-12 * (1 + glm::length(start[k])))
                << model.name << ", order " << k;
        }
    }
}

TEST(ParametricDomain, ALissajousFigureClosesOnlyOnWholePeriodsOfBothFrequencies) {
    const auto closed = [](double kx, double ky, std::optional<Interval> domain = std::nullopt) {
        return make("lissajous", {{"kx", kx}, {"ky", ky}}, domain).closed();
    };
    EXPECT_TRUE(closed(3, 2));
    EXPECT_TRUE(closed(0, 2));
    EXPECT_FALSE(closed(1.5, 2));
    EXPECT_FALSE(closed(std::numbers::sqrt2, 2));
    EXPECT_TRUE(closed(1.5, 2, Interval{0, 4 * pi}));
    EXPECT_TRUE(closed(2, 4, Interval{0, pi}));
    EXPECT_FALSE(closed(3, 2, Interval{0, pi}));
    // (cos t, sin 2t) passes through the centre at π/2 and 3π/2: a loop, and no period.
    EXPECT_FALSE(closed(1, 2, Interval{pi / 2, 3 * pi / 2}));
}

TEST(ParametricDomain, AnOwnDomainIsClosedWhenItSpansWholePeriods) {
    EXPECT_TRUE(make("circle", {}, Interval{1, 1 + 2 * pi}).closed());
    EXPECT_TRUE(make("circle", {}, Interval{-3, -3 + 6 * pi}).closed());
    EXPECT_FALSE(make("circle", {}, Interval{0, 6.283}).closed());
    EXPECT_FALSE(make("circle", {}, Interval{0, pi}).closed());
    EXPECT_FALSE(make("helix", {}, Interval{0, 2 * pi}).closed());
    EXPECT_FALSE(make("helix", {{"pitch", 0.0}}).closed());
    EXPECT_FALSE(make("spiral", {{"a", 1.0}, {"b", 0.0}}).closed());
    EXPECT_TRUE(make("rose", {{"k", 3.0}}, Interval{0, 2 * pi}).closed());
    EXPECT_FALSE(make("rose", {{"k", 4.0}}, Interval{0, pi}).closed());
    EXPECT_TRUE(make("viviani", {}, Interval{0, 4 * pi}).closed());
    EXPECT_FALSE(make("viviani", {}, Interval{0.5, 0.5 + 2 * pi}).closed());
    // The double point of Viviani's curve: equal ends, half a period.
    EXPECT_FALSE(make("viviani", {}, Interval{0, 2 * pi}).closed());
    EXPECT_TRUE(make("circle", {}, Interval{1, 2}).hasOwnDomain());
}

TEST(ParametricDomain, ThePeriodOfTheButterflyIsOnlyTheFourthOrderSeamAtMultiplesOfTwelvePi) {
    const ParametricCurve butterfly = make("butterfly");
    EXPECT_TRUE(make("butterfly", {}, Interval{0, 24 * pi}).closed());
    EXPECT_TRUE(make("butterfly", {}, Interval{5, 5 + 24 * pi}).closed());
    EXPECT_TRUE(make("butterfly", {}, Interval{-12 * pi, 0}).closed());
    EXPECT_FALSE(make("butterfly", {}, Interval{5, 5 + 12 * pi}).closed());
    EXPECT_FALSE(make("butterfly", {}, Interval{0, 2 * pi}).closed());

    // r holds sin⁵(t/12), whose fifth derivative at the seam is ±120/12⁵.
    const auto start = rowsOf(butterfly, 0, 6);
    const auto end = rowsOf(butterfly, 12 * pi, 6);
    for (std::size_t k = 0; k <= 4; ++k) {
        EXPECT_NEAR(end[k].y, start[k].y, 1e-11) << k;
        EXPECT_NEAR(end[k].x, start[k].x, 1e-11) << k;
    }
    EXPECT_NEAR(end[5].y - start[5].y, 240 / std::pow(12, 5), 1e-9);
    EXPECT_NEAR(end[5].x - start[5].x, 0, 1e-9);
    for (const double t : {0.4, 3.0, 17.0}) {
        EXPECT_LT(glm::length(butterfly.point(t + 24 * pi) - butterfly.point(t)), 1e-13);
        EXPECT_GT(glm::length(butterfly.point(t + 12 * pi) - butterfly.point(t)), 1e-9);
    }
}

TEST(ParametricDomain, OverOneTurnTheButterflyMissesItsStartByAThirtySecond) {
    const ParametricCurve butterfly = make("butterfly");
    const Vec3 gap = butterfly.point(2 * pi) - butterfly.point(0);
    EXPECT_NEAR(gap.y, -1.0 / 32, 1e-15);
    EXPECT_NEAR(gap.x, 0, 1e-15);
}

// --- refusals ------------------------------------------------------------------------------------

void expectRefusal(const Result<ParametricCurve>& result, std::string_view code,
                   const std::string& path) {
    ASSERT_FALSE(result.ok()) << path;
    EXPECT_EQ(codeName(result.error().code), code) << path;
    EXPECT_EQ(result.error().path, path);
    EXPECT_FALSE(result.error().message.empty());
}

TEST(ParametricRefusals, WrongParametersAreNamed) {
    const auto with = [](std::string_view name, const Parameters& parameters) {
        return ParametricCurve::make(name, parameters);
    };
    expectRefusal(with("hypotrochoid", {{"r", 0.0}}), "OUT_OF_RANGE", "parameters.r");
    expectRefusal(with("epitrochoid", {{"r", 1e-12}}), "OUT_OF_RANGE", "parameters.r");
    expectRefusal(with("circle", {{"radius", std::nan("")}}), "NOT_FINITE", "parameters.radius");
    expectRefusal(with("circle", {{"radius", infinity}}), "NOT_FINITE", "parameters.radius");
    expectRefusal(with("ellipse", {{"b", 1.1e9}}), "OUT_OF_RANGE", "parameters.b");
    expectRefusal(with("helix", {{"turns", 0.0}}), "OUT_OF_RANGE", "parameters.turns");
    expectRefusal(with("torus-knot", {{"p", 1.5}}), "NOT_INTEGER", "parameters.p");
    expectRefusal(with("circle", {{"r", 1.0}}), "UNKNOWN_FIELD", "parameters.r");
    expectRefusal(with("Circle", {}), "UNKNOWN_NAME", "name");
}

TEST(ParametricRefusals, DomainsMustBeFiniteAscendingAndLongEnough) {
    const auto on = [](double start, double end) {
        return ParametricCurve::make("circle", {}, Interval{start, end});
    };
    expectRefusal(on(std::nan(""), 1), "NOT_FINITE", "domain[0]");
    expectRefusal(on(0, infinity), "NOT_FINITE", "domain[1]");
    expectRefusal(on(1, 1), "OUT_OF_RANGE", "domain");
    expectRefusal(on(2, 1), "OUT_OF_RANGE", "domain");
    expectRefusal(on(0, 5e-7), "OUT_OF_RANGE", "domain");
    expectRefusal(on(1e8, 1e8 + 0.05), "OUT_OF_RANGE", "domain");
    expectRefusal(on(0, 1.1e9), "OUT_OF_RANGE", "domain[1]");
    EXPECT_TRUE(on(1e8, 1e8 + 0.2).ok());
    EXPECT_TRUE(on(-1e9, 1e9).ok());
}

TEST(ParametricDescriptions, EveryModelIsListedInTheOrderOfItsEnumeratorWithUsableDefaults) {
    std::size_t i = 0;
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        EXPECT_EQ(static_cast<std::size_t>(model.model), i++) << model.name;
        EXPECT_FALSE(model.label.empty());
        const ParametricCurve curve = make(model.name);
        EXPECT_EQ(curve.name(), model.name);
        EXPECT_EQ(curve.dimension(), model.dimension);
        ASSERT_EQ(curve.parameters().size(), model.parameters.size());
        for (std::size_t k = 0; k < model.parameters.size(); ++k) {
            const ParameterDescription& parameter = model.parameters[k];
            EXPECT_EQ(curve.parameters()[k], parameter.defaultValue) << parameter.name;
            EXPECT_LE(parameter.min, parameter.low) << parameter.name;
            EXPECT_LE(parameter.low, parameter.defaultValue) << parameter.name;
            EXPECT_LE(parameter.defaultValue, parameter.high) << parameter.name;
            EXPECT_LE(parameter.high, parameter.max) << parameter.name;
            EXPECT_FALSE(parameter.help.empty()) << parameter.name;
        }
        // Planar models stay in the plane, the others leave it.
        const Interval domain = curve.domain();
        double height = 0;
        for (int n = 0; n <= 10; ++n) {
            height = std::max(height,
                              std::abs(curve.point(domain.start + n * domain.length() / 10.3).z));
        }
        EXPECT_EQ(height > 0, model.dimension == 3) << model.name;
    }
    EXPECT_EQ(i, 17u);
}

TEST(ParametricDescriptions, EqualCurvesAreThoseMadeAlike) {
    EXPECT_EQ(make("rose"), make("rose", {{"k", 4.0}}));
    EXPECT_NE(make("rose"), make("rose", {{"k", 5.0}}));
    EXPECT_NE(make("circle"), make("circle", {}, Interval{0, 1}));
    EXPECT_NE(make("astroid"), make("cardioid"));
}

}  // namespace
}  // namespace knotwork
