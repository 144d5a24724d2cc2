#include "geometry/jet.hpp"

#include "support/calculus.hpp"
#include "support/function_gates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knotwork {
namespace {

constexpr int top = Jet::maxOrder;

double factorial(int n) { return std::tgamma(n + 1.0); }

void expectNearRelative(double actual, double expected, double tolerance, const char* what, int k) {
    EXPECT_NEAR(actual, expected, tolerance * std::max(1.0, std::abs(expected)))
        << what << ", order " << k;
}

TEST(Jet, DerivativesOfSineCycle) {
    const double t = 0.7;
    const auto [s, c] = sinCos(Jet::variable(t, top));
    for (int k = 0; k <= top; ++k) {
        expectNearRelative(s.derivative(k), std::sin(t + k * std::numbers::pi / 2), 1e-14, "sin",
                           k);
        expectNearRelative(c.derivative(k), std::cos(t + k * std::numbers::pi / 2), 1e-14, "cos",
                           k);
    }
}

TEST(Jet, DerivativesOfTheExponentialAreItself) {
    const Jet e = exp(2.0 * Jet::variable(0.3, top));
    for (int k = 0; k <= top; ++k) {
        expectNearRelative(e.derivative(k), std::pow(2, k) * std::exp(0.6), 1e-14, "exp", k);
    }
}

TEST(Jet, DerivativesOfTheLogarithmAreFactorialsOverPowers) {
    const double t = 1.7;
    const Jet logarithm = log(Jet::variable(t, top));
    EXPECT_DOUBLE_EQ(logarithm.value(), std::log(t));
    for (int k = 1; k <= top; ++k) {
        const double expected = (k % 2 == 0 ? -1 : 1) * factorial(k - 1) / std::pow(t, k);
        expectNearRelative(logarithm.derivative(k), expected, 1e-13, "log", k);
    }
}

TEST(Jet, ARealPowerFollowsTheBinomialSeries) {
    const double t = 1.3;
    const double exponent = 2.7;
    const Jet power = pow(Jet::variable(t, top), exponent);
    double falling = 1;
    for (int k = 0; k <= top; ++k) {
        expectNearRelative(power.derivative(k), falling * std::pow(t, exponent - k), 1e-12, "pow",
                           k);
        falling *= exponent - k;
    }
}

TEST(Jet, TheSquareOfARootIsTheArgument) {
    const Jet argument = 2.0 + sin(Jet::variable(0.4, top));
    const Jet root = sqrt(argument);
    const Jet square = root * root;
    for (int k = 0; k <= top; ++k) EXPECT_NEAR(square[k], argument[k], 1e-14) << "order " << k;
    EXPECT_GT(root.value(), 0);
}

TEST(Jet, AQuotientTimesItsDivisorIsTheDividend) {
    const Jet t = Jet::variable(0.6, top);
    const Jet dividend = exp(t);
    const Jet divisor = 1.5 + cos(t);
    const Jet product = (dividend / divisor) * divisor;
    for (int k = 0; k <= top; ++k) EXPECT_NEAR(product[k], dividend[k], 1e-14) << "order " << k;
}

TEST(Jet, PolynomialsOfIntegersAreExact) {
    // t² − 6t³ + 12t⁴ − 8t⁵ at t = 2, derivatives by hand.
    const Jet t = Jet::variable(2, 6);
    const Jet p = integerPower(1.0 - 2.0 * t, 3) * integerPower(t, 2);
    const double expected[] = {-108, -324, -774, -1380, -1632, -960, 0};
    for (int k = 0; k <= 6; ++k) EXPECT_EQ(p.derivative(k), expected[k]) << "order " << k;
}

TEST(Jet, APowerOfTheVariableVanishesAtZeroToItsOrderExactly) {
    const Jet power = integerPower(Jet::variable(0, 8), 5);
    for (int k = 0; k <= 8; ++k) EXPECT_EQ(power.derivative(k), k == 5 ? 120 : 0) << "order " << k;
}

TEST(Jet, ComposingTaylorSeriesIsEvaluatingTheOuterFunctionOnTheInnerJet) {
    const Jet inner = sin(Jet::variable(0.9, 12));
    const Jet outer = exp(Jet::variable(inner.value(), 12));
    const Jet composed = compose(outer, inner);
    const Jet direct = exp(inner);
    for (int k = 0; k <= 12; ++k) EXPECT_NEAR(composed[k], direct[k], 1e-14) << "order " << k;
}

TEST(Jet, MixedOrdersKeepTheSmaller) {
    const Jet sum = Jet::variable(1, 7) + Jet::variable(2, 3);
    EXPECT_EQ(sum.order(), 3);
    EXPECT_EQ((Jet::variable(1, 2) * Jet::variable(2, 9)).order(), 2);
    EXPECT_EQ((Jet::variable(1, 4) - Jet::constant(2, 9)).order(), 4);
    EXPECT_EQ(sum.value(), 3);
    EXPECT_EQ(sum.derivative(1), 2);
}

TEST(Jet, AFormulaAgreesWithItsComplexStep) {
    const auto formula = [](const auto& t) {
        using std::cos, std::exp, std::log, std::sin, std::sqrt;
        return exp(sin(2.0 * t)) / sqrt(1.0 + t * t) - log(3.0 + cos(t));
    };
    for (const double t : {-1.2, 0.0, 0.5, 2.1}) {
        const Jet jet = formula(Jet::variable(t, 6));
        EXPECT_DOUBLE_EQ(jet.value(), formula(t));
        expectNearRelative(jet.derivative(1), test::complexStepDerivative(formula, t),
                           test::gates::complexStepSlope, "slope", 1);
        for (int k = 2; k <= 6; ++k) {
            expectNearRelative(jet.derivative(k), test::cauchyDerivative(formula, t, k, 0.5),
                               test::gates::cauchy, "Cauchy", k);
        }
    }
}

}  // namespace
}  // namespace knotwork
