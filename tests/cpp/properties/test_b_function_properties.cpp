// The axioms of B-functions for random parameters of every family and for what the algebra makes.
#include "properties/generators.hpp"
#include "properties/property.hpp"

#include "geometry/quadrature.hpp"
#include "support/function_gates.hpp"
#include "support/rational.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace knotwork {
namespace {

using test::BFunctionCase;
using test::Rational;
namespace gates = test::gates;

using Rows = std::array<double, 5>;

Rows rowsAt(const BFunction& function, double t) {
    Rows rows{};
    function.derivatives(t, rows);
    return rows;
}

/// Ends, neighbours of the ends, a grid and a few others.
std::vector<double> parameters() {
    std::vector<double> grid;
    for (int i = 1; i < 16; ++i) grid.push_back(i / 16.0);
    return *test::parametersOf({0, 1}, grid, 8);
}

BFunctionCase anyOfBoth() {
    return *test::whole(0, 1) == 0 ? *test::anyFamily() : *test::anyBFunction(3);
}

TEST(BFunctionProperty, RisesFromZeroToOneAndNeverLeavesThem) {
    test::holds(1000, [] {
        const BFunction function = anyOfBoth().function;
        RC_ASSERT(function.value(0) == 0.0);
        RC_ASSERT(function.value(1) == 1.0);
        double before = 0;
        for (const double t : parameters()) {
            const double value = function.value(t);
            RC_ASSERT(value >= before - gates::erb);
            RC_ASSERT(value >= 0);
            RC_ASSERT(value <= 1);
            before = value;
        }
    });
}

TEST(BFunctionProperty, TheSlopeIsNotNegative) {
    test::holds(1000, [] {
        const BFunction function = anyOfBoth().function;
        for (const double t : parameters()) {
            const Rows rows = rowsAt(function, t);
            RC_ASSERT(rows[1] >= -gates::complexStepSlope);
            RC_ASSERT(std::abs(rows[0] - function.value(t)) <= gates::erb);
        }
    });
}

TEST(BFunctionProperty, WhatIsCalledSymmetricIs) {
    test::holds(1000, [] {
        const BFunction function = anyOfBoth().function;
        RC_PRE(function.symmetric());
        for (const double t : parameters()) {
            RC_ASSERT(std::abs(function.value(t) + function.value(1 - t) - 1) <=
                      2 * gates::erb + 2e-16 * rowsAt(function, t)[1]);  // 1 − t is rounded
        }
    });
}

TEST(BFunctionProperty, DerivativesUpToTheHermiteOrderVanishAtTheEnds) {
    test::holds(1000, [] {
        const BFunction function = anyOfBoth().function;
        const auto order = function.order();
        for (const int end : {0, 1}) {
            const Rows rows = rowsAt(function, end);
            const double s = order[static_cast<std::size_t>(end)];
            for (int k = 1; k <= 4; ++k) {
                const double derivative = rows[static_cast<std::size_t>(k)];
                // Exactly 0 but for the cubics of a table, which sum up to it.
                if (k <= s) RC_ASSERT(std::abs(derivative) <= gates::complexStepSlope);
                if (k == s + 1 && function.smooth()) RC_ASSERT(derivative != 0);
            }
        }
    });
}

TEST(BFunctionProperty, DifferencesAreIntegralsOfTheDerivatives) {
    test::holds(500, [] {
        const BFunctionCase any = *test::anyBFunction(2);
        RC_PRE(any.function.smooth());
        const double from = 0.05 + 0.8 * std::abs(*test::real(1));
        const double to = from + 0.05;
        const Rows start = rowsAt(any.function, from);
        const Rows end = rowsAt(any.function, to);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto next = [&](double t) { return rowsAt(any.function, t)[k + 1]; };
            const auto size = [&](double t) { return std::abs(next(t)); };
            const double scale = 1 + integrateGauss<16>(size, from, to);
            const double change = integrateGauss<16>(next, from, to);
            RC_ASSERT(std::abs(end[k] - start[k] - change) <= gates::integrals * scale);
        }
    });
}

TEST(BFunctionProperty, TheAlgebraIsWhatItsFormulasSay) {
    test::holds(500, [] {
        const BFunction a = BFunctionCase(*test::anyBFunction(1)).function;
        const BFunction b = BFunctionCase(*test::anyBFunction(1)).function;
        const double weight = std::abs(*test::real(1));
        const BFunction dual = BFunction::makeDual(a).value();
        const BFunction half = BFunction::makeSymmetrised(a).value();
        const BFunction chain = BFunction::makeComposed(a, b).value();
        const BFunction mixed = BFunction::makeMixed(a, b, weight).value();
        for (const double t : parameters()) {
            const double mirrored = 1 - a.value(1 - t);
            RC_ASSERT(dual.value(t) == mirrored);
            RC_ASSERT(std::abs(half.value(t) - (a.value(t) + mirrored) / 2) <= gates::bFunction);
            RC_ASSERT(chain.value(t) == a.value(b.value(t)));
            RC_ASSERT(std::abs(mixed.value(t) - (weight * a.value(t) +
                                                 (1 - weight) * b.value(t))) <= gates::bFunction);
        }
        RC_ASSERT(half.symmetric());
        RC_ASSERT(dual.order()[0] == a.order()[1]);
    });
}

TEST(BFunctionProperty, SamplesAreTheValues) {
    test::holds(300, [] {
        const BFunction function = anyOfBoth().function;
        const std::vector<double> ts = parameters();
        std::vector<double> sampled(ts.size());
        function.sample(ts, sampled);
        std::vector<double> rows(3 * ts.size());
        function.sampleDerivatives(ts, rows);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            RC_ASSERT(sampled[i] == function.value(ts[i]));
            RC_ASSERT(rows[2 * ts.size() + i] == rowsAt(function, ts[i])[2]);
        }
    });
}

/// B of degree p + q + 1 by powers of t: B′ = N t^p (1 − t)^q, N = (p + q + 1)!/(p! q!).
std::vector<Rational> betaPolynomial(int p, int q) {
    Rational factor(1);
    for (int k = 1; k <= p + q + 1; ++k) factor = factor * Rational(k);
    for (int k = 1; k <= p; ++k) factor = factor / Rational(k);
    for (int k = 1; k <= q; ++k) factor = factor / Rational(k);
    std::vector<Rational> powers(static_cast<std::size_t>(p + q) + 2);
    Rational binomial(1);
    for (int j = 0; j <= q; ++j) {
        const Rational sign(j % 2 == 0 ? 1 : -1);
        powers[static_cast<std::size_t>(p + j) + 1] =
            factor * sign * binomial / Rational(p + j + 1);
        binomial = binomial * Rational(q - j) / Rational(j + 1);
    }
    return powers;
}

Rational valueAt(const std::vector<Rational>& powers, const Rational& t) {
    Rational sum(0);
    for (std::size_t k = powers.size(); k-- > 0;) sum = sum * t + powers[k];
    return sum;
}

std::vector<Rational> differentiated(const std::vector<Rational>& powers) {
    std::vector<Rational> lower;
    for (std::size_t k = 1; k < powers.size(); ++k) {
        lower.push_back(powers[k] * Rational(static_cast<long long>(k)));
    }
    return lower;
}

TEST(BFunctionProperty, HermiteOrdersOfPolynomialsAreExactInRationals) {
    for (int p = 0; p <= 6; ++p) {
        for (int q = 0; q <= 6; ++q) {
            const BFunction function = BFunction::makePolynomial(p, q).value();
            EXPECT_EQ(function.order()[0], p);
            EXPECT_EQ(function.order()[1], q);
            std::vector<double> atZero(static_cast<std::size_t>(p + q) + 2);
            std::vector<double> atOne(atZero.size());
            function.derivatives(0, atZero);
            function.derivatives(1, atOne);
            std::vector<Rational> exact = betaPolynomial(p, q);
            for (std::size_t k = 0; k < atZero.size(); ++k) {
                const Rational start = valueAt(exact, Rational(0));
                const Rational end = valueAt(exact, Rational(1));
                // The first derivative that does not vanish is the one after the order.
                const int order = static_cast<int>(k);
                if (order > 0 && order <= p + 1) {
                    EXPECT_EQ(start == Rational(0), order <= p) << k;
                }
                if (order > 0 && order <= q + 1) {
                    EXPECT_EQ(end == Rational(0), order <= q) << k;
                }
                EXPECT_NEAR(atZero[k], start.value(), 1e-14 * std::abs(start.value())) << k;
                EXPECT_NEAR(atOne[k], end.value(), 1e-14 * std::abs(end.value())) << k;
                exact = differentiated(exact);
            }
        }
    }
}

TEST(BFunctionProperty, PolynomialsAgreeWithRationalsInside) {
    test::holds(300, [] {
        const int p = *test::whole(0, 6);
        const int q = *test::whole(0, 6);
        const int eighth = *test::whole(0, 8);
        const BFunction function = BFunction::makePolynomial(p, q).value();
        const auto exact = betaPolynomial(p, q);
        RC_ASSERT(std::abs(function.value(eighth / 8.0) -
                           valueAt(exact, Rational(eighth, 8)).value()) <= gates::bFunction);
        RC_ASSERT(std::abs(rowsAt(function, eighth / 8.0)[1] -
                           valueAt(differentiated(exact), Rational(eighth, 8)).value()) <=
                  10 * gates::bFunction);
    });
}

}  // namespace
}  // namespace knotwork
