// The theorems of blending surfaces (formulas in blending_surface.hpp) on random models, patches of
// every kind, knots, poses and B-functions, open and closed in each direction.
#include "properties/property.hpp"
#include "properties/surface_generators.hpp"

#include "support/blending_gates.hpp"
#include "support/seen_knots.hpp"
#include "support/splines.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace knotwork {
namespace {

using test::BlendDirectionCase;
using test::BlendingSurfaceCase;
using test::matrixAt;
using test::placesOf;
namespace gates = test::gates;

constexpr SurfaceOrders third{3, 3};

double largestOf(std::span<const Vec3> rows) {
    double largest = 1;
    for (const Vec3& row : rows) largest = std::max(largest, glm::length(row));
    return largest;
}

/// The least distance of neighbouring knots that are not equal, at most 1: derivatives grow by its
/// powers.
double leastSpan(const BlendDirection& along) {
    double least = 1;
    for (std::size_t i = 0; i + 1 < along.knots.size(); ++i) {
        const double span = along.knots[i + 1] - along.knots[i];
        if (span > 0) least = std::min(least, span);
    }
    return least;
}

TEST(BlendingSurfaceProperty, AtItsKnotsItHasTheDerivativesOfItsPatchUpToTheHermiteOrders) {
    test::holds(400, [] {
        const BlendingSurface surface = BlendingSurfaceCase(*test::anyBlendingSurface()).surface();
        const double leastU = leastSpan(surface.alongU());
        const double leastV = leastSpan(surface.alongV());
        std::vector<Vec3> expected(third.size());
        for (const test::SeenKnot& u : test::seenKnots(surface.alongU())) {
            for (const test::SeenKnot& v : test::seenKnots(surface.alongV())) {
                const auto found = matrixAt(surface, {u.t, v.t, u.side, v.side}, third);
                surface.patch(u.patch, v.patch, {u.own, v.own, u.side, v.side}, third, expected);
                const double size = largestOf(expected);
                for (std::size_t a = 0; a <= 3 && static_cast<double>(a) <= u.order; ++a) {
                    for (std::size_t b = 0; b <= 3 && static_cast<double>(b) <= v.order; ++b) {
                        const std::size_t k = third.at(a, b);
                        const double grown = std::pow(leastU, -static_cast<double>(a)) *
                                             std::pow(leastV, -static_cast<double>(b));
                        RC_ASSERT(glm::length(found[k] - expected[k]) <=
                                  gates::hermite * size * grown);
                    }
                }
            }
        }
    });
}

/// A net over [0, 1]² with one polynomial piece of degree (1 … 3, 1 … 3).
BsplineSurface anyPolynomial() {
    const int m = *test::whole(1, 3);
    const int n = *test::whole(1, 3);
    std::vector<Vec3> points;
    for (int k = 0; k < (m + 1) * (n + 1); ++k) points.push_back(*test::spacePoint(1, 3));
    return BsplineSurface::make(KnotVector::uniform(m, m + 1, Form::clamped).value(),
                                KnotVector::uniform(n, n + 1, Form::clamped).value(),
                                std::move(points))
        .value();
}

/// Open, with a B-function of any family over the whole range of its parameters.
BlendDirectionCase anyOpenDirection(const Interval& over) {
    BlendDirectionCase along = *test::anyBlendDirection(over);
    along.form = BlendForm::open;
    along.knots = *test::blendingKnots(over, along.count);
    along.blend = *test::anyFamily();
    return along;
}

/// Σ over k of binomial(a, k) |B^(k)|/h^k here: by what rounding errors of patches grow in the a-th
/// derivative.
double growth(const BlendDirection& along, double t, Side side, std::size_t a) {
    const BlendingSpan span = along.spanAt(t, side);
    std::array<double, 4> rows{};
    along.blend.derivatives(span.ratio(), rows);
    double sum = 1;
    double binomial = 1;
    for (std::size_t k = 0; k <= a; ++k) {
        sum += binomial * std::abs(rows[k]) * std::pow(span.length, -static_cast<double>(k));
        binomial *= static_cast<double>(a - k) / static_cast<double>(k + 1);
    }
    return sum;
}

double growth(const BlendingSurface& surface, const SurfacePlace& at, std::size_t a,
              std::size_t b) {
    return growth(surface.alongU(), at.u, at.sideU, a) *
           growth(surface.alongV(), at.v, at.sideV, b);
}

constexpr SurfaceOrders second{2, 2};

void expectModel(const BlendingSurface& surface, double gate) {
    for (const SurfacePlace& at : placesOf(surface)) {
        const auto expected = matrixAt(surface.model(), at, second);
        const auto found = matrixAt(surface, at, second);
        const double size = largestOf(expected);
        for (std::size_t a = 0; a <= 2; ++a) {
            for (std::size_t b = 0; b <= 2; ++b) {
                const std::size_t k = second.at(a, b);
                RC_ASSERT(glm::length(found[k] - expected[k]) <=
                          gate * size * growth(surface, at, a, b));
            }
        }
    }
}

// Its Taylor polynomials are all the polynomial itself: they differ by rounding, and are blended.
TEST(BlendingSurfaceProperty, PatchesThatAreAllOnePolynomialReproduceItForEveryFamily) {
    test::holds(400, [] {
        const BsplineSurface model = anyPolynomial();
        const BlendDirectionCase u = anyOpenDirection(model.domain().u);
        const BlendDirectionCase v = anyOpenDirection(model.domain().v);
        const PatchCut cut{PatchKind::bezier, {model.knotsU().degree(), model.knotsV().degree()}};
        expectModel(BlendingSurface::make(model, u.direction(), v.direction(), cut).value(),
                    gates::reproduction);
    });
}

TEST(BlendingSurfaceProperty, SubSurfacesThatNobodyMovedReproduceTheirModelForEveryFamily) {
    test::holds(200, [] {
        const ParametricSurface model = test::ModelCase(*test::anyModelSurface()).surface();
        BlendDirectionCase u = anyOpenDirection(model.domain().u);
        BlendDirectionCase v = anyOpenDirection(model.domain().v);
        const auto close = [](BlendDirectionCase& along, const Interval& over, bool closed) {
            if (!closed || *test::whole(0, 1) == 0) return;
            along.form = BlendForm::closed;
            along.knots = *test::blendingKnots(over, along.count + 1);
        };
        close(u, model.domain().u, model.closed().u);
        close(v, model.domain().v, model.closed().v);
        // Where it is closed the model goes round by its formula: the same to rounding.
        expectModel(BlendingSurface::make(model, u.direction(), v.direction(), {}).value(),
                    gates::reproduction);
    });
}

/// What the B-function of a direction makes of patch `index` at a parameter.
double weightOf(const BlendDirection& along, std::size_t index, double t, Side side) {
    const BlendingSpan span = along.spanAt(t, side);
    const double weight = along.blend.value(span.ratio());
    return (span.first == index ? 1 - weight : 0) + (span.second == index ? weight : 0);
}

TEST(BlendingSurfaceProperty, APoseMovesItByTheWeightsOfItsPatchAndOnlyThere) {
    test::holds(300, [] {
        const BlendingSurfaceCase given = *test::anyBlendingSurface();
        const BlendingSurface before = given.surface();
        const auto i = static_cast<std::size_t>(*test::whole(0, static_cast<int>(given.u.count) - 1));
        const auto j = static_cast<std::size_t>(*test::whole(0, static_cast<int>(given.v.count) - 1));
        Pose pose = given.poses[i * given.v.count + j];
        const Vec3 by{1, 2, -1};
        pose.translate += by;
        const BlendingSurface after = before.withPose(i, j, pose);
        auto poses = given.poses;
        poses[i * given.v.count + j] = pose;
        const BlendingSurface another = before.withPoses(poses);
        for (const SurfacePlace& at : placesOf(before)) {
            const double weight = weightOf(before.alongU(), i, at.u, at.sideU) *
                                  weightOf(before.alongV(), j, at.v, at.sideV);
            const auto old = matrixAt(before, at, {1, 1});
            const auto moved = matrixAt(after, at, {1, 1});
            RC_ASSERT(moved == matrixAt(another, at, {1, 1}));
            if (weight == 0) RC_ASSERT(moved[0] == old[0]);
            RC_ASSERT(glm::length(moved[0] - old[0] - weight * by) <=
                      gates::reproduction * largestOf(old));
        }
    });
}

/// A net to cut patches from, and two directions to blend them along.
struct NetBlend {
    test::SurfaceCase net;
    BlendDirectionCase u;
    BlendDirectionCase v;
    PatchCut cut;
};

NetBlend anyNetBlend() {
    NetBlend blend;
    blend.net = *test::anySurface({.maxDegree = 4, .nearlyEqualKnots = false});
    const Rectangle whole = blend.net.surface().domain();
    blend.u = *test::anyBlendDirection(whole.u);
    blend.v = *test::anyBlendDirection(whole.v);
    const auto kind = static_cast<PatchKind>(*test::whole(0, 2));
    blend.cut = {kind, {*test::whole(1, 3), *test::whole(1, 3)}};
    return blend;
}

// ∂²S/∂u∂v is ∂²S/∂v∂u: of the surface with its directions exchanged.
TEST(BlendingSurfaceProperty, ExchangingTheDirectionsTransposesTheMatrixOfDerivatives) {
    test::holds(200, [] {
        const NetBlend given = anyNetBlend();
        std::vector<Pose> poses;
        for (std::size_t k = 0; k < given.u.count * given.v.count; ++k) {
            poses.push_back(*test::somePose());
        }
        std::vector<Pose> turnedPoses;
        for (std::size_t j = 0; j < given.v.count; ++j) {
            for (std::size_t i = 0; i < given.u.count; ++i) {
                turnedPoses.push_back(poses[i * given.v.count + j]);
            }
        }
        const PatchCut turnedCut{given.cut.kind, {given.cut.degree[1], given.cut.degree[0]}};
        const auto surface = BlendingSurface::make(given.net.surface(), given.u.direction(),
                                                   given.v.direction(), given.cut, poses)
                                 .value();
        const auto turned =
            BlendingSurface::make(given.net.transposed().surface(), given.v.direction(),
                                  given.u.direction(), turnedCut, turnedPoses)
                .value();
        for (const SurfacePlace& at : placesOf(surface)) {
            const auto found = matrixAt(surface, at, second);
            const auto other = matrixAt(turned, {at.v, at.u, at.sideV, at.sideU}, second);
            for (std::size_t a = 0; a <= 2; ++a) {
                for (std::size_t b = 0; b <= 2; ++b) {
                    const Vec3 gap = found[second.at(a, b)] - other[second.at(b, a)];
                    RC_ASSERT(glm::length(gap) <= gates::reproduction * largestOf(found) *
                                                      growth(surface, at, a, b));
                }
            }
        }
    });
}

TEST(BlendingSurfaceProperty, AnAffineMapOfTheModelIsOneOfTheSurface) {
    test::holds(200, [] {
        NetBlend given = anyNetBlend();
        const auto make = [&] {
            return BlendingSurface::make(given.net.surface(), given.u.direction(),
                                         given.v.direction(), given.cut)
                .value();
        };
        const BlendingSurface before = make();
        const Affine map{Mat3(*test::spacePoint(1, 3), *test::spacePoint(1, 3),
                              *test::spacePoint(1, 3)),
                         *test::spacePoint(1, 3)};
        for (Vec3& point : given.net.points) point = map.point(point);
        const BlendingSurface after = make();
        for (const SurfacePlace& at : placesOf(before)) {
            const auto from = matrixAt(before, at, {1, 1});
            const auto to = matrixAt(after, at, {1, 1});
            for (std::size_t a = 0; a <= 1; ++a) {
                for (std::size_t b = 0; b <= 1; ++b) {
                    const std::size_t k = 2 * a + b;
                    const Vec3 expected = k == 0 ? map.point(from[k]) : map.vector(from[k]);
                    RC_ASSERT(glm::length(to[k] - expected) <=
                              gates::affine * largestOf(from) * growth(before, at, a, b));
                }
            }
        }
    });
}

/// At the seam from inside either end, where neither has a break there.
void expectSeam(const BlendingSurface& surface, const BlendDirection& along, bool alongU) {
    if (!along.closed()) return;
    const auto& knots = along.knots;
    const bool broken = knots[0] == knots[1] || knots[knots.size() - 2] == knots.back();
    const auto placed = [&](const SurfacePlace& at, double t, Side side) {
        SurfacePlace there = at;
        (alongU ? there.u : there.v) = t;
        (alongU ? there.sideU : there.sideV) = side;
        return there;
    };
    for (const SurfacePlace& at : placesOf(surface)) {
        const auto start = matrixAt(surface, placed(at, knots.front(), Side::right), second);
        RC_ASSERT(matrixAt(surface, placed(at, knots.back(), Side::right), second) == start);
        if (broken) continue;
        const auto end = matrixAt(surface, placed(at, knots.back(), Side::left), second);
        RC_ASSERT(glm::length(end[0] - start[0]) <= gates::reproduction * largestOf(start));
    }
}

TEST(BlendingSurfaceProperty, WhereItIsClosedItEndsAsItBegins) {
    test::holds(300, [] {
        const BlendingSurface surface = BlendingSurfaceCase(*test::anyBlendingSurface()).surface();
        expectSeam(surface, surface.alongU(), true);
        expectSeam(surface, surface.alongV(), false);
    });
}

}  // namespace
}  // namespace knotwork
