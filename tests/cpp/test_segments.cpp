// Bézier curves, lines and arcs.
#include "geometry/curve.hpp"
#include "scene/specs.hpp"
#include "support/json_text.hpp"
#include "support/model_curves.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace knotwork {
namespace {

constexpr Interval unit{0, 1};

// Basis form against de Boor's algorithm with coordinates in ±1 (DESIGN: 2e-14), the k-th
// derivative relative to the d^k that it may grow by.
constexpr double deBoorGate = 2e-14;
constexpr double closedForm = 1e-13;  // sin and cos of a few turns

template <std::size_t N>
std::array<Vec3, N> rowsAt(const Curve& curve, double t, Side side = Side::right) {
    std::array<Vec3, N> rows;
    rows.fill(Vec3(99));
    evaluate(curve, t, side, rows);
    return rows;
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance, double t = 0) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << "at " << t << ": " << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y
        << ' ' << b.z;
}

/// The curve a little further on, by its Taylor series: a derivative that is 1 % wrong is seen.
void expectTaylor(const Curve& curve, double t, double h, double tolerance) {
    const auto rows = rowsAt<20>(curve, t);
    for (std::size_t order = 0; order < 3; ++order) {
        Vec3 sum(0);
        double factor = 1;
        for (std::size_t k = 0; order + k < rows.size(); ++k) {
            sum += factor * rows[order + k];
            factor *= h / static_cast<double>(k + 1);
        }
        expectNear(sum, rowsAt<3>(curve, t + h)[order], tolerance, t);
    }
}

std::vector<Vec3> randomPoints(test::RandomSplines& random, int count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    }
    return points;
}

TEST(BezierCurve, IsASplineOfOneSpanWithAllItsDerivatives) {
    test::RandomSplines random(51);
    for (int round = 0; round < 200; ++round) {
        const int degree = random.integer(1, round % 10 == 0 ? 25 : 9);
        std::vector<double> weights;
        if (round % 3 == 0) {
            for (int i = 0; i <= degree; ++i) weights.push_back(random.real(0.5, 2));
        }
        const Interval domain{random.real(-3, 3), random.real(4, 9)};
        const Curve curve(BezierCurve::make(randomPoints(random, degree + 1), weights, domain).value());
        const Curve spline(asBspline(*curve.as<BezierCurve>()).value());
        for (const double share : {0.0, 0.2, 0.7, 1.0}) {
            const double t = domain.start + share * domain.length();
            const auto got = rowsAt<4>(curve, t);
            const auto expected = rowsAt<4>(spline, t);
            double scale = weights.empty() ? 1 : 20;
            for (std::size_t k = 0; k < 4; ++k) {
                expectNear(got[k], expected[k], deBoorGate * scale, t);
                scale *= 4.0 * degree / domain.length();
            }
        }
        EXPECT_EQ(rowsAt<1>(curve, domain.start)[0], curve.as<BezierCurve>()->points().front());
    }
}

TEST(BezierCurve, EndsInItsEndPointsExactlyAndGoesOnByItsFormula) {
    const Curve parabola(BezierCurve::make({{0, 0, 0}, {1, 0, 0}, {2, 4, 0}}, {}, {1, 3}).value());
    EXPECT_EQ(rowsAt<1>(parabola, 1)[0], Vec3(0));
    EXPECT_EQ(rowsAt<1>(parabola, 3)[0], Vec3(2, 4, 0));
    // With u = (t − 1)/2 it is (2u, 4u²): x = t − 1, y = x².
    for (const double t : {-2.0, 0.5, 1.7, 3.5, 10.0}) {
        const auto rows = rowsAt<5>(parabola, t);
        expectNear(rows[0], {t - 1, (t - 1) * (t - 1), 0}, 1e-13, t);
        expectNear(rows[1], {1, 2 * (t - 1), 0}, 1e-13, t);
        expectNear(rows[2], {0, 2, 0}, 1e-14, t);
        EXPECT_EQ(rows[3], Vec3(0));
        EXPECT_EQ(rows[4], Vec3(0));
    }
    EXPECT_EQ(dimension(parabola), 2);
    EXPECT_FALSE(isClosed(parabola));
}

TEST(BezierCurve, WithWeightsIsAnExactCircle) {
    const double w = std::sqrt(0.5);
    const Curve quarter(
        BezierCurve::make({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, w, 1}, unit).value());
    for (int i = 0; i <= 20; ++i) {
        const double t = i / 20.0;
        const auto rows = rowsAt<3>(quarter, t);
        EXPECT_NEAR(glm::length(rows[0]), 1, 4e-16);
        EXPECT_NEAR(glm::dot(rows[0], rows[1]), 0, 4e-15);
        EXPECT_NEAR(glm::length(glm::cross(rows[1], rows[2])) / std::pow(glm::length(rows[1]), 3), 1,
                    1e-14);
    }
    expectTaylor(quarter, 0.4, 0.05, 1e-12);
}

TEST(BezierCurve, FromTaylorCoefficientsHasThoseDerivativesWhereverItsDomainLies) {
    test::RandomSplines random(52);
    for (const int degree : {1, 2, 3, 5, 9, 25}) {
        for (const Interval& domain : {Interval{0.5, 1.5}, Interval{1, 2}, Interval{0, 1},
                                       Interval{0.9, 1.4}}) {
            const auto taylor = randomPoints(random, degree + 1);
            const Curve curve(BezierCurve::fromTaylor(taylor, 1, domain));
            const auto rows = rowsAt<4>(curve, 1);
            double factorial = 1;
            double scale = 1;
            for (std::size_t k = 0; k < 4 && k <= static_cast<std::size_t>(degree); ++k) {
                if (k > 0) factorial *= static_cast<double>(k);
                expectNear(rows[k], factorial * taylor[k], deBoorGate * scale);
                scale *= 4.0 * degree / domain.length();
            }
        }
    }
}

TEST(BezierCurve, OfDegreeTwoHasTheControlPointsOfTheBlossom) {
    const std::array taylor{Vec3(1, 2, 0), Vec3(3, -1, 0), Vec3(0.5, 4, 0)};
    const auto curve = BezierCurve::fromTaylor(taylor, 2, {1, 4});
    const double s = -1;
    const double e = 2;
    // p + p′(s + e)/2 + p″ s e/2, and p″ is twice the coefficient.
    expectNear(curve.points()[1], taylor[0] + taylor[1] * (s + e) / 2.0 + taylor[2] * s * e, 1e-15);
    expectNear(curve.points()[0], taylor[0] + s * taylor[1] + s * s * taylor[2], 1e-15);
    expectNear(curve.points()[2], taylor[0] + e * taylor[1] + e * e * taylor[2], 1e-15);
}

TEST(LineCurve, RunsStraightFromOnePointToTheOtherAndOn) {
    const Curve line(LineCurve::make({1, 2, 3}, {4, 0, 3}, {2, 5}).value());
    EXPECT_EQ(rowsAt<1>(line, 2)[0], Vec3(1, 2, 3));
    EXPECT_EQ(rowsAt<1>(line, 5)[0], Vec3(4, 0, 3));
    const auto rows = rowsAt<4>(line, 8);
    expectNear(rows[0], {7, -2, 3}, 1e-15);
    expectNear(rows[1], {1, -2.0 / 3, 0}, 1e-15);
    EXPECT_EQ(rows[2], Vec3(0));
    EXPECT_EQ(rows[3], Vec3(0));
    EXPECT_EQ(dimension(line), 3);
}

TEST(LineCurve, AsATangentHasItsPointAndDerivativeExactly) {
    const Curve line(LineCurve::tangent(0.3, {0.1, 0.7, 0}, {1.3, -0.2, 0}, {0, 2}));
    EXPECT_EQ(rowsAt<1>(line, 0.3)[0], Vec3(0.1, 0.7, 0));
    EXPECT_EQ(rowsAt<2>(line, 1.9)[1], Vec3(1.3, -0.2, 0));
    EXPECT_EQ(rowsAt<1>(line, 2)[0], line.as<LineCurve>()->to());
    EXPECT_EQ(dimension(line), 2);
}

TEST(ArcCurve, HasThePointTheFirstDerivativeAndTheCurvatureItWasGiven) {
    test::RandomSplines random(53);
    for (int round = 0; round < 100; ++round) {
        const auto given = randomPoints(random, 3);
        const double at = random.real(-2, 2);
        const Curve arc(ArcCurve::make(at, given[0], given[1], given[2], {-1, 1}).value());
        const auto rows = rowsAt<3>(arc, at);
        EXPECT_EQ(rows[0], given[0]);
        expectNear(rows[1], given[1], 1e-15);
        const double speed = glm::length(given[1]);
        const double curvature =
            glm::length(glm::cross(given[1], given[2])) / (speed * speed * speed);
        const Vec3 across = given[2] - glm::dot(given[1], given[2]) / (speed * speed) * given[1];
        expectNear(rows[2], across, 1e-13 * (1 + glm::length(across)));
        const Vec3 centre = rows[0] + rows[2] / (speed * speed * curvature * curvature);
        for (const double t : {-1.0, -0.3, 0.4, 1.0}) {
            const auto there = rowsAt<2>(arc, t);
            EXPECT_NEAR(glm::length(there[1]), speed, closedForm);
            EXPECT_NEAR(glm::length(there[0] - centre) * curvature, 1,
                        closedForm * (1 + curvature * glm::length(centre)));
        }
    }
}

TEST(ArcCurve, HasExactDerivativesOfEveryOrder) {
    const Curve arc(ArcCurve::make(0.5, {1, 2, 0}, {0, 2, 1}, {-3, 0.5, 1}, {0, 2}).value());
    for (const double t : {0.0, 0.5, 1.7, 4.0}) expectTaylor(arc, t, 0.2, closedForm);
    const auto rows = rowsAt<26>(arc, 1.1);
    const double turn = glm::length(rows[2]) / glm::length(rows[1]);  // k σ
    for (std::size_t m = 1; m + 2 < rows.size(); ++m) {
        expectNear(rows[m + 2], -turn * turn * rows[m], closedForm * std::pow(turn, m + 2));
    }
}

TEST(ArcCurve, BecomesTheLineAsItsCurvatureGoesToZero) {
    const auto arcOf = [](double bend) {
        return Curve(ArcCurve::make(0, {0, 0, 0}, {2, 0, 0}, {5, 4 * bend, 0}, {0, 1}).value());
    };
    EXPECT_EQ(rowsAt<1>(arcOf(0), 1)[0], Vec3(2, 0, 0));
    for (const double bend : {1e-3, 1e-6, 1e-9, 1e-12, 1e-200}) {
        // The curvature is `bend`, s = 2: to first order the arc leaves the line by bend s²/2.
        const Vec3 end = rowsAt<1>(arcOf(bend), 1)[0];
        EXPECT_NEAR(end.y / (2 * bend), 1, bend * bend + 1e-15) << bend;
        EXPECT_NEAR(end.x, 2, 2 * bend * bend + 1e-15);
    }
}

TEST(Segments, AreSampledAsTheyAreEvaluated) {
    test::RandomSplines random(54);
    const std::array curves{
        Curve(BezierCurve::make(randomPoints(random, 4), {}, {1, 3}).value()),
        Curve(BezierCurve::make(randomPoints(random, 12), {}, {1, 3}).value()),
        Curve(BezierCurve::make(randomPoints(random, 3), {1, 2, 3}, {1, 3}).value()),
        Curve(LineCurve::make({0, 1, 0}, {2, 2, 2}, {1, 3}).value()),
        Curve(ArcCurve::make(1, {0, 1, 0}, {2, 2, 2}, {1, 0, 0}, {1, 3}).value())};
    for (const Curve& curve : curves) {
        const CurveSampler sampler(curve);
        std::array<double, 33> xyz{};
        sampler.uniform(0, 11, 11, xyz);
        for (std::size_t i = 0; i < 11; ++i) {
            const double t = 1 + 0.2 * static_cast<double>(i);
            expectNear({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}, rowsAt<1>(curve, t)[0], 4e-14);
        }
        const std::array ts{1.0, 2.9, 3.0};
        std::array<double, 27> rows{};
        sampler.at(ts, 2, rows);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double* at = &rows[3 * (3 * k + i)];
                expectNear({at[0], at[1], at[2]}, rowsAt<3>(curve, ts[i])[k], 1e-10);
            }
        }
    }
}

using scene::Json;
using test::json;

TEST(SegmentSpecs, AreCompletedAndReadBack) {
    const auto bezier = scene::makeCurve(json(R"({"type": "bezier-curve", "points": [[0,0],[1,2]]})"));
    ASSERT_TRUE(bezier.ok());
    EXPECT_EQ(scene::dumpJson(bezier->spec),
              R"({"type":"bezier-curve","points":[[0.0,0.0],[1.0,2.0]],"domain":[0.0,1.0]})");
    for (const char* text : {
             R"({"type":"bezier-curve","points":[[0,0],[1,2],[3,0]],"weights":[1,2,1],"domain":[2,5]})",
             R"({"type":"line-curve","from":[0,1,2],"to":[1,2,3],"domain":[0,2]})",
             R"({"type":"arc-curve","at":1,"point":[0,1],"first":[1,2],"second":[0,3],"domain":[0,2]})",
         }) {
        const auto made = scene::makeCurve(json(text));
        ASSERT_TRUE(made.ok()) << text;
        EXPECT_EQ(made->spec, json(text));
        EXPECT_EQ(scene::specOf(made->value), json(text));
    }
}

TEST(SegmentSpecs, BadOnesAreRefusedWithTheirPlace) {
    struct Refusal {
        const char* text;
        Code code;
        const char* path;
    };
    const std::array refusals{
        Refusal{R"({"type":"bezier-curve","points":[[0,0]]})", Code::wrongLength, "points"},
        Refusal{R"({"type":"bezier-curve","points":[[0,0],[2e12,0]]})", Code::outOfRange, "points[1]"},
        Refusal{R"({"type":"bezier-curve","points":[[0,0],[1,0]],"weights":[1]})", Code::wrongLength,
                "weights"},
        Refusal{R"({"type":"bezier-curve","points":[[0,0],[1,0]],"weights":[1,0]})", Code::outOfRange,
                "weights[1]"},
        Refusal{R"({"type":"bezier-curve","points":[[0,0],[1,0]],"domain":[1,1]})", Code::outOfRange,
                "domain"},
        Refusal{R"({"type":"bezier-curve","points":[[0,0],[1,0]],"degree":1})", Code::unknownField,
                "degree"},
        Refusal{R"({"type":"line-curve","from":[0,0]})", Code::wrongType, "to"},
        Refusal{R"({"type":"line-curve","from":[0,0],"to":[0,"1"]})", Code::wrongType, "to[1]"},
        Refusal{R"({"type":"line-curve","from":[0,0],"to":[0,-2e12]})", Code::outOfRange, "to"},
        Refusal{R"({"type":"line-curve","from":[0,0],"to":[0,1],"domain":[3,2]})", Code::outOfRange,
                "domain"},
        Refusal{R"({"type":"arc-curve","at":0,"point":[0,0],"first":[0,0],"second":[1,0],"domain":[0,1]})",
                Code::outOfRange, "first"},
        Refusal{R"({"type":"arc-curve","at":0,"point":[0,0],"first":[1,0],"second":[1,0]})",
                Code::wrongType, "domain"},
        Refusal{R"({"type":"arc-curve","at":2e9,"point":[0,0],"first":[1,0],"second":[1,0],"domain":[0,1]})",
                Code::outOfRange, "at"},
    };
    for (const Refusal& refusal : refusals) {
        const auto made = scene::makeCurve(json(refusal.text));
        ASSERT_FALSE(made.ok()) << refusal.text;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << refusal.text;
        EXPECT_EQ(made.error().path, refusal.path) << refusal.text;
    }
    std::vector<Vec3> many(27, Vec3(0));
    EXPECT_EQ(BezierCurve::make(many, {}, unit).error().code, Code::tooLarge);
    EXPECT_EQ(ArcCurve::make(0, {0, 0, 0}, {1e-170, 0, 0}, {1, 1, 0}, unit).error().path, "first");
    for (const double at : {std::nan(""), -2e9}) {
        const auto made = ArcCurve::make(at, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, unit);
        EXPECT_EQ(made.error().code, std::isnan(at) ? Code::notFinite : Code::outOfRange);
        EXPECT_EQ(made.error().path, "at");
    }
}

}  // namespace
}  // namespace knotwork
