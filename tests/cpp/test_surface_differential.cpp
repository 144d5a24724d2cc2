#include "geometry/surface_differential.hpp"

#include "support/surface_gates.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::model;

constexpr double pi = std::numbers::pi;

SurfacePlace place(const Surface& surface, double u, double v) {
    return placeInDomain(surface, u, v).value();
}

void expectCurvatures(const Surface& surface, double u, double v, double k1, double k2) {
    const auto found = curvatures(surface, place(surface, u, v));
    ASSERT_TRUE(found.ok()) << u << ' ' << v << ' ' << found.error().message;
    EXPECT_NEAR(found->k1, k1, gates::curvature) << u << ' ' << v;
    EXPECT_NEAR(found->k2, k2, gates::curvature) << u << ' ' << v;
    EXPECT_NEAR(found->gaussian, k1 * k2, gates::curvature) << u << ' ' << v;
    EXPECT_NEAR(found->mean, (k1 + k2) / 2, gates::curvature) << u << ' ' << v;
}

TEST(SurfaceDifferential, TheNormalIsTheCrossProduct) {
    for (const BsplineSurface& spline : test::surfacesOfEveryForm(3, 3)) {
        const Surface surface = spline;
        const Rectangle whole = spline.domain();
        for (const double u : test::telling(whole.u, spline.breaksU())) {
            for (const double v : test::telling(whole.v, spline.breaksV())) {
                const SurfacePlace at = place(surface, u, v);
                const auto rows = test::matrixAt(surface, at, {1, 1});
                const Vec3 cross = glm::cross(rows[2], rows[1]);
                if (glm::length(cross) < 1e-3) continue;
                const Vec3 gap = unitNormal(surface, at) - cross / glm::length(cross);
                EXPECT_LE(glm::length(gap), gates::normal);
            }
        }
    }
}

TEST(SurfaceDifferential, CurvaturesAreThoseOfTheFundamentalForms) {
    for (const BsplineSurface& spline : test::surfacesOfEveryForm(3, 3)) {
        const Surface surface = spline;
        const Rectangle whole = spline.domain();
        for (const double share : {0.13, 0.42, 0.77}) {
            const SurfacePlace at{whole.u.start + share * whole.u.length(),
                                  whole.v.end - share * whole.v.length()};
            const auto rows = test::matrixAt(surface, at, {2, 2});
            const Vec3& su = rows[3];
            const Vec3& sv = rows[1];
            const Vec3 cross = glm::cross(su, sv);
            const double area = glm::dot(cross, cross);
            if (area < 1e-4) continue;
            const Vec3 n = cross / std::sqrt(area);
            const double e = glm::dot(rows[6], n);
            const double f = glm::dot(rows[4], n);
            const double g = glm::dot(rows[2], n);
            const double gaussian = (e * g - f * f) / area;
            const double mean = (e * glm::dot(sv, sv) - 2 * f * glm::dot(su, sv) +
                                 g * glm::dot(su, su)) / (2 * area);
            const auto found = curvatures(surface, at);
            ASSERT_TRUE(found.ok());
            const double size = 1 + mean * mean + std::abs(gaussian);
            EXPECT_NEAR(found->gaussian, gaussian, gates::generalCurvature * size);
            EXPECT_NEAR(found->mean, mean, gates::generalCurvature * size);
            EXPECT_NEAR(found->k1 * found->k2, gaussian, gates::generalCurvature * size);
            EXPECT_GE(found->k1, found->k2);
        }
    }
}

TEST(SurfaceDifferential, ASphereIsEquallyCurvedEverywhereAndItsNormalPointsOutwards) {
    const Surface sphere = model("sphere", {{"radius", 2}});
    for (const double u : {0.0, 0.5, 3.0, 2 * pi}) {
        for (const double v : {-pi / 2, -1.0, 0.0, 0.7, 1.570796, pi / 2}) {
            const Vec3 normal = unitNormal(sphere, place(sphere, u, v));
            const Vec3 outwards = pointAt(sphere, {u, v}) / 2.0;
            EXPECT_LE(glm::length(normal - outwards), gates::normal) << u << ' ' << v;
            expectCurvatures(sphere, u, v, -0.5, -0.5);
        }
    }
}

TEST(SurfaceDifferential, ATorusACylinderAndAPlaneHaveTheirCurvatures) {
    const Surface torus = model("torus", {{"R", 3}, {"r", 0.5}});
    for (const double v : {0.0, 1.0, pi / 2, 3.0, 5.0}) {
        expectCurvatures(torus, 1.3, v, std::max(-2.0, -std::cos(v) / (3 + 0.5 * std::cos(v))), -2);
    }
    expectCurvatures(model("cylinder", {{"radius", 4}}), 2, 0.3, 0, -0.25);
    expectCurvatures(model("plane"), 0.2, 1, 0, 0);
}

TEST(SurfaceDifferential, AHelicoidIsMinimal) {
    const Surface helicoid = model("helicoid", {{"pitch", 2 * pi}});
    for (const double v : {-1.0, -0.2, 0.0, 0.6}) {
        const double k = 1 / (1 + v * v);
        expectCurvatures(helicoid, 0.4, v, k, -k);
    }
}

TEST(SurfaceDifferential, TheTipOfAConeHasANormalForEveryDirectionAndNoCurvatures) {
    const Surface cone = model("cone", {{"radius", 1}, {"height", 1}});
    for (const double u : {0.0, 1.0, 4.0}) {
        const Vec3 expected = Vec3(std::cos(u), std::sin(u), 1) / std::numbers::sqrt2;
        const Vec3 normal = unitNormal(cone, place(cone, u, 1));
        EXPECT_LE(glm::length(normal - expected), gates::normal) << u;
        expectCurvatures(cone, u, 0.5, 0, -std::numbers::sqrt2);
        const auto tip = curvatures(cone, place(cone, u, 1));
        ASSERT_FALSE(tip.ok());
        EXPECT_EQ(tip.error().code, Code::notSupported);
    }
}

TEST(SurfaceDifferential, ARationalPieceOfASphereIsOneUpToItsPole) {
    const Surface sphere = test::eighthOfSphere();
    for (const double u : {0.0, 0.3, 1.0}) {
        for (const double v : {0.0, 0.5, 0.999, 1.0}) {
            const SurfacePlace at = place(sphere, u, v);
            EXPECT_LE(glm::length(unitNormal(sphere, at) - pointAt(sphere, at)), gates::poleNormal)
                << u << ' ' << v;
            const auto found = curvatures(sphere, at);
            ASSERT_TRUE(found.ok());
            EXPECT_NEAR(found->gaussian, 1, gates::poleCurvature) << u << ' ' << v;
            EXPECT_NEAR(found->mean, -1, gates::poleCurvature) << u << ' ' << v;
        }
    }
}

/// Three Bézier pieces along u, the middle one over a gap of this length; its side v = 0 is a point.
Surface inPieces(int degree, double gap) {
    std::vector<double> knots;
    for (const double knot : {0.0, 0.5, 0.5 + gap, 1.0}) {
        knots.insert(knots.end(), static_cast<std::size_t>(degree), knot);
    }
    knots.insert(knots.begin(), 0.0);
    knots.push_back(1.0);
    const int rows = 3 * degree + 1;
    std::vector<Vec3> points;
    for (int i = 0; i < rows; ++i) {
        points.emplace_back(2, -1, 0);
        for (int j = 1; j < 4; ++j) {
            points.emplace_back(i + 0.3 * std::sin(3 * i + j), j, std::sin(1.7 * i + j));
        }
    }
    return BsplineSurface::make(KnotVector::make(knots, degree, rows, Form::clamped).value(),
                                KnotVector::uniform(2, 4, Form::clamped).value(), points)
        .value();
}

void expectAlike(const Surface& a, const SurfacePlace& at, const Surface& b,
                 const SurfacePlace& there) {
    const Vec3 off = unitNormal(a, at) - unitNormal(b, there);
    EXPECT_LE(glm::length(off), gates::poleNormal) << at.u << ' ' << at.v;
    const auto found = curvatures(a, at);
    const auto expected = curvatures(b, there);
    ASSERT_EQ(found.ok(), expected.ok()) << at.u << ' ' << at.v;
    if (!found) return;
    EXPECT_NEAR(found->k1, expected->k1, gates::poleCurvature) << at.u << ' ' << at.v;
    EXPECT_NEAR(found->k2, expected->k2, gates::poleCurvature) << at.u << ' ' << at.v;
}

TEST(SurfaceDifferential, HowFastAPieceIsRunThroughMattersToNoNormalAndNoCurvature) {
    for (const int degree : {1, 2, 3}) {
        const Surface wide = inPieces(degree, 0.25);
        for (const double gap : {1e-3, 1e-6, 1e-8, 1e-10, 2e-12}) {
            const Surface narrow = inPieces(degree, gap);
            const double end = 0.5 + gap;
            for (const double share : {0.0, 0.25, 0.7, 1.0}) {
                const double u = share == 1 ? end : 0.5 + share * gap;
                const Side side = share == 1 ? Side::left : Side::right;
                const double same = 0.5 + (u - 0.5) / (end - 0.5) * 0.25;
                for (const double v : {0.0, 0.3, 1.0}) {
                    const Side sideV = v == 1 ? Side::left : Side::right;
                    expectAlike(narrow, {u, v, side, sideV}, wide, {same, v, side, sideV});
                }
            }
        }
    }
}

TEST(SurfaceDifferential, KnotsCloseToEachOtherChangeNoNormal) {
    const Surface plain = inPieces(3, 0.25);
    const auto& spline = *plain.as<BsplineSurface>();
    for (const double gap : {1e-3, 1e-6, 1e-8, 1e-10}) {
        std::vector<double> refined(spline.breaksU().begin(), spline.breaksU().end());
        refined.insert(refined.end(), {0.25, 0.25 + gap});
        std::sort(refined.begin(), refined.end());
        const Surface close =
            refine(spline, refined, {spline.breaksV().begin(), spline.breaksV().end()}).value();
        for (const double u : {0.25, 0.25 + gap / 3, 0.25 + gap}) {
            for (const double v : {0.0, 0.3}) {
                const Vec3 off = unitNormal(close, {u, v}) - unitNormal(plain, {u, v});
                EXPECT_LE(glm::length(off), gates::normalAmongCloseKnots / gap) << gap << ' ' << v;
            }
        }
    }
}

TEST(SurfaceDifferential, ATriangleWithACollapsedSideAndOneWithACornerThatIsFlatHaveNormals) {
    const auto line = KnotVector::uniform(1, 2, Form::clamped).value();
    const Surface collapsed =
        BsplineSurface::make(line, line, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}).value();
    EXPECT_EQ(unitNormal(collapsed, place(collapsed, 0.5, 0)), Vec3(0, 0, -1));
    EXPECT_EQ(unitNormal(collapsed, place(collapsed, 1, 0)), Vec3(0, 0, -1));
    // Su and Sv are parallel in the corner.
    const auto arc = KnotVector::uniform(2, 3, Form::clamped).value();
    const Surface flat = BsplineSurface::make(arc, line,
                                              {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                               {2, 1, 0}, {1, 2, 0}})
                             .value();
    EXPECT_LE(glm::length(unitNormal(flat, place(flat, 0, 0)) - Vec3(0, 0, 1)), 1e-15);
}

TEST(SurfaceDifferential, WhatIsNoSurfaceHasNoNormal) {
    const Surface point = model("sphere", {{"radius", 0}});
    EXPECT_EQ(unitNormal(point, place(point, 1, 0)), Vec3(0));
    EXPECT_EQ(curvatures(point, place(point, 1, 0)).error().code, Code::notSupported);
    const Surface line = model("cylinder", {{"radius", 0}});
    EXPECT_EQ(unitNormal(line, place(line, 1, 0.5)), Vec3(0));
}

TEST(SurfaceDifferential, AThinStripHasItsNormal) {
    const Surface strip = model("plane", {{"width", 1e6}, {"height", 1e-6}});
    EXPECT_EQ(unitNormal(strip, place(strip, 1, 0)), Vec3(0, 0, 1));
    expectCurvatures(strip, 1, 0, 0, 0);
}

}  // namespace
}  // namespace knotwork
