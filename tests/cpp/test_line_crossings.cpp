#include "geometry/line_crossings.hpp"

#include "geometry/degree_elevation.hpp"
#include "geometry/refinement.hpp"
#include "geometry/smooth_pieces.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knotwork::test {
namespace {

constexpr PlaneLine xAxis{};

Curve bezier(std::vector<Vec3> points, std::vector<double> weights = {}) {
    return BezierCurve::make(std::move(points), std::move(weights), {0, 1}).value();
}

/// The graph of a polynomial of degree 3 or less over [0, 1] by its Bernstein coefficients.
Curve graph(const std::vector<double>& coefficients) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        points.emplace_back(static_cast<double>(i) / static_cast<double>(coefficients.size() - 1),
                            coefficients[i], 0);
    }
    return bezier(std::move(points));
}

std::size_t onCurve(const Curve& curve, const PlaneLine& line = xAxis) {
    return lineCrossings(curve, line)->curve.size();
}
std::size_t onPolygon(const Curve& curve, const PlaneLine& line = xAxis) {
    return lineCrossings(curve, line)->polygon.size();
}

double distanceOf(const PlaneLine& line, const Vec3& p) {
    const Vec3 normal = glm::normalize(Vec3(-line.direction.y, line.direction.x, 0));
    return glm::dot(normal, p - line.point);
}

Vec3 pointFrom(const Curve& curve, double t, Side side) {
    Vec3 point;
    evaluate(curve, t, side, {&point, 1});
    return point;
}

/// Changes of sign between many samples of every piece, not counting jumps: never more than there are
/// crossings.
int sampledCrossings(const Curve& curve, const PlaneLine& line) {
    int count = 0;
    double former = 0;
    double first = 0;
    const Interval whole = domain(curve);
    Vec3 last = pointFrom(curve, whole.start, Side::right);
    bool begun = true;  // no jump so far
    for (const Interval& piece : smoothPieces(curve)) {
        if (glm::length(pointFrom(curve, piece.start, Side::right) - last) > 1e-9) {
            former = 0;
            begun = false;
        }
        for (std::size_t i = 0; i <= 200; ++i) {
            const double t = uniformParameter(piece, i, 201);
            last = pointFrom(curve, t, i == 200 ? Side::left : Side::right);
            const double now = distanceOf(line, last);
            if (std::abs(now) <= 1e-9) continue;
            if (former * now < 0) ++count;
            if (first == 0 && begun) first = now;
            former = now;
        }
    }
    const bool seam = isClosed(curve) && glm::length(pointFrom(curve, whole.start, Side::right) - last) < 1e-9;
    return count + (seam && first * former < 0 ? 1 : 0);
}

TEST(LineCrossings, AreThoseOfACubicWithThreeRoots) {
    // (t − 1/4)(t − 1/2)(t − 3/4) in Bernstein form: −3/32, 13/96, −13/96, 3/32.
    const auto found = lineCrossings(graph({-3.0 / 32, 13.0 / 96, -13.0 / 96, 3.0 / 32}), xAxis);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->curve.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(found->curve[k].t, 0.25 * static_cast<double>(k + 1), 1e-14);
        EXPECT_NEAR(found->curve[k].point.y, 0, 1e-16);
    }
    ASSERT_EQ(found->polygon.size(), 3U);
    EXPECT_NEAR(found->polygon[1].x, 0.5, 1e-15);
    EXPECT_NEAR(found->polygon[0].x, 9.0 / 22 / 3, 1e-15);
}

TEST(LineCrossings, ContactIsNoneWhereverItIs) {
    for (const double t : {0.5, 1.0 / 3, 0.1234567, 1e-3, 0.999}) {
        // (s − t)² is positive but for s = t.
        EXPECT_EQ(onCurve(graph({t * t, t * t - t, (1 - t) * (1 - t)})), 0U) << t;
        // (s − t)³ crosses where it rests.
        const double a = -t, b = 1 - t;
        const Curve rests = graph({a * a * a, a * a * b, a * b * b, b * b * b});
        ASSERT_EQ(onCurve(rests), 1U) << t;
        EXPECT_NEAR(lineCrossings(rests, xAxis)->curve[0].t, t, 1e-4);
    }
    EXPECT_EQ(onCurve(graph({0, -1, 0})), 0U);          // both ends on the line
    EXPECT_EQ(onCurve(graph({0, 1, -1})), 1U);          // begins on it and crosses later
    EXPECT_EQ(onCurve(graph({1, 0, 0, 1})), 0U);
    EXPECT_EQ(onCurve(graph({0, 0, 0})), 0U);
}

TEST(LineCrossings, TwoThatAreNearlyOneAreTwo) {
    for (const double apart : {1e-1, 1e-3, 1e-5}) {
        const double a = 0.4 - apart / 2, b = 0.4 + apart / 2;
        // (s − a)(s − b)
        const Curve curve = graph({a * b, a * b - (a + b) / 2, (1 - a) * (1 - b)});
        const auto found = lineCrossings(curve, xAxis);
        ASSERT_EQ(found->curve.size(), 2U) << apart;
        EXPECT_NEAR(found->curve[0].t, a, 1e-10);
        EXPECT_NEAR(found->curve[1].t, b, 1e-10);
    }
}

TEST(LineCrossings, ADipBelowTheToleranceIsContact) {
    const double apart = 1e-7;  // a dip of 2.5e-15
    const double a = 0.4 - apart / 2, b = 0.4 + apart / 2;
    EXPECT_EQ(onCurve(graph({a * b, a * b - (a + b) / 2, (1 - a) * (1 - b)})), 0U);
}

TEST(LineCrossings, AreNoMoreOfTheCurveThanOfItsPolygon) {
    RandomSplines random(83);
    int all = 0;
    int less = 0;
    for (int i = 0; i < 3000; ++i) {
        SplineKind kind;
        kind.dimension = 2 + i % 2;
        kind.rational = i % 3 == 0;
        const Curve curve = random.curve(random.form(), kind);
        const double angle = random.real(0, 2 * std::numbers::pi);
        const PlaneLine line{{random.real(-0.6, 0.6), random.real(-0.6, 0.6), 0},
                             {3 * std::cos(angle), 3 * std::sin(angle), 0}};
        const auto found = lineCrossings(curve, line);
        EXPECT_LE(found->curve.size(), found->polygon.size());
        EXPECT_GE(static_cast<int>(found->curve.size()), sampledCrossings(curve, line));
        for (const Crossing& crossing : found->curve) {
            EXPECT_TRUE(domain(curve).contains(crossing.t));
            EXPECT_NEAR(distanceOf(line, crossing.point), 0, 1e-12);
        }
        for (const Vec3& p : found->polygon) EXPECT_NEAR(distanceOf(line, p), 0, 1e-14);
        for (std::size_t k = 1; k < found->curve.size(); ++k) {
            EXPECT_LT(found->curve[k - 1].t, found->curve[k].t);
        }
        if (isClosed(curve)) {
            EXPECT_EQ(found->polygon.size() % 2, 0U);
        }
        all += static_cast<int>(found->curve.size());
        less += int{found->curve.size() < found->polygon.size()};
    }
    EXPECT_GT(all, 4000);
    EXPECT_GT(less, 200);
}

TEST(LineCrossings, AClosedCurveIsCrossedAnEvenNumberOfTimesAlsoAtItsSeam) {
    const std::vector<Vec3> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    for (int degree = 1; degree <= 3; ++degree) {
        std::vector<double> knots{0, 1, 2, 3, 4};
        const Curve curve = BsplineCurve::make(
            KnotVector::make(knots, degree, 4, Form::closed).value(), square, 2).value();
        const Vec3 seam = pointAt(curve, 0);
        for (double angle = 0.1; angle < 3; angle += 0.37) {
            const PlaneLine line{seam, {std::cos(angle), std::sin(angle), 0}};
            const std::size_t count = onCurve(curve, line);
            EXPECT_EQ(count % 2, 0U) << degree << " " << angle;
        }
        EXPECT_EQ(onCurve(curve, {seam, -seam}), 2U);  // through the seam and the centre
        EXPECT_EQ(onPolygon(curve, {seam, -seam}), 2U);
    }
}

TEST(LineCrossings, AJumpAtAGapIsNone) {
    const std::vector<double> knots{0, 0, 1, 1, 2, 2};
    const Curve curve = BsplineCurve::make(
        KnotVector::make(knots, 1, 4, Form::clamped).value(),
        {{0, 1, 0}, {1, 1, 0}, {1, -1, 0}, {2, -1, 0}}, 2).value();
    EXPECT_EQ(onCurve(curve), 0U);
    EXPECT_EQ(onPolygon(curve), 1U);
    EXPECT_EQ(onCurve(curve, {{0.5, 0, 0}, {0, 1, 0}}), 1U);
}

TEST(LineCrossings, ABumpBetweenTwoKnotsOnTheLineIsCrossedTwice) {
    const std::vector<double> knots{0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
    const Curve curve = BsplineCurve::make(
        KnotVector::make(knots, 2, 7, Form::clamped).value(),
        {{0, -1, 0}, {1, -0.5, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 0}, {5, -0.5, 0}, {6, -1, 0}}, 2).value();
    const auto found = lineCrossings(curve, xAxis);
    ASSERT_EQ(found->curve.size(), 2U);
    EXPECT_NEAR(found->curve[0].t, 1, 1e-9);
    EXPECT_NEAR(found->curve[1].t, 2, 1e-9);
    EXPECT_EQ(found->polygon, (std::vector<Vec3>{{2, 0, 0}, {4, 0, 0}}));
}

TEST(LineCrossings, StayWhenKnotsComeInAndThePolygonsBecomeFewer) {
    RandomSplines random(29);
    for (int i = 0; i < 200; ++i) {
        SplineKind kind;
        kind.dimension = 2;
        const BsplineCurve curve = random.curve(Form::clamped, kind);
        const PlaneLine line{{random.real(-0.3, 0.3), random.real(-0.3, 0.3), 0}, {1, random.real(-2, 2), 0}};
        const auto before = lineCrossings(curve, line);
        const Interval whole = curve.domain();
        const auto refined = insertKnot(curve, random.real(whole.start + 0.1 * whole.length(), whole.end - 0.1 * whole.length()), 1);
        if (!refined) continue;
        const auto after = lineCrossings(*refined, line);
        EXPECT_EQ(after->curve.size(), before->curve.size());
        EXPECT_LE(after->polygon.size(), before->polygon.size());
    }
}

TEST(LineCrossings, OfASubdivisionCurveAreThoseOfItsPolyline) {
    CurveSubdivision made;
    made.scheme = CurveScheme::laneRiesenfeld;
    made.degree = 3;
    made.levels = 4;
    made.closed = true;
    made.points = {{0, 0, 0}, {2, 2, 0}, {4, -2, 0}, {6, 2, 0}, {8, -2, 0}, {4, -6, 0}};
    const Curve curve = SubdivisionCurve::make(made).value();
    const auto found = lineCrossings(curve, {{0, 0.3, 0}, {1, 0.02, 0}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->curve.size() % 2, 0U);
    EXPECT_GE(found->curve.size(), 2U);
    EXPECT_LE(found->curve.size(), found->polygon.size());
    for (const Crossing& crossing : found->curve) {
        EXPECT_LT(glm::length(pointAt(curve, crossing.t) - crossing.point), 1e-13);
    }
}

TEST(LineCrossings, ThereAreNoneOfACurveWithoutControlPolygon) {
    EXPECT_FALSE(lineCrossings(LineCurve::make({0, -1, 0}, {0, 1, 0}, {0, 1}).value(), xAxis));
}

}  // namespace
}  // namespace knotwork::test
