// The identities of B-spline surfaces on random ones of every pair of forms, polynomial and rational,
// from both sides of every knot of both directions.
#include "properties/property.hpp"
#include "properties/surface_generators.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/bspline_kernels.hpp"
#include "geometry/surface_differential.hpp"
#include "support/gates.hpp"
#include "support/refinements.hpp"
#include "support/surface_gates.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <limits>
#include <vector>

namespace knotwork {
namespace {

using test::matrixAt;
using test::placesOf;
using test::SurfaceCase;
using Complex = std::complex<double>;
namespace gates = test::gates;

/// The binomial coefficient.
double choose(std::size_t of, std::size_t few) {
    double number = 1;
    for (std::size_t i = 0; i < few; ++i) {
        number *= static_cast<double>(of - i) / static_cast<double>(i + 1);
    }
    return number;
}

/// The quotient rule in two variables, written out: of derivatives of wS and of w those of S. With
/// `sign` 1 instead of −1 and sizes for derivatives, a bound of their sizes.
template <class Scalar>
std::vector<Scalar> quotients(const SurfaceOrders& orders, const std::vector<Scalar>& lifted,
                              const std::vector<Scalar>& weights, double sign) {
    std::vector<Scalar> found(orders.size());
    for (std::size_t a = 0; a <= static_cast<std::size_t>(orders.u); ++a) {
        for (std::size_t b = 0; b < orders.columns(); ++b) {
            Scalar sum = lifted[orders.at(a, b)];
            for (std::size_t i = 0; i <= a; ++i) {
                for (std::size_t j = 0; j <= b; ++j) {
                    if (i + j == 0) continue;
                    sum += sign * choose(a, i) * choose(b, j) * weights[orders.at(i, j)] *
                           found[orders.at(a - i, b - j)];
                }
            }
            found[orders.at(a, b)] = sum / weights[0];
        }
    }
    return found;
}

/// Rows of derivatives of the functions on one span, at a parameter of any kind.
template <class Scalar>
std::vector<std::vector<Scalar>> basisOn(const KnotVector& knots, std::size_t span,
                                         const Scalar& t, int order) {
    const auto degree = static_cast<std::size_t>(knots.degree());
    std::vector<std::vector<Scalar>> rows;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
        rows.emplace_back(degree + 1);
        kernels::basisDerivative(knots.extended(), degree, span, k, t, std::span(rows.back()));
    }
    return rows;
}

struct Spot {
    double inside;
    std::size_t span;
};

Spot spotOf(const KnotVector& knots, double t, Side side) {
    const double inside = knots.wrap(t, side);
    return {inside, knots.findSpan(inside, side)};
}

/// How large the derivatives could be here: the basis' ones, all of one sign, with the least weight
/// under them.
std::vector<double> sizesAt(const BsplineSurface& surface, const SurfacePlace& at,
                            const SurfaceOrders& orders) {
    const auto sums = [](const KnotVector& knots, double t, Side side, int order) {
        const Spot spot = spotOf(knots, t, side);
        std::vector<double> found;
        for (const auto& row : basisOn(knots, spot.span, spot.inside, order)) {
            double sum = 0;
            for (const double value : row) sum += std::abs(value);
            found.push_back(sum);
        }
        return found;
    };
    const auto u = sums(surface.knotsU(), at.u, at.sideU, orders.u);
    const auto v = sums(surface.knotsV(), at.v, at.sideV, orders.v);
    std::vector<double> sizes;
    for (const double a : u) {
        for (const double b : v) sizes.push_back(a * b);
    }
    if (!surface.rational()) return sizes;
    std::vector<double> weights = sizes;  // they and their points are at most 3 in size
    for (std::size_t k = 1; k < weights.size(); ++k) weights[k] *= 3;
    weights[0] = 0.25;
    for (double& size : sizes) size *= 3;
    return quotients(orders, sizes, weights, 1);
}

/// The derivatives of one coordinate at complex parameters, by the triangular scheme on complex
/// numbers and the sums and quotients of the definition.
std::vector<Complex> complexMatrix(const BsplineSurface& surface, const std::array<Spot, 2>& spots,
                                   const std::array<Complex, 2>& at, const SurfaceOrders& orders,
                                   int axis) {
    const auto u = basisOn(surface.knotsU(), spots[0].span, at[0], orders.u);
    const auto v = basisOn(surface.knotsV(), spots[1].span, at[1], orders.v);
    std::vector<Complex> lifted;
    std::vector<Complex> weights;
    for (const auto& rowU : u) {
        for (const auto& rowV : v) {
            Complex sum = 0;
            Complex weightSum = 0;
            for (std::size_t i = 0; i < rowU.size(); ++i) {
                for (std::size_t j = 0; j < rowV.size(); ++j) {
                    const std::size_t k =
                        surface.knotsU().pointIndex(spots[0].span, i) * surface.columnCount() +
                        surface.knotsV().pointIndex(spots[1].span, j);
                    const double weight = surface.weights().empty() ? 1 : surface.weights()[k];
                    const Complex factor = rowU[i] * rowV[j] * weight;
                    sum += factor * surface.points()[k][axis];
                    weightSum += factor;
                }
            }
            lifted.push_back(sum);
            weights.push_back(weightSum);
        }
    }
    return surface.weights().empty() ? lifted : quotients(orders, lifted, weights, -1);
}

/// What a complex step through values of size 1 loses on a short span, as with curves: it sees their
/// rounding errors, divided by the span.
double stepNoise(const KnotVector& knots, std::size_t span) {
    const auto t = knots.extended();
    return 100 * std::numeric_limits<double>::epsilon() / (t[span + 1] - t[span]);
}

/// Every entry is the complex step of the one before it, along u and along v.
void expectSteps(const BsplineSurface& surface, const SurfacePlace& at,
                 const SurfaceOrders& orders) {
    constexpr double step = 1e-40;
    const std::array spots{spotOf(surface.knotsU(), at.u, at.sideU),
                           spotOf(surface.knotsV(), at.v, at.sideV)};
    const Complex u = spots[0].inside;
    const Complex v = spots[1].inside;
    const Complex over(0, step);
    const auto found = matrixAt(surface, at, orders);
    const auto sizes = sizesAt(surface, at, orders);
    for (int axis = 0; axis < 3; ++axis) {
        const auto alongU = complexMatrix(surface, spots, {u + over, v}, orders, axis);
        const auto alongV = complexMatrix(surface, spots, {u, v + over}, orders, axis);
        for (std::size_t a = 0; a <= static_cast<std::size_t>(orders.u); ++a) {
            for (std::size_t b = 0; b < orders.columns(); ++b) {
                const std::size_t k = orders.at(a, b);
                const double gate = gates::complexStep * sizes[k];
                const double value = found[k][axis];
                RC_ASSERT(std::abs(value - alongU[k].real()) <= gate);
                if (a > 0) {
                    const std::size_t below = orders.at(a - 1, b);
                    const double noise = stepNoise(surface.knotsU(), spots[0].span) * sizes[below];
                    RC_ASSERT(std::abs(value - alongU[below].imag() / step) <= gate + noise);
                }
                if (b > 0) {
                    const std::size_t below = orders.at(a, b - 1);
                    const double noise = stepNoise(surface.knotsV(), spots[1].span) * sizes[below];
                    RC_ASSERT(std::abs(value - alongV[below].imag() / step) <= gate + noise);
                }
            }
        }
    }
}

TEST(SurfaceProperty, EveryDerivativeIsTheComplexStepOfTheOneBeforeAlongBothDirections) {
    test::holds(60, [] {
        const BsplineSurface surface =
            SurfaceCase(*test::anySurface({.nearlyEqualKnots = false})).surface();
        for (const SurfacePlace& at : placesOf(surface)) expectSteps(surface, at, {3, 2});
    });
}

TEST(SurfaceProperty, FirstDerivativesAreComplexStepsBetweenNearlyEqualKnotsToo) {
    test::holds(100, [] {
        const BsplineSurface surface = SurfaceCase(*test::anySurface()).surface();
        for (const SurfacePlace& at : placesOf(surface)) expectSteps(surface, at, {1, 1});
    });
}

// ∂²S/∂u∂v is ∂²S/∂v∂u: of the surface with its directions exchanged.
TEST(SurfaceProperty, ExchangingTheDirectionsTransposesTheMatrixOfDerivatives) {
    test::holds(200, [] {
        const SurfaceCase given = *test::anySurface();
        const BsplineSurface surface = given.surface();
        const BsplineSurface turned = given.transposed().surface();
        constexpr SurfaceOrders orders{3, 2};
        constexpr SurfaceOrders exchanged{2, 3};
        for (const SurfacePlace& at : placesOf(surface)) {
            const auto found = matrixAt(surface, at, orders);
            const auto other = matrixAt(turned, {at.v, at.u, at.sideV, at.sideU}, exchanged);
            const auto sizes = sizesAt(surface, at, orders);
            for (std::size_t a = 0; a <= 3; ++a) {
                for (std::size_t b = 0; b <= 2; ++b) {
                    const Vec3 gap = found[orders.at(a, b)] - other[exchanged.at(b, a)];
                    RC_ASSERT(glm::length(gap) <= gates::refinement * sizes[orders.at(a, b)]);
                }
            }
        }
    });
}

// The functions sum to 1 and their derivatives to 0: the map's offset appears once and unchanged.
TEST(SurfaceProperty, AnAffineMapOfThePointsIsOneOfTheSurface) {
    test::holds(300, [] {
        SurfaceCase given = *test::anySurface();
        const BsplineSurface before = given.surface();
        const Mat3 linear(*test::spacePoint(1, 3), *test::spacePoint(1, 3),
                          *test::spacePoint(1, 3));
        const Vec3 offset = *test::spacePoint(1, 3);
        for (Vec3& point : given.points) point = linear * point + offset;
        const BsplineSurface after = given.surface();
        constexpr SurfaceOrders orders{1, 1};
        for (const SurfacePlace& at : placesOf(before)) {
            const auto from = matrixAt(before, at, orders);
            const auto to = matrixAt(after, at, orders);
            const auto sizes = sizesAt(before, at, orders);
            RC_ASSERT(glm::length(linear * from[0] + offset - to[0]) <= gates::refinement);
            for (std::size_t k = 1; k < 4; ++k) {
                RC_ASSERT(glm::length(linear * from[k] - to[k]) <=
                          gates::refinement * 4 * (1 + sizes[k]));
            }
        }
    });
}

TEST(SurfaceProperty, ItLiesBetweenTheActivePointsInEveryCoordinate) {
    test::holds(300, [] {
        const BsplineSurface surface = SurfaceCase(*test::anySurface()).surface();
        for (const SurfacePlace& at : placesOf(surface)) {
            const Spot u = spotOf(surface.knotsU(), at.u, at.sideU);
            const Spot v = spotOf(surface.knotsV(), at.v, at.sideV);
            Vec3 least(2);
            Vec3 most(-2);
            for (std::size_t i = 0; i <= static_cast<std::size_t>(surface.knotsU().degree()); ++i) {
                for (std::size_t j = 0; j <= static_cast<std::size_t>(surface.knotsV().degree());
                     ++j) {
                    const Vec3& point =
                        surface.points()[surface.knotsU().pointIndex(u.span, i) *
                                             surface.columnCount() +
                                         surface.knotsV().pointIndex(v.span, j)];
                    least = glm::min(least, point);
                    most = glm::max(most, point);
                }
            }
            const Vec3 point = pointAt(surface, at);
            for (int axis = 0; axis < 3; ++axis) {
                RC_ASSERT(point[axis] >= least[axis] - gates::exact);
                RC_ASSERT(point[axis] <= most[axis] + gates::exact);
            }
        }
    });
}

/// A row of the basis over all points of one direction.
std::vector<double> weightsAt(const KnotVector& knots, double t, Side side) {
    std::vector<double> row(static_cast<std::size_t>(knots.pointCount()));
    basisRows(knots, t, side, 0, row);
    return row;
}

TEST(SurfaceProperty, APointMovesTheSurfaceByItsFunctionAndOnlyOnItsSupport) {
    test::holds(300, [] {
        SurfaceCase given = *test::anySurface();
        const BsplineSurface before = given.surface();
        const int i = *test::whole(0, given.u.count - 1);
        const int j = *test::whole(0, given.v.count - 1);
        given.points[static_cast<std::size_t>(i * given.v.count + j)].x += 1;
        const BsplineSurface after = given.surface();
        for (const SurfacePlace& at : placesOf(before)) {
            const double weight =
                weightsAt(before.knotsU(), at.u, at.sideU)[static_cast<std::size_t>(i)] *
                weightsAt(before.knotsV(), at.v, at.sideV)[static_cast<std::size_t>(j)];
            const Vec3 change = matrixAt(after, at, {})[0] - matrixAt(before, at, {})[0];
            if (weight == 0) RC_ASSERT(change == Vec3(0));
            if (given.weights.empty()) {
                RC_ASSERT(std::abs(change.x - weight) <= gates::basisAgainstDeBoor);
            }
        }
    });
}

TEST(SurfaceProperty, RefinementInBothDirectionsKeepsTheSurface) {
    test::holds(200, [] {
        const BsplineSurface surface = SurfaceCase(*test::anySurface()).surface();
        test::RandomSplines random(static_cast<unsigned>(*test::whole(0, 1'000'000)));
        const auto refined =
            refine(surface, test::randomRefinement(surface.knotsU(), random, 5),
                   test::randomRefinement(surface.knotsV(), random, 5));
        RC_PRE(refined.ok());  // a new knot was not too near to an old one
        RC_ASSERT(refined->domain() == surface.domain());
        for (const SurfacePlace& at : placesOf(*refined)) {
            const Vec3 moved = matrixAt(*refined, at, {})[0] - matrixAt(surface, at, {})[0];
            RC_ASSERT(glm::length(moved) <= gates::refinement);
        }
    });
}

TEST(SurfaceProperty, AtAKnotOfMultiplicityMTheFirstDegreeMinusMDerivativesAreContinuous) {
    test::holds(200, [] {
        const BsplineSurface surface =
            SurfaceCase(*test::anySurface({.nearlyEqualKnots = false})).surface();
        const KnotVector& knots = surface.knotsU();
        const Interval domain = knots.domain();
        for (const double u : knots.knots()) {
            const bool inner = domain.start < u && u < domain.end;
            const int smooth = knots.degree() - knots.multiplicity(u);
            if ((!inner && !(knots.closed() && u == domain.start)) || smooth < 0) continue;
            const SurfaceOrders orders{smooth, 1};
            for (const SurfacePlace& at : placesOf(surface)) {
                if (at.u != u || at.sideU != Side::left) continue;
                const SurfacePlace beyond{u, at.v, Side::right, at.sideV};
                const auto left = matrixAt(surface, at, orders);
                const auto right = matrixAt(surface, beyond, orders);
                const auto before = sizesAt(surface, at, orders);
                const auto after = sizesAt(surface, beyond, orders);
                const double gate = surface.rational() ? gates::rationalJumps : gates::refinement;
                for (std::size_t k = 0; k < left.size(); ++k) {
                    RC_ASSERT(glm::length(left[k] - right[k]) <=
                              gate * (1 + before[k] + after[k]));
                }
            }
        }
    });
}

TEST(SurfaceProperty, WhereItIsClosedItEndsAsItBegins) {
    test::holds(200, [] {
        const BsplineSurface surface = SurfaceCase(*test::anySurface()).surface();
        const Rectangle whole = surface.domain();
        const auto expectSame = [&](const SurfacePlace& a, const SurfacePlace& b) {
            RC_ASSERT(matrixAt(surface, a, {2, 2}) == matrixAt(surface, b, {2, 2}));
        };
        for (const SurfacePlace& at : placesOf(surface)) {
            if (surface.closed().u) {
                expectSame({whole.u.start, at.v, at.sideU, at.sideV},
                           {whole.u.end, at.v, at.sideU, at.sideV});
            }
            if (surface.closed().v) {
                expectSame({at.u, whole.v.start, at.sideU, at.sideV},
                           {at.u, whole.v.end, at.sideU, at.sideV});
            }
        }
    });
}

TEST(SurfaceProperty, WhereItIsClampedBothWaysItsCornersAreThoseOfItsNet) {
    test::holds(300, [] {
        SurfaceCase given = *test::anySurface();
        RC_PRE(given.u.form == Form::clamped && given.v.form == Form::clamped);
        const BsplineSurface surface = given.surface();
        const Rectangle whole = surface.domain();
        const std::size_t columns = surface.columnCount();
        const std::size_t last = surface.points().size() - 1;
        const double gate = surface.rational() ? gates::exact : 0;
        const auto expectCorner = [&](double u, double v, std::size_t corner) {
            for (const Side sideU : test::bothSides) {
                for (const Side sideV : test::bothSides) {
                    const Vec3 found = matrixAt(surface, {u, v, sideU, sideV}, {})[0];
                    RC_ASSERT(glm::length(found - surface.points()[corner]) <= gate);
                }
            }
        };
        expectCorner(whole.u.start, whole.v.start, 0);
        expectCorner(whole.u.start, whole.v.end, columns - 1);
        expectCorner(whole.u.end, whole.v.start, last + 1 - columns);
        expectCorner(whole.u.end, whole.v.end, last);
    });
}

// ---- Normals of every kind ---------------------------------------------------------------------

/// Where the first derivatives span a plane.
void expectNormals(const Surface& surface) {
    for (const SurfacePlace& at : placesOf(surface)) {
        const auto rows = matrixAt(surface, at, {1, 1});
        const Vec3 cross = glm::cross(rows[2], rows[1]);
        const double size = glm::length(rows[2]) * glm::length(rows[1]);
        if (!(glm::length(cross) > 1e-3 * size) || !(size > 1e-3)) continue;
        const Vec3 normal = unitNormal(surface, at);
        RC_ASSERT(std::abs(glm::length(normal) - 1) <= gates::normal);
        RC_ASSERT(glm::length(normal - cross / glm::length(cross)) <= gates::normal);
    }
}

TEST(SurfaceProperty, TheNormalIsTheCrossProductOfTheFirstDerivatives) {
    test::holds(100, [] {
        expectNormals(SurfaceCase(*test::anySurface({.nearlyEqualKnots = false})).surface());
    });
    test::holds(100, [] { expectNormals(test::ModelCase(*test::anyModelSurface()).surface()); });
    test::holds(100, [] {
        expectNormals(test::BlendingSurfaceCase(*test::anyBlendingSurface()).surface());
    });
}

}  // namespace
}  // namespace knotwork
