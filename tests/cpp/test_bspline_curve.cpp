#include "geometry/bspline_curve.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/bspline_kernels.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::Rational;
using test::SplineKind;
using Complex = std::complex<double>;

double distance(const Vec3& a, const Vec3& b) { return glm::length(a - b); }

std::vector<std::vector<Rational>> exactPoints(const nlohmann::json& texts) {
    std::vector<std::vector<Rational>> points;
    for (const auto& point : texts) points.push_back(test::rationals(point));
    return points;
}

std::vector<Vec3> planar(const std::vector<std::vector<Rational>>& exact) {
    std::vector<Vec3> points;
    for (const auto& point : exact) points.emplace_back(point[0].value(), point[1].value(), 0);
    return points;
}

BsplineCurve planarCurve(const KnotVector& knots, const std::vector<Vec3>& points,
                         std::vector<double> weights = {}) {
    return BsplineCurve::make(knots, points, 2, std::move(weights)).value();
}

const BsplineCurve& quadCurve() {
    static const BsplineCurve curve = [] {
        const auto& given = test::truth("quad_curve");
        const auto knots = test::doubles(test::rationals(given["knots"]));
        return planarCurve(KnotVector::make(knots, 2, 5, Form::clamped).value(),
                           planar(exactPoints(given["ctrl"])));
    }();
    return curve;
}

BsplineCurve closedCubic() {
    return planarCurve(KnotVector::uniform(3, 5, Form::closed).value(),
                       planar(exactPoints(test::truth("closed_cubic_uniform")["ctrl"])));
}

void expectPoints(const BsplineCurve& curve, const nlohmann::json& expected) {
    for (const auto& [t, point] : expected.items()) {
        const auto exact = test::rationals(point);
        const Vec3 found = curve.point(Rational::parse(t).value());
        EXPECT_NEAR(found.x, exact[0].value(), test::gates::exact) << "t = " << t;
        EXPECT_NEAR(found.y, exact[1].value(), test::gates::exact) << "t = " << t;
    }
}

TEST(BsplineCurve, AgreesWithTheExactPointsOfTheQuadratic) {
    expectPoints(quadCurve(), test::truth("quad_curve")["pts"]);
}

TEST(BsplineCurve, AgreesWithTheExactPointsOfTheClosedCubic) {
    expectPoints(closedCubic(), test::truth("closed_cubic_uniform")["pts"]);
}

TEST(BsplineCurve, DerivativeOfTheQuadraticIsExact) {
    std::array<Vec3, 2> rows;
    quadCurve().derivatives(2, Side::right, rows);
    EXPECT_NEAR(rows[1].x, 4.0 / 3, test::gates::exact);
    EXPECT_NEAR(rows[1].y, -2.0 / 3, test::gates::exact);
}

// The same kernels without rounding: what is left is the formula.
TEST(BsplineCurve, DeBoorIsExactOnRationals) {
    for (const char* name : {"quad_curve", "closed_cubic_uniform"}) {
        const auto& given = test::truth(name);
        const BsplineCurve curve = name[0] == 'q' ? quadCurve() : closedCubic();
        const auto points = exactPoints(given["ctrl"]);
        std::vector<Rational> knots;
        for (const double t : curve.knotVector().extended()) {
            knots.emplace_back(static_cast<long long>(t));
        }
        for (const auto& [text, expected] : given["pts"].items()) {
            const Rational t = Rational::parse(text);
            const std::size_t span = curve.knotVector().findSpan(t.value());
            const auto degree = static_cast<std::size_t>(curve.degree());
            for (std::size_t axis = 0; axis < 2; ++axis) {
                std::vector<Rational> active;
                for (std::size_t j = 0; j <= degree; ++j) {
                    active.push_back(points[curve.knotVector().pointIndex(span, j)][axis]);
                }
                EXPECT_EQ(kernels::deBoor(std::span<const Rational>(knots), degree, span, t,
                                          std::span(active)),
                          test::rationals(expected)[axis])
                    << name << " at " << text;
            }
        }
    }
}

TEST(BsplineCurve, DeBoorAgreesWithTheBasisForm) {
    RandomSplines random(31);
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        std::vector<double> row(curve.points().size());
        for (const double t : test::telltaleParameters(curve.knotVector(), random)) {
            basisRows(curve.knotVector(), t, Side::right, 0, row);
            Vec3 sum(0);
            for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * curve.points()[i];
            ASSERT_LE(distance(sum, curve.point(t)), test::gates::basisAgainstDeBoor);
        }
    }
}

// The k-th derivative in homogeneous coordinates at a complex parameter.
std::array<Complex, 4> lifted(const BsplineCurve& curve, std::size_t span, std::size_t order,
                              Complex t) {
    const auto degree = static_cast<std::size_t>(curve.degree());
    std::vector<Complex> values(degree + 1);
    kernels::basisDerivative(curve.knotVector().extended(), degree, span, order, t,
                             std::span(values));
    std::array<Complex, 4> sum{};
    for (std::size_t j = 0; j <= degree; ++j) {
        const std::size_t i = curve.knotVector().pointIndex(span, j);
        const Complex factor = values[j] * (curve.weights().empty() ? 1 : curve.weights()[i]);
        for (int axis = 0; axis < 3; ++axis) {
            sum[static_cast<std::size_t>(axis)] += factor * curve.points()[i][axis];
        }
        sum[3] += factor;
    }
    return sum;
}

void expectRow(const Vec3& row, const std::array<Complex, 4>& below, double step) {
    const Vec3 expected = Vec3(below[0].imag(), below[1].imag(), below[2].imag()) / step;
    ASSERT_LE(distance(row, expected),
              test::gates::complexStep * std::max(1.0, glm::length(expected)));
}

TEST(BsplineCurve, DerivativesAgreeWithTheComplexStep) {
    constexpr double step = 1e-30;
    RandomSplines random(32);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        std::vector<Vec3> rows(static_cast<std::size_t>(curve.degree()) + 2);
        for (const double t : test::telltaleParameters(curve.knotVector(), random, 5)) {
            for (const Side side : test::bothSides) {
                const double inside = curve.knotVector().wrap(t, side);
                const std::size_t span = curve.knotVector().findSpan(inside, side);
                curve.derivatives(t, side, rows);
                for (std::size_t k = 1; k < rows.size(); ++k) {
                    expectRow(rows[k], lifted(curve, span, k - 1, Complex(inside, step)), step);
                }
            }
        }
    }
}

TEST(BsplineCurve, FirstDerivativeOfARationalCurveAgreesWithTheComplexStep) {
    constexpr double step = 1e-30;
    RandomSplines random(33);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve = random.curve(random.form(), SplineKind{.rational = true});
        std::array<Vec3, 2> rows;
        for (const double t : test::telltaleParameters(curve.knotVector(), random, 5)) {
            const std::size_t span = curve.knotVector().findSpan(curve.knotVector().wrap(t));
            curve.derivatives(t, Side::right, rows);
            auto below = lifted(curve, span, 0, Complex(curve.knotVector().wrap(t), step));
            for (std::size_t axis = 0; axis < 3; ++axis) below[axis] /= below[3];
            expectRow(rows[1], below, step);
        }
    }
}

TEST(BsplineCurve, PointIsTheFirstRowOfTheDerivatives) {
    RandomSplines random(34);
    for (int round = 0; round < 200; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 2 == 0});
        std::array<Vec3, 1> rows;
        for (const double t : test::telltaleParameters(curve.knotVector(), random)) {
            curve.derivatives(t, Side::right, rows);
            ASSERT_LE(distance(rows[0], curve.point(t)), test::gates::basisAgainstDeBoor);
        }
    }
}

// C^(d-m) and no more: the first derivative that may jump does.
TEST(BsplineCurve, SmoothnessAtAKnotIsDegreeMinusMultiplicity) {
    RandomSplines random(35);
    for (int round = 0; round < 200; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const auto rowCount = static_cast<std::size_t>(curve.degree()) + 1;
        std::vector<Vec3> left(rowCount);
        std::vector<Vec3> right(rowCount);
        for (const double t : curve.knotVector().knots()) {
            const Interval domain = curve.domain();
            if (!curve.closed() && (t <= domain.start || t >= domain.end)) continue;
            curve.derivatives(t, Side::left, left);
            curve.derivatives(t, Side::right, right);
            const int smooth = curve.degree() - curve.knotVector().multiplicity(t);
            for (int k = 0; k <= smooth; ++k) {
                const auto row = static_cast<std::size_t>(k);
                ASSERT_LE(distance(left[row], right[row]),
                          test::gates::complexStep * std::max(1.0, glm::length(right[row])));
            }
            const auto jump = static_cast<std::size_t>(smooth + 1);
            ASSERT_GT(distance(left[jump], right[jump]), 1e-6);
        }
    }
}

TEST(BsplineCurve, FullKnotIsAGapBetweenTwoControlPoints) {
    const auto knots = KnotVector::make({0, 0, 0, 1, 1, 1, 2, 2, 2}, 2, 6, Form::clamped).value();
    const auto curve =
        planarCurve(knots, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {5, 1, 0}, {6, 3, 0}, {7, 1, 0}});
    std::array<Vec3, 1> left;
    curve.derivatives(1, Side::left, left);
    EXPECT_EQ(left[0], Vec3(2, 0, 0));
    EXPECT_EQ(curve.point(1), Vec3(5, 1, 0));
}

TEST(BsplineCurve, ClampedCurveEndsExactlyInItsEndPoints) {
    RandomSplines random(36);
    for (int round = 0; round < 100; ++round) {
        const BsplineCurve curve = random.curve(Form::clamped);
        EXPECT_EQ(curve.point(curve.domain().start), curve.points().front());
        EXPECT_EQ(curve.point(curve.domain().end), curve.points().back());
    }
}

TEST(BsplineCurve, ClosedCurveContinuesByItsPeriod) {
    RandomSplines random(37);
    for (int round = 0; round < 100; ++round) {
        const BsplineCurve curve = random.curve(Form::closed);
        const double period = curve.domain().length();
        EXPECT_EQ(curve.point(curve.domain().start), curve.point(curve.domain().end));
        const double t = random.real(curve.domain().start, curve.domain().end);
        EXPECT_LE(distance(curve.point(t), curve.point(t + 3 * period)), 1e-12);
        EXPECT_LE(distance(curve.point(t), curve.point(t - 2 * period)), 1e-12);
    }
}

TEST(BsplineCurve, OtherCurvesContinueByTheirEndPieces) {
    std::array<Vec3, 3> rows;
    for (const auto& [end, t] : {std::pair{4.0, 5.5}, std::pair{0.0, -1.25}}) {
        quadCurve().derivatives(end, Side::right, rows);
        const double h = t - end;
        const Vec3 taylor = rows[0] + h * rows[1] + h * h / 2 * rows[2];
        EXPECT_LE(distance(quadCurve().point(t), taylor), 1e-13);
    }
}

TEST(BsplineCurve, FirstRowsDoNotDependOnHowManyAreAskedFor) {
    RandomSplines random(38);
    const BsplineCurve curve = random.curve(Form::clamped, SplineKind{.rational = true});
    std::array<Vec3, 3> few;
    std::array<Vec3, 40> many;
    curve.derivatives(curve.domain().start + 0.1, Side::right, few);
    curve.derivatives(curve.domain().start + 0.1, Side::right, many);
    for (std::size_t k = 0; k < few.size(); ++k) EXPECT_EQ(few[k], many[k]);
    curve.derivatives(0, Side::right, std::span<Vec3>());
}

TEST(BsplineCurve, DerivativesBeyondTheDegreeAreZero) {
    std::array<Vec3, 5> rows;
    rows.fill(Vec3(1));
    quadCurve().derivatives(2, Side::right, rows);
    EXPECT_NE(rows[2], Vec3(0));
    EXPECT_EQ(rows[3], Vec3(0));
    EXPECT_EQ(rows[4], Vec3(0));
}

BsplineCurve quarterCircle() {
    const double w = std::numbers::sqrt2 / 2;
    return planarCurve(KnotVector::uniform(2, 3, Form::clamped).value(),
                       {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, w, 1});
}

// |C|² = 1 and its derivatives: C·C' = 0, C'·C' + C·C'' = 0, 3C'·C'' + C·C''' = 0.
TEST(BsplineCurve, WeightsMakeAnExactCircle) {
    const BsplineCurve circle = quarterCircle();
    std::array<Vec3, 4> c;
    for (int i = 0; i <= 64; ++i) {
        circle.derivatives(i / 64.0, Side::right, c);
        EXPECT_NEAR(glm::length(circle.point(i / 64.0)), 1, test::gates::exact);
        EXPECT_NEAR(glm::dot(c[0], c[1]), 0, 5 * test::gates::exact);
        EXPECT_NEAR(glm::dot(c[1], c[1]) + glm::dot(c[0], c[2]), 0, 5 * test::gates::exact);
        EXPECT_NEAR(3 * glm::dot(c[1], c[2]) + glm::dot(c[0], c[3]), 0, 1e-12);
    }
}

TEST(BsplineCurve, EqualWeightsChangeNothing) {
    RandomSplines random(39);
    const BsplineCurve plain = random.curve(Form::closed);
    const std::vector<double> weights(plain.points().size(), 0.3);
    const auto weighted =
        BsplineCurve::make(plain.knotVector(), {plain.points().begin(), plain.points().end()}, 3,
                           weights)
            .value();
    EXPECT_FALSE(weighted.rational());
    EXPECT_EQ(std::vector<double>(weighted.weights().begin(), weighted.weights().end()), weights);
    for (const double t : test::telltaleParameters(plain.knotVector(), random)) {
        EXPECT_EQ(plain.point(t), weighted.point(t));
    }
}

TEST(BsplineCurve, CommonFactorOfTheWeightsChangesNothing) {
    RandomSplines random(40);
    const BsplineCurve curve = random.curve(Form::clamped, SplineKind{.rational = true});
    std::vector<double> weights(curve.weights().begin(), curve.weights().end());
    for (double& weight : weights) weight *= 1e6;
    const auto scaled =
        BsplineCurve::make(curve.knotVector(), {curve.points().begin(), curve.points().end()}, 3,
                           weights)
            .value();
    for (const double t : test::telltaleParameters(curve.knotVector(), random)) {
        EXPECT_LE(distance(curve.point(t), scaled.point(t)), test::gates::exact);
    }
}

struct Refused {
    std::vector<Vec3> points;
    int dimension;
    std::vector<double> weights;
    Code code;
    const char* path;
};

void PrintTo(const Refused& refused, std::ostream* out) {
    *out << codeName(refused.code) << " at " << refused.path;
}

class BsplineCurveRefuses : public testing::TestWithParam<Refused> {};

TEST_P(BsplineCurveRefuses, WithCodeAndPath) {
    const Refused& given = GetParam();
    const auto made = BsplineCurve::make(KnotVector::uniform(2, 3, Form::clamped).value(),
                                         given.points, given.dimension, given.weights);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(codeName(made.error().code), codeName(given.code));
    EXPECT_EQ(made.error().path, given.path);
    EXPECT_FALSE(made.error().message.empty());
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<Vec3> three{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};

INSTANTIATE_TEST_SUITE_P(
    Input, BsplineCurveRefuses,
    testing::Values(
        Refused{{{0, 0, 0}, {1, 1, 0}}, 2, {}, Code::wrongLength, "points"},
        Refused{{}, 2, {}, Code::wrongLength, "points"},
        Refused{{{0, 0, 0}, {1, nan, 0}, {2, 0, 0}}, 2, {}, Code::notFinite, "points[1]"},
        Refused{{{0, 0, 0}, {1, 0, 0}, {infinity, 0, 0}}, 3, {}, Code::notFinite, "points[2]"},
        Refused{{{-2e12, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 3, {}, Code::outOfRange, "points[0]"},
        Refused{{{0, 0, 0}, {1, 0, 3}, {2, 0, 0}}, 2, {}, Code::outOfRange, "points[1]"},
        Refused{three, 4, {}, Code::outOfRange, "dimension"},
        Refused{three, 2, {1, 1}, Code::wrongLength, "weights"},
        Refused{three, 2, {1, 0, 1}, Code::outOfRange, "weights[1]"},
        Refused{three, 2, {-1, 1, 1}, Code::outOfRange, "weights[0]"},
        Refused{three, 2, {1, 1, nan}, Code::notFinite, "weights[2]"},
        Refused{three, 2, {1, 1, 1e10}, Code::outOfRange, "weights[2]"}));

TEST(BsplineCurve, OneCoordinateOfAnyPointIsEnoughToRefuseIt) {
    const KnotVector knots = KnotVector::uniform(2, 5, Form::clamped).value();
    for (std::size_t i = 0; i < 5; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double bad : {nan, infinity, -infinity, 1.1e12, -1.1e12}) {
                std::vector<Vec3> points(5, Vec3(1e12, -1e12, 1e12));
                ASSERT_TRUE(BsplineCurve::make(knots, points, 3).ok());
                points[i][axis] = bad;
                const auto made = BsplineCurve::make(knots, points, 3);
                ASSERT_FALSE(made.ok()) << i << ", " << axis << ", " << bad;
                EXPECT_EQ(made.error().path, "points[" + std::to_string(i) + "]");
            }
        }
        for (const double z : {1.0, -1.0, nan}) {
            std::vector<Vec3> points(5, Vec3(1, 2, 0));
            points[i].z = z;
            const auto made = BsplineCurve::make(knots, points, 2);
            ASSERT_FALSE(made.ok()) << i << ", " << z;
            EXPECT_EQ(made.error().path, "points[" + std::to_string(i) + "]");
        }
    }
}

}  // namespace
}  // namespace knotwork
