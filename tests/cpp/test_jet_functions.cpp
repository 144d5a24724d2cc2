// The elementary functions on jets, and what they say where a derivative does not exist.
#include "geometry/jet.hpp"

#include "support/calculus.hpp"
#include "support/function_gates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;

constexpr int top = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

void expectRelative(double actual, double expected, double tolerance, const std::string& what) {
    EXPECT_NEAR(actual, expected, tolerance * std::max(1.0, std::abs(expected))) << what;
}

/// On a jet, on numbers, and on complex numbers inside the circle of `radius` around t.
template <class Function>
void expectAnalytic(const char* name, const Function& function, double t, double radius) {
    const Jet jet = function(Jet::variable(t, top));
    EXPECT_DOUBLE_EQ(jet.value(), function(t)) << name;
    expectRelative(jet.derivative(1), test::complexStepDerivative(function, t),
                   gates::complexStepSlope, std::string(name) + ", complex step");
    for (int k = 2; k <= top; ++k) {
        const double expected = test::cauchyDerivative(function, t, k, radius);
        // A rounding of the values on the circle comes out multiplied by k!/radius^k.
        const double noise = 1e-14 * std::tgamma(k + 1.0) / std::pow(radius, k);
        EXPECT_NEAR(jet.derivative(k), expected, gates::cauchy * std::abs(expected) + noise)
            << name << ", order " << k;
    }
}

TEST(JetFunctions, AgreeWithTheComplexStepAndWithCauchysIntegralToOrderTwelve) {
    using std::acos, std::asin, std::atan, std::cosh, std::pow, std::sinh, std::tan, std::tanh;
    for (const double t : {-0.3, 0.0, 0.25}) {
        expectAnalytic("tan", [](const auto& x) { return tan(1.1 * x + 0.2); }, t, 0.7);
        expectAnalytic("atan", [](const auto& x) { return atan(x * x + x); }, t, 0.4);
        expectAnalytic("asin", [](const auto& x) { return asin(0.5 * x + 0.1); }, t, 1);
        expectAnalytic("acos", [](const auto& x) { return acos(0.5 * x - 0.1); }, t, 1);
        expectAnalytic("sinh", [](const auto& x) { return sinh(1.5 * x); }, t, 1);
        expectAnalytic("cosh", [](const auto& x) { return cosh(1.5 * x); }, t, 1);
        expectAnalytic("tanh", [](const auto& x) { return tanh(x + 0.3); }, t, 0.9);
        expectAnalytic("base^x", [](const auto& x) { return pow(2.5, x); }, t, 1);
        expectAnalytic("x^x", [](const auto& x) { return pow(1.5 + x, 0.5 - x); }, t, 0.9);
        expectAnalytic("x^2.5", [](const auto& x) { return pow(1.5 + x, 2.5); }, t, 0.9);
    }
}

TEST(JetFunctions, HaveTheSeriesOfTheHandbookAtZero) {
    const Jet t = Jet::variable(0, 11);
    const auto expectSeries = [](const Jet& jet, const std::vector<double>& odd) {
        for (std::size_t i = 0; i < odd.size(); ++i) {
            EXPECT_EQ(jet[2 * static_cast<int>(i)], 0);
            EXPECT_NEAR(jet[2 * static_cast<int>(i) + 1], odd[i], 1e-15);
        }
    };
    expectSeries(tan(t), {1, 1.0 / 3, 2.0 / 15, 17.0 / 315, 62.0 / 2835, 1382.0 / 155925});
    expectSeries(tanh(t), {1, -1.0 / 3, 2.0 / 15, -17.0 / 315, 62.0 / 2835, -1382.0 / 155925});
    expectSeries(asin(t), {1, 1.0 / 6, 3.0 / 40, 15.0 / 336, 105.0 / 3456, 945.0 / 42240});
    expectSeries(atan(t), {1, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11});
    expectSeries(sinh(t), {1, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800});
}

TEST(JetFunctions, InvertEachOther) {
    const Jet t = Jet::variable(0.4, top);
    const auto expectIdentity = [&t](const Jet& jet, const char* what) {
        for (int k = 0; k <= top; ++k) EXPECT_NEAR(jet[k], t[k], 1e-12) << what << ", order " << k;
    };
    expectIdentity(tan(atan(t)), "tan atan");
    expectIdentity(sin(asin(t)), "sin asin");
    expectIdentity(cos(acos(t)), "cos acos");
    expectIdentity(log(exp(t)), "log exp");
    expectIdentity(pow(pow(t, 0.4), 2.5), "powers");
    const Jet one = cosh(t) * cosh(t) - sinh(t) * sinh(t);
    for (int k = 0; k <= top; ++k) EXPECT_NEAR(one[k], k == 0 ? 1 : 0, 1e-14) << k;
}

TEST(JetFunctions, TheSlopeOfTanhKeepsItsDigitsWhereTanhIsNearlyOne) {
    const Jet jet = tanh(Jet::variable(15, 2));
    const double slope = 1 / (std::cosh(15.0) * std::cosh(15.0));
    EXPECT_NEAR(jet.derivative(1) / slope, 1, 1e-14);
    EXPECT_NEAR(jet.derivative(2) / (-2 * std::tanh(15.0) * slope), 1, 1e-14);
}

TEST(JetFunctions, TheAbsoluteValueHasTheSlopeOfTheSideItIsTakenFrom) {
    const Jet t = Jet::variable(0, 3);
    EXPECT_EQ(abs(t, Side::right)[1], 1);
    EXPECT_EQ(abs(t, Side::left)[1], -1);
    EXPECT_EQ(abs(-t, Side::right)[1], 1);
    const Jet square = abs(-(t * t), Side::left);
    EXPECT_EQ(square[2], 1);
    EXPECT_EQ(abs(t * t * t, Side::left)[3], -1);
    EXPECT_EQ(abs(Jet::variable(-2, 1))[1], -1);
    EXPECT_EQ(abs(Jet::constant(0, 4))[3], 0);
}

TEST(JetFunctions, RootsAndPowersOfZeroHaveTheirOneSidedDerivatives) {
    const Jet t = Jet::variable(0, 6);
    const auto rows = [](const Jet& jet) {
        std::vector<double> list;
        for (int k = 0; k <= 3; ++k) list.push_back(jet.derivative(k));
        return list;
    };
    EXPECT_EQ(rows(sqrt(t * t * t * t)), (std::vector<double>{0, 0, 2, 0}));
    EXPECT_EQ(rows(sqrt(t * t, Side::left)), (std::vector<double>{0, -1, 0, 0}));
    EXPECT_EQ(rows(pow(t * t, 1.5)), (std::vector<double>{0, 0, 0, 6}));
    EXPECT_EQ(rows(pow(t * t, 1.5, Side::left)), (std::vector<double>{0, 0, 0, -6}));
    EXPECT_EQ(rows(pow(-t, 3)), (std::vector<double>{0, 0, 0, -6}));
    EXPECT_EQ(rows(pow(t, 2000)), (std::vector<double>{0, 0, 0, 0}));
    EXPECT_EQ(rows(pow(t, 1.5)), (std::vector<double>{0, 0, infinity, -infinity}));
    EXPECT_EQ(rows(sqrt(t)), (std::vector<double>{0, infinity, -infinity, infinity}));
    EXPECT_TRUE(std::isnan(sqrt(t, Side::left)[1]));
    EXPECT_EQ(pow(t, 0.0)[0], 1);
    EXPECT_EQ(pow(t, t)[0], 1);
    EXPECT_TRUE(std::isnan(pow(t, t)[1]));
    EXPECT_EQ(pow(t, 1.0 + t)[1], 1);
    // Of t⁶ to the third order no more is known than that it is O(t⁴): its root is O(t²).
    const Jet lost = pow(Jet::variable(0, 3), 6);
    EXPECT_EQ(sqrt(lost)[1], 0);
    EXPECT_TRUE(std::isnan(sqrt(lost)[2]));
    EXPECT_EQ(pow(lost, 1.25)[3], 0);
    EXPECT_EQ(asin(Jet::variable(1, 2), Side::left)[1], infinity);
    EXPECT_TRUE(std::isnan(asin(Jet::variable(1, 2), Side::right)[1]));
}

TEST(JetFunctions, ExponentsOfEverySizeAreTaken) {
    const Jet t = Jet::variable(0, 3);
    for (const double exponent : {infinity, -infinity, std::nan(""), 1e300, -1e300, 1e-300}) {
        (void)pow(t, exponent);
        (void)pow(t, exponent + t);
        (void)pow(t * t, exponent, Side::left);
    }
    EXPECT_EQ(pow(t, -1)[0], infinity);
}

}  // namespace
}  // namespace knotwork
