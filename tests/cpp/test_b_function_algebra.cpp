// Dual, symmetrised, composed, mixed and tabulated B-functions.
#include "geometry/b_function.hpp"

#include "support/function_gates.hpp"
#include "support/function_specimens.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace knotwork {
namespace {

using Order = std::array<double, 2>;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> rowsOf(const BFunction& function, double t, std::size_t count) {
    std::vector<double> rows(count);
    function.derivatives(t, rows);
    return rows;
}

void expectSameFunction(const BFunction& a, const BFunction& b, const char* what) {
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
        const auto rowsA = rowsOf(a, t, 6);
        const auto rowsB = rowsOf(b, t, 6);
        for (std::size_t k = 0; k < rowsA.size(); ++k) {
            EXPECT_NEAR(rowsA[k], rowsB[k], 1e-11 * std::max(1.0, std::abs(rowsB[k])))
                << what << " at " << t << ", order " << k;
        }
    }
}

const BFunction& skew() {
    static const BFunction function = BFunction::makePolynomial(1, 3).value();
    return function;
}

TEST(BFunctionAlgebra, TheDualOfAPolynomialHasItsPowersExchanged) {
    const BFunction dual = BFunction::makeDual(skew()).value();
    expectSameFunction(dual, BFunction::makePolynomial(3, 1).value(), "dual");
    EXPECT_EQ(dual.order(), (Order{3, 1}));
}

TEST(BFunctionAlgebra, TheDualOfARationalHasTheReciprocalWeight) {
    const BFunction dual = BFunction::makeDual(BFunction::makeRational(3, 4).value()).value();
    expectSameFunction(dual, BFunction::makeRational(3, 0.25).value(), "dual");
}

TEST(BFunctionAlgebra, TheDualOfTheDualIsTheFunction) {
    const BFunction twice = BFunction::makeDual(BFunction::makeDual(skew()).value()).value();
    expectSameFunction(twice, skew(), "twice dual");
}

TEST(BFunctionAlgebra, SymmetrisingGivesTheMeanWithTheDualAndTheSmallerOrder) {
    const BFunction half = BFunction::makeSymmetrised(skew()).value();
    const BFunction mean =
        BFunction::makeMixed(skew(), BFunction::makePolynomial(3, 1).value(), 0.5).value();
    expectSameFunction(half, mean, "symmetrised");
    EXPECT_TRUE(half.symmetric());
    EXPECT_FALSE(skew().symmetric());
    EXPECT_EQ(half.order(), (Order{1, 1}));
}

TEST(BFunctionAlgebra, ComposingRationalsMultipliesTheirPowers) {
    // t^m/(t^m + s^m) is a power of the odds t/s, so composing multiplies exponents.
    const BFunction composed = BFunction::makeComposed(BFunction::makeRational(2).value(),
                                                       BFunction::makeRational(3).value())
                                   .value();
    expectSameFunction(composed, BFunction::makeRational(6).value(), "composed");
    EXPECT_EQ(composed.order(), (Order{5, 5}));
    EXPECT_TRUE(composed.symmetric());
}

TEST(BFunctionAlgebra, ComposingAppliesTheInnerFunctionFirst) {
    const BFunction square = BFunction::makePolynomial(1, 0).value();  // t²
    const BFunction composed = BFunction::makeComposed(skew(), square).value();
    EXPECT_DOUBLE_EQ(composed.value(0.3), skew().value(0.09));
    EXPECT_DOUBLE_EQ(rowsOf(composed, 0.3, 2)[1], 0.6 * rowsOf(skew(), 0.09, 2)[1]);
}

TEST(BFunctionAlgebra, TheOrderOfAComposedOneIsThatOfTheProductOfThePowers) {
    const auto order = [](const BFunction& outer, const BFunction& inner) {
        return BFunction::makeComposed(outer, inner).value().order();
    };
    const BFunction erb = BFunction::makeExpoRational().value();
    EXPECT_EQ(order(skew(), skew()), (Order{3, 15}));
    EXPECT_EQ(order(skew(), erb), (Order{infinity, infinity}));
    EXPECT_EQ(order(BFunction(), skew()), (Order{1, 3}));
    // 1.5² = 2.25: two derivatives vanish, not (1+1)(1+1) − 1 = 3.
    const BFunction root = BFunction::makeRational(1.5).value();
    EXPECT_EQ(order(root, root), (Order{2, 2}));
    EXPECT_EQ(BFunction::makeRational(2.25).value().order(), (Order{2, 2}));
}

TEST(BFunctionAlgebra, MixingWeighsTheFirstByTheWeightAndTakesTheSmallerOrder) {
    const BFunction first = BFunction::makePolynomial(4, 2).value();
    const BFunction mixed = BFunction::makeMixed(first, skew(), 0.25).value();
    EXPECT_DOUBLE_EQ(mixed.value(0.4), 0.25 * first.value(0.4) + 0.75 * skew().value(0.4));
    EXPECT_EQ(mixed.order(), (Order{1, 2}));
    EXPECT_EQ(BFunction::makeMixed(first, skew(), 1).value().order(), (Order{4, 2}));
    EXPECT_EQ(BFunction::makeMixed(first, skew(), 0).value().order(), (Order{1, 3}));
    EXPECT_TRUE(BFunction::makeMixed(BFunction(), skew(), 1).value().symmetric());
    EXPECT_FALSE(BFunction::makeMixed(BFunction(), skew(), 0.5).value().symmetric());
}

TEST(BFunctionAlgebra, OperandsOutliveTheFunctionTheyWereGivenBy) {
    BFunction kept;
    {
        const BFunction inner = BFunction::makeExpoRational(1, 2, 1, 0.5).value();
        kept = BFunction::makeComposed(BFunction::makeDual(inner).value(), inner).value();
    }
    EXPECT_NEAR(kept.value(0.5), 0.5, 1e-15);
}

// --- tables --------------------------------------------------------------------------------------

TEST(TabulatedBFunction, PassesThroughItsValues) {
    const std::vector<double> values{0, 0, 1e-9, 0.2, 0.7, 0.7, 0.99, 1};
    const BFunction function = BFunction::makeTabulated(values).value();
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(function.value(static_cast<double>(i) / 7.0), values[i], 2e-16) << i;
    }
}

TEST(TabulatedBFunction, ReproducesCubics) {
    std::vector<double> values;
    for (int i = 0; i <= 10; ++i) values.push_back(0.01 * i * i * (3 - 0.2 * i));
    values.back() = 1;
    const BFunction function = BFunction::makeTabulated(values).value();
    expectSameFunction(function, BFunction::makePolynomial(1, 1).value(), "3t² − 2t³");
    EXPECT_EQ(function.order(), (Order{1, 1}));
    EXPECT_TRUE(function.symmetric());
}

TEST(TabulatedBFunction, ConvergesWithTheFourthPowerOfTheStep) {
    const BFunction model = BFunction::makeExpoRational().value();
    const auto worst = [&](int cells) {
        std::vector<double> values(static_cast<std::size_t>(cells) + 1);
        model.sampleUniform(values);
        const BFunction table = BFunction::makeTabulated(values).value();
        double error = 0;
        for (int i = 200; i <= 800; ++i) {
            error = std::max(error, std::abs(table.value(i / 1000.0) - model.value(i / 1000.0)));
        }
        return error;
    };
    EXPECT_GT(worst(50) / worst(100), 12);
}

TEST(TabulatedBFunction, HasOneContinuousDerivative) {
    const std::vector<double> values{0, 0.3, 0.31, 0.6, 0.95, 1};
    const BFunction function = BFunction::makeTabulated(values).value();
    for (const double knot : {0.2, 0.4, 0.6, 0.8}) {
        const auto left = rowsOf(function, knot - 1e-12, 2);
        const auto right = rowsOf(function, knot + 1e-12, 2);
        EXPECT_NEAR(left[1], right[1], 1e-9) << knot;
    }
}

TEST(TabulatedBFunction, DerivativesAreThoseOfItsCubics) {
    const BFunction function = BFunction::makeTabulated(test::smoothTable(7)).value();
    const double h = 1e-4;
    for (const double t : {0.05, 0.21, 0.4, 0.74, 0.93}) {
        const auto rows = rowsOf(function, t, 5);
        const double up = function.value(t + h);
        const double down = function.value(t - h);
        EXPECT_NEAR(rows[1], (up - down) / (2 * h), 1e-6) << t;
        EXPECT_NEAR(rows[2], (up - 2 * function.value(t) + down) / (h * h), 1e-6) << t;
        const auto further = rowsOf(function, t + h, 3);
        EXPECT_NEAR(rows[3], (further[2] - rows[2]) / h, 1e-6) << t;
        EXPECT_EQ(rows[4], 0) << t;
    }
}

TEST(TabulatedBFunction, ItsOrderAtEachEndIsThatOfItsOuterPiece) {
    const auto order = [](std::vector<double> values) {
        return BFunction::makeTabulated(values).value().order();
    };
    EXPECT_EQ(order({0, 1}), (Order{0, 0}));
    EXPECT_EQ(order({0, 0, 1, 1}), (Order{infinity, infinity}));
    std::vector<double> cube;
    for (int i = 0; i <= 8; ++i) cube.push_back(i * i * i / 512.0);
    EXPECT_EQ(order(cube), (Order{2, 0}));
}

}  // namespace
}  // namespace knotwork
