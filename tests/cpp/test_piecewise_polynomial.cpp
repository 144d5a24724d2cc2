#include "geometry/piecewise_polynomial.hpp"

#include "support/gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::SplineKind;

Vec3 tripleAt(std::span<const double> xyz, std::size_t i) {
    return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

std::vector<double> uniformSamples(const BsplineSampler& sampler, std::size_t total) {
    std::vector<double> xyz(3 * total);
    sampler.uniform(0, total, total, xyz);
    return xyz;
}

std::vector<double> samplesAt(const BsplineSampler& sampler, const std::vector<double>& ts,
                              int derivatives = 0) {
    std::vector<double> xyz(3 * ts.size() * (static_cast<std::size_t>(derivatives) + 1));
    sampler.at(ts, derivatives, xyz);
    return xyz;
}

std::vector<double> uniformParameters(const Interval& domain, std::size_t total) {
    std::vector<double> ts(total);
    for (std::size_t i = 0; i < total; ++i) ts[i] = uniformParameter(domain, i, total);
    return ts;
}

double largestCoordinate(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// Fast against slow, at uniform parameters, knots and ends.
double largestError(const BsplineCurve& curve, RandomSplines& random) {
    const BsplineSampler sampler(curve);
    std::vector<double> ts = uniformParameters(curve.domain(), 300);
    const std::vector<double> uniform = uniformSamples(sampler, ts.size());
    const std::size_t uniformCount = ts.size();
    for (const double t : test::telltaleParameters(curve.knotVector(), random)) ts.push_back(t);
    const std::vector<double> found = samplesAt(sampler, ts);
    double largest = 0;
    for (std::size_t i = 0; i < ts.size(); ++i) {
        const Vec3 slow = curve.point(ts[i]);
        largest = std::max(largest, largestCoordinate(slow - tripleAt(found, i)));
        if (i < uniformCount) {
            largest = std::max(largest, largestCoordinate(slow - tripleAt(uniform, i)));
        }
    }
    return largest;
}

struct Gate {
    const char* name;
    SplineKind kind;
    double bound;
};

void PrintTo(const Gate& gate, std::ostream* out) { *out << gate.name; }

class FastSamples : public testing::TestWithParam<Gate> {};

TEST_P(FastSamples, AgreeWithDeBoor) {
    RandomSplines random(51);
    for (int round = 0; round < 150; ++round) {
        const BsplineCurve curve = random.curve(random.form(), GetParam().kind);
        ASSERT_LE(largestError(curve, random), GetParam().bound) << "degree " << curve.degree();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Degrees, FastSamples,
    testing::Values(
        Gate{"cubic", {.minDegree = 1, .maxDegree = 3, .size = 20}, test::gates::cubicSamples},
        Gate{"planar",
             {.minDegree = 1, .maxDegree = 3, .size = 20, .dimension = 2},
             test::gates::cubicSamples},
        Gate{"power", {.minDegree = 4, .maxDegree = 7, .size = 20}, test::gates::powerSamples},
        Gate{"bernstein",
             {.minDegree = 8, .maxDegree = 25, .size = 20},
             test::gates::bernsteinSamples},
        Gate{"planarBernstein",
             {.minDegree = 8, .maxDegree = 25, .size = 20, .dimension = 2},
             test::gates::bernsteinSamples},
        Gate{"rational",
             {.minDegree = 1, .maxDegree = 9, .size = 20, .rational = true},
             test::gates::rationalSamples}),
    [](const auto& instance) { return std::string(instance.param.name); });

// Row by row, relative to the largest value of the row on the curve.
void expectRows(const BsplineCurve& curve, const std::vector<double>& ts, int derivatives,
                double bound) {
    const std::vector<double> found = samplesAt(BsplineSampler(curve), ts, derivatives);
    std::vector<Vec3> rows(static_cast<std::size_t>(derivatives) + 1);
    std::vector<double> errors(rows.size());
    std::vector<double> sizes(rows.size(), 1e-300);
    for (std::size_t i = 0; i < ts.size(); ++i) {
        curve.derivatives(ts[i], Side::right, rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const Vec3 fast = tripleAt(found, k * ts.size() + i);
            errors[k] = std::max(errors[k], glm::length(rows[k] - fast));
            sizes[k] = std::max(sizes[k], glm::length(rows[k]));
        }
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        ASSERT_LE(errors[k], bound * sizes[k]) << "row " << k << ", degree " << curve.degree();
    }
}

TEST(BsplineSampler, DerivativesOfEveryOrderAgreeWithTheCurve) {
    RandomSplines random(52);
    for (int round = 0; round < 150; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.dimension = random.integer(2, 3)});
        expectRows(curve, test::telltaleParameters(curve.knotVector(), random, 50),
                   curve.degree() + 2, test::gates::sampledDerivatives);
    }
}

TEST(BsplineSampler, FirstDerivativesOfHighDegreesAgreeWithTheCurve) {
    RandomSplines random(62);
    for (int round = 0; round < 100; ++round) {
        const SplineKind kind{.minDegree = 8, .maxDegree = 25, .dimension = random.integer(2, 3)};
        const BsplineCurve curve = random.curve(random.form(), kind);
        expectRows(curve, test::telltaleParameters(curve.knotVector(), random, 50), 3,
                   test::gates::highDegreeDerivatives);
    }
}

TEST(BsplineSampler, DerivativesOfRationalCurvesAgreeWithTheCurve) {
    RandomSplines random(53);
    for (int round = 0; round < 100; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.maxDegree = 5, .rational = true});
        expectRows(curve, test::telltaleParameters(curve.knotVector(), random, 50), 4,
                   test::gates::sampledDerivatives);
    }
}

TEST(BsplineSampler, WeightsOfVeryDifferentSizeKeepTheirDigits) {
    const auto knots = KnotVector::uniform(3, 7, Form::clamped).value();
    const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {3, 2, 0},
                                   {4, 0, 0}, {5, 2, 0}, {6, 0, 0}};
    const auto curve =
        BsplineCurve::make(knots, points, 2, {1e-9, 1, 1e9, 1e-9, 1e-9, 1e9, 1e-9}).value();
    RandomSplines random(54);
    EXPECT_LE(largestError(curve, random), test::gates::rationalSamples);
}

TEST(BsplineSampler, UniformSamplesAreTheSamplesAtTheirParametersToTheBit) {
    RandomSplines random(55);
    for (int round = 0; round < 50; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const BsplineSampler sampler(curve);
        const std::size_t total = 2 + static_cast<std::size_t>(random.integer(0, 700));
        EXPECT_EQ(uniformSamples(sampler, total),
                  samplesAt(sampler, uniformParameters(curve.domain(), total)));
    }
}

TEST(BsplineSampler, HowSamplesAreCutIntoCallsDoesNotShow) {
    RandomSplines random(56);
    for (int round = 0; round < 50; ++round) {
        const BsplineSampler sampler(random.curve(random.form(), SplineKind{.maxDegree = 11}));
        const std::size_t total = 2 + static_cast<std::size_t>(random.integer(0, 900));
        const auto whole = uniformSamples(sampler, total);
        std::vector<double> pieces;
        for (std::size_t first = 0; first < total;) {
            const auto wanted = static_cast<std::size_t>(random.integer(0, 300));
            const std::size_t count = std::min(wanted, total - first);
            std::vector<double> piece(3 * count);
            sampler.uniform(first, count, total, piece);
            pieces.insert(pieces.end(), piece.begin(), piece.end());
            first += count;
        }
        ASSERT_EQ(whole, pieces);
    }
}

TEST(BsplineSampler, OrderOfTheParametersDoesNotShow) {
    RandomSplines random(57);
    for (int round = 0; round < 50; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const BsplineSampler sampler(curve);
        auto ts = test::telltaleParameters(curve.knotVector(), random, 300);
        const auto sorted = samplesAt(sampler, ts, 1);
        std::reverse(ts.begin(), ts.end());
        const auto reversed = samplesAt(sampler, ts, 1);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            ASSERT_EQ(tripleAt(sorted, i), tripleAt(reversed, ts.size() - 1 - i));
        }
    }
}

TEST(BsplineSampler, EndsAreExact) {
    RandomSplines random(58);
    for (int round = 0; round < 100; ++round) {
        const BsplineCurve curve = random.curve(random.form(), SplineKind{.size = 20});
        const BsplineSampler sampler(curve);
        const auto uniform = uniformSamples(sampler, 77);
        const auto at = samplesAt(sampler, {curve.domain().end, curve.domain().start});
        EXPECT_EQ(tripleAt(uniform, 0), curve.point(curve.domain().start));
        EXPECT_EQ(tripleAt(uniform, 76), curve.point(curve.domain().end));
        EXPECT_EQ(tripleAt(at, 0), tripleAt(uniform, 76));
        EXPECT_EQ(tripleAt(at, 1), tripleAt(uniform, 0));
        if (curve.closed()) {
            EXPECT_EQ(tripleAt(uniform, 0), tripleAt(uniform, 76));
        }
    }
}

TEST(BsplineSampler, OutsideTheDomainItContinuesAsTheCurveDoes) {
    RandomSplines random(59);
    for (int round = 0; round < 50; ++round) {
        const BsplineCurve curve = random.curve(random.form(), SplineKind{.maxDegree = 3});
        std::vector<double> ts;
        for (int i = 0; i < 20; ++i) {
            ts.push_back(curve.domain().start - random.real(0, 1));
            ts.push_back(curve.domain().end + random.real(0, 1));
        }
        expectRows(curve, ts, 1, test::gates::sampledDerivatives);
    }
}

TEST(BsplineSampler, AtAGapTheRightSideIsTaken) {
    const auto knots = KnotVector::make({0, 0, 1, 1, 2, 2}, 1, 4, Form::clamped).value();
    const auto curve =
        BsplineCurve::make(knots, {{0, 0, 0}, {1, 0, 0}, {1, 5, 0}, {2, 5, 0}}, 2).value();
    const auto xyz = uniformSamples(BsplineSampler(curve), 5);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(xyz[3 * i], 0.5 * static_cast<double>(i));
        EXPECT_EQ(xyz[3 * i + 1], i < 2 ? 0 : 5);
    }
}

// A step up at every knot, and samples on the knots: rounding must not give one to the wrong side.
TEST(BsplineSampler, SamplesThatFallOnGapsAreOnTheRightSide) {
    constexpr int steps = 20;
    std::vector<double> knots;
    std::vector<Vec3> points;
    for (int i = 0; i <= steps; ++i) knots.insert(knots.end(), 2, i);
    for (int i = 0; i < steps; ++i) points.insert(points.end(), 2, Vec3(i, 0, 0));
    const auto vector = KnotVector::make(knots, 1, 2 * steps, Form::clamped).value();
    const BsplineSampler sampler(BsplineCurve::make(vector, points, 2).value());
    for (std::size_t part = 1; part <= 60; ++part) {
        const std::size_t total = steps * part + 1;
        const auto xyz = uniformSamples(sampler, total);
        for (std::size_t i = 0; i + 1 < total; ++i) {
            const double t = uniformParameter({0, steps}, i, total);
            ASSERT_EQ(xyz[3 * i], std::floor(t)) << "sample " << i << " of " << total;
        }
    }
}

TEST(BsplineSampler, FewSamplesOfManySpansAndManySamplesOfFew) {
    RandomSplines random(60);
    std::vector<Vec3> points;
    for (int i = 0; i < 1000; ++i) points.emplace_back(random.real(-1, 1), random.real(-1, 1), 0);
    const auto curve =
        BsplineCurve::make(KnotVector::uniform(3, 1000, Form::closed).value(), points, 2).value();
    const BsplineSampler sampler(curve);
    for (const std::size_t total : {1u, 2u, 3u, 7u, 998u, 20'000u}) {
        const auto xyz = uniformSamples(sampler, total);
        for (std::size_t i = 0; i < total; ++i) {
            const Vec3 slow = curve.point(uniformParameter(curve.domain(), i, total));
            ASSERT_LE(glm::length(slow - tripleAt(xyz, i)), test::gates::cubicSamples);
        }
    }
}

TEST(BsplineSampler, NothingAskedForIsNothingDone) {
    RandomSplines random(61);
    const BsplineSampler sampler(random.curve(Form::clamped));
    sampler.uniform(0, 0, 10, {});
    sampler.uniform(10, 0, 10, {});
    sampler.uniform(0, 0, 0, {});
    sampler.at({}, 3, {});
}

}  // namespace
}  // namespace knotwork
