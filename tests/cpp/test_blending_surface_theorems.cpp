// The theorems of blending surfaces, for patches of every kind and B-functions of most families.
#include "support/blending_gates.hpp"
#include "support/blending_surfaces.hpp"
#include "support/seen_knots.hpp"

#include <gtest/gtest.h>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::expectNear;
using test::matrixAt;

constexpr SurfaceOrders second{2, 2};
constexpr std::array bothSides{Side::left, Side::right};

std::vector<Vec3> patchAt(const BlendingSurface& surface, std::size_t i, std::size_t j,
                          const SurfacePlace& at, const SurfaceOrders& orders) {
    std::vector<Vec3> rows(orders.size(), Vec3(99));
    surface.patch(i, j, at, orders, rows);
    return rows;
}

double largestOf(std::span<const Vec3> rows) {
    double largest = 1;
    for (const Vec3& row : rows) largest = std::max(largest, glm::length(row));
    return largest;
}

TEST(BlendingSurfaceTheorem, AtItsKnotsTheSurfaceHasItsPatchUpToTheHermiteOrders) {
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, surface] : test::blendingSpecimens(blendU, blendV)) {
            for (const test::SeenKnot& u : test::seenKnots(surface.alongU())) {
                for (const test::SeenKnot& v : test::seenKnots(surface.alongV())) {
                    const auto got = matrixAt(surface, {u.t, v.t, u.side, v.side}, second);
                    const auto expected = patchAt(surface, u.patch, v.patch,
                                                  {u.own, v.own, u.side, v.side}, second);
                    for (std::size_t a = 0; a <= 2 && static_cast<double>(a) <= u.order; ++a) {
                        for (std::size_t b = 0; b <= 2 && static_cast<double>(b) <= v.order; ++b) {
                            expectNear(got[second.at(a, b)], expected[second.at(a, b)],
                                       gates::hermite * largestOf(expected),
                                       name + " by " + blends + " at " + std::to_string(u.patch) +
                                           ", " + std::to_string(v.patch));
                        }
                    }
                }
            }
        }
    }
}

/// Where a closed direction goes on from its end.
double wrapped(const BlendDirection& along, double t, Side side) {
    const double seam = side == Side::right ? along.knots.back() : along.knots.front();
    if (!along.closed() || t != seam) return t;
    return side == Side::right ? along.knots.front() : along.knots.back();
}

TEST(BlendingSurfaceTheorem, SubSurfacesThatNobodyMovedAreTheModelForEveryBFunction) {
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, surface] : test::blendingSpecimens(blendU, blendV, false)) {
            const bool returns = name.find("shell") == std::string::npos &&
                                 name.find("strip") == std::string::npos;
            if (!surface.cutsModel() || !returns) continue;
            const Rectangle whole = surface.domain();
            for (const double u : test::telling(whole.u, surface.breaksU())) {
                for (const double v : test::telling(whole.v, surface.breaksV())) {
                    for (const Side side : bothSides) {
                        const SurfacePlace at{wrapped(surface.alongU(), u, side),
                                              wrapped(surface.alongV(), v, side), side, side};
                        EXPECT_EQ(matrixAt(surface, {u, v, side, side}, second),
                                  matrixAt(surface.model(), at, second))
                            << name << " by " << blends;
                    }
                }
            }
        }
    }
}

TEST(BlendingSurfaceTheorem, ATurnThatBeginsElsewhereIsTheModelToo) {
    const Surface torus = test::model("torus");
    const auto erb = BFunction::makeExpoRational().value();
    const double turn = domain(torus).u.length();
    const auto surface =
        BlendingSurface::make(torus, {3, BlendForm::closed, erb, {1, 2, 5, 1 + turn}},
                              {4, BlendForm::closed, erb, {-2, -1, 1, 2, turn - 2}}, {})
            .value();
    for (const double u : {1.0, 1.5, 4.9, 6.0, 7.0, 1 + turn}) {
        for (const double v : {-2.0, 0.0, 1.7, 3.0, 4.2, turn - 2}) {
            const auto got = matrixAt(surface, {u, v}, second);
            const auto expected = matrixAt(torus, {u, v}, second);
            for (std::size_t k = 0; k < got.size(); ++k) {
                expectNear(got[k], expected[k], gates::reproduction * largestOf(expected),
                           "the turned torus");
            }
        }
    }
}

constexpr double choose[5][5]{
    {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};

/// The derivatives of Σ β_a γ_b P_ab, all sums spelled out.
std::vector<Vec3> spelledOut(const BlendingSurface& surface, const SurfacePlace& at,
                             const SurfaceOrders& orders) {
    const BlendDirection& u = surface.alongU();
    const BlendDirection& v = surface.alongV();
    std::size_t i = 0;
    while (i + 2 < u.knots.size() && u.knots[i + 1] <= at.u) ++i;
    std::size_t j = 0;
    while (j + 2 < v.knots.size() && v.knots[j + 1] <= at.v) ++j;
    const auto weights = [](const BlendDirection& along, std::size_t from, double t) {
        const double h = along.knots[from + 1] - along.knots[from];
        std::array<double, 5> b{};
        along.blend.derivatives((t - along.knots[from]) / h, b);
        for (std::size_t k = 0; k < b.size(); ++k) b[k] /= std::pow(h, static_cast<double>(k));
        return b;
    };
    const auto second1 = weights(u, i, at.u);
    const auto second2 = weights(v, j, at.v);
    std::vector<Vec3> sum(orders.size(), Vec3(0));
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) {
            const bool wrapsU = i + a == u.count;
            const bool wrapsV = j + b == v.count;
            const SurfacePlace own{wrapsU ? at.u - (u.knots.back() - u.knots.front()) : at.u,
                                   wrapsV ? at.v - (v.knots.back() - v.knots.front()) : at.v,
                                   at.sideU, at.sideV};
            const auto patch =
                patchAt(surface, wrapsU ? 0 : i + a, wrapsV ? 0 : j + b, own, orders);
            for (std::size_t m = 0; m <= static_cast<std::size_t>(orders.u); ++m) {
                for (std::size_t n = 0; n <= static_cast<std::size_t>(orders.v); ++n) {
                    for (std::size_t k = 0; k <= m; ++k) {
                        for (std::size_t l = 0; l <= n; ++l) {
                            const double beta = a == 1 ? second1[k] : (k == 0 ? 1 : 0) - second1[k];
                            const double gamma = b == 1 ? second2[l] : (l == 0 ? 1 : 0) - second2[l];
                            sum[orders.at(m, n)] += choose[m][k] * choose[n][l] * beta * gamma *
                                                    patch[orders.at(m - k, n - l)];
                        }
                    }
                }
            }
        }
    }
    return sum;
}

TEST(BlendingSurfaceTheorem, BetweenKnotsFourPatchesAreBlendedWithAllDerivatives) {
    constexpr SurfaceOrders orders{4, 3};
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, surface] : test::blendingSpecimens(blendU, blendV)) {
            const Rectangle whole = surface.domain();
            for (const double share : {0.02, 0.21, 0.38, 0.55, 0.74, 0.97}) {
                const SurfacePlace at{whole.u.start + share * whole.u.length(),
                                      whole.v.end - share * whole.v.length()};
                const auto got = matrixAt(surface, at, orders);
                const auto expected = spelledOut(surface, at, orders);
                for (std::size_t k = 0; k < got.size(); ++k) {
                    expectNear(got[k], expected[k], gates::blendedRows * largestOf(expected),
                               name + " by " + blends + ", entry " + std::to_string(k));
                }
            }
        }
    }
}

TEST(BlendingSurfaceTheorem, TheMixedDerivativeIsThatOfEitherFirstDerivative) {
    constexpr SurfaceOrders orders{1, 1};
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, surface] : test::blendingSpecimens(blendU, blendV)) {
            const Rectangle whole = surface.domain();
            const double h = 1e-4;
            const double u = whole.u.start + 0.43 * whole.u.length();
            const double v = whole.v.start + 0.29 * whole.v.length();
            // The five point rule, exact to h⁴ where no knot is within 2h.
            const auto slope = [&](bool alongU, std::size_t entry) {
                Vec3 sum(0);
                for (const auto& [steps, weight] :
                     {std::pair{-2, 1.0}, std::pair{-1, -8.0}, std::pair{1, 8.0}, std::pair{2, -1.0}}) {
                    const SurfacePlace at{u + (alongU ? steps * h : 0), v + (alongU ? 0 : steps * h)};
                    sum += weight * matrixAt(surface, at, orders)[entry];
                }
                return sum / (12 * h);
            };
            const auto got = matrixAt(surface, {u, v}, orders);
            const double gate = gates::fivePoints * largestOf(got);
            expectNear(slope(true, orders.at(0, 0)), got[orders.at(1, 0)], gate, name + blends);
            expectNear(slope(false, orders.at(0, 0)), got[orders.at(0, 1)], gate, name + blends);
            expectNear(slope(true, orders.at(0, 1)), got[orders.at(1, 1)], gate, name + blends);
            expectNear(slope(false, orders.at(1, 0)), got[orders.at(1, 1)], gate, name + blends);
        }
    }
}

TEST(BlendingSurfaceTheorem, OnePoseChangesOnlyWhereItsPatchTakesPart) {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    for (const auto& [name, surface] : test::blendingSpecimens(cubic, cubic)) {
        const BlendDirection& u = surface.alongU();
        const BlendDirection& v = surface.alongV();
        for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 0}, {1, 2}}) {
            auto poses = test::somePoses(u.count * v.count, 17, false);
            poses[i * v.count + j].translate += Vec3(0.5, 1, -1);
            const BlendingSurface moved = surface.withPoses(poses);
            const auto inside = [](const BlendDirection& along, std::size_t index, double t) {
                const Interval support = along.support(index);
                const Interval whole = along.domain();
                if (along.closed() && support.start < t - whole.length()) return true;
                const bool itsOwn = t == along.knots[index];  // an end, for a patch at an open one
                return (support.start < t && t < support.end) || itsOwn;
            };
            std::size_t within = 0;
            for (const double s : test::telling(surface.domain().u, u.knots)) {
                for (const double t : test::telling(surface.domain().v, v.knots)) {
                    const Vec3 before = pointAt(surface, {s, t});
                    const Vec3 after = pointAt(moved, {s, t});
                    if (inside(u, i, s) && inside(v, j, t)) {
                        EXPECT_NE(before, after) << name << " at " << s << ", " << t;
                        ++within;
                    } else {
                        EXPECT_EQ(before, after) << name << " at " << s << ", " << t;
                    }
                }
            }
            EXPECT_GT(within, 0u) << name;
        }
    }
}

TEST(BlendingSurfaceTheorem, AnAffineMapOfTheModelIsThatOfTheSurface) {
    const Affine map{Mat3(1.5, 0.3, -0.2, 0.4, -0.8, 0.1, 0.3, 0.5, 1.1), {3, -2, 1}};
    const BsplineSurface net = test::someSurface({3, 2, Form::closed, Form::open, 7, 6, true});
    std::vector<Vec3> images;
    for (const Vec3& point : net.points()) images.push_back(map.point(point));
    const BsplineSurface mapped =
        BsplineSurface::make(net.knotsU(), net.knotsV(), images,
                             {net.weights().begin(), net.weights().end()})
            .value();
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, cut] : test::allPatchCuts()) {
            const test::BlendingOptions options{4, 3, BlendForm::closed, BlendForm::open, cut,
                                                blendU, blendV, false};
            const BlendingSurface from = test::blendOver(net, options);
            const BlendingSurface to = test::blendOver(mapped, options);
            for (const double u : test::telling(from.domain().u, from.alongU().knots)) {
                for (const double v : test::telling(from.domain().v, from.alongV().knots)) {
                    const auto before = matrixAt(from, {u, v}, {1, 1});
                    const auto after = matrixAt(to, {u, v}, {1, 1});
                    const double gate = gates::affine * largestOf(before);
                    expectNear(after[0], map.point(before[0]), gate, name + " by " + blends);
                    for (std::size_t k = 1; k < 4; ++k) {
                        expectNear(after[k], map.vector(before[k]), gate, name + " by " + blends);
                    }
                }
            }
        }
    }
}

TEST(BlendingSurfaceTheorem, TheLinearBFunctionJoinsWithoutASlopeInCommon) {
    for (const auto& [name, surface] : test::blendingSpecimens({}, {})) {
        const BlendDirection& u = surface.alongU();
        const double v = surface.domain().v.start + 0.3 * surface.domain().v.length();
        double largest = 0;
        for (std::size_t i = 1; i + 1 < u.knots.size(); ++i) {
            const auto left = matrixAt(surface, {u.knots[i], v, Side::left, Side::left}, {1, 0});
            const auto right = matrixAt(surface, {u.knots[i], v}, {1, 0});
            expectNear(left[0], right[0], gates::hermite * largestOf(left), name);
            largest = std::max(largest, glm::length(left[1] - right[1]));
        }
        EXPECT_GT(largest, 0.01) << name;
    }
}

TEST(BlendingSurfaceTheorem, WhereItClosesItGoesOnAsSmoothlyAsAtAnyKnot) {
    const auto smooth = BFunction::makePolynomial(2, 2).value();
    for (const auto& [name, surface] : test::blendingSpecimens(smooth, smooth)) {
        const Rectangle whole = surface.domain();
        for (const double share : {0.0, 0.17, 0.5, 0.93}) {
            if (surface.closed().u) {
                const double v = whole.v.start + share * whole.v.length();
                const auto end = matrixAt(surface, {whole.u.end, v, Side::left}, second);
                const auto start = matrixAt(surface, {whole.u.start, v}, second);
                for (std::size_t k = 0; k < end.size(); ++k) {
                    expectNear(end[k], start[k], gates::hermite * largestOf(start), name);
                }
                EXPECT_EQ(matrixAt(surface, {whole.u.end, v}, second), start) << name;
            }
            if (surface.closed().v) {
                const double u = whole.u.start + share * whole.u.length();
                const SurfacePlace last{u, whole.v.end, Side::right, Side::left};
                const auto end = matrixAt(surface, last, second);
                const auto start = matrixAt(surface, {u, whole.v.start}, second);
                for (std::size_t k = 0; k < end.size(); ++k) {
                    expectNear(end[k], start[k], gates::hermite * largestOf(start), name);
                }
            }
        }
    }
}

}  // namespace
}  // namespace knotwork
