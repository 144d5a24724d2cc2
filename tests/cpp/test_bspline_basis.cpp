#include "geometry/bspline_basis.hpp"

#include "geometry/bspline_kernels.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numeric>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::Rational;
using Complex = std::complex<double>;

const KnotVector& truthKnots() {
    static const KnotVector knots =
        KnotVector::make(test::doubles(test::rationals(test::truth("bspline_basis")["knots"])), 3,
                         10, Form::clamped)
            .value();
    return knots;
}

void expectRow(std::span<const double> row, const std::vector<Rational>& exact) {
    ASSERT_EQ(row.size(), exact.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        EXPECT_NEAR(row[i], exact[i].value(), test::gates::exact) << "function " << i;
    }
}

TEST(BsplineBasis, AgreesWithTheExactFractions) {
    const auto& expected = test::truth("bspline_basis");
    std::vector<double> rows(20);
    basisRows(truthKnots(), 1.25, Side::right, 1, rows);
    expectRow(std::span(rows).first(10), test::rationals(expected["N(5/4)"]));
    expectRow(std::span(rows).last(10), test::rationals(expected["N1(5/4)"]));
}

TEST(BsplineBasis, KernelIsExactOnRationals) {
    const auto& expected = test::truth("bspline_basis");
    const auto knots = test::rationals(expected["knots"]);
    const std::size_t span = truthKnots().findSpan(1.25);
    for (const std::size_t order : {0u, 1u}) {
        std::vector<Rational> values(4);
        kernels::basisDerivative(std::span<const Rational>(knots), 3, span, order, Rational(5, 4),
                                 std::span(values));
        const auto row = test::rationals(expected[order == 0 ? "N(5/4)" : "N1(5/4)"]);
        for (std::size_t j = 0; j < 4; ++j) EXPECT_EQ(values[j], row[span - 3 + j]);
    }
}

// Piegl and Tiller, The NURBS Book, Ex. 2.3 and 2.4.
TEST(BsplineBasis, AgreesWithThePublishedQuadraticExample) {
    const auto knots =
        KnotVector::make({0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5}, 2, 8, Form::clamped).value();
    ASSERT_EQ(knots.findSpan(2.5), 4u);
    std::vector<double> rows(12);
    basisDerivatives(knots, 4, 2.5, 3, rows);
    const std::vector<double> expected{0.125, 0.75, 0.125, -0.5, 0, 0.5, 1, -2, 1, 0, 0, 0};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(rows[i], expected[i], test::gates::exact) << i;
    }
}

TEST(BsplineBasis, IsAPartitionOfUnityFromBothSidesOfEveryKnot) {
    RandomSplines random(21);
    for (int round = 0; round < 500; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 7), random.form());
        std::vector<double> values(static_cast<std::size_t>(knots.degree()) + 1);
        for (const double t : test::telltaleParameters(knots, random)) {
            for (const Side side : test::bothSides) {
                basisFunctions(knots, knots.findSpan(t, side), t, values);
                const double sum = std::accumulate(values.begin(), values.end(), 0.0);
                ASSERT_NEAR(sum, 1, test::gates::partitionOfUnity);
                ASSERT_GE(*std::min_element(values.begin(), values.end()), 0);
            }
        }
    }
}

TEST(BsplineBasis, IsAPartitionOfUnityAtTheHighestDegree) {
    RandomSplines random(22);
    const KnotVector knots = random.knotVector(25, Form::closed);
    std::vector<double> values(26);
    for (const double t : test::telltaleParameters(knots, random)) {
        basisFunctions(knots, knots.findSpan(t), t, values);
        ASSERT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1,
                    test::gates::partitionOfUnity);
    }
}

TEST(BsplineBasis, ClampedEndsBelongToTheEndPointsExactly) {
    RandomSplines random(23);
    for (int degree = 1; degree <= 7; ++degree) {
        const KnotVector knots = random.knotVector(degree, Form::clamped);
        std::vector<double> row(static_cast<std::size_t>(knots.pointCount()));
        basisRows(knots, knots.domain().start, Side::right, 0, row);
        EXPECT_EQ(row.front(), 1);
        EXPECT_EQ(std::count(row.begin(), row.end(), 0.0), knots.pointCount() - 1);
        basisRows(knots, knots.domain().end, Side::right, 0, row);
        EXPECT_EQ(row.back(), 1);
        EXPECT_EQ(std::count(row.begin(), row.end(), 0.0), knots.pointCount() - 1);
    }
}

// Order k against the complex step through order k-1, relative to the largest of the row.
TEST(BsplineBasis, DerivativesOfEveryOrderAgreeWithTheComplexStep) {
    constexpr double step = 1e-30;
    RandomSplines random(24);
    for (int round = 0; round < 300; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 7), random.form());
        const auto degree = static_cast<std::size_t>(knots.degree());
        std::vector<double> rows((degree + 2) * (degree + 1));
        std::vector<Complex> lower(degree + 1);
        for (const double t : test::telltaleParameters(knots, random, 5)) {
            const std::size_t span =
                knots.findSpan(t, random.integer(0, 1) == 0 ? Side::left : Side::right);
            basisDerivatives(knots, span, t, knots.degree() + 1, rows);
            for (std::size_t order = 1; order <= degree + 1; ++order) {
                kernels::basisDerivative(knots.extended(), degree, span, order - 1,
                                         Complex(t, step), std::span(lower));
                const auto row = std::span(rows).subspan(order * (degree + 1), degree + 1);
                double largest = 0;
                for (const double value : row) largest = std::max(largest, std::abs(value));
                for (std::size_t j = 0; j <= degree; ++j) {
                    ASSERT_NEAR(row[j], lower[j].imag() / step, test::gates::complexStep * largest);
                }
            }
        }
    }
}

TEST(BsplineBasis, DerivativesBeyondTheDegreeAreZero) {
    const auto knots = KnotVector::uniform(2, 6, Form::closed).value();
    std::vector<double> rows(6 * 6, 17);
    basisRows(knots, 0.3, Side::right, 5, rows);
    EXPECT_NE(rows[2 * 6], 0);
    for (std::size_t i = 3 * 6; i < rows.size(); ++i) EXPECT_EQ(rows[i], 0);
}

TEST(BsplineBasis, RowsOfAClosedVectorWrapOntoTheFirstPoints) {
    const auto knots = KnotVector::uniform(3, 5, Form::closed).value();
    std::vector<double> row(5);
    basisRows(knots, 4, Side::right, 0, row);  // points 4, 0, 1 weigh 1/6, 4/6, 1/6
    const std::vector<double> expected{4.0 / 6, 1.0 / 6, 0, 0, 1.0 / 6};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(row[i], expected[i], test::gates::exact);
    std::vector<double> next(5);
    basisRows(knots, 9, Side::right, 0, next);
    EXPECT_EQ(row, next);
}

}  // namespace
}  // namespace knotwork
