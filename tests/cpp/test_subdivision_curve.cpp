#include "geometry/subdivision_curve.hpp"

#include "geometry/bspline_curve.hpp"
#include "geometry/curve.hpp"
#include "geometry/tessellation.hpp"
#include "support/gates.hpp"
#include "support/polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::chaikin;
using test::farthest;
using test::fourPoint;
using test::laneRiesenfeld;
using test::wholePoints;

constexpr double rounding = 1e-12;  // coordinates up to 50

SubdivisionCurve curveOf(CurveSubdivision s) { return SubdivisionCurve::make(std::move(s)).value(); }

BsplineCurve limitOf(int degree, const std::vector<Vec3>& points, bool closed) {
    const Form form = closed ? Form::closed : Form::open;
    const int count = static_cast<int>(points.size());
    return BsplineCurve::make(KnotVector::uniform(degree, count, form).value(), points, 3).value();
}

Vec3 row(const SubdivisionCurve& curve, double t, Side side, std::size_t order) {
    std::vector<Vec3> rows(order + 1);
    curve.evaluate(t, side, rows);
    return rows[order];
}

// ---- The parameter -----------------------------------------------------------------------------

/// The largest distance of curve and spline at equal parameters, eight a leg.
double deviation(const SubdivisionCurve& curve, const BsplineCurve& spline) {
    const Interval whole = curve.domain();
    const int steps = static_cast<int>(whole.length()) * 8 << curve.subdivision().levels;
    double largest = 0;
    for (int i = 0; i <= steps; ++i) {
        const double t = whole.start + whole.length() * i / steps;
        largest = std::max(largest, glm::length(row(curve, t, Side::left, 0) - spline.point(t)));
    }
    return largest;
}

TEST(SubdivisionCurve, ComesFourTimesAsNearToTheBsplineOfTheSameParameterWithEveryLevel) {
    for (const int degree : {2, 3, 4, 5, 8}) {
        for (const bool closed : {true, false}) {
            const auto points = wholePoints(11, 21);
            const BsplineCurve spline = limitOf(degree, points, closed);
            const double coarse = deviation(curveOf(laneRiesenfeld(degree, points, closed, 6)), spline);
            const double fine = deviation(curveOf(laneRiesenfeld(degree, points, closed, 7)), spline);
            EXPECT_NEAR(coarse / fine, 4, 0.01) << degree << (closed ? " closed" : " open");
        }
    }
}

TEST(SubdivisionCurve, OfDegreeOneIsTheBsplineOfDegreeOne) {
    for (const bool closed : {true, false}) {
        const auto points = wholePoints(11, 22);
        const auto curve = curveOf(laneRiesenfeld(1, points, closed, 3));
        EXPECT_LE(deviation(curve, limitOf(1, points, closed)), rounding);
    }
}

TEST(SubdivisionCurve, HasTheDomainOfTheUniformBspline) {
    const auto points = wholePoints(7, 23);
    EXPECT_EQ(curveOf(laneRiesenfeld(3, points, true, 2)).domain(), (Interval{0, 7}));
    EXPECT_EQ(curveOf(laneRiesenfeld(3, points, false, 2)).domain(), (Interval{3, 7}));
    EXPECT_EQ(curveOf(chaikin(points, true, 2)).domain(), (Interval{0, 7}));
    EXPECT_EQ(curveOf(chaikin(points, false, 2)).domain(), (Interval{2, 7}));
    EXPECT_EQ(curveOf(fourPoint(0.05, points, true, 2)).domain(), (Interval{0, 7}));
    EXPECT_EQ(curveOf(fourPoint(0.05, points, false, 2)).domain(), (Interval{0, 6}));
}

struct Sample {
    CurveSubdivision subdivision;
    double first;  // the parameter of the first vertex, from the header's formulas
};

std::vector<Sample> samples() {
    const auto points = wholePoints(9, 24);
    const double h = 1.0 / 8;
    return {{laneRiesenfeld(1, points, true, 3), 0},     {laneRiesenfeld(1, points, false, 3), 1},
            {laneRiesenfeld(3, points, true, 3), -h},    {laneRiesenfeld(3, points, false, 3), 3 - h},
            {laneRiesenfeld(6, points, true, 3), -2.5 * h}, {chaikin(points, true, 3), -h / 2},
            {chaikin(points, false, 3), 2 - h / 2},      {fourPoint(0.07, points, true, 3), 0},
            {fourPoint(0.07, points, false, 3), 0}};
}

TEST(SubdivisionCurve, PassesEveryVertexAtItsParameterFromBothSides) {
    for (const auto& [subdivision, first] : samples()) {
        const auto curve = curveOf(subdivision);
        const auto vertices = curve.vertices();
        for (std::size_t j = 0; j < vertices.size(); ++j) {
            const double t = first + static_cast<double>(j) / 8;
            EXPECT_EQ(row(curve, t, Side::left, 0), vertices[j]) << j;
            EXPECT_EQ(row(curve, t, Side::right, 0), vertices[j]) << j;
        }
    }
}

TEST(SubdivisionCurve, HasTheSlopesOfItsLegsAndCornersBetweenThem) {
    for (const auto& [subdivision, first] : samples()) {
        const auto curve = curveOf(subdivision);
        const auto vertices = curve.vertices();
        for (std::size_t j = 1; j + 1 < vertices.size(); ++j) {
            const double t = first + static_cast<double>(j) / 8;
            EXPECT_EQ(row(curve, t, Side::left, 1), 8.0 * (vertices[j] - vertices[j - 1]));
            EXPECT_EQ(row(curve, t, Side::right, 1), 8.0 * (vertices[j + 1] - vertices[j]));
            EXPECT_EQ(row(curve, t + 1.0 / 32, Side::right, 1), row(curve, t, Side::right, 1));
            EXPECT_LE(glm::length(row(curve, t + 1.0 / 32, Side::right, 0) -
                                  (0.75 * vertices[j] + 0.25 * vertices[j + 1])), rounding);
            EXPECT_EQ(row(curve, t, Side::right, 2), Vec3(0));
        }
    }
}

TEST(SubdivisionCurve, BreaksAtTheVerticesInTheDomain) {
    for (const auto& [subdivision, first] : samples()) {
        const auto curve = curveOf(subdivision);
        const Interval whole = curve.domain();
        std::vector<double> expected;
        for (std::size_t j = 0; j < curve.vertices().size(); ++j) {
            double t = first + static_cast<double>(j) / 8;
            if (curve.closed() && t < 0) t += whole.length();
            if (whole.contains(t)) expected.push_back(t);
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(std::vector<double>(curve.breaks().begin(), curve.breaks().end()), expected);
    }
}

TEST(SubdivisionCurve, ClosesAndWraps) {
    for (const auto& [subdivision, first] : samples()) {
        if (!subdivision.closed) continue;
        const auto curve = curveOf(subdivision);
        EXPECT_EQ(row(curve, 0, Side::right, 0), row(curve, 9, Side::left, 0));
        for (const double t : {0.0, 0.3, 4.0, 8.99}) {
            EXPECT_LE(glm::length(row(curve, t + 18, Side::right, 0) - row(curve, t, Side::right, 0)),
                      rounding);
            EXPECT_LE(glm::length(row(curve, t - 9, Side::left, 1) - row(curve, t, Side::left, 1)),
                      rounding);
        }
    }
}

TEST(SubdivisionCurve, AnOpenOneIsContinuedByTheRestOfItsPolygonAndThenStraightOn) {
    const auto curve = curveOf(laneRiesenfeld(5, wholePoints(9, 25), false, 0));
    const auto p = curve.vertices();
    EXPECT_EQ(row(curve, 3, Side::left, 0), p[0]);
    EXPECT_EQ(row(curve, 4, Side::left, 0), p[1]);
    EXPECT_EQ(row(curve, 1, Side::right, 0), p[0] - 2.0 * (p[1] - p[0]));
    EXPECT_EQ(row(curve, 12, Side::right, 0), p[8] + (p[8] - p[7]));
}

TEST(SubdivisionCurve, IsItsOwnPolyline) {
    for (const auto& [subdivision, first] : samples()) {
        const Curve curve(curveOf(subdivision));
        const Polyline line = polyline(curve, 1e-9);
        const Interval whole = domain(curve);
        EXPECT_EQ(line.parameters.front(), whole.start);
        EXPECT_EQ(line.parameters.back(), whole.end);
        EXPECT_LE(line.parameters.size(), curve.as<SubdivisionCurve>()->vertices().size() + 2);
        for (std::size_t i = 0; i + 1 < line.parameters.size(); ++i) {
            const double middle = (line.parameters[i] + line.parameters[i + 1]) / 2;
            const auto at = [&](std::size_t k) {
                return Vec3(line.xyz[3 * k], line.xyz[3 * k + 1], line.xyz[3 * k + 2]);
            };
            EXPECT_LE(glm::length(pointAt(curve, middle) - 0.5 * (at(i) + at(i + 1))), rounding);
        }
    }
}

TEST(SubdivisionCurve, IsSampledAsItIsEvaluated) {
    for (const auto& [subdivision, first] : samples()) {
        const Curve curve(curveOf(subdivision));
        std::vector<double> xyz(3 * 301);
        CurveSampler(curve).uniform(0, 301, 301, xyz);
        for (std::size_t i = 0; i < 301; ++i) {
            const Vec3 expected = pointAt(curve, uniformParameter(domain(curve), i, 301));
            EXPECT_LE(glm::length(Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]) - expected), rounding);
        }
    }
}

TEST(SubdivisionCurve, IsPlanarWhereAllPointsAre) {
    EXPECT_EQ(curveOf(chaikin(test::square(), true, 2)).dimension(), 2);
    EXPECT_EQ(curveOf(chaikin({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}}, true, 2)).dimension(), 3);
}

TEST(SubdivisionCurve, TakesAMillionPointsAndNoMore) {
    EXPECT_TRUE(SubdivisionCurve::make(chaikin(wholePoints(4, 26), true, 18)).ok());
    const auto refused = SubdivisionCurve::make(chaikin(wholePoints(4, 26), true, 19));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, Code::tooLarge);
    EXPECT_EQ(refused.error().path, "levels");
}

// ---- Limits ------------------------------------------------------------------------------------

TEST(SubdivisionLimits, OfCubicsAndOfChaikinHaveTheKnownStencils) {
    const auto p = wholePoints(8, 31);
    const auto cubic = curveOf(laneRiesenfeld(3, p, true, 2));
    const auto quadratic = curveOf(chaikin(p, true, 2));
    for (std::size_t i = 0; i < 8; ++i) {
        const Vec3& before = p[(i + 7) % 8];
        const Vec3& after = p[(i + 1) % 8];
        EXPECT_LE(glm::length(cubic.limitPoints()[i] - (before + 4.0 * p[i] + after) / 6.0), rounding);
        EXPECT_LE(glm::length(cubic.limitTangents().value()[i] - (after - before) / 2.0), rounding);
        EXPECT_LE(glm::length(quadratic.limitPoints()[i] - (before + 6.0 * p[i] + after) / 8.0),
                  rounding);
        EXPECT_LE(glm::length(quadratic.limitTangents().value()[i] - (after - before) / 2.0), rounding);
    }
}

TEST(SubdivisionLimits, LieOnTheBsplineAtTheParametersOfThePoints) {
    for (const int degree : {1, 2, 3, 4, 7, 9}) {
        const auto p = wholePoints(12, 32);
        const auto closed = curveOf(laneRiesenfeld(degree, p, true, 0));
        const auto open = curveOf(laneRiesenfeld(degree, p, false, 0));
        for (std::size_t i = 0; i < 12; ++i) {
            const double index = static_cast<double>(i);
            const Vec3 onRing = limitOf(degree, p, true).point(index - (degree - 1) / 2.0);
            EXPECT_LE(glm::length(closed.limitPoints()[i] - onRing), rounding);
            const double t = std::clamp(index + (degree + 1) / 2.0, double(degree), 12.0);
            EXPECT_LE(glm::length(open.limitPoints()[i] - limitOf(degree, p, false).point(t)), rounding);
        }
    }
}

/// Limits of a polygon and of the next one agree where they have a vertex in common (odd degrees and
/// the four-point scheme), tangents halved: with linear polygons, that is the definition of both.
void expectInvariant(const CurveSubdivision& s, std::ptrdiff_t shift, std::size_t first,
                     std::size_t last) {
    CurveSubdivision finer = s;
    finer.levels = 1;
    finer.points = test::subdivided(finer);
    const auto a = curveOf(s);
    const auto b = curveOf(finer);
    const auto count = static_cast<std::ptrdiff_t>(finer.points.size());
    for (std::size_t i = first; i < last; ++i) {
        const auto j = static_cast<std::size_t>(
            (2 * static_cast<std::ptrdiff_t>(i) + shift + count) % count);
        EXPECT_LE(glm::length(a.limitPoints()[i] - b.limitPoints()[j]), rounding) << i;
        EXPECT_LE(glm::length(a.limitTangents().value()[i] - 2.0 * b.limitTangents().value()[j]),
                  rounding) << i;
    }
}

TEST(SubdivisionLimits, DoNotChangeWithTheLevel) {
    const auto p = wholePoints(12, 33);
    for (const int degree : {3, 5, 9}) {
        expectInvariant(laneRiesenfeld(degree, p, true, 0), -(degree - 1) / 2, 0, 12);
        const auto reach = static_cast<std::size_t>(degree - 1) / 2;
        expectInvariant(laneRiesenfeld(degree, p, false, 0), -(degree - 1) / 2, reach, 12 - reach);
    }
    for (const double w : {0.01, 1.0 / 16, 0.15, 0.19}) {
        expectInvariant(fourPoint(w, p, true, 0), 0, 0, 12);
        expectInvariant(fourPoint(w, p, false, 0), 0, 0, 12);
        expectInvariant(fourPoint(w, {p[0], p[1]}, false, 0), 0, 0, 2);
        expectInvariant(fourPoint(w, {p[0], p[1], p[2]}, true, 0), 0, 0, 3);
    }
}

TEST(SubdivisionLimits, OfTheFourPointSchemeAreTheSlopesOfCubicsAndOfLines) {
    std::vector<Vec3> points;
    for (int i = 0; i < 9; ++i) points.emplace_back(i, i * i * (i - 5), 3 * i);
    const auto tangents = curveOf(fourPoint(1.0 / 16, points, false, 0)).limitTangents().value();
    for (int i = 2; i < 7; ++i) {
        const Vec3 slope(1, 3 * i * i - 10 * i, 3);
        EXPECT_LE(glm::length(tangents[static_cast<std::size_t>(i)] - slope), rounding);
    }
    for (Vec3& p : points) p.y = -p.x;
    for (const double w : {0.03, 0.18}) {
        const auto slopes = curveOf(fourPoint(w, points, false, 0)).limitTangents().value();
        for (const Vec3& slope : slopes) EXPECT_LE(glm::length(slope - Vec3(1, -1, 3)), rounding);
    }
}

TEST(SubdivisionLimits, AreWhatDeepLevelsComeTo) {
    const auto p = wholePoints(6, 34);
    for (const auto& s : {laneRiesenfeld(4, p, true, 14), chaikin(p, true, 14),
                          laneRiesenfeld(9, {p[0], p[1], p[2]}, true, 14),
                          fourPoint(0.08, p, true, 14), fourPoint(0.08, p, false, 14)}) {
        const auto curve = curveOf(s);
        const double h = std::ldexp(1.0, -14);
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const double t = static_cast<double>(i) - std::max(splineDegree(s) - 1, 0) / 2.0;
            EXPECT_LE(glm::length(row(curve, t, Side::right, 0) - curve.limitPoints()[i]), 1e-5);
            const double from = curve.closed() ? t - h : std::max(t - h, 0.0);
            const double to = curve.closed() ? t + h : std::min(t + h, 5.0);
            const Vec3 slope = (row(curve, to, Side::left, 0) - row(curve, from, Side::right, 0)) /
                               (to - from);
            EXPECT_LE(glm::length(slope - curve.limitTangents().value()[i]), 0.1) << i;
        }
    }
}

TEST(SubdivisionLimits, HaveNoTangentsWhereTheLimitHasCorners) {
    const auto p = wholePoints(6, 35);
    for (const double w : {-0.1, 0.0, 0.1928, 0.25, 1.0}) {
        const auto refused = curveOf(fourPoint(w, p, true, 1)).limitTangents();
        ASSERT_FALSE(refused.ok()) << w;
        EXPECT_EQ(refused.error().code, Code::notSupported);
        EXPECT_EQ(refused.error().path, "tension");
        EXPECT_EQ(curveOf(fourPoint(w, p, true, 1)).limitPoints(), p);
    }
    EXPECT_TRUE(curveOf(fourPoint(0.1927, p, true, 1)).limitTangents().ok());
    const auto refused = curveOf(laneRiesenfeld(1, p, true, 1)).limitTangents();
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, Code::notSupported);
    EXPECT_LE(farthest(curveOf(laneRiesenfeld(1, p, true, 1)).limitPoints(), p), 0);
}

}  // namespace
}  // namespace knotwork
