#include "drawing/curve_path.hpp"

#include "scene/specs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace knotwork::drawing {
namespace {

Curve curveOf(const std::string& text) {
    auto made = scene::makeCurve(scene::parseJson(text).value());
    EXPECT_TRUE(made.ok()) << text << ": " << (made.ok() ? "" : made.error().message);
    return made->value;
}

CurvePart whole(const Curve& curve) { return {curve, domain(curve), {}}; }

Vec3 onStep(const Vec3& from, const PathStep& step, double s) {
    if (step.kind != PathStep::Kind::cubic) return from + s * (step.end - from);
    const double r = 1 - s;
    return r * r * r * from + 3 * r * r * s * step.first + 3 * r * s * s * step.second +
           s * s * s * step.end;
}

/// The steps of a polynomial curve are its spans: each is the span at equal parameters.
void expectExact(const Curve& curve, PathStep::Kind kind) {
    const std::vector<PathStep> path = curvePath(whole(curve), 1e-9);
    std::vector<double> stops = breakParameters(curve, domain(curve));
    stops.insert(stops.begin(), domain(curve).start);
    stops.push_back(domain(curve).end);
    std::size_t span = 0;
    Vec3 from{0};
    for (const PathStep& step : path) {
        if (step.kind != PathStep::Kind::move) {
            ASSERT_EQ(step.kind, kind);
            ASSERT_LT(span + 1, stops.size());
            for (const double s : {0.0, 0.25, 0.5, 0.9, 1.0}) {
                const double t = stops[span] + s * (stops[span + 1] - stops[span]);
                std::array<Vec3, 1> row{};
                evaluate(curve, t, s < 1 ? Side::right : Side::left, row);
                EXPECT_LE(glm::length(onStep(from, step, s) - row[0]), 1e-13) << t;
            }
            ++span;
        }
        from = step.end;
    }
    EXPECT_EQ(span + 1, stops.size());
}

TEST(CurvePath, IsExactForSplinesUpToDegreeThreeInEveryForm) {
    const std::string points = R"("points": [[0,0],[1,0.5],[0.5,1],[-1,1],[-0.5,-1],[0.2,-0.7]])";
    for (const std::string form : {"clamped", "open", "closed"}) {
        for (const int degree : {1, 2, 3}) {
            expectExact(curveOf(R"({"type": "bspline-curve", "degree": )" + std::to_string(degree) +
                                R"(, "form": ")" + form + "\", " + points + "}"),
                        degree == 1 ? PathStep::Kind::line : PathStep::Kind::cubic);
        }
    }
    expectExact(curveOf(R"({"type": "bspline-curve", "degree": 3, )" + points +
                        R"(, "knots": [0, 0, 0, 0, 0.01, 2.99, 3, 3, 3, 3]})"),
                PathStep::Kind::cubic);
}

TEST(CurvePath, IsExactForBezierCurvesLinesAndPolygons) {
    expectExact(curveOf(R"({"type": "bezier-curve", "points": [[0,0],[1,2],[2,0]], "domain": [2, 5]})"),
                PathStep::Kind::cubic);
    expectExact(curveOf(R"({"type": "bezier-curve", "points": [[0,0],[1,2]]})"),
                PathStep::Kind::line);
    expectExact(curveOf(R"({"type": "line-curve", "from": [1,1], "to": [3,-1]})"),
                PathStep::Kind::line);
    expectExact(curveOf(R"({"type": "subdivision-curve", "scheme": "chaikin", "closed": true,
                            "levels": 3, "points": [[0,0],[1,0],[1,1]]})"),
                PathStep::Kind::line);
}

TEST(CurvePath, BeginsAnewWhereTheCurveJumps) {
    const auto path = curvePath(
        whole(curveOf(R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,0],[5,5],[6,5]],
                          "knots": [0, 0, 1, 1, 2, 2]})")),
        1e-3);
    ASSERT_EQ(path.size(), 4U);
    EXPECT_EQ(path[2].kind, PathStep::Kind::move);
    EXPECT_EQ(path[2].end, Vec3(5, 5, 0));
}

TEST(CurvePath, AnAffineMapOfTheCurveMapsThePath) {
    const Curve curve = curveOf(
        R"({"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[2,0],[3,1]]})");
    CurvePart turned = whole(curve);
    turned.placement = {rotation(Vec3(1, 2, 3), 0.7) * 2.0, Vec3(4, -5, 6)};
    const auto plain = curvePath(whole(curve), 1e-3);
    const auto mapped = curvePath(turned, 1e-3);
    ASSERT_EQ(plain.size(), mapped.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_LE(glm::length(turned.placement.point(plain[i].end) - mapped[i].end), 1e-13);
        if (plain[i].kind != PathStep::Kind::cubic) continue;
        EXPECT_LE(glm::length(turned.placement.point(plain[i].first) - mapped[i].first), 1e-13);
    }
}

double distanceFromChord(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double x = b.x - a.x, y = b.y - a.y;
    const double square = x * x + y * y;
    const double along = square > 0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0;
    const double s = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - s * x, p.y - a.y - s * y);
}

/// The largest distance of points of the path from a dense polyline of the curve, in the plane.
double distanceFromCurve(const std::vector<PathStep>& path, const Curve& curve) {
    constexpr std::size_t count = 6001;
    std::vector<double> xyz(3 * count);
    CurveSampler(curve).uniform(0, count, count, xyz);
    const auto sample = [&](std::size_t i) { return Vec3(xyz[3 * i], xyz[3 * i + 1], 0); };
    double worst = 0;
    Vec3 from{0};
    for (const PathStep& step : path) {
        for (int k = 0; step.kind != PathStep::Kind::move && k < 6; ++k) {
            const Vec3 p = onStep(from, step, (k + 0.5) / 6);
            double best = 1e300;
            for (std::size_t i = 0; i + 1 < count; ++i) {
                best = std::min(best, distanceFromChord(p, sample(i), sample(i + 1)));
            }
            worst = std::max(worst, best);
        }
        from = step.end;
    }
    return worst;
}

TEST(CurvePath, StaysWithinItsToleranceOfEveryModelCurve) {
    for (const char* name : {"circle", "ellipse", "lissajous", "rose", "butterfly", "hypotrochoid",
                             "epitrochoid", "astroid", "cardioid", "nephroid", "lemniscate",
                             "spiral", "helix", "viviani", "trefoil", "torus-knot"}) {
        const Curve curve =
            curveOf(R"({"type": "parametric-curve", "name": ")" + std::string(name) + "\"}");
        for (const double tolerance : {1e-2, 1e-3}) {
            const auto path = curvePath(whole(curve), tolerance);
            // The chords of the samples are up to 4e-4 away from the curve.
            EXPECT_LE(distanceFromCurve(path, curve), tolerance + 4e-4) << name;
            EXPECT_LE(path.size(), 400U) << name;
        }
    }
}

TEST(CurvePath, SeesWavesWhoseZerosAreEvenlySpread) {
    const Curve curve = curveOf(
        R"~({"type": "formula-curve", "x": "t", "y": "sin(64*pi*t)", "domain": [0, 1]})~");
    const auto path = curvePath(whole(curve), 1e-3);
    EXPECT_GE(path.size(), 128U);
    EXPECT_LE(distanceFromCurve(path, curve), 1.5e-3);
}

TEST(CurvePath, EndsWhereADerivativeIsInfiniteOrTheCurveLeavesTheWorld) {
    const Curve root = curveOf(
        R"~({"type": "formula-curve", "x": "t", "y": "sqrt(t)", "domain": [0, 1]})~");
    const auto path = curvePath(whole(root), 1e-4);
    EXPECT_LE(path.size(), 200U);
    EXPECT_LE(glm::length(path.back().end - Vec3(1, 1, 0)), 1e-15);
    for (const PathStep& step : path) {
        EXPECT_TRUE(isFinite(step.first) && isFinite(step.second) && isFinite(step.end));
        EXPECT_NEAR(step.end.y, std::sqrt(step.end.x), 1e-15);
    }
}

TEST(CurvePath, TakesFewSteps) {
    const Curve circle = curveOf(R"({"type": "parametric-curve", "name": "circle",
                                     "parameters": {"radius": 300}})");
    EXPECT_LE(curvePath(whole(circle), 0.05).size(), 17U);
}

}  // namespace
}  // namespace knotwork::drawing
