#include "geometry/surface.hpp"

#include "geometry/bspline_curve.hpp"
#include "support/surface_gates.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::matrixAt;
using test::someSurface;
using test::surfacesOfEveryForm;
using test::telling;

constexpr std::array bothSides{Side::left, Side::right};

/// The surface's definition by curves: a curve along v for every row, and their points (with the
/// sums of their weights) as a curve along u.
Vec3 byCurves(const BsplineSurface& surface, const SurfacePlace& at) {
    std::vector<Vec3> points;
    std::vector<double> weights;
    const std::size_t columns = surface.columnCount();
    const bool weighted = !surface.weights().empty();
    for (std::size_t i = 0; i < surface.rowCount(); ++i) {
        const auto row = surface.points().subspan(i * columns, columns);
        std::vector<double> of(columns, 1);
        if (weighted) std::copy_n(&surface.weights()[i * columns], columns, of.begin());
        const auto curve = BsplineCurve::make(surface.knotsV(), {row.begin(), row.end()}, 3, of);
        std::vector<Vec3> lifts;
        for (const double weight : of) lifts.emplace_back(weight, 0, 0);
        const auto lift = BsplineCurve::make(surface.knotsV(), lifts, 3);
        Vec3 point;
        Vec3 weight;
        curve->derivatives(at.v, at.sideV, {&point, 1});
        lift->derivatives(at.v, at.sideV, {&weight, 1});
        points.push_back(point);
        weights.push_back(weight.x);
    }
    const auto curve = BsplineCurve::make(surface.knotsU(), points, 3, weights);
    Vec3 point;
    curve->derivatives(at.u, at.sideU, {&point, 1});
    return point;
}

TEST(BsplineSurface, IsACurveOfCurvesInEveryForm) {
    for (const BsplineSurface& surface : surfacesOfEveryForm(3, 2)) {
        const Rectangle whole = surface.domain();
        for (const double u : telling(whole.u, surface.breaksU())) {
            for (const double v : telling(whole.v, surface.breaksV())) {
                for (const Side side : bothSides) {
                    const SurfacePlace at{u, v, side, side};
                    const Vec3 found = matrixAt(surface, at, {})[0];
                    EXPECT_LE(glm::length(found - byCurves(surface, at)), gates::nestedCurves)
                        << u << ' ' << v;
                }
            }
        }
    }
}

TEST(BsplineSurface, AClampedOneBeginsAndEndsInItsCorners) {
    for (const bool weighted : {false, true}) {
        const BsplineSurface surface = someSurface({.weighted = weighted});
        const Rectangle whole = surface.domain();
        const std::size_t columns = surface.columnCount();
        const std::size_t count = surface.points().size();
        const auto expectCorner = [&](const SurfacePlace& at, std::size_t corner) {
            const Vec3 gap = pointAt(surface, at) - surface.points()[corner];
            EXPECT_LE(glm::length(gap), weighted ? gates::weightedCorner : 0) << corner;
        };
        expectCorner({whole.u.start, whole.v.start}, 0);
        expectCorner({whole.u.start, whole.v.end, Side::right, Side::left}, columns - 1);
        expectCorner({whole.u.end, whole.v.start, Side::left, Side::right}, count - columns);
        expectCorner({whole.u.end, whole.v.end, Side::left, Side::left}, count - 1);
    }
}

TEST(BsplineSurface, StaysInTheBoxOfItsPoints) {
    for (const BsplineSurface& surface : surfacesOfEveryForm(4, 3)) {
        for (const double u : telling(surface.domain().u, surface.breaksU())) {
            for (const double v : telling(surface.domain().v, surface.breaksV())) {
                const Vec3 point = pointAt(surface, {u, v});
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_LE(std::abs(point[axis]), 1 + gates::nestedCurves);
                }
            }
        }
    }
}

TEST(BsplineSurface, EqualPointsGiveAPoint) {
    for (BsplineSurface surface : surfacesOfEveryForm(3, 5)) {
        const std::vector<double> weights(surface.weights().begin(), surface.weights().end());
        const auto constant =
            BsplineSurface::make(surface.knotsU(), surface.knotsV(),
                                 std::vector<Vec3>(surface.points().size(), Vec3(1, -2, 3)),
                                 weights);
        for (const double u : telling(surface.domain().u, surface.breaksU())) {
            const auto rows = matrixAt(*constant, {u, surface.domain().v.start + 0.3}, {1, 1});
            EXPECT_LE(glm::length(rows[0] - Vec3(1, -2, 3)), gates::nestedCurves);
            for (std::size_t k = 1; k < 4; ++k) EXPECT_LE(glm::length(rows[k]), 1e-12);
        }
    }
}

// --- derivatives ---------------------------------------------------------------------------------

/// Cubic through S^(a, b) in steps of h: differences of one order give the next one.
Vec3 difference(const Surface& surface, SurfacePlace at, SurfaceOrders orders, bool alongU,
                double step) {
    const auto value = [&](double by) {
        SurfacePlace moved = at;
        (alongU ? moved.u : moved.v) += by * step;
        return matrixAt(surface, moved, orders).back();
    };
    return (8.0 * (value(1) - value(-1)) - (value(2) - value(-2))) / (12 * step);
}

TEST(BsplineSurface, EveryEntryOfTheMatrixIsTheDerivativeOfTheOneBefore) {
    for (const bool weighted : {false, true}) {
        const Surface surface = someSurface({4, 3, Form::clamped, Form::closed, 8, 7, weighted, 3});
        const Rectangle whole = domain(surface);
        for (const double share : {0.11, 0.47, 0.83}) {
            const SurfacePlace at{whole.u.start + share * whole.u.length(),
                                  whole.v.end - share * whole.v.length()};
            const SurfaceOrders orders{3, 3};
            const auto rows = matrixAt(surface, at, orders);
            for (int a = 0; a <= 3; ++a) {
                for (int b = 0; b <= 3; ++b) {
                    const auto entry = [&](int i, int j) {
                        return rows[orders.at(static_cast<std::size_t>(i),
                                              static_cast<std::size_t>(j))];
                    };
                    if (a > 0) {
                        const Vec3 slope = difference(surface, at, {a - 1, b}, true, 1e-3);
                        EXPECT_LE(glm::length(slope - entry(a, b)), 1e-6 * (1 + glm::length(slope)));
                    }
                    if (b > 0) {
                        const Vec3 slope = difference(surface, at, {a, b - 1}, false, 1e-3);
                        EXPECT_LE(glm::length(slope - entry(a, b)), 1e-6 * (1 + glm::length(slope)));
                    }
                }
            }
        }
    }
}

TEST(BsplineSurface, BothSidesOfAKnotAgreeUpToItsContinuityAndNotBeyond) {
    const Surface surface = someSurface({3, 3, Form::clamped, Form::clamped, 6, 6, false, 5});
    const double knot = breaksU(surface)[4];  // simple: two derivatives go on
    const auto left = matrixAt(surface, {knot, 2, Side::left, Side::right}, {3, 1});
    const auto right = matrixAt(surface, {knot, 2, Side::right, Side::right}, {3, 1});
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_LE(glm::length(left[k] - right[k]), 1e-11) << k;
    }
    EXPECT_GT(glm::length(left[6] - right[6]), 0.01);
}

TEST(BsplineSurface, DerivativesBeyondTheDegreeVanish) {
    const auto rows = matrixAt(someSurface({2, 3}), {3.3, 4.1}, {25, 25});
    const SurfaceOrders orders{25, 25};
    for (std::size_t a = 0; a <= 25; ++a) {
        for (std::size_t b = 0; b <= 25; ++b) {
            if (a <= 2 && b <= 3) continue;
            EXPECT_EQ(glm::length(rows[orders.at(a, b)]), 0) << a << ' ' << b;
        }
    }
    EXPECT_GT(glm::length(rows[orders.at(2, 3)]), 0);
}

// --- exact surfaces ------------------------------------------------------------------------------

TEST(BsplineSurface, AQuarterOfACylinderIsExact) {
    const double half = std::numbers::sqrt2 / 2;
    const auto arc = KnotVector::uniform(2, 3, Form::clamped).value();
    const auto line = KnotVector::uniform(1, 2, Form::clamped).value();
    const auto surface =
        BsplineSurface::make(arc, line,
                             {{1, 0, 0}, {1, 0, 2}, {1, 1, 0}, {1, 1, 2}, {0, 1, 0}, {0, 1, 2}},
                             {1, 1, half, half, 1, 1});
    for (int i = 0; i <= 10; ++i) {
        const Vec3 point = pointAt(*surface, {i / 10.0, 0.3});
        EXPECT_NEAR(std::hypot(point.x, point.y), 1, 1e-15);
        EXPECT_NEAR(point.z, 0.6, 1e-15);
    }
}

TEST(BsplineSurface, AnEighthOfASphereIsExact) {
    const BsplineSurface surface = test::eighthOfSphere();
    for (int i = 0; i <= 10; ++i) {
        for (int j = 0; j <= 10; ++j) {
            EXPECT_NEAR(glm::length(pointAt(surface, {i / 10.0, j / 10.0})), 1, 4e-16);
        }
    }
}

// --- refinement ----------------------------------------------------------------------------------

std::vector<double> withMiddles(const KnotVector& knots) {
    std::vector<double> more(knots.knots().begin(), knots.knots().end());
    const Interval domain = knots.domain();
    const std::vector<double> old = more;
    for (std::size_t i = 0; i + 1 < old.size(); ++i) {
        const double middle = (old[i] + old[i + 1]) / 2;
        if (old[i] < old[i + 1] && domain.contains(old[i]) && domain.contains(old[i + 1])) {
            more.push_back(middle);
        }
    }
    std::sort(more.begin(), more.end());
    return more;
}

TEST(BsplineSurface, RefinementKeepsTheSurface) {
    for (const BsplineSurface& surface : surfacesOfEveryForm(3, 2)) {
        const auto refined =
            refine(surface, withMiddles(surface.knotsU()), withMiddles(surface.knotsV()));
        ASSERT_TRUE(refined.ok()) << refined.error().message;
        EXPECT_GT(refined->rowCount(), surface.rowCount());
        EXPECT_GT(refined->columnCount(), surface.columnCount());
        for (const double u : telling(surface.domain().u, refined->breaksU())) {
            for (const double v : telling(surface.domain().v, refined->breaksV())) {
                const Vec3 moved = pointAt(*refined, {u, v}) - pointAt(surface, {u, v});
                EXPECT_LE(glm::length(moved), gates::refinedSurface);
            }
        }
    }
}

TEST(BsplineSurface, ARefusedRefinementNamesTheDirection) {
    const BsplineSurface surface = someSurface();
    const std::vector<double> u(surface.knotsU().knots().begin(), surface.knotsU().knots().end());
    std::vector<double> v(surface.knotsV().knots().begin(), surface.knotsV().knots().end());
    v.pop_back();
    const auto refined = refine(surface, u, v);
    ASSERT_FALSE(refined.ok());
    EXPECT_EQ(refined.error().code, Code::knotsCount);
    EXPECT_EQ(refined.error().path, "knots[1]");
}

TEST(BsplineSurface, HasAtMostAHundredThousandPointsAlsoWhenRefined) {
    const auto line = [](int count) { return KnotVector::uniform(1, count, Form::clamped).value(); };
    const auto made = BsplineSurface::make(line(400), line(251), {});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, Code::tooLarge);
    EXPECT_EQ(made.error().path, "points");
    EXPECT_NE(made.error().message.find("100400 points"), std::string::npos);
    const auto large =
        BsplineSurface::make(line(400), line(250), std::vector<Vec3>(100'000)).value();
    const auto knotsOf = [](const KnotVector& knots) {
        return std::vector<double>(knots.knots().begin(), knots.knots().end());
    };
    const auto refined = refine(large, withMiddles(large.knotsU()), knotsOf(large.knotsV()));
    ASSERT_FALSE(refined.ok());
    EXPECT_EQ(refined.error().code, Code::tooLarge);
    EXPECT_EQ(refined.error().path, "knots");
    EXPECT_NE(refined.error().message.find("199750 points"), std::string::npos);
    EXPECT_TRUE(refine(large, knotsOf(large.knotsU()), knotsOf(large.knotsV())).ok());
}

TEST(BsplineSurface, ErrorsOfADirectionAreSeenFromTheSurface) {
    const auto path = [](const char* of, std::size_t direction) {
        return ofDirection(refuse(Code::outOfRange, of, ""), direction).path;
    };
    EXPECT_EQ(path("knots[3]", 0), "knots[0][3]");
    EXPECT_EQ(path("knots", 1), "knots[1]");
    EXPECT_EQ(path("degree", 1), "degree[1]");
    // Too few points: rows along u, columns along v.
    EXPECT_EQ(path("points", 0), "points");
    EXPECT_EQ(path("points", 1), "points[0]");
    EXPECT_EQ(path("form", 1), "form");
}

TEST(BsplineSurface, RefusesByRowAndColumn) {
    const BsplineSurface good = someSurface();
    std::vector<Vec3> points(good.points().begin(), good.points().end());
    points[2 * good.columnCount() + 3].y = std::nan("");
    const auto notFinite = BsplineSurface::make(good.knotsU(), good.knotsV(), points);
    EXPECT_EQ(notFinite.error().path, "points[2][3]");
    EXPECT_EQ(notFinite.error().code, Code::notFinite);
    points.pop_back();
    EXPECT_EQ(BsplineSurface::make(good.knotsU(), good.knotsV(), points).error().code,
              Code::wrongLength);
    std::vector<double> weights(good.points().size(), 1);
    weights[good.columnCount()] = 0;
    const auto weightless = BsplineSurface::make(
        good.knotsU(), good.knotsV(), {good.points().begin(), good.points().end()}, weights);
    EXPECT_EQ(weightless.error().path, "weights[1][0]");
    EXPECT_EQ(weightless.error().code, Code::outOfRange);
}

}  // namespace
}  // namespace knotwork
