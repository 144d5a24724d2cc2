#include "geometry/parametric_curve.hpp"

#include "geometry/quadrature.hpp"
#include "support/calculus.hpp"
#include "support/function_gates.hpp"
#include "support/truth.hpp"
#include "support/model_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::Complex;
using test::Parameters;
using test::make;
using test::rowsOf;

constexpr double pi = std::numbers::pi;

double decimal(const nlohmann::json& text) { return std::stod(text.get<std::string>()); }

void expectPoint(const Vec3& point, const nlohmann::json& expected, const std::string& what) {
    EXPECT_NEAR(point.x, decimal(expected[0]), gates::curvePoint) << what;
    EXPECT_NEAR(point.y, decimal(expected[1]), gates::curvePoint) << what;
    EXPECT_EQ(point.z, 0) << what;
}

double arcLength(const ParametricCurve& curve, double a, double b, int panels) {
    const auto speed = [&](double t) { return glm::length(rowsOf(curve, t, 2)[1]); };
    double length = 0;
    for (int i = 0; i < panels; ++i) {
        const double step = (b - a) / panels;
        length += integrateGauss<16>(speed, a + i * step, a + (i + 1) * step);
    }
    return length;
}

// --- the truth -----------------------------------------------------------------------------------

TEST(ParametricCurve, TheButterflyPassesThroughItsTruePoints) {
    const auto& truth = test::truth("butterfly");
    const ParametricCurve butterfly = make("butterfly");
    const std::pair<const char*, double> places[] = {
        {"0", 0},        {"1", 1},   {"pi/3", pi / 3}, {"2pi", 2 * pi},
        {"6pi", 6 * pi}, {"10", 10}, {"12pi", 12 * pi}};
    for (const auto& [key, t] : places) expectPoint(butterfly.point(t), truth[key], key);
}

TEST(ParametricCurve, TheButterflyHasItsTrueLength) {
    const auto& truth = test::truth("butterfly");
    const ParametricCurve butterfly = make("butterfly");
    EXPECT_NEAR(arcLength(butterfly, 0, 12 * pi, 600), decimal(truth["length_0_12pi"]), 1e-9);
    EXPECT_NEAR(arcLength(butterfly, 0, 2 * pi, 200), decimal(truth["length_0_2pi"]), 1e-10);
}

TEST(ParametricCurve, TheRoseFourThirdsPassesThroughItsTruePoints) {
    const auto& truth = test::truth("rose_4_3");
    const ParametricCurve rose = make("rose", {{"k", 4.0 / 3}});
    expectPoint(rose.point(1), truth["t=1"], "t = 1");
    expectPoint(rose.point(2), truth["t=2"], "t = 2");
}

// --- every model against its formula of the table ------------------------------------------------

struct Formula {
    std::string name;
    Parameters parameters;
    std::function<std::array<Complex, 3>(Complex)> at;
};

std::vector<Formula> planarFormulas() {
    using std::cos, std::exp, std::pow, std::sin;
    return {
        {"circle",
         {{"radius", 1.5}},
         [](Complex t) {
             return std::array<Complex, 3>{1.5 * cos(t), 1.5 * sin(t), 0.0};
         }},
        {"ellipse",
         {{"a", 3.0}, {"b", 0.5}},
         [](Complex t) {
             return std::array<Complex, 3>{3.0 * cos(t), 0.5 * sin(t), 0.0};
         }},
        {"lissajous",
         {{"a", 2.0}, {"b", 0.7}, {"kx", 3.0}, {"ky", 2.5}},
         [](Complex t) {
             return std::array<Complex, 3>{2.0 * cos(3.0 * t), 0.7 * sin(2.5 * t), 0.0};
         }},
        {"rose",
         {{"a", 2.0}, {"k", 1.5}},
         [](Complex t) {
             return std::array<Complex, 3>{2.0 * cos(1.5 * t) * cos(t), 2.0 * cos(1.5 * t) * sin(t),
                                           0.0};
         }},
        {"butterfly",
         {{"scale", 0.5}},
         [](Complex t) {
             const Complex r = exp(cos(t)) - 2.0 * cos(4.0 * t) - pow(sin(t / 12.0), 5);
             return std::array<Complex, 3>{0.5 * sin(t) * r, 0.5 * cos(t) * r, 0.0};
         }},
        {"hypotrochoid",
         {{"R", 5.0}, {"r", 2.0}, {"d", 3.0}},
         [](Complex t) {
             return std::array<Complex, 3>{3.0 * cos(t) + 3.0 * cos(1.5 * t),
                                           3.0 * sin(t) - 3.0 * sin(1.5 * t), 0.0};
         }},
        {"epitrochoid",
         {{"R", 3.0}, {"r", 2.0}, {"d", 0.5}},
         [](Complex t) {
             return std::array<Complex, 3>{5.0 * cos(t) - 0.5 * cos(2.5 * t),
                                           5.0 * sin(t) - 0.5 * sin(2.5 * t), 0.0};
         }},
        {"astroid",
         {{"a", 2.0}},
         [](Complex t) {
             return std::array<Complex, 3>{2.0 * pow(cos(t), 3), 2.0 * pow(sin(t), 3), 0.0};
         }},
        {"cardioid",
         {{"a", 0.5}},
         [](Complex t) {
             return std::array<Complex, 3>{0.5 * (2.0 * cos(t) - cos(2.0 * t)),
                                           0.5 * (2.0 * sin(t) - sin(2.0 * t)), 0.0};
         }},
        {"nephroid",
         {{"a", 0.5}},
         [](Complex t) {
             return std::array<Complex, 3>{0.5 * (3.0 * cos(t) - cos(3.0 * t)),
                                           0.5 * (3.0 * sin(t) - sin(3.0 * t)), 0.0};
         }},
        {"heart",
         {{"scale", 0.1}},
         [](Complex t) {
             return std::array<Complex, 3>{
                 1.6 * pow(sin(t), 3),
                 1.3 * cos(t) - 0.5 * cos(2.0 * t) - 0.2 * cos(3.0 * t) - 0.1 * cos(4.0 * t), 0.0};
         }},
        {"lemniscate",
         {{"a", 3.0}},
         [](Complex t) {
             const Complex w = 1.0 + sin(t) * sin(t);
             return std::array<Complex, 3>{3.0 * cos(t) / w, 3.0 * sin(t) * cos(t) / w, 0.0};
         }},
        {"spiral",
         {{"a", 0.2}, {"b", 0.3}, {"turns", 2.0}},
         [](Complex t) {
             return std::array<Complex, 3>{(0.2 + 0.3 * t) * cos(t), (0.2 + 0.3 * t) * sin(t), 0.0};
         }},
    };
}

std::vector<Formula> everyFormula() {
    using std::cos, std::sin;
    std::vector<Formula> all = planarFormulas();
    all.push_back({"helix", {{"radius", 2.0}, {"pitch", 0.5}, {"turns", 4.0}}, [](Complex t) {
                       return std::array<Complex, 3>{2.0 * cos(t), 2.0 * sin(t), t / (4 * pi)};
                   }});
    all.push_back(
        {"viviani", {{"a", 2.0}}, [](Complex t) {
             return std::array<Complex, 3>{2.0 * (1.0 + cos(t)), 2.0 * sin(t), 4.0 * sin(t / 2.0)};
         }});
    all.push_back({"trefoil", {{"scale", 0.5}}, [](Complex t) {
                       return std::array<Complex, 3>{0.5 * (sin(t) + 2.0 * sin(2.0 * t)),
                                                     0.5 * (cos(t) - 2.0 * cos(2.0 * t)),
                                                     -0.5 * sin(3.0 * t)};
                   }});
    all.push_back(
        {"torus-knot", {{"p", 3.0}, {"q", 5.0}, {"R", 3.0}, {"r", 0.5}}, [](Complex t) {
             const Complex w = 3.0 + 0.5 * cos(5.0 * t);
             return std::array<Complex, 3>{w * cos(3.0 * t), w * sin(3.0 * t), 0.5 * sin(5.0 * t)};
         }});
    return all;
}

TEST(ParametricCurve, EveryModelHasAFormulaInThisTest) {
    EXPECT_EQ(everyFormula().size(), parametricCurveModels().size());
    for (const Formula& formula : everyFormula()) {
        EXPECT_NE(findParametricModel(formula.name), nullptr) << formula.name;
    }
}

TEST(ParametricCurve, PointsAreThoseOfTheFormulaInsideTheDomainAndOutside) {
    for (const Formula& formula : everyFormula()) {
        const ParametricCurve curve = make(formula.name, formula.parameters);
        for (const double t : {-4.0, 0.0, 0.3, 1.9, 5.5, 40.0}) {
            const auto expected = formula.at(t);
            const Vec3 point = curve.point(t);
            for (int i = 0; i < 3; ++i) {
                const double value = expected[static_cast<std::size_t>(i)].real();
                EXPECT_NEAR(point[i], value, 10 * gates::curvePoint)
                    << formula.name << " at " << t << ", coordinate " << i;
            }
        }
    }
}

TEST(ParametricCurve, FirstDerivativesAgreeWithComplexStepsOfTheFormula) {
    for (const Formula& formula : everyFormula()) {
        const ParametricCurve curve = make(formula.name, formula.parameters);
        for (const double t : {-1.0, 0.3, 1.9, 5.5}) {
            const Vec3 slope = rowsOf(curve, t, 2)[1];
            for (int i = 0; i < 3; ++i) {
                const auto coordinate = [&](Complex z) {
                    return formula.at(z)[static_cast<std::size_t>(i)];
                };
                EXPECT_NEAR(slope[i], test::complexStepDerivative(coordinate, t),
                            gates::complexStepSlope * std::max(1.0, glm::length(slope)))
                    << formula.name << " at " << t << ", coordinate " << i;
            }
        }
    }
}

TEST(ParametricCurve, HigherDerivativesAgreeWithCauchysIntegralOfTheFormula) {
    for (const Formula& formula : everyFormula()) {
        const ParametricCurve curve = make(formula.name, formula.parameters);
        for (const double t : {0.3, 1.9, 5.5}) {
            const auto rows = rowsOf(curve, t, 9);
            for (int k = 2; k <= 8; ++k) {
                const Vec3 row = rows[static_cast<std::size_t>(k)];
                for (int i = 0; i < 3; ++i) {
                    const auto coordinate = [&](Complex z) {
                        return formula.at(z)[static_cast<std::size_t>(i)];
                    };
                    const double radius = 0.5;
                    const double noise = 1e-14 * std::tgamma(k + 1) / std::pow(radius, k);
                    EXPECT_NEAR(row[i], test::cauchyDerivative(coordinate, t, k, radius),
                                10 * noise + gates::cauchy * glm::length(row))
                        << formula.name << " at " << t << ", order " << k << ", coordinate " << i;
                }
            }
        }
    }
}

TEST(ParametricCurve, DerivativesGoUpToOrderTwentyFive) {
    const ParametricCurve ellipse = make("ellipse");
    const auto rows = rowsOf(ellipse, 0.4, 28);
    for (int k = 0; k <= 25; ++k) {
        const auto row = static_cast<std::size_t>(k);
        EXPECT_NEAR(rows[row].x, 2 * std::cos(0.4 + k * pi / 2), 1e-13) << k;
        EXPECT_NEAR(rows[row].y, std::sin(0.4 + k * pi / 2), 1e-13) << k;
    }
    EXPECT_EQ(rows[26], Vec3(0));
}

TEST(ParametricCurve, BatchesGiveTheSamePointsAsSingleCalls) {
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        const ParametricCurve curve = make(model.name);
        const std::vector<double> ts{-2, 0, 0.7, 3, 50};
        std::vector<Vec3> points(ts.size());
        curve.samplePoints(ts, points);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            EXPECT_EQ(points[i], curve.point(ts[i])) << model.name;
            const Vec3 row = rowsOf(curve, ts[i], 2)[0];
            EXPECT_LE(glm::length(row - points[i]), 1e-14 * (1 + glm::length(row))) << model.name;
        }
        std::vector<Vec3> uniform(4);
        curve.sampleUniform(uniform);
        EXPECT_EQ(uniform[0], curve.point(curve.domain().start)) << model.name;
        EXPECT_EQ(uniform[3], curve.point(curve.domain().end)) << model.name;
    }
}

}  // namespace
}  // namespace knotwork
