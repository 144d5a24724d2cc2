#include "geometry/blending_triangle.hpp"

#include "geometry/jet.hpp"
#include "geometry/surface_differential.hpp"
#include "geometry/surface_tessellation.hpp"
#include "support/blending_triangles.hpp"
#include "support/surface_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::expectNear;
using test::matrixAt;
using test::model;
using test::threeTimes;
using test::triangleOf;

constexpr SurfaceOrders third{3, 3};
constexpr std::array<std::array<double, 2>, 3> corners{{{0, 0.4}, {1, 0}, {1, 1}}};

/// The end of a direction is approached from the left.
SurfacePlace placeAt(double u, double v) {
    return {u, v, u == 1 ? Side::left : Side::right, v == 1 ? Side::left : Side::right};
}

void expectRows(std::span<const Vec3> got, std::span<const Vec3> expected,
                const SurfaceOrders& orders, double upTo, const std::string& name) {
    const double gate = gates::triangleCorner * test::largest(expected);
    for (std::size_t a = 0; a <= static_cast<std::size_t>(orders.u); ++a) {
        for (std::size_t b = 0; b < orders.columns(); ++b) {
            if (static_cast<double>(a + b) > upTo) continue;
            expectNear(got[orders.at(a, b)], expected[orders.at(a, b)], gate,
                       name + ", derivative " + std::to_string(a) + ", " + std::to_string(b));
        }
    }
}

// ---- Against formulas --------------------------------------------------------------------------

using JetPoint = std::array<Jet, 3>;

/// Patches over the unit square: a torus, a cone and a plane.
JetPoint patchFormula(std::size_t k, const Jet& x, const Jet& y) {
    const double turn = 2 * std::numbers::pi;
    if (k == 0) {
        const Jet rho = 3 + 0.5 * cos(turn * y);
        return {rho * cos(turn * x), rho * sin(turn * x), 0.5 * sin(turn * y)};
    }
    if (k == 1) return {2 * (1 - y) * cos(turn * x), 2 * (1 - y) * sin(turn * x), 3 * y};
    return {4 * x, 1.5 * y, Jet::constant(0, x.order())};
}

const std::array<Surface, 3>& formulaPatches() {
    static const std::array<Surface, 3> all{model("torus", {{"R", 3}, {"r", 0.5}}),
                                            model("cone", {{"radius", 2}, {"height", 3}}),
                                            model("plane", {{"width", 4}, {"height", 1.5}})};
    return all;
}

Jet weightFormula(int order, const Jet& u, const Jet& v, const Jet& w) {
    if (order == 1) return u * u * (3 - 2 * u + 6 * v * w);
    return u * u * u * (10 - 15 * u + 6 * u * u + 30 * v * w * (3 * v * w - u + 1));
}

TEST(BlendingTriangle, HasTheDerivativesOfItsFormulaInEveryDirection) {
    constexpr int order = 6;
    constexpr SurfaceOrders orders{order, order};
    for (const int blend : {1, 2}) {
        const Surface surface = triangleOf(formulaPatches(), {blend, {}});
        for (const auto& [u, v] : {std::pair{0.31, 0.27}, {0.84, 0.66}, {0.5, 0.125}, {0.0, 0.7},
                                   {0.93, 0.0}, {1.0, 0.4}, {1.0, 1.0}}) {
            const auto rows = matrixAt(surface, placeAt(u, v), orders);
            for (const auto& [du, dv] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {0.6, 0.8}, {-0.3, 0.9},
                                         {0.9, -0.5}, {-0.7, -0.2}, {0.1, 0.5}}) {
                const Jet t = Jet::variable(0, order);
                const Jet across = v + dv * t;
                const Jet along = u + du * t;
                const std::array<Jet, 3> lambda{1 - along, along * (1 - across), along * across};
                JetPoint sum{0 * t, 0 * t, 0 * t};
                for (std::size_t k = 0; k < 3; ++k) {
                    const Jet weight =
                        weightFormula(blend, lambda[k], lambda[(k + 1) % 3], lambda[(k + 2) % 3]);
                    const JetPoint point = patchFormula(k, lambda[1], lambda[2]);
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * point[c];
                }
                double factorial = 1;
                for (int n = 0; n <= order; ++n) {
                    if (n > 1) factorial *= n;
                    Vec3 got(0);
                    double binomial = 1;
                    double size = 1;
                    for (int b = 0; b <= n; ++b) {
                        const Vec3& row = rows[orders.at(static_cast<std::size_t>(n - b),
                                                         static_cast<std::size_t>(b))];
                        got += binomial * std::pow(du, n - b) * std::pow(dv, b) * row;
                        size = std::max(size, binomial * glm::length(row));
                        binomial *= static_cast<double>(n - b) / (b + 1);
                    }
                    const Vec3 expected =
                        factorial * Vec3(sum[0][n], sum[1][n], sum[2][n]);
                    expectNear(got, expected, gates::triangleSeries * size,
                               "order " + std::to_string(blend) + ", derivative " +
                                   std::to_string(n) + " at " + std::to_string(u));
                }
            }
        }
    }
}

// ---- Theorems ----------------------------------------------------------------------------------

TEST(BlendingTriangleTheorem, InEachCornerThePatchAloneCountsUpToTheOrder) {
    const auto patches = test::threePatches();
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = triangleOf(patches, blend);
        for (std::size_t k = 0; k < 3; ++k) {
            const Surface alone = threeTimes(patches[k], blend);
            const SurfacePlace at = placeAt(corners[k][0], corners[k][1]);
            const auto got = matrixAt(surface, at, third);
            const auto expected = matrixAt(alone, at, third);
            expectRows(got, expected, third, blend.hermiteOrder(), name);
            EXPECT_EQ(got[0], expected[0]) << name;
            // The point of the patch itself in its own corner, to the bit.
            const Rectangle whole = domain(patches[k]);
            EXPECT_EQ(got[0], pointAt(patches[k], {k == 1 ? whole.u.end : whole.u.start,
                                                   k == 2 ? whole.v.end : whole.v.start,
                                                   k == 1 ? Side::left : Side::right,
                                                   k == 2 ? Side::left : Side::right}))
                << name;
            if (blend.hermiteOrder() >= 3) continue;
            const auto next = static_cast<std::size_t>(blend.hermiteOrder()) + 1;
            double apart = 0;
            for (std::size_t a = 0; a <= next; ++a) {
                apart += glm::length(got[third.at(a, next - a)] - expected[third.at(a, next - a)]);
            }
            EXPECT_GT(apart, 0.1) << name << ": of the next order the others count";
        }
    }
}

TEST(BlendingTriangleTheorem, ItIsTheSumOfItsPatchesByItsWeights) {
    for (const auto& [name, blend] : test::triangleBlends()) {
        const BlendingTriangle triangle = triangleOf(test::threePatches(), blend);
        for (const double u : {0.0, 0.3, 0.9, 1.0}) {
            for (const double v : {0.0, 0.2, 0.7, 1.0}) {
                const Barycentric weights = triangle.weights(u, v);
                Vec3 sum(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Surface& patch = triangle.local(k);
                    sum += weights[k] * pointAt(patch, test::onPatch(patch, u * (1 - v), u * v));
                }
                expectNear(pointAt(Surface(triangle), placeAt(u, v)), sum, 10 * gates::trianglePoint,
                           name);
                EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, gates::weightSum) << name;
            }
        }
    }
}

TEST(BlendingTriangleTheorem, CornersAreThoseOfPatchesWhoseEndsAreRounded) {
    const double start = -1.1;
    const double end = 0.3;
    ASSERT_NE(start + (end - start), end);
    const auto knots = KnotVector::make({start, start, end, end}, 1, 2, Form::clamped).value();
    const std::vector<Vec3> points{{0, 0, 0}, {0, 1, 3}, {1, 0, 7}, {1, 1, 0}};
    const Surface patch = BsplineSurface::make(knots, knots, points).value();
    const Surface surface = triangleOf({patch, patch, patch});
    EXPECT_EQ(pointAt(surface, placeAt(1, 0)), points[2]);
    EXPECT_EQ(pointAt(surface, placeAt(1, 1)), points[1]);
}

TEST(BlendingTriangleTheorem, OnTheOppositeSideAPatchHasNoInfluenceUpToTheOrder) {
    const auto patches = test::threePatches();
    const Surface other = test::someSurface({2, 2, Form::clamped, Form::clamped, 3, 3, false, 99});
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = triangleOf(patches, blend);
        for (std::size_t k = 0; k < 3; ++k) {
            auto replaced = patches;
            replaced[k] = other;
            const Surface changed = triangleOf(replaced, blend);
            for (const double share : {0.125, 0.4, 0.5, 0.9}) {
                const SurfacePlace at =
                    k == 0 ? placeAt(1, share) : placeAt(share, k == 1 ? 1 : 0);
                expectRows(matrixAt(changed, at, third), matrixAt(surface, at, third), third,
                           blend.hermiteOrder(), name);
                EXPECT_EQ(pointAt(changed, at), pointAt(surface, at)) << name;
            }
            const SurfacePlace inside = placeAt(0.6, 0.5);
            EXPECT_GT(glm::length(pointAt(changed, inside) - pointAt(surface, inside)), 1e-3);
        }
    }
}

TEST(BlendingTriangleTheorem, PatchesThatAreOneSurfaceBlendIntoIt) {
    const BsplineSurface whole = test::someSurface({3, 2, Form::clamped, Form::clamped, 6, 5});
    const auto knotsOf = [](const KnotVector& knots, double share) {
        std::vector<double> finer(knots.knots().begin(), knots.knots().end());
        finer.push_back(knots.domain().start + share * knots.domain().length());
        std::sort(finer.begin(), finer.end());
        return finer;
    };
    const auto refined = [&](double share) {
        return refine(whole, knotsOf(whole.knotsU(), share), knotsOf(whole.knotsV(), share)).value();
    };
    const Surface expected = whole;
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = triangleOf({whole, refined(0.37), refined(0.81)}, blend);
        for (const double u : {0.0, 0.2, 0.45, 0.8, 1.0}) {
            for (const double v : {0.0, 0.3, 0.5, 0.9, 1.0}) {
                const SurfacePlace at = placeAt(u, v);
                const SurfacePlace own = test::onPatch(expected, u * (1 - v), u * v);
                expectNear(pointAt(surface, at), pointAt(expected, own), gates::trianglePoint, name);
                const Vec3 turned = unitNormal(surface, at) - unitNormal(expected, own);
                EXPECT_LE(glm::length(turned), gates::trianglePole) << name << ' ' << u << ' ' << v;
            }
        }
    }
}

TEST(BlendingTriangleTheorem, ThreeEqualPatchesAreKeptToTheBit) {
    const Surface torus = model("torus");
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = threeTimes(torus, blend);
        for (const double u : {0.0, 0.25, 0.7, 1.0}) {
            for (const double v : {0.0, 0.25, 0.7, 1.0}) {
                EXPECT_EQ(pointAt(surface, placeAt(u, v)),
                          pointAt(torus, test::onPatch(torus, u * (1 - v), u * v)))
                    << name;
            }
        }
    }
}

TEST(BlendingTriangleTheorem, AnAffineMapOfThePatchesIsOneOfTheBlend) {
    const Mat3 turn(1, 2, 0, -1, 0.5, 3, 0.25, 0, -2);
    const Vec3 by(3, -4, 5);
    const auto patches = test::threePatches();
    std::vector<Surface> moved;
    for (const Surface& patch : patches) {
        const BsplineSurface& net = *patch.as<BsplineSurface>();
        std::vector<Vec3> points;
        for (const Vec3& point : net.points()) points.push_back(turn * point + by);
        moved.emplace_back(BsplineSurface::make(net.knotsU(), net.knotsV(), std::move(points),
                                                {net.weights().begin(), net.weights().end()})
                               .value());
    }
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = triangleOf(patches, blend);
        const Surface image = triangleOf({moved[0], moved[1], moved[2]}, blend);
        for (const auto& [u, v] : {std::pair{0.3, 0.2}, {0.7, 0.6}, {1.0, 0.5}, {0.0, 0.1}}) {
            auto expected = matrixAt(surface, placeAt(u, v), third);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                expected[k] = turn * expected[k] + (k == 0 ? by : Vec3(0));
            }
            expectRows(matrixAt(image, placeAt(u, v), third), expected, third, 3, name);
        }
    }
}

TEST(BlendingTriangleTheorem, NormalsAreThoseOfTheCrossProductAndAtThePoleThoseOfThePatch) {
    const auto patches = test::threePatches();
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface = triangleOf(patches, blend);
        for (const double u : {0.2, 0.5, 1.0}) {
            for (const double v : {0.0, 0.4, 1.0}) {
                const auto rows = matrixAt(surface, placeAt(u, v), {1, 1});
                const Vec3 expected = glm::normalize(glm::cross(rows[2], rows[1]));
                expectNear(unitNormal(surface, placeAt(u, v)), expected, 1e-14, name);
            }
        }
        if (blend.hermiteOrder() < 1) continue;
        const auto own = matrixAt(patches[0], test::onPatch(patches[0], 0, 0), {1, 1});
        for (const double v : {0.0, 0.3, 0.5, 1.0}) {
            expectNear(unitNormal(surface, placeAt(0, v)),
                       glm::normalize(glm::cross(own[2], own[1])), gates::trianglePole, name);
        }
    }
}

TEST(BlendingTriangleTheorem, InEachCornerCurvaturesOfOrderTwoAreThoseOfThePatch) {
    const std::array<Surface, 3> patches{model("torus"), model("helicoid"),
                                         test::someSurface({3, 3, Form::open, Form::clamped})};
    for (const auto& [name, blend] : test::triangleBlends()) {
        if (blend.hermiteOrder() < 2) continue;
        // Each patch in each corner.
        for (std::size_t turn = 0; turn < 3; ++turn) {
            const std::array<Surface, 3> turned{patches[turn], patches[(turn + 1) % 3],
                                                patches[(turn + 2) % 3]};
            const Surface surface = triangleOf(turned, blend);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto got = curvatures(surface, placeAt(corners[k][0], corners[k][1]));
                const auto expected = curvatures(
                    turned[k], test::onPatch(turned[k], k == 1 ? 1 : 0, k == 2 ? 1 : 0));
                ASSERT_TRUE(got.ok() && expected.ok()) << name << k << turn;
                const double size = 1 + expected->k1 * expected->k1 + expected->k2 * expected->k2;
                const double gate = gates::trianglePole * size;
                EXPECT_NEAR(got->gaussian, expected->gaussian, gate) << name << k << turn;
                EXPECT_NEAR(got->mean, expected->mean, gate) << name << k << turn;
            }
        }
    }
}

// ---- As every surface --------------------------------------------------------------------------

TEST(BlendingTriangle, GridsHaveItsPointsAndNormals) {
    for (const auto& [name, blend] : test::triangleBlends()) {
        test::expectGrid(triangleOf(test::threePatches(), blend), 9, 12, name);
    }
    test::expectGrid(triangleOf(formulaPatches()), 17, 5, "models");
}

TEST(BlendingTriangle, TriangulationsCoverTheTriangleAndNothingElse) {
    const Surface flat = threeTimes(model("plane", {{"width", 4}, {"height", 3}}));
    const auto mesh = trianglesWithin(flat, 1e-3).value();
    double area = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        std::array<Vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const double* at = &mesh.positions[3 * mesh.triangles[k + c]];
            p[c] = Vec3(at[0], at[1], at[2]);
            EXPECT_LE(3 * at[0] + 4 * at[1], 12 + 1e-12);
        }
        const double one = glm::cross(p[1] - p[0], p[2] - p[0]).z / 2;
        EXPECT_GE(one, -1e-15);
        area += one;
    }
    EXPECT_NEAR(area, 6, 1e-12);
}

/// Two planes that meet along x = 1/2, and one that is flat.
Surface bent(bool alongX) {
    const auto knots = KnotVector::make({0, 0, 0.5, 1, 1}, 1, 3, Form::clamped).value();
    const auto line = KnotVector::uniform(1, 2, Form::clamped).value();
    if (alongX) {
        return BsplineSurface::make(knots, line, {{0, 0, 0}, {0, 1, 0}, {0.5, 0, 1}, {0.5, 1, 1},
                                                  {1, 0, 0}, {1, 1, 0}})
            .value();
    }
    return BsplineSurface::make(line, knots, {{0, 0, 0}, {0, 0.5, 1}, {0, 1, 0}, {1, 0, 0},
                                              {1, 0.5, 1}, {1, 1, 0}})
        .value();
}

/// How far midpoints of edges and of triangles lie from the surface at the same parameters.
double farthest(const Surface& surface, const SurfaceTriangles& mesh) {
    double most = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        for (const auto& [a, b] : {std::pair{1.0 / 3, 1.0 / 3}, {0.5, 0.5}, {0.5, 0.0},
                                   {0.0, 0.5}, {0.2, 0.3}, {0.7, 0.1}}) {
            const std::array<double, 3> shares{a, b, 1 - a - b};
            Vec3 flat(0);
            SurfacePlace at{0, 0};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t i = mesh.triangles[k + c];
                const double* p = &mesh.positions[3 * i];
                flat += shares[c] * Vec3(p[0], p[1], p[2]);
                at.u += shares[c] * mesh.parameters[2 * i];
                at.v += shares[c] * mesh.parameters[2 * i + 1];
            }
            most = std::max(most, glm::length(flat - pointAt(surface, at)));
        }
    }
    return most;
}

TEST(BlendingTriangle, TriangulationsStayWithinTheTolerance) {
    const Surface bumpy = test::someSurface({3, 3, Form::clamped, Form::clamped, 12, 12});
    const Surface other = test::someSurface({2, 4, Form::clamped, Form::clamped, 9, 8, true, 5});
    for (const Surface& surface :
         {Surface(triangleOf(formulaPatches())), Surface(triangleOf(test::threePatches(), {2, {}})),
          Surface(triangleOf({bumpy, other, model("sphere")})), Surface(threeTimes(bumpy)),
          Surface(triangleOf({bent(true), model("plane"), bent(false)})),
          Surface(threeTimes(test::someSurface({1, 1, Form::clamped, Form::clamped, 4, 5})))}) {
        for (const double tolerance : {1.0, 0.1, 0.02}) {
            const auto mesh = trianglesWithin(surface, tolerance);
            ASSERT_TRUE(mesh.ok());
            EXPECT_LE(farthest(surface, *mesh), tolerance * (1 + 1e-9)) << tolerance;
        }
    }
}

TEST(BlendingTriangle, TriangulationsStayWithinTheToleranceWhereKnotsRunAcrossThem) {
    for (unsigned seed = 1; seed <= 9; ++seed) {
        const auto patch = [seed](unsigned k) -> Surface {
            const int degree = 1 + static_cast<int>(seed + k) % 4;
            const int other = 1 + static_cast<int>(seed / 2 + k) % 4;
            return test::someSurface({degree, other, Form::clamped, Form::open,
                                      degree + 1 + static_cast<int>(3 * seed + k) % 7, other + 4,
                                      k == 2, 10 * seed + k});
        };
        const Surface surface = triangleOf({patch(1), patch(2), patch(3)});
        for (const double tolerance : {1.0, 0.3, 0.1}) {
            const auto mesh = trianglesWithin(surface, tolerance).value();
            EXPECT_LE(farthest(surface, mesh), tolerance * (1 + 1e-9)) << seed;
        }
    }
}

TEST(BlendingTriangle, ItsSidesAreIsolines) {
    const auto patches = test::threePatches();
    const Surface surface = triangleOf(patches);
    const auto pole = isolinePoints(surface, {false, 0}, 5);
    for (std::size_t k = 3; k < pole.size(); ++k) EXPECT_EQ(pole[k], pole[k - 3]);
    const auto opposite = isolinePoints(surface, {false, 1}, 5);
    for (std::size_t i = 0; i < 5; ++i) {
        const double t = static_cast<double>(i) / 4;
        const double w = t * t * (3 - 2 * t);
        const Vec3 expected = (1 - w) * pointAt(patches[1], test::onPatch(patches[1], 1 - t, t)) +
                              w * pointAt(patches[2], test::onPatch(patches[2], 1 - t, t));
        expectNear({opposite[3 * i], opposite[3 * i + 1], opposite[3 * i + 2]}, expected,
                   gates::trianglePoint, "the side opposite to corner 0");
    }
}

TEST(BlendingTriangle, KnotsOfPatchesAreSeenFromTheSideThatAPlaceIsApproachedFrom) {
    for (const bool alongX : {true, false}) {
        const Surface surface = triangleOf({bent(alongX), model("plane"), bent(alongX)});
        // On the knot: x = u (1 − v) = 1/2 or y = uv = 1/2.
        for (const double u : {0.5, 0.625, 0.75, 0.875, 1.0}) {
            const double v = alongX ? 1 - 0.5 / u : 0.5 / u;
            for (const double du : {-1.0, 1.0}) {
                for (const double dv : {-1.0, 1.0}) {
                    const double h = 1e-7;
                    const SurfacePlace at{u, v, du < 0 ? Side::left : Side::right,
                                          dv < 0 ? Side::left : Side::right};
                    const SurfacePlace near{u + h * du, v + h * dv, at.sideU, at.sideV};
                    const double share = alongX ? u * (1 - v) : u * v;
                    ASSERT_EQ(share, 0.5) << u;
                    const auto rows = matrixAt(surface, at, {1, 1});
                    const Vec3 slope = du * rows[2] + dv * rows[1];
                    const Vec3 step = (pointAt(surface, near) - rows[0]) / h;
                    EXPECT_LE(glm::length(slope - step), 1e-5) << u << ' ' << du << ' ' << dv;
                }
            }
        }
    }
}

TEST(BlendingTriangle, TriangulationsBeginBetweenTheKnotsOfItsPatches) {
    const Surface surface = triangleOf({bent(true), model("plane"), bent(false)});
    for (const auto& breaks : {breaksU(surface), breaksV(surface)}) {
        EXPECT_EQ((std::vector<double>{breaks.begin(), breaks.end()}),
                  (std::vector<double>{0, 0.5, 1}));
    }
    EXPECT_TRUE(breaksU(threeTimes(model("torus"))).empty());
    const Surface fine = test::someSurface({1, 1, Form::clamped, Form::clamped, 400, 3});
    EXPECT_EQ(breaksU(threeTimes(fine)).size(), 256U);
}

// ---- Surfaces of triangles of surfaces ---------------------------------------------------------

TEST(BlendingTriangle, IsAPatchOfAnother) {
    const Surface inner = triangleOf(formulaPatches(), {2, {}});
    const Surface outer = threeTimes(inner);
    const Surface mixed = triangleOf({inner, model("plane"), inner});
    for (const auto& [u, v] : {std::pair{0.3, 0.2}, {0.8, 0.6}, {1.0, 1.0}}) {
        EXPECT_EQ(pointAt(outer, placeAt(u, v)), pointAt(inner, placeAt(u * (1 - v), u * v)));
        // The five point rule, which knows nothing of series.
        const double h = 1e-3;
        const auto at = [&](double du, double dv) {
            return pointAt(mixed, {u + du * h, v + dv * h});
        };
        const auto rows = matrixAt(mixed, placeAt(u, v), {1, 1});
        expectNear((at(-2, 0) - 8.0 * at(-1, 0) + 8.0 * at(1, 0) - at(2, 0)) / (12 * h), rows[2],
                   1e-7, "Su");
        expectNear((at(0, -2) - 8.0 * at(0, -1) + 8.0 * at(0, 1) - at(0, 2)) / (12 * h), rows[1],
                   1e-7, "Sv");
    }
}

TEST(BlendingTriangle, IsAModelToCutPatchesFrom) {
    const Surface model = triangleOf(test::threePatches());
    const auto surface =
        BlendingSurface::make(model, {.count = 3}, {.count = 3}, {PatchKind::bezier, {3, 3}}).value();
    EXPECT_EQ(pointAt(surface, {0.5, 0.5}), pointAt(model, {0.5, 0.5}));
    const auto copy = BlendingSurface::make(model, {.count = 3}, {.count = 3}, {}).value();
    test::expectGrid(copy, 5, 6, "the model");
    // Derivatives end with those of 25 in all.
    const auto far = BlendingSurface::make(model, {.count = 3}, {.count = 3},
                                           {PatchKind::bezier, {13, 13}});
    ASSERT_FALSE(far.ok());
    EXPECT_EQ(far.error().code, Code::notFinite);
    EXPECT_EQ(far.error().path, "model");
    EXPECT_TRUE(isFinite(matrixAt(model, {0.3, 0.4}, {12, 13}).back()));
    EXPECT_FALSE(isFinite(matrixAt(model, {0.3, 0.4}, {13, 13}).back()));
}

void expectRefusal(const Result<BlendingTriangle>& made, Code code, const char* path) {
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, code);
    EXPECT_EQ(made.error().path, path);
    EXPECT_GT(made.error().message.size(), 20U);
}

TEST(BlendingTriangle, RefusesOrdersAndBFunctionsThatMakeNoWeights) {
    const auto patches = test::threePatches();
    expectRefusal(BlendingTriangle::make(patches, {0, {}}), Code::outOfRange, "order");
    expectRefusal(BlendingTriangle::make(patches, {3, {}}), Code::outOfRange, "order");
    const auto steep = BFunction::makeLogistic(1000).value();
    ASSERT_EQ(steep.value(1.0 / 3), 0);
    expectRefusal(BlendingTriangle::make(patches, {1, steep}), Code::outOfRange, "bFunction");
    const auto flat = BFunction::makeTabulated(std::vector{0.0, 0.0, 0.0, 0.5, 1.0}).value();
    expectRefusal(BlendingTriangle::make(patches, {1, flat}), Code::outOfRange, "bFunction");
}

TEST(BlendingTriangle, RefusesBlendsThatAreNestedTooDeep) {
    Surface nested = model("plane");
    for (int depth = 0; depth < 6; ++depth) nested = threeTimes(nested);  // 729 planes
    const auto deeper = BlendingTriangle::make({nested, nested, nested}, {});
    expectRefusal(deeper, Code::tooLarge, "locals");
    const BlendDirection two{.count = 2};
    const auto copies = BlendingSurface::make(nested, two, two, {}).value();
    const Surface last = BlendingSurface::make(copies, two, two, {}).value();
    const auto ninth = BlendingSurface::make(last, two, two, {});
    ASSERT_FALSE(ninth.ok());
    EXPECT_EQ(ninth.error().path, "model");
    const Surface plain = model("plane");
    expectRefusal(BlendingTriangle::make({plain, plain, last}, {}), Code::tooLarge, "locals");
    EXPECT_TRUE(isFinite(pointAt(last, {0.5, 0.5})));
    EXPECT_TRUE(isFinite(unitNormal(last, {0.5, 0.5})));
}

}  // namespace
}  // namespace knotwork
