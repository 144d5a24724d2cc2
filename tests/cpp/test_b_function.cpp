#include "geometry/b_function.hpp"

#include "support/calculus.hpp"
#include "support/function_gates.hpp"
#include "support/function_specimens.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::Complex;
using test::Specimen;

constexpr double infinity = std::numeric_limits<double>::infinity();

double decimal(const nlohmann::json& text) { return std::stod(text.get<std::string>()); }

std::vector<double> rowsOf(const BFunction& function, double t, std::size_t count) {
    std::vector<double> rows(count);
    function.derivatives(t, rows);
    return rows;
}

// --- the truth -----------------------------------------------------------------------------------

TEST(BFunction, TheDefaultExpoRationalOneAgreesWithItsTrueValues) {
    const BFunction erb = BFunction::makeExpoRational().value();
    for (const auto& [key, text] : test::truth("ERB_default")["B"].items()) {
        const double expected = decimal(text);
        const double value = erb.value(std::stod(key));
        EXPECT_NEAR(value, expected, gates::erb) << "t = " << key;
        if (expected < 0.1) {
            EXPECT_NEAR(value / expected, 1, gates::erbTail) << "t = " << key;
        }
    }
}

TEST(BFunction, TheDefaultExpoRationalOneAgreesWithItsTrueDerivatives) {
    const auto& expected = test::truth("ERB_default");
    const BFunction erb = BFunction::makeExpoRational().value();
    const auto at3 = rowsOf(erb, 0.3, 4);
    EXPECT_NEAR(at3[1], decimal(expected["dB(0.3)"]), 1e-14);
    EXPECT_NEAR(at3[2], decimal(expected["d2B(0.3)"]), 1e-13);
    EXPECT_NEAR(at3[3], decimal(expected["d3B(0.3)"]), 1e-12);
    const auto at5 = rowsOf(erb, 0.5, 4);
    EXPECT_NEAR(at5[1], decimal(expected["S"]), 1e-14);
    EXPECT_NEAR(at5[2], 0, 1e-14);
    EXPECT_NEAR(at5[3], decimal(expected["d3B(0.5)"]), 1e-13);
}

TEST(BFunction, TheLogisticOneAgreesWithItsTrueValuesRelativeToThem) {
    const auto& expected = test::truth("logistic");
    const BFunction logistic = BFunction::makeLogistic().value();
    for (const auto& [key, text] : expected["B"].items()) {
        EXPECT_NEAR(logistic.value(std::stod(key)) / decimal(text), 1, 1e-13) << "t = " << key;
    }
    const auto rows = rowsOf(logistic, 0.25, 3);
    EXPECT_NEAR(rows[1], decimal(expected["dB(0.25)"]), 1e-14);
    EXPECT_NEAR(rows[2], decimal(expected["d2B(0.25)"]), 2e-14);
    EXPECT_NEAR(rowsOf(logistic, 0.5, 2)[1], decimal(expected["dB(0.5)"]), 1e-15);
}

TEST(BFunction, PolynomialRationalAndTrigonometricOnesAgreeWithTheTruth) {
    const auto expectFraction = [](const BFunction& function, double t,
                                   const nlohmann::json& text) {
        const double expected = test::Rational::parse(text.get<std::string>()).value();
        EXPECT_NEAR(function.value(t), expected, gates::bFunction) << text << " at " << t;
    };
    const auto& beta = test::truth("beta");
    for (const int p : {1, 2, 3}) {
        const std::string key = "(" + std::to_string(p) + "," + std::to_string(p) + ") 3/10";
        expectFraction(BFunction::makePolynomial(p, p).value(), 0.3, beta[key]);
    }
    expectFraction(BFunction::makePolynomial(2, 3).value(), 1.0 / 3, beta["(2,3) 1/3"]);
    expectFraction(BFunction::makePolynomial(3, 2).value(), 1.0 / 3, beta["(3,2) 1/3"]);
    expectFraction(BFunction::makeRational(2).value(), 0.3, test::truth("rational")["m=2 3/10"]);
    expectFraction(BFunction::makeRational(3).value(), 0.3, test::truth("rational")["m=3 3/10"]);
    for (const int m : {1, 2, 3}) {
        const auto& text = test::truth("trig")["order" + std::to_string(m) + " 0.3"];
        EXPECT_NEAR(BFunction::makeTrigonometric(m).value().value(0.3), decimal(text),
                    gates::bFunction);
    }
}

TEST(BFunction, SlopesAtTheMiddleAreThoseOfTheTable) {
    const auto slope = [](const Result<BFunction>& f) { return rowsOf(f.value(), 0.5, 2)[1]; };
    EXPECT_DOUBLE_EQ(slope(BFunction()), 1);
    EXPECT_DOUBLE_EQ(slope(BFunction::makeTrigonometric(1)), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(slope(BFunction::makePolynomial(1, 1)), 1.5);
    EXPECT_DOUBLE_EQ(slope(BFunction::makePolynomial(2, 2)), 15.0 / 8);
    EXPECT_DOUBLE_EQ(slope(BFunction::makePolynomial(3, 3)), 35.0 / 16);
    EXPECT_DOUBLE_EQ(slope(BFunction::makeRational(7)), 7);
    EXPECT_DOUBLE_EQ(slope(BFunction::makeLogistic(3)), 6);
}

// --- the axioms ----------------------------------------------------------------------------------

TEST(BFunction, EveryOneIsExactlyZeroAndOneAtTheEndsAndBeyond) {
    for (const auto& [name, function] : test::everySpecimen()) {
        for (const double t : {-infinity, -3.0, -1e-300, 0.0}) {
            EXPECT_EQ(function.value(t), 0) << name << " at " << t;
        }
        for (const double t : {1.0, 1.0 + 1e-15, 7.0, infinity}) {
            EXPECT_EQ(function.value(t), 1) << name << " at " << t;
        }
        EXPECT_EQ(function.value(std::nan("")), 0) << name;
    }
}

TEST(BFunction, EveryOneStaysWithinZeroAndOneAndNeverDecreases) {
    for (const auto& [name, function] : test::everySpecimen()) {
        double before = 0;
        for (int i = 0; i <= 5000; ++i) {
            const double value = function.value(i / 5000.0);
            ASSERT_GE(value, 0) << name << " at " << i / 5000.0;
            ASSERT_LE(value, 1) << name << " at " << i / 5000.0;
            // The table of an expo-rational one may step back by a rounding, the rest too.
            ASSERT_GE(value, before - 4e-15) << name << " at " << i / 5000.0;
            before = value;
        }
    }
}

TEST(BFunction, EveryOneHasFiniteDerivativesAndNoNegativeSlope) {
    const double near[] = {0,   1e-300, 1e-12, 1e-4,      0.02,        0.3, 0.5 - 1e-9,
                           0.5, 0.75,   0.98,  1 - 1e-12, 1 - 0x1p-53, 1};
    for (const auto& [name, function] : test::everySpecimen()) {
        for (const double t : near) {
            const auto rows = rowsOf(function, t, 26);
            EXPECT_GE(rows[1], 0) << name << " at " << t;
            for (const double row : rows) ASSERT_TRUE(std::isfinite(row)) << name << " at " << t;
        }
    }
}

TEST(BFunction, OutsideTheUnitIntervalDerivativesVanish) {
    for (const auto& [name, function] : test::everySpecimen()) {
        EXPECT_EQ(rowsOf(function, -0.5, 4), (std::vector<double>{0, 0, 0, 0})) << name;
        EXPECT_EQ(rowsOf(function, 1.5, 4), (std::vector<double>{1, 0, 0, 0})) << name;
    }
}

TEST(BFunction, SymmetricOnesAndTheirReflectionsAddUpToOneAndOthersDoNot) {
    for (const auto& [name, function] : test::everySpecimen()) {
        double worst = 0;
        for (int i = 1; i < 1024; ++i) {  // so that 1 − t is exact
            const double t = i / 1024.0;
            worst = std::max(worst, std::abs(function.value(t) + function.value(1 - t) - 1));
        }
        if (function.symmetric()) {
            EXPECT_LE(worst, 1e-15) << name;
        } else if (name.find("e-300") == std::string::npos) {  // those look symmetric
            EXPECT_GT(worst, 1e-11) << name;
        }
    }
}

// --- Hermite orders ------------------------------------------------------------------------------

TEST(BFunction, DerivativesOfPolynomialOnesAtTheEndsAreExactIntegers) {
    for (int p = 0; p <= 5; ++p) {
        for (int q = 0; q <= 5; ++q) {
            // B′ = c t^p (1−t)^q, hence B^(k)(0) = (k−1)! c (−1)^j C(q, j) with j = k−1−p; at 1 the
            // roles change and the sign is that of the dual.
            const BFunction function = BFunction::makePolynomial(p, q).value();
            const double c =
                std::round(std::tgamma(p + q + 2) / std::tgamma(p + 1) / std::tgamma(q + 1));
            const auto expected = [c](int low, int other, int k) {
                const int j = k - 1 - low;
                if (j < 0 || j > other) return 0.0;
                const double choose = std::round(std::tgamma(other + 1) / std::tgamma(j + 1) /
                                                 std::tgamma(other - j + 1));
                return std::round(std::tgamma(k)) * c * choose * (j % 2 == 0 ? 1 : -1);
            };
            const auto atStart = rowsOf(function, 0, 13);
            const auto atEnd = rowsOf(function, 1, 13);
            for (int k = 1; k <= 12; ++k) {
                const auto row = static_cast<std::size_t>(k);
                EXPECT_EQ(atStart[row], expected(p, q, k)) << p << ", " << q << ", order " << k;
                EXPECT_EQ(atEnd[row], (k % 2 == 0 ? -1 : 1) * expected(q, p, k))
                    << p << ", " << q << ", order " << k;
            }
            EXPECT_EQ(function.order(), (std::array<double, 2>{double(p), double(q)}));
        }
    }
}

TEST(BFunction, AsManyDerivativesVanishAtEachEndAsTheOrderSaysAndNotOneMore) {
    for (const auto& [name, function] : test::everySpecimen()) {
        const auto order = function.order();
        const auto powers = function.powers();
        for (const int end : {0, 1}) {
            const auto side = static_cast<std::size_t>(end);
            const auto rows = rowsOf(function, end, 26);
            for (std::size_t k = 1; k < rows.size(); ++k) {
                if (static_cast<double>(k) <= order[side]) {
                    EXPECT_EQ(rows[k], 0) << name << " at " << end << ", order " << k;
                }
            }
            // The derivative after the last that vanishes exists only for a whole power, and a
            // function of one whose derivatives end earlier does not know it.
            const bool whole = powers[side] == std::floor(powers[side]);
            if (whole && order[side] < 25 && name != "composed") {
                EXPECT_NE(rows[static_cast<std::size_t>(order[side]) + 1], 0) << name << " " << end;
            }
        }
    }
}

TEST(BFunction, ValuesLeaveTheEndsWithThePowerThatTheOrderComesFrom) {
    std::vector<Specimen> all = test::nestedSpecimens();
    all.push_back({"trigonometric, even", BFunction::makeTrigonometric(6).value()});
    all.push_back({"trigonometric, odd", BFunction::makeTrigonometric(5).value()});
    all.push_back({"polynomial", BFunction::makePolynomial(3, 2).value()});
    all.push_back({"rational", BFunction::makeRational(2.5, 3).value()});
    const double h = 1e-3;
    for (const auto& [name, function] : all) {
        // In a table the next power takes over within a fraction of the first cell.
        if (function.family() == BFamily::tabulated || function.powers()[0] == infinity) continue;
        const double power = std::log2(function.value(2 * h) / function.value(h));
        EXPECT_NEAR(power, function.powers()[0], 0.02) << name;
        EXPECT_EQ(function.order()[0], std::ceil(function.powers()[0]) - 1) << name;
    }
}

TEST(BFunction, OrdersOfTheFamiliesAreThoseOfTheTable) {
    using Order = std::array<double, 2>;
    EXPECT_EQ(BFunction().order(), (Order{0, 0}));
    EXPECT_EQ(BFunction::makeTrigonometric(4).value().order(), (Order{4, 4}));
    EXPECT_EQ(BFunction::makePolynomial(2, 5).value().order(), (Order{2, 5}));
    EXPECT_EQ(BFunction::makeRational(1).value().order(), (Order{0, 0}));
    EXPECT_EQ(BFunction::makeRational(2).value().order(), (Order{1, 1}));
    EXPECT_EQ(BFunction::makeRational(2.5).value().order(), (Order{2, 2}));
    EXPECT_EQ(BFunction::makeExpoRational().value().order(), (Order{infinity, infinity}));
    EXPECT_EQ(BFunction::makeLogistic().value().order(), (Order{infinity, infinity}));
}

// --- derivatives ---------------------------------------------------------------------------------

// The formulas of the table once more, for complex arguments.
struct FamilyFormula {
    std::string name;
    BFunction function;
    std::function<Complex(Complex)> value;
};

std::vector<FamilyFormula> formulas() {
    using std::cos, std::exp, std::pow, std::sin;
    const double pi = std::numbers::pi;
    return {
        {"trigonometric 1", BFunction::makeTrigonometric(1).value(),
         [pi](Complex t) { return 0.5 - 0.5 * cos(pi * t); }},
        {"trigonometric 2", BFunction::makeTrigonometric(2).value(),
         [pi](Complex t) { return t - sin(2 * pi * t) / (2 * pi); }},
        {"trigonometric 3", BFunction::makeTrigonometric(3).value(),
         [pi](Complex t) { return 0.5 - (9.0 * cos(pi * t) - cos(3 * pi * t)) / 16.0; }},
        {"polynomial 3, 3", BFunction::makePolynomial(3, 3).value(),
         [](Complex t) { return t * t * t * t * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t))); }},
        {"polynomial 1, 2", BFunction::makePolynomial(1, 2).value(),
         [](Complex t) { return t * t * (6.0 + t * (-8.0 + 3.0 * t)); }},
        {"rational 2.5, 0.7", BFunction::makeRational(2.5, 0.7).value(),
         [](Complex t) { return pow(t, 2.5) / (pow(t, 2.5) + 0.7 * pow(1.0 - t, 2.5)); }},
        {"rational 3, 4", BFunction::makeRational(3, 4).value(),
         [](Complex t) { return t * t * t / (t * t * t + 4.0 * pow(1.0 - t, 3)); }},
        {"logistic 1.7", BFunction::makeLogistic(1.7).value(),
         [](Complex t) { return 1.0 / (1.0 + exp(1.7 * (1.0 / t - 1.0 / (1.0 - t)))); }},
    };
}

TEST(BFunction, ValuesAreThoseOfTheFormula) {
    for (const FamilyFormula& formula : formulas()) {
        for (const double t : {0.03, 0.2, 0.5, 0.81, 0.97}) {
            EXPECT_NEAR(formula.function.value(t), formula.value(t).real(), gates::bFunction)
                << formula.name << " at " << t;
        }
    }
}

TEST(BFunction, SlopesAgreeWithTheComplexStepOfTheFormula) {
    for (const FamilyFormula& formula : formulas()) {
        for (const double t : {0.03, 0.2, 0.5, 0.81, 0.97}) {
            const double slope = test::complexStepDerivative(formula.value, t);
            EXPECT_NEAR(rowsOf(formula.function, t, 2)[1] / slope, 1, gates::complexStepSlope)
                << formula.name << " at " << t;
        }
    }
}

TEST(BFunction, HigherDerivativesAgreeWithCauchysIntegralOfTheFormula) {
    for (const FamilyFormula& formula : formulas()) {
        for (const double t : {0.2, 0.5, 0.81}) {
            const auto rows = rowsOf(formula.function, t, 7);
            for (int k = 2; k <= 6; ++k) {
                const double radius = 0.12;
                const double expected = test::cauchyDerivative(formula.value, t, k, radius);
                // What the sum over the circle can resolve, and a relative part.
                const double noise = 1e-14 * std::tgamma(k + 1) / std::pow(radius, k);
                EXPECT_NEAR(rows[static_cast<std::size_t>(k)], expected,
                            noise + gates::cauchy * std::abs(expected))
                    << formula.name << " at " << t << ", order " << k;
            }
        }
    }
}

TEST(BFunction, EvenTrigonometricOnesKeepTheirRelativeAccuracyNearZero) {
    for (const int m : {2, 4, 10, 20}) {
        const BFunction function = BFunction::makeTrigonometric(m).value();
        const double slope = rowsOf(function, 0.5, 2)[1];
        for (const double t : {1e-6, 0.003, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5}) {
            const long double integral =
                static_cast<long double>(t) *
                test::integrateTanhSinh([&](long double q, long double) {
                    return std::pow(std::sin(std::numbers::pi_v<long double> * t * q), m);
                });
            EXPECT_NEAR(function.value(t) / static_cast<double>(slope * integral), 1, 2e-12)
                << "order " << m << " at " << t;
        }
    }
}

// --- batches and reading back --------------------------------------------------------------------

TEST(BFunction, BatchesGiveTheSameValuesAsSingleCalls) {
    const std::vector<double> ts{-1, 0, 1e-5, 0.2, 0.5, 0.77, 1, 2, std::nan("")};
    for (const auto& [name, function] : test::everySpecimen()) {
        std::vector<double> values(ts.size());
        function.sample(ts, values);
        std::vector<double> rows(3 * ts.size());
        function.sampleDerivatives(ts, rows);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            EXPECT_EQ(values[i], function.value(ts[i])) << name << " at " << ts[i];
            const auto single = rowsOf(function, ts[i], 3);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(rows[k * ts.size() + i], single[k]) << name;
        }
    }
}

TEST(BFunction, SamplesOfPolynomialOnesAreTheirValuesForAllPowers) {
    for (int p = 0; p <= 20; p += 4) {
        for (int q = 0; q <= 20; q += 5) {
            const BFunction function = BFunction::makePolynomial(p, q).value();
            std::vector<double> values(38);
            function.sampleUniform(values);
            for (std::size_t i = 0; i < values.size(); ++i) {
                EXPECT_EQ(values[i], function.value(static_cast<double>(i) / 37)) << p << q << i;
            }
        }
    }
}

TEST(BFunction, UniformSamplesIncludeBothEnds) {
    std::vector<double> values(5);
    BFunction().sampleUniform(values);
    EXPECT_EQ(values, (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(BFunction, WhatItWasMadeFromCanBeReadBack) {
    const BFunction erb = BFunction::makeExpoRational(0.5, 2, 3, 0.25).value();
    EXPECT_EQ(erb.description().name, "expo-rational");
    EXPECT_EQ(erb.parameters()[3], 0.25);
    const BFunction mixed = BFunction::makeMixed(erb, BFunction(), 0.25).value();
    EXPECT_EQ(mixed.parameters()[0], 0.25);
    EXPECT_EQ(mixed.operands(), (std::vector{erb, BFunction()}));
    const BFunction table = BFunction::makeTabulated(std::vector{0.0, 0.5, 1.0}).value();
    EXPECT_EQ(table.values()[1], 0.5);
    EXPECT_NE(erb, BFunction::makeExpoRational(0.5, 2, 3, 0.26).value());
    EXPECT_EQ(erb, BFunction::makeExpoRational(0.5, 2, 3, 0.25).value());
}

TEST(BFunction, OnlyThoseWithAllDerivativesEverywhereAreSmooth) {
    EXPECT_TRUE(BFunction::makeExpoRational(1, 1, 1, 0.5).value().smooth());
    EXPECT_TRUE(BFunction::makeExpoRational(0.4, 1, 4, 0.5).value().smooth());
    EXPECT_FALSE(BFunction::makeExpoRational(1, 1, 2, 0.5).value().smooth());
    EXPECT_FALSE(BFunction::makeExpoRational(0.7, 1, 1, 0.5).value().smooth());
    EXPECT_TRUE(BFunction::makeRational(3).value().smooth());
    EXPECT_FALSE(BFunction::makeRational(2.5).value().smooth());
    const BFunction rough = BFunction::makeTabulated(test::smoothTable(5)).value();
    EXPECT_FALSE(BFunction::makeDual(rough).value().smooth());
    EXPECT_NE(rough.warning(), "");
}

}  // namespace
}  // namespace knotwork
