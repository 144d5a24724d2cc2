// The expo-rational B-function against slow quadrature, over the whole range of its parameters.
#include "geometry/b_function.hpp"

#include "support/calculus.hpp"
#include "support/function_gates.hpp"
#include "support/function_specimens.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::Complex;

struct Parameters {
    double alpha = 1;
    double beta = 1;
    double gamma = 1;
    double lambda = 0.5;

    [[nodiscard]] BFunction make() const {
        return BFunction::makeExpoRational(alpha, beta, gamma, lambda).value();
    }
    [[nodiscard]] std::string text() const { return test::numbers({alpha, beta, gamma, lambda}); }
};

/// B by a double exponential rule in long double. φ is told the distances u from λ, t from 0 and
/// s from 1, so that nothing cancels at any scale.
class SlowExpoRational {
public:
    explicit SlowExpoRational(const Parameters& parameters) : p_(parameters) {
        left_ = integralUpTo(p_.lambda);
        right_ = integralFrom(p_.lambda);
    }

    [[nodiscard]] long double value(double t) const {
        const long double total = left_ + right_;
        return t <= p_.lambda ? integralUpTo(t) / total : 1 - integralFrom(t) / total;
    }
    [[nodiscard]] long double scale() const { return 1 / (left_ + right_); }

private:
    // Fine steps for steep densities: p = α(1+γ) goes up to 20.
    static constexpr long double step = 1.0L / 200;

    [[nodiscard]] long double density(long double u, long double t, long double s) const {
        const long double power = p_.alpha * (std::log(u / t) + p_.gamma * std::log(u / s));
        return u > 0 ? std::exp(-p_.beta * std::exp(power)) : 1;
    }
    [[nodiscard]] long double integralUpTo(double end) const {
        const long double gap = static_cast<long double>(p_.lambda) - end;
        const auto f = [&](long double q, long double r) {
            const long double u = gap + end * r;
            return density(u, end * q, 1.0L - p_.lambda + u);
        };
        return end * test::integrateTanhSinh(f, step);
    }
    [[nodiscard]] long double integralFrom(double start) const {
        const long double gap = static_cast<long double>(start) - p_.lambda;
        const long double length = 1.0L - start;
        const auto f = [&](long double q, long double r) {
            const long double u = gap + length * r;
            return density(u, p_.lambda + u, length * q);
        };
        return length * test::integrateTanhSinh(f, step);
    }

    Parameters p_;
    long double left_ = 0;
    long double right_ = 0;
};

/// Places where something could go wrong: both ends, both sides of λ, and in between.
std::vector<double> tellingPlaces(double lambda) {
    std::vector<double> ts{1e-6, 0.002, 0.03, 0.11, 0.37, 0.5, 0.61, 0.83, 0.96, 0.999};
    for (const double near : {1e-9, 1e-3, 0.2}) {
        ts.push_back(lambda * (1 - near));
        ts.push_back(lambda + (1 - lambda) * near);
    }
    ts.push_back(lambda);
    return ts;
}

void expectAccurate(const Parameters& parameters) {
    const BFunction function = parameters.make();
    const SlowExpoRational slow(parameters);
    for (const double t : tellingPlaces(parameters.lambda)) {
        const long double expected = slow.value(t);
        const double value = function.value(t);
        ASSERT_NEAR(value, static_cast<double>(expected), gates::erb)
            << parameters.text() << " at " << t;
        if (expected < 1e-3L && expected > 1e-290L) {
            ASSERT_NEAR(static_cast<double>(value / expected), 1, gates::erbTail)
                << parameters.text() << " at " << t;
        }
    }
}

TEST(ExpoRational, ValuesAreRightOverTheUsualRange) {
    for (const double alpha : {0.5, 1.0, 2.0}) {
        for (const double beta : {0.2, 1.0, 8.0}) {
            for (const double gamma : {0.5, 2.0}) {
                for (const double lambda : {0.2, 0.5}) {
                    expectAccurate({alpha, beta, gamma, lambda});
                }
            }
        }
    }
}

TEST(ExpoRational, ValuesAreRightInTheCornersOfTheRange) {
    for (const double alpha : {1e-3, 0.03, 4.0}) {
        for (const double beta : {1e-3, 100.0}) {
            for (const double gamma : {1e-3, 4.0}) {
                for (const double lambda : {0.001, 0.5, 0.999}) {
                    expectAccurate({alpha, beta, gamma, lambda});
                }
            }
        }
    }
}

TEST(ExpoRational, MassWithinARoundingOfLambdaIsNotLost) {
    expectAccurate({0.027, 100, 1, 0.001});
    expectAccurate({0.027, 100, 1e-3, 0.5});
    expectAccurate({0.01, 100, 4, 0.3});
}

TEST(ExpoRational, TheFarTailKeepsItsRelativeAccuracyUntilItVanishes) {
    const Parameters usual;
    const BFunction function = usual.make();
    const SlowExpoRational slow(usual);
    int tested = 0;
    for (double t = 0.05; t > 4e-4; t *= 0.93) {
        const long double expected = slow.value(t);
        EXPECT_NEAR(static_cast<double>(function.value(t) / expected), 1, gates::erbTail) << t;
        ++tested;
    }
    EXPECT_GT(tested, 60);
    EXPECT_GT(function.value(4e-4), 0);
    EXPECT_EQ(function.value(3e-4), 0);  // below the smallest number
}

TEST(ExpoRational, OtherFarTailsKeepTheirRelativeAccuracyToo) {
    for (const Parameters& p : {Parameters{2, 1, 1, 0.5}, Parameters{1.3, 2, 0.6, 0.3},
                                Parameters{0.3, 60, 1, 0.5}, Parameters{0.1, 90, 4, 0.6},
                                Parameters{4, 0.5, 4, 0.4}}) {
        const BFunction function = p.make();
        const SlowExpoRational slow(p);
        int tested = 0;
        for (double t = p.lambda; t > 1e-9; t *= 0.7) {
            const long double expected = slow.value(t);
            if (expected > 1e-3L || expected < 1e-290L) continue;
            EXPECT_NEAR(static_cast<double>(function.value(t) / expected), 1, gates::erbTail)
                << p.text() << " at " << t;
            ++tested;
        }
        EXPECT_GT(tested, 2) << p.text();
    }
}

TEST(ExpoRational, DenseSamplesInPlaceAreTheValues) {
    // More than one to a cell, and long enough for runs within one.
    for (const Parameters& p : {Parameters{}, Parameters{2, 1, 1, 0.5}, Parameters{1.3, 2, 0.6, 0.3},
                                Parameters{1, 100, 1, 0.5}, Parameters{0.01, 100, 4, 0.3}}) {
        const BFunction function = p.make();
        for (const std::size_t count : {300u, 1025u, 6001u}) {
            std::vector<double> values(count);
            function.sampleUniform(values);
            for (std::size_t i = 0; i < count; ++i) {
                const double t = static_cast<double>(i) / static_cast<double>(count - 1);
                ASSERT_EQ(values[i], function.value(t)) << p.text() << " at " << t;
            }
        }
    }
}

TEST(ExpoRational, WhatStandsAmongDenseSamplesAndIsOutsideOrNoNumberIsStillZeroOrOne) {
    std::vector<double> ts(64, 0.4);
    ts[5] = std::nan("");
    ts[10] = -0.3;
    ts[19] = 1.7;
    ts[32] = 0.7;
    const BFunction function = Parameters{}.make();
    std::vector<double> values(ts.size());
    function.sample(ts, values);
    for (std::size_t i = 0; i < ts.size(); ++i) EXPECT_EQ(values[i], function.value(ts[i])) << i;
    EXPECT_EQ(values[5], 0);
    EXPECT_EQ(values[10], 0);
    EXPECT_EQ(values[19], 1);
}

TEST(ExpoRational, ValuesAreContinuousWhereTheTablesMeet) {
    // Octave eighths of the distance to λ and to either end, λ itself, and where it is divided
    // evenly on both sides.
    for (const Parameters& p :
         {Parameters{}, Parameters{1.3, 2, 0.6, 0.3}, Parameters{4, 9, 4, 0.8}}) {
        const BFunction function = p.make();
        std::vector<double> borders{p.lambda};
        for (double key = 1; key > 1e-4; key *= 0.5) {
            for (int eighth = 8; eighth < 16; ++eighth) {
                const double part = key * eighth / 16;
                borders.insert(borders.end(),
                               {p.lambda * part, p.lambda * (1 - part),
                                p.lambda + (1 - p.lambda) * part, 1 - (1 - p.lambda) * part});
            }
        }
        for (int i = 1; i < 256; ++i) {
            borders.insert(borders.end(),
                           {p.lambda * i / 256, p.lambda + (1 - p.lambda) * i / 256});
        }
        for (const double t : borders) {
            const double jump =
                function.value(std::nextafter(t, 2)) - function.value(std::nextafter(t, -1));
            EXPECT_NEAR(jump, 0, 4e-15) << p.text() << " at " << t;
        }
    }
}

TEST(ExpoRational, SlopesAreTheDensityOverItsIntegral) {
    for (const Parameters& p :
         {Parameters{}, Parameters{0.7, 3, 2, 0.4}, Parameters{2, 0.5, 0.5, 0.8}}) {
        const BFunction function = p.make();
        const double scale = static_cast<double>(SlowExpoRational(p).scale());
        for (const double t : {0.05, 0.2, 0.45, 0.6, 0.9}) {
            const double ratio = std::pow(std::abs(t - p.lambda), p.alpha * (1 + p.gamma)) /
                                 std::pow(t * std::pow(1 - t, p.gamma), p.alpha);
            std::array<double, 2> rows{};
            function.derivatives(t, rows);
            EXPECT_NEAR(rows[1] / (scale * std::exp(-p.beta * ratio)), 1, 1e-12)
                << p.text() << " at " << t;
        }
    }
}

TEST(ExpoRational, HigherDerivativesAgreeWithTheDensitysComplexStepAndCauchysIntegral) {
    for (const Parameters& p :
         {Parameters{}, Parameters{0.7, 3, 2, 0.4}, Parameters{2, 0.5, 0.5, 0.8}}) {
        const BFunction function = p.make();
        const double scale = static_cast<double>(SlowExpoRational(p).scale());
        for (const double t : {0.15, 0.25, 0.6, 0.66}) {
            const double side = t < p.lambda ? -1 : 1;
            const auto slope = [&](Complex z) {
                const Complex distance = side * (z - p.lambda);
                const Complex power = std::pow(distance, p.alpha * (1 + p.gamma)) *
                                      std::pow(z, -p.alpha) * std::pow(1.0 - z, -p.alpha * p.gamma);
                return scale * std::exp(-p.beta * power);
            };
            std::array<double, 6> rows{};
            function.derivatives(t, rows);
            EXPECT_NEAR(rows[2] / test::complexStepDerivative(slope, t), 1, gates::complexStepSlope)
                << p.text() << " at " << t;
            for (int k = 2; k <= 4; ++k) {
                const double expected = test::cauchyDerivative(slope, t, k, 0.07);
                const double noise = 1e-14 * std::tgamma(k + 1) / std::pow(0.07, k);
                EXPECT_NEAR(rows[static_cast<std::size_t>(k) + 1], expected,
                            noise + gates::cauchy * std::abs(expected))
                    << p.text() << " at " << t << ", order " << k + 1;
            }
        }
    }
}

TEST(ExpoRational, AtLambdaTheSlopeIsLargestAndOddDerivativesOfTheBumpVanish) {
    for (const Parameters& p :
         {Parameters{}, Parameters{0.7, 3, 2, 0.4}, Parameters{1.5, 1, 1, 0.3}}) {
        const BFunction function = p.make();
        std::array<double, 3> at{};
        std::array<double, 3> left{};
        std::array<double, 3> right{};
        function.derivatives(p.lambda, at);
        function.derivatives(p.lambda - 1e-3, left);
        function.derivatives(p.lambda + 1e-3, right);
        EXPECT_GT(at[1], left[1]) << p.text();
        EXPECT_GT(at[1], right[1]) << p.text();
        EXPECT_EQ(at[2], 0) << p.text();
        EXPECT_NEAR(at[1], static_cast<double>(SlowExpoRational(p).scale()), 1e-12) << p.text();
    }
}

TEST(ExpoRational, AtLambdaDerivativesThatJumpAreZeroAndThoseBelowAreExact) {
    // p = 3: φ = 1 − c|u|³ + …, whose third derivative jumps from 6c to −6c.
    const BFunction odd = BFunction::makeExpoRational(1.5, 1, 1, 0.5).value();
    std::array<double, 5> rows{};
    odd.derivatives(0.5, rows);
    for (const std::size_t k : {2u, 3u, 4u}) EXPECT_EQ(rows[k], 0) << k;
    odd.derivatives(0.5 - 1e-9, rows);
    EXPECT_GT(rows[4], 1);
    odd.derivatives(0.5 + 1e-9, rows);
    EXPECT_LT(rows[4], -1);
    // p = 4: φ = 1 − β u⁴/(1/4)² + …
    const BFunction even = BFunction::makeExpoRational(2, 3, 1, 0.5).value();
    std::array<double, 6> more{};
    even.derivatives(0.5, more);
    EXPECT_NEAR(more[5] / more[1], -3 * 16 * 24, 1e-9);
}

TEST(ExpoRational, AStepForLargeBetaAndAlmostLinearForSmall) {
    const BFunction step = BFunction::makeExpoRational(1, 100, 1, 0.3).value();
    EXPECT_LT(step.value(0.15), 1e-5);
    EXPECT_GT(step.value(0.5), 1 - 1e-5);
    const BFunction flat = BFunction::makeExpoRational(1, 1e-6, 1, 0.5).value();
    for (const double t : {0.1, 0.4, 0.9}) EXPECT_NEAR(flat.value(t), t, 1e-5);
}

}  // namespace
}  // namespace knotwork
