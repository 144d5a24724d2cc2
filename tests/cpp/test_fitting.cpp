#include "geometry/fitting.hpp"

#include "geometry/bspline_basis.hpp"

#include "support/gates.hpp"
#include "support/splines.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::allForms;
using test::Rational;
using test::RandomSplines;

std::vector<Vec3> randomPoints(RandomSplines& random, int count, bool spatial = true) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(random.real(-1, 1), random.real(-1, 1),
                            spatial ? random.real(-1, 1) : 0);
    }
    return points;
}

std::vector<Vec3> pointsOf(const BsplineCurve& curve, std::span<const double> ts) {
    std::vector<Vec3> points;
    for (const double t : ts) points.push_back(curve.point(t));
    return points;
}

double farthest(std::span<const Vec3> a, std::span<const Vec3> b) {
    double largest = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        largest = std::max(largest, glm::length(a[i] - b[i]));
    }
    return largest;
}

/// Σ_k N_i(u_k) (C(u_k) - Q_k) for every i, and λ Dᵀ D c with D the second differences: the
/// gradient of what is minimised, half of it.
std::vector<Vec3> gradient(const BsplineCurve& curve, std::span<const Vec3> points,
                           std::span<const double> ts, double smoothing = 0) {
    const std::span<const Vec3> c = curve.points();
    const std::size_t n = c.size();
    std::vector<Vec3> sums(n, Vec3(0));
    std::vector<double> row(n);
    for (std::size_t k = 0; k < ts.size(); ++k) {
        const Vec3 error = curve.point(ts[k]) - points[k];
        basisRows(curve.knotVector(), ts[k], Side::right, 0, row);
        for (std::size_t i = 0; i < n; ++i) sums[i] += row[i] * error;
    }
    for (std::size_t i = 0; i < (curve.closed() ? n : n - 2); ++i) {
        const std::size_t triple[] = {i, (i + 1) % n, (i + 2) % n};
        const double factors[] = {1, -2, 1};
        const Vec3 bend = c[triple[0]] - 2.0 * c[triple[1]] + c[triple[2]];
        for (int j = 0; j < 3; ++j) sums[triple[j]] += smoothing * factors[j] * bend;
    }
    return sums;
}

double largest(std::span<const Vec3> vectors) {
    double most = 0;
    for (const Vec3& v : vectors) most = std::max(most, glm::length(v));
    return most;
}

/// Open knots may leave a control point without any part in the domain: not these.
KnotVector fittingKnots(RandomSplines& random, int degree, Form form, bool multiple) {
    for (;;) {
        KnotVector knots = random.knotVector(degree, form, multiple);
        const auto t = knots.extended();
        const auto d = static_cast<std::size_t>(degree);
        const Interval domain = knots.domain();
        if (t[d + 1] > domain.start && t[t.size() - d - 2] < domain.end) return knots;
    }
}

BsplineCurve fittingCurve(RandomSplines& random, int degree, Form form, bool multiple = false) {
    KnotVector knots = fittingKnots(random, degree, form, multiple);
    auto points = randomPoints(random, knots.pointCount());
    return BsplineCurve::make(std::move(knots), std::move(points), 3).value();
}

/// Parameters of the domain, ascending, with every knot and both ends among them; `times` for every
/// span and a few at random.
std::vector<double> dataParameters(const KnotVector& knots, RandomSplines& random, int between) {
    std::vector<double> ts = test::telltaleParameters(knots, random, between);
    if (knots.closed()) ts.pop_back();
    const auto t = knots.extended();
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        for (int j = 1; j <= knots.degree() + 1; ++j) {
            const double u = t[i] + (t[i + 1] - t[i]) * j / (knots.degree() + 2);
            if (t[i] < t[i + 1] && knots.domain().contains(u)) ts.push_back(u);
        }
    }
    std::sort(ts.begin(), ts.end());
    return ts;
}

TEST(Fitting, InterpolatesPieglAndTillersExampleExactly) {
    const auto& known = test::truth("interp_PT_9_1");
    const std::vector<Vec3> data{{0, 0, 0}, {3, 4, 0}, {-1, 4, 0}, {-4, 0, 0}, {-4, -3, 0}};
    const Fit fit = interpolateCurve(data, 3, Form::clamped).value();
    const auto knots = test::doubles(test::rationals(known["knots"]));
    const auto found = fit.curve.knotVector().knots();
    ASSERT_EQ(found.size(), knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) EXPECT_NEAR(found[i], knots[i], 1e-15);
    for (std::size_t i = 0; i < data.size(); ++i) {
        const auto exact = test::doubles(test::rationals(known["ctrl"][i]));
        EXPECT_NEAR(fit.curve.points()[i].x, exact[0], test::gates::exact) << i;
        EXPECT_NEAR(fit.curve.points()[i].y, exact[1], test::gates::exact) << i;
    }
    EXPECT_EQ(fit.curve.dimension(), 2);
}

// The normal equations of a quadratic with three control points (Bernstein polynomials), solved in
// fractions by Cramer's rule.
TEST(Fitting, SmallLeastSquaresProblemIsTheExactFraction) {
    const std::vector<Rational> u{{0}, {1, 4}, {1, 2}, {1, 2}, {5, 8}, {1}};
    const std::vector<Rational> q{{1}, {-3}, {2}, {5}, {0}, {7, 2}};
    Rational a[3][4];
    for (std::size_t k = 0; k < u.size(); ++k) {
        const Rational v = Rational(1) - u[k];
        const Rational row[4] = {v * v, Rational(2) * u[k] * v, u[k] * u[k], q[k]};
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 4; ++j) a[i][j] = a[i][j] + row[i] * row[j];
        }
    }
    const auto determinant = [&](int replaced) {
        const auto at = [&](int i, int j) { return a[i][j == replaced ? 3 : j]; };
        return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
               at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
               at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
    };
    std::vector<Vec3> points;
    for (const Rational& value : q) points.emplace_back(value.value(), 0, -2 * value.value());
    const auto knots = KnotVector::make({0, 0, 0, 1, 1, 1}, 2, 3, Form::clamped).value();
    const auto curve = leastSquaresCurve(points, test::doubles(u), knots).value();
    for (int i = 0; i < 3; ++i) {
        const double exact = (determinant(i) / determinant(-1)).value();
        EXPECT_NEAR(curve.points()[static_cast<std::size_t>(i)].x, exact, 2 * test::gates::exact);
        EXPECT_NEAR(curve.points()[static_cast<std::size_t>(i)].z, -2 * exact,
                    4 * test::gates::exact);
    }
}

TEST(Fitting, ReproducesTheSplineThatTheDataComeFrom) {
    RandomSplines random(51);
    for (int degree = 1; degree <= 9; ++degree) {
        for (const Form form : allForms) {
            for (int round = 0; round < 20; ++round) {
                const bool dense = round % 2 == 0;
                const auto curve = fittingCurve(random, degree, form, round % 3 == 0);
                const auto ts = dataParameters(curve.knotVector(), random, dense ? 2000 : 5);
                const auto points = pointsOf(curve, ts);
                const auto fit = leastSquaresCurve(points, ts, curve.knotVector());
                ASSERT_TRUE(fit.ok()) << fit.error().path << ' ' << fit.error().message;
                ASSERT_LE(residualsOf(*fit, points, ts).max, test::gates::fitted);
                // The outermost control points of an open curve may hardly move it.
                if (form == Form::open) continue;
                ASSERT_LE(farthest(fit->points(), curve.points()), test::gates::fitted)
                    << "degree " << degree << " form " << static_cast<int>(form);
            }
        }
    }
}

TEST(Fitting, ResidualIsOrthogonalToTheSpline) {
    RandomSplines random(52);
    for (int round = 0; round < 200; ++round) {
        const KnotVector knots =
            fittingKnots(random, random.integer(1, 7), random.form(), round % 2 == 0);
        const auto ts = dataParameters(knots, random, round % 4 == 0 ? 1000 : 10);
        const auto points = randomPoints(random, static_cast<int>(ts.size()));
        const auto curve = leastSquaresCurve(points, ts, knots).value();
        ASSERT_LE(largest(gradient(curve, points, ts)),
                  test::gates::fitted * static_cast<double>(ts.size()) *
                      std::max(1.0, largest(curve.points())))
            << "round " << round;
    }
}

TEST(Fitting, SmoothingMinimisesTheSumThatIsDocumented) {
    RandomSplines random(53);
    for (int round = 0; round < 200; ++round) {
        const int degree = random.integer(1, 5);
        const KnotVector knots = fittingKnots(random, degree, random.form(), round % 2 == 0);
        const auto ts = dataParameters(knots, random, 10);
        const auto points = randomPoints(random, static_cast<int>(ts.size()));
        const double smoothing = std::pow(10.0, random.integer(-4, 4));
        const auto curve =
            leastSquaresCurve(points, ts, knots, {.smoothing = smoothing}).value();
        ASSERT_LE(largest(gradient(curve, points, ts, smoothing)),
                  test::gates::fitted * (static_cast<double>(ts.size()) + smoothing))
            << "round " << round;
    }
}

double roughness(const BsplineCurve& curve) {
    const auto c = curve.points();
    double sum = 0;
    for (std::size_t i = 0; i + 2 < c.size(); ++i) {
        const Vec3 bend = c[i] - 2.0 * c[i + 1] + c[i + 2];
        sum += glm::dot(bend, bend);
    }
    return sum;
}

TEST(Fitting, MoreSmoothingIsSmootherAndFartherAwayUpToAStraightLine) {
    RandomSplines random(54);
    const auto points = randomPoints(random, 60);
    double lastResidual = -1;
    double lastRoughness = 1e300;
    for (const double smoothing : {0.0, 1e-3, 1e-1, 1e1, 1e3, 1e5}) {
        const FitRequest request{.count = 20, .options = {.smoothing = smoothing}};
        const Fit fit = fitCurve(points, request).value();
        EXPECT_GT(fit.residuals.sumOfSquares, lastResidual);
        EXPECT_LT(roughness(fit.curve), lastRoughness);
        lastResidual = fit.residuals.sumOfSquares;
        lastRoughness = roughness(fit.curve);
    }
    const Fit line = fitCurve(points, {.count = 20, .options = {.smoothing = 1e12}}).value();
    const Vec3 step = line.curve.points()[1] - line.curve.points()[0];
    EXPECT_GT(glm::length(step), 1e-3);
    for (std::size_t i = 1; i < 20; ++i) {
        const Vec3 found = line.curve.points()[i] - line.curve.points()[i - 1];
        EXPECT_LE(glm::length(found - step), 1e-7);
    }
}

TEST(Fitting, SmoothingSettlesWhatTheDataLeaveOpen) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {3, 1, 0}};
    const FitRequest request{.count = 10, .options = {.smoothing = 1e-3}};
    EXPECT_TRUE(fitCurve(points, request).ok());
    EXPECT_EQ(fitCurve(points, {.count = 10}).error().code, Code::rankDeficient);
    const std::vector<Vec3> twice{{0, 0, 0}, {1, 2, 0}, {1, 2, 0}, {3, 1, 0}};
    const FitRequest equal{.count = 4, .options = {.smoothing = 1e-3}};
    EXPECT_TRUE(fitCurve(twice, equal).ok());
    EXPECT_EQ(fitCurve(twice, {.count = 4}).error().code, Code::rankDeficient);
}

TEST(Fitting, InterpolatesEveryPointAtItsParameter) {
    RandomSplines random(55);
    for (const Form form : allForms) {
        for (int degree = 1; degree <= 7; ++degree) {
            for (const auto how : {Parametrisation::uniform, Parametrisation::centripetal,
                                   Parametrisation::chord}) {
                for (int count = degree + 1; count < degree + 14; ++count) {
                    const auto points = randomPoints(random, count);
                    const auto fit = interpolateCurve(points, degree, form, how);
                    ASSERT_TRUE(fit.ok()) << fit.error().path << ": " << fit.error().message
                                          << " degree " << degree << " count " << count;
                    // Far control points, as open curves of high degree have, cost digits.
                    const double gate =
                        test::gates::interpolated * std::max(1.0, largest(fit->curve.points()));
                    ASSERT_LE(farthest(pointsOf(fit->curve, fit->parameters), points), gate)
                        << "degree " << degree << " count " << count << " form "
                        << static_cast<int>(form);
                    ASSERT_LE(fit->residuals.max, gate);
                }
            }
        }
    }
}

TEST(Fitting, AsManyControlPointsAsPointsInterpolate) {
    RandomSplines random(56);
    for (const Form form : allForms) {
        const auto points = randomPoints(random, 9);
        const Fit fit = fitCurve(points, {.count = 9, .form = form}).value();
        EXPECT_EQ(fit.curve, interpolateCurve(points, 3, form)->curve);
        EXPECT_LE(fit.residuals.max, test::gates::fitted);
    }
}

TEST(Fitting, EndsAreInterpolatedExactlyAndTheRestIsStillTheBest) {
    RandomSplines random(57);
    for (int round = 0; round < 60; ++round) {
        const Form form = round % 2 == 0 ? Form::clamped : Form::open;
        const KnotVector knots = fittingKnots(random, random.integer(1, 6), form, round % 3 == 0);
        auto ts = dataParameters(knots, random, 20);
        // Data need not stand at the ends.
        if (round % 4 < 2) ts = {ts.begin() + 2, ts.end() - 2};
        const auto points = randomPoints(random, static_cast<int>(ts.size()));
        const auto curve =
            leastSquaresCurve(points, ts, knots, {.interpolateEnds = true}).value();
        const Interval domain = knots.domain();
        const Vec3 start = curve.point(domain.start);
        const Vec3 end = curve.point(domain.end);
        const double gate = form == Form::clamped ? 0 : test::gates::fitted;
        ASSERT_LE(glm::length(start - points.front()), gate) << "round " << round;
        ASSERT_LE(glm::length(end - points.back()), gate) << "round " << round;
        // The gradient is a combination of the two end functions, and of nothing else.
        const auto n = static_cast<std::size_t>(knots.pointCount());
        std::vector<double> first(n);
        std::vector<double> last(n);
        basisRows(knots, domain.start, Side::right, 0, first);
        basisRows(knots, domain.end, Side::left, 0, last);
        const auto slope = gradient(curve, points, ts);
        const auto p = static_cast<std::size_t>(
            std::max_element(first.begin(), first.end()) - first.begin());
        const auto q = static_cast<std::size_t>(
            std::max_element(last.begin(), last.end()) - last.begin());
        const double det = first[p] * last[q] - first[q] * last[p];
        if (std::abs(det) < 1e-3) continue;
        const Vec3 a = (slope[p] * last[q] - slope[q] * last[p]) / det;
        const Vec3 b = (slope[q] * first[p] - slope[p] * first[q]) / det;
        for (std::size_t i = 0; i < n; ++i) {
            ASSERT_LE(glm::length(slope[i] - first[i] * a - last[i] * b),
                      test::gates::fitted * static_cast<double>(ts.size()));
        }
    }
}

TEST(Fitting, FollowsAnAffineMap) {
    RandomSplines random(58);
    const Mat3 map(1.5, -0.5, 0.25, 0.75, 1.25, -1, 0.5, 2, 1);
    const Vec3 shift(3, -2, 1);
    for (const Form form : allForms) {
        const auto points = randomPoints(random, 200);
        std::vector<Vec3> mapped;
        for (const Vec3& point : points) mapped.push_back(map * point + shift);
        const FitRequest request{.count = 12, .form = form,
                                 .parameters = Parametrisation::uniform,
                                 .options = {.smoothing = 0.1}};
        const Fit fit = fitCurve(points, request).value();
        const Fit other = fitCurve(mapped, request).value();
        std::vector<Vec3> expected;
        for (const Vec3& point : fit.curve.points()) expected.push_back(map * point + shift);
        EXPECT_LE(farthest(other.curve.points(), expected), test::gates::fitted);
    }
}

TEST(Fitting, ClosedFitDoesNotCareWhereTheListBegins) {
    RandomSplines random(59);
    const auto points = randomPoints(random, 60);
    std::vector<Vec3> turned(points.begin() + 12, points.end());
    turned.insert(turned.end(), points.begin(), points.begin() + 12);
    const FitRequest request{.count = 15, .form = Form::closed,
                             .parameters = Parametrisation::uniform,
                             .options = {.smoothing = 0.01}};
    const Fit fit = fitCurve(points, request).value();
    const Fit other = fitCurve(turned, request).value();
    std::vector<Vec3> expected(fit.curve.points().begin() + 3, fit.curve.points().end());
    expected.insert(expected.end(), fit.curve.points().begin(), fit.curve.points().begin() + 3);
    EXPECT_LE(farthest(other.curve.points(), expected), test::gates::fitted);
    EXPECT_TRUE(fit.curve.closed());
    EXPECT_EQ(fit.curve.domain(), (Interval{0, 1}));
}

TEST(Fitting, DenseDataAreReproducedUpToHighDegrees) {
    RandomSplines random(60);
    for (int degree = 1; degree <= 12; ++degree) {
        const auto curve = fittingCurve(random, degree, Form::clamped);
        std::vector<double> ts;
        for (std::size_t i = 0; i <= 3000; ++i) {
            ts.push_back(uniformParameter(curve.domain(), i, 3001));
        }
        const auto points = pointsOf(curve, ts);
        const auto fit = leastSquaresCurve(points, ts, curve.knotVector()).value();
        EXPECT_LE(farthest(pointsOf(fit, ts), points), test::gates::fitted) << degree;
    }
}

TEST(Fitting, CrowdedDataInASpanAreStillSolvedWell) {
    RandomSplines random(61);
    const auto curve = fittingCurve(random, 3, Form::clamped);
    auto ts = dataParameters(curve.knotVector(), random, 0);
    const double crowded = (curve.domain().start + curve.domain().end) / 2 + 0.01;
    for (int i = 0; i < 9000; ++i) ts.push_back(crowded + i * 1e-9);
    std::sort(ts.begin(), ts.end());
    const auto points = pointsOf(curve, ts);
    const auto fit = leastSquaresCurve(points, ts, curve.knotVector()).value();
    EXPECT_LE(farthest(fit.points(), curve.points()), test::gates::fitted);
}

TEST(Fitting, WhatCannotBeFittedIsRefusedWithItsReason) {
    const auto refusal = [](const auto& made) {
        return made.ok() ? "ok" : std::string(codeName(made.error().code)) + " " + made.error().path;
    };
    const std::vector<Vec3> tooMany(maxDataCount + 1, Vec3(1, 2, 0));
    const auto knots = KnotVector::uniform(2, 3, Form::clamped).value();
    EXPECT_EQ(refusal(leastSquaresCurve(tooMany, {}, knots)), "TOO_LARGE points");
    // The parabola through them has its middle control point at twice that height.
    const std::vector<double> ts{0, 0.5, 1};
    const auto hill = [&](double height) {
        const std::vector<Vec3> points{{0, 0, 0}, {1, height, 0}, {2, 0, 0}};
        return refusal(leastSquaresCurve(points, ts, knots));
    };
    EXPECT_EQ(hill(4e11), "ok");
    EXPECT_EQ(hill(6e11), "OUT_OF_RANGE controlPoints[1]");
    // A millisecond at the parameter 10⁸ is no domain.
    const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    FitRequest late{.degree = 1, .count = 2};
    const std::vector<double> narrow{1e8, 1e8 + 5e-4, 1e8 + 1e-3};
    late.parameters = narrow;
    EXPECT_EQ(refusal(fitCurve(corner, late)), "OUT_OF_RANGE parameters");
    const std::vector<double> wide{1e8, 1e8 + 5, 1e8 + 10};
    late.parameters = wide;
    EXPECT_EQ(refusal(fitCurve(corner, late)), "ok");
}

TEST(Fitting, ParametersAreOneAPointAndAscend) {
    const auto path = [](std::vector<double> parameters, std::size_t points) {
        const auto error = checkParameters(parameters, points);
        return error ? error->path : "none";
    };
    EXPECT_EQ(path({}, 0), "none");
    EXPECT_EQ(path({0, 0, 1}, 3), "none");
    EXPECT_EQ(path({0, 1}, 3), "parameters");
    EXPECT_EQ(path({0, 2, 1}, 3), "parameters[2]");
    EXPECT_EQ(path({0, 1, 2e9}, 3), "parameters[2]");
    EXPECT_EQ(path({0, std::nan(""), 1}, 3), "parameters[1]");
}

TEST(Fitting, ResidualsAreThoseOfTheCurve) {
    RandomSplines random(62);
    for (const Form form : allForms) {
        const auto points = randomPoints(random, 700, false);
        const Fit fit = fitCurve(points, {.count = 10, .form = form}).value();
        double sum = 0;
        double most = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double distance = glm::length(fit.curve.point(fit.parameters[k]) - points[k]);
            sum += distance * distance;
            most = std::max(most, distance);
        }
        EXPECT_NEAR(fit.residuals.sumOfSquares, sum, 1e-12 * sum);
        EXPECT_NEAR(fit.residuals.rms, std::sqrt(sum / 700), 1e-13);
        EXPECT_NEAR(fit.residuals.max, most, 1e-13);
        EXPECT_EQ(fit.curve.dimension(), 2);
    }
}

}  // namespace
}  // namespace knotwork
