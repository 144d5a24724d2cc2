#include "geometry/oslo.hpp"

#include "geometry/oslo_kernels.hpp"
#include "geometry/refinement.hpp"
#include "support/gates.hpp"
#include "support/refinements.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::Rational;
using test::SplineKind;

using Exact = std::vector<Rational>;

// --- exact ------------------------------------------------------------------------------------

std::size_t spanOf(const Exact& knots, const Rational& t) {
    std::size_t span = 0;
    while (span + 1 < knots.size() && knots[span + 1].value() <= t.value()) ++span;
    return span;
}

std::span<const Rational> argumentsOf(const Exact& refined, std::size_t j, std::size_t degree) {
    return std::span<const Rational>(refined).subspan(j + 1, degree);
}

Exact exactOslo1(const Exact& knots, const Exact& refined, std::size_t degree, const Exact& points) {
    Exact answer;
    for (std::size_t j = 0; j + degree + 1 < refined.size(); ++j) {
        const std::size_t span = spanOf(knots, refined[j]);
        Exact weights(degree + 1);
        kernels::discreteBsplines<Rational>(knots, degree, span, argumentsOf(refined, j, degree),
                                            weights);
        Rational sum;
        Rational point;
        for (std::size_t k = 0; k <= degree; ++k) {
            EXPECT_GE(weights[k].value(), 0) << "row " << j;
            sum = sum + weights[k];
            point = point + weights[k] * points[span - degree + k];
        }
        EXPECT_EQ(sum, Rational(1)) << "row " << j;
        answer.push_back(point);
    }
    return answer;
}

Exact exactOslo2(const Exact& knots, const Exact& refined, std::size_t degree, const Exact& points) {
    Exact answer;
    for (std::size_t j = 0; j + degree + 1 < refined.size(); ++j) {
        const std::size_t span = spanOf(knots, refined[j]);
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(span - degree);
        Exact active(first, first + static_cast<std::ptrdiff_t>(degree) + 1);
        answer.push_back(kernels::blossom<Rational, Rational>(
            knots, degree, span, argumentsOf(refined, j, degree), active));
    }
    return answer;
}

// b_i = (1 - a_i) c_{i-1} + a_i c_i, a_i clamped to [0, 1].
Exact exactBoehm(Exact knots, const Exact& added, std::size_t degree, Exact points) {
    for (const Rational& t : added) {
        Exact next;
        for (std::size_t i = 0; i <= points.size(); ++i) {
            if (i == points.size() || knots[i].value() >= t.value()) {
                next.push_back(points[i - 1]);
            } else if (knots[i + degree].value() <= t.value()) {
                next.push_back(points[i]);
            } else {
                const Rational a = (t - knots[i]) / (knots[i + degree] - knots[i]);
                next.push_back((Rational(1) - a) * points[i - 1] + a * points[i]);
            }
        }
        points = next;
        const auto after = static_cast<std::ptrdiff_t>(spanOf(knots, t)) + 1;
        knots.insert(knots.begin() + after, t);
    }
    return points;
}

TEST(Oslo, BothAlgorithmsAndRepeatedBoehmAgreeInExactFractions) {
    RandomSplines random(61);
    for (int round = 0; round < 200; ++round) {
        const auto degree = static_cast<std::size_t>(random.integer(1, 4));
        const int inner = random.integer(0, 4);
        Exact knots(degree + 1, Rational(0));
        for (int i = 1; i <= inner; ++i) {
            knots.insert(knots.end(), static_cast<std::size_t>(random.integer(1, static_cast<int>(degree) + 1)),
                         Rational(6 * i));
        }
        knots.insert(knots.end(), degree + 1, Rational(6 * inner + 6));
        Exact points;
        while (points.size() + degree + 1 < knots.size()) points.emplace_back(random.integer(-9, 9));
        Exact added;
        Exact refined = knots;
        for (int i = 0; i < 6; ++i) {
            const Rational t(random.integer(1, 6 * inner + 5));
            if (std::count(refined.begin(), refined.end(), t) > static_cast<long>(degree)) continue;
            added.push_back(t);
            refined.insert(refined.begin() + static_cast<std::ptrdiff_t>(spanOf(refined, t)) + 1, t);
        }
        const Exact first = exactOslo1(knots, refined, degree, points);
        ASSERT_EQ(first, exactOslo2(knots, refined, degree, points));
        ASSERT_EQ(first, exactBoehm(knots, added, degree, points));
    }
}

BsplineCurve quadratic() {
    const auto& given = test::truth("quad_curve");
    std::vector<Vec3> points;
    for (const auto& text : given["ctrl"]) {
        const auto exact = test::rationals(text);
        points.emplace_back(exact[0].value(), exact[1].value(), 0);
    }
    const auto knots = test::doubles(test::rationals(given["knots"]));
    return BsplineCurve::make(KnotVector::make(knots, 2, 5, Form::clamped).value(), points, 2)
        .value();
}

TEST(Oslo, MatrixAndPointsAreThoseOfTheTruth) {
    const auto& given = test::truth("oslo_quad");
    const BsplineCurve curve = quadratic();
    const auto refined = refinedKnots(curve.knotVector(),
                                      test::doubles(test::rationals(given["to"])))
                             .value();
    const std::vector<double> matrix = osloMatrix(curve.knotVector(), refined);
    ASSERT_EQ(matrix.size(), 9U * 5U);
    const auto points = oslo1(curve.knotVector(), refined, curve.points());
    for (std::size_t j = 0; j < 9; ++j) {
        const auto row = test::doubles(test::rationals(given["alpha"][j]));
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_NEAR(matrix[5 * j + i], row[i], test::gates::exact) << j << ", " << i;
        }
        const auto point = test::doubles(test::rationals(given["ctrl"][j]));
        EXPECT_NEAR(points[j].x, point[0], test::gates::exact);
        EXPECT_NEAR(points[j].y, point[1], test::gates::exact);
    }
}

// --- random curves ----------------------------------------------------------------------------

double largestDifference(const BsplineCurve& a, const BsplineCurve& b) {
    EXPECT_EQ(a.knotVector(), b.knotVector());
    EXPECT_EQ(a.weights().size(), b.weights().size());
    double largest = 0;
    for (std::size_t i = 0; i < a.points().size(); ++i) {
        largest = std::max(largest, glm::length(a.points()[i] - b.points()[i]));
    }
    for (std::size_t i = 0; i < a.weights().size(); ++i) {
        largest = std::max(largest, std::abs(a.weights()[i] - b.weights()[i]));
    }
    return largest;
}

TEST(Oslo, RefinementsByAllAlgorithmsAreTheSameAndDoNotMoveTheCurve) {
    RandomSplines random(62);
    for (int round = 0; round < 1500; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const auto knots =
            test::randomRefinement(curve.knotVector(), random, random.integer(0, 25));
        const auto refined = refineByOslo1(curve, knots);
        ASSERT_TRUE(refined.ok()) << refined.error().path << ": " << refined.error().message;
        ASSERT_LE(test::farthest(curve, *refined, random), test::gates::refinement);
        const auto second = refineByOslo2(curve, knots);
        const auto boehm = refineByBoehm(curve, knots);
        ASSERT_TRUE(second.ok() && boehm.ok());
        ASSERT_LE(largestDifference(*refined, *second), test::gates::osloAgainstBoehm);
        ASSERT_LE(largestDifference(*refined, *boehm), test::gates::osloAgainstBoehm);
    }
}

TEST(Oslo, BoehmInOnePassIsBoehmKnotByKnot) {
    RandomSplines random(63);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        BsplineCurve stepwise = curve;
        for (int i = 0; i < 12; ++i) {
            const auto ts = test::telltaleParameters(stepwise.knotVector(), random, 5);
            const double t = ts[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(ts.size()) - 1))];
            if (auto more = insertKnot(stepwise, t, 1)) stepwise = *more;
        }
        const auto all = stepwise.knotVector().knots();
        const auto once = refineByBoehm(curve, {all.begin(), all.end()});
        ASSERT_TRUE(once.ok()) << once.error().path << ": " << once.error().message;
        ASSERT_LE(largestDifference(*once, stepwise), test::gates::osloAgainstBoehm);
    }
}

TEST(Oslo, RowsOfTheMatrixSumToOneAndAreNeverNegative) {
    RandomSplines random(64);
    for (int round = 0; round < 500; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 7), random.form());
        const auto refined =
            refinedKnots(knots, test::randomRefinement(knots, random, random.integer(0, 25)))
                .value();
        const std::vector<double> matrix = osloMatrix(knots, refined);
        const auto columns = static_cast<std::size_t>(knots.pointCount());
        ASSERT_EQ(matrix.size(), columns * static_cast<std::size_t>(refined.pointCount()));
        for (std::size_t row = 0; row < matrix.size(); row += columns) {
            double sum = 0;
            long used = 0;
            for (std::size_t i = 0; i < columns; ++i) {
                ASSERT_GE(matrix[row + i], 0);
                sum += matrix[row + i];
                used += matrix[row + i] != 0;
            }
            ASSERT_NEAR(sum, 1, test::gates::partitionOfUnity);
            ASSERT_LE(used, knots.degree() + 1);
        }
    }
}

TEST(Oslo, RefinementThatAddsNothingChangesNothing) {
    RandomSplines random(65);
    for (int round = 0; round < 200; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const auto knots = curve.knotVector().knots();
        ASSERT_EQ(refineByOslo1(curve, {knots.begin(), knots.end()}).value(), curve);
        ASSERT_EQ(refineByOslo2(curve, {knots.begin(), knots.end()}).value(), curve);
        ASSERT_EQ(refineByBoehm(curve, {knots.begin(), knots.end()}).value(), curve);
    }
}

// --- special cases ----------------------------------------------------------------------------

TEST(Oslo, HalvingUniformKnotsOfAClosedCurveIsLaneRiesenfeld) {
    RandomSplines random(66);
    for (int degree = 1; degree <= 7; ++degree) {
        const int n = degree + 4;
        std::vector<Vec3> points;
        for (int i = 0; i < n; ++i) points.emplace_back(random.real(-1, 1), random.real(-1, 1), 0);
        const auto curve =
            BsplineCurve::make(KnotVector::uniform(degree, n, Form::closed).value(), points, 2);
        std::vector<double> halves;
        for (int i = 0; i <= 2 * n; ++i) halves.push_back(i / 2.0);
        const auto refined = refineByOslo1(*curve, halves).value();
        // Double every point, then take means of neighbours `degree` times.
        std::vector<Vec3> doubled;
        for (const Vec3& point : points) doubled.insert(doubled.end(), 2, point);
        for (int step = 0; step < degree; ++step) {
            std::vector<Vec3> means;
            for (std::size_t i = 0; i < doubled.size(); ++i) {
                means.push_back((doubled[i] + doubled[(i + 1) % doubled.size()]) / 2.0);
            }
            doubled = means;
        }
        double best = 1;
        for (std::size_t shift = 0; shift < doubled.size(); ++shift) {
            double largest = 0;
            for (std::size_t i = 0; i < doubled.size(); ++i) {
                largest = std::max(largest, glm::length(refined.points()[i] -
                                                        doubled[(i + shift) % doubled.size()]));
            }
            best = std::min(best, largest);
        }
        EXPECT_LE(best, test::gates::osloAgainstBoehm) << "degree " << degree;
    }
}

TEST(Oslo, RaisingOneKnotOfABezierCurveToItsDegreeIsDeCasteljau) {
    const std::vector<Vec3> b{{0, 0, 0}, {1, 3, 0}, {4, 4, 0}, {6, 0, 0}};
    const auto curve =
        BsplineCurve::make(KnotVector::make({0, 0, 0, 0, 1, 1, 1, 1}, 3, 4, Form::clamped).value(),
                           b, 2);
    const auto refined =
        refineByOslo1(*curve, {0, 0, 0, 0, 0.25, 0.25, 0.25, 1, 1, 1, 1}).value();
    const auto mix = [](const Vec3& p, const Vec3& q) { return 0.75 * p + 0.25 * q; };
    const Vec3 b01 = mix(b[0], b[1]);
    const Vec3 b12 = mix(b[1], b[2]);
    const Vec3 b23 = mix(b[2], b[3]);
    const std::vector<Vec3> expected{b[0],           b01, mix(b01, b12), mix(mix(b01, b12), mix(b12, b23)),
                                     mix(b12, b23), b23, b[3]};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LE(glm::length(refined.points()[i] - expected[i]), test::gates::exact) << i;
    }
}

// Piegl and Tiller, The NURBS Book, Ex. 5.1.
TEST(Oslo, OneKnotIsThePublishedInsertion) {
    const auto knots =
        KnotVector::make({0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}, 3, 8, Form::clamped).value();
    const auto refined =
        refinedKnots(knots, {0, 0, 0, 0, 1, 2, 2.5, 3, 4, 5, 5, 5, 5}).value();
    const std::vector<double> matrix = osloMatrix(knots, refined);
    const auto expectRow = [&](std::size_t j, std::size_t i, double first, double second) {
        EXPECT_NEAR(matrix[8 * j + i], first, test::gates::exact);
        EXPECT_NEAR(matrix[8 * j + i + 1], second, test::gates::exact);
    };
    expectRow(3, 2, 1.0 / 6, 5.0 / 6);
    expectRow(4, 3, 0.5, 0.5);
    expectRow(5, 4, 5.0 / 6, 1.0 / 6);
    EXPECT_EQ(matrix[8 * 2 + 2], 1);
    EXPECT_EQ(matrix[8 * 6 + 5], 1);
}

TEST(Oslo, SeamOfAClosedCurveMayBeRepeatedAtEitherEnd) {
    RandomSplines random(67);
    const auto knots = KnotVector::make({0, 0, 1, 2, 4, 5}, 2, 5, Form::closed).value();
    std::vector<Vec3> points;
    for (int i = 0; i < 5; ++i) points.emplace_back(random.real(-1, 1), random.real(-1, 1), 0);
    const auto curve = BsplineCurve::make(knots, points, 2).value();
    for (const auto& refined : {std::vector<double>{0, 0, 0, 1, 2, 3, 4, 5},
                                {0, 0, 1, 2, 3, 4, 5, 5}, {0, 1, 2, 3, 4, 5, 5, 5}}) {
        for (const auto refine : {refineByOslo1, refineByOslo2, refineByBoehm}) {
            const auto made = refine(curve, refined);
            ASSERT_TRUE(made.ok()) << made.error().message;
            EXPECT_LE(test::farthest(curve, *made, random), test::gates::refinement);
        }
    }
}

// --- refusals ---------------------------------------------------------------------------------

void expectRefusal(const KnotVector& knots, std::vector<double> refined, Code code,
                   const std::string& path) {
    const auto made = refinedKnots(knots, std::move(refined));
    ASSERT_FALSE(made.ok()) << path;
    EXPECT_EQ(codeName(made.error().code), codeName(code)) << made.error().message;
    EXPECT_EQ(made.error().path, path) << made.error().message;
    EXPECT_GT(made.error().message.size(), 20U);
}

TEST(Oslo, VectorsThatAreNoRefinementAreRefusedWithTheirPlace) {
    const auto knots =
        KnotVector::make({0, 0, 0, 1, 2, 2, 3, 3, 3}, 2, 6, Form::clamped).value();
    expectRefusal(knots, {0, 0, 0, 1, 3, 3, 3}, Code::knotsCount, "knots");
    expectRefusal(knots, {}, Code::knotsCount, "knots");
    expectRefusal(knots, std::vector<double>(200'000, 1), Code::tooLarge, "knots");
    expectRefusal(knots, {0, 0, 0, 1.5, 2, 2, 3, 3, 3}, Code::knotsMultiplicity, "knots[3]");
    expectRefusal(knots, {0, 0, 0, 1, 1, 2, 3, 3, 3}, Code::knotsMultiplicity, "knots[6]");
    expectRefusal(knots, {0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 3, 3}, Code::knotsMultiplicity, "knots[6]");
    expectRefusal(knots, {0, 0, 0, 1, 2, 1.5, 2, 3, 3, 3}, Code::knotsDecreasing, "knots[5]");
    expectRefusal(knots, {-1, -1, -1, 0, 0, 0, 1, 2, 2, 3, 3, 3}, Code::outOfRange, "knots[0]");
    const auto open = KnotVector::uniform(2, 5, Form::open).value();
    expectRefusal(open, {0, 1, 1.5, 2, 3, 4, 5, 6, 7}, Code::outOfRange, "knots[2]");
    expectRefusal(open, {0, 1, 2, 3, 4, 5, 5.5, 6, 7}, Code::outOfRange, "knots[6]");
    expectRefusal(open, {0, 1, 2, 3, 4, 4.5, 4.7, 5, 6}, Code::knotsMultiplicity, "knots[8]");
    const auto closed = KnotVector::uniform(2, 4, Form::closed).value();
    expectRefusal(closed, {0, 1, 2, 3, 3.5, 4.5}, Code::outOfRange, "knots[5]");
    expectRefusal(closed, {-1, 0, 1, 2, 3, 4}, Code::outOfRange, "knots[0]");
    expectRefusal(closed, {0, 1, 1.5, 3, 4}, Code::knotsMultiplicity, "knots[3]");
    const auto seam = KnotVector::make({0, 0, 1, 2, 3}, 2, 4, Form::closed).value();
    expectRefusal(seam, {0, 1, 1.5, 2, 3}, Code::knotsMultiplicity, "knots[1]");
}

}  // namespace
}  // namespace knotwork
