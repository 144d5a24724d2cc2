#include "geometry/triangle_weights.hpp"

#include "geometry/jet.hpp"
#include "support/blending_triangles.hpp"

#include <gtest/gtest.h>

namespace knotwork {
namespace {

namespace gates = test::gates;

constexpr std::size_t order = 6;

/// Corners, sides and the inside.
std::vector<Barycentric> lattice(int steps) {
    std::vector<Barycentric> all;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double x = static_cast<double>(i) / steps;
            const double y = static_cast<double>(j) / steps;
            all.push_back({i + j == steps ? 0 : 1 - x - y, x, y});
        }
    }
    return all;
}

double weight(const TriangleBlend& blend, const Barycentric& at, std::size_t corner) {
    return TriangleWeights(blend, at, 0, (corner + 2) % 3).series(0)[0];
}

TEST(TriangleWeights, SumToOneAndAreNeverNegative) {
    for (const auto& [name, blend] : test::triangleBlends()) {
        for (const Barycentric& at : lattice(23)) {
            Barycentric each{};
            for (std::size_t k = 0; k < 3; ++k) {
                each[k] = weight(blend, at, k);
                EXPECT_GE(each[k], 0) << name;
                EXPECT_EQ(each[k], TriangleWeights(blend, at, 0, (k + 1) % 3).series(1)[0]) << name;
            }
            EXPECT_NEAR(each[0] + each[1] + each[2], 1, gates::weightSum) << name;
            const Barycentric values = TriangleWeights(blend, at, 0).values();
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(values[k], each[k], gates::weightSum) << name;
                EXPECT_GE(values[k], 0) << name;
            }
        }
    }
}

TEST(TriangleWeights, AreTheFractionsOfTheirFormulas) {
    // By (u + v + w)⁴ and (u + v + w)⁷ over 2^8 and 2^14.
    EXPECT_EQ(weight({1, {}}, {0.5, 0.25, 0.25}, 0), 19.0 / 32);
    EXPECT_EQ(weight({1, {}}, {0.5, 0.25, 0.25}, 1), 13.0 / 64);
    EXPECT_EQ(weight({1, {}}, {0.25, 0.75, 0}, 0), 5.0 / 32);
    EXPECT_EQ(weight({2, {}}, {0.5, 0.25, 0.25}, 0), 677.0 / 1024);
    EXPECT_EQ(weight({2, {}}, {0.5, 0.25, 0.25}, 2), 347.0 / 2048);
    EXPECT_EQ(weight({2, {}}, {0.25, 0, 0.75}, 0), 53.0 / 512);
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    EXPECT_EQ(weight({1, cubic}, {0.5, 0.25, 0.25}, 0), 8.0 / 13);  // (1/2) / (1/2 + 2 · 5/32)
    for (const auto& [name, blend] : test::triangleBlends()) {
        for (std::size_t k = 0; k < 3; ++k) {
            Barycentric corner{};
            corner[k] = 1;
            EXPECT_EQ(TriangleWeights(blend, corner, 0).values(), corner) << name;
            EXPECT_NEAR(weight(blend, {1.0 / 3, 1.0 / 3, 1.0 / 3}, k), 1.0 / 3, gates::weightSum);
        }
    }
}

TEST(TriangleWeights, TurnWithTheCorners) {
    for (const auto& [name, blend] : test::triangleBlends()) {
        for (const auto& [u, v, w] : lattice(9)) {
            const double one = weight(blend, {u, v, w}, 0);
            EXPECT_NEAR(weight(blend, {w, u, v}, 1), one, gates::weightSum) << name;
            EXPECT_NEAR(weight(blend, {v, w, u}, 2), one, gates::weightSum) << name;
            EXPECT_NEAR(weight(blend, {u, w, v}, 0), one, gates::weightSum) << name;
        }
    }
}

TEST(TriangleWeights, VanishOnTheOppositeSideUpToTheirOrder) {
    for (const auto& [name, blend] : test::triangleBlends()) {
        const auto upTo =
            static_cast<std::size_t>(std::min(blend.hermiteOrder(), double{maxTriangleOrder}));
        for (const double share : {0.0, 0.3, 0.5, 1.0}) {
            for (std::size_t k = 0; k < 3; ++k) {
                Barycentric at{};
                at[(k + 1) % 3] = share;
                at[(k + 2) % 3] = 1 - share;
                const TriangleWeights weights(blend, at, upTo, (k + 2) % 3);
                EXPECT_TRUE(weights.vanishes(0)) << name;
                if (upTo == maxTriangleOrder || share == 0 || share == 1) continue;
                EXPECT_FALSE(TriangleWeights(blend, at, upTo + 1, (k + 2) % 3).vanishes(0)) << name;
            }
        }
    }
}

/// The formulas again, from the expansions of powers of u + v + w.
Jet spelledOut(int which, const Jet& u, const Jet& v, const Jet& w) {
    if (which == 1) {
        return u * u * (u * u + 4 * u * (v + w) + 3 * (v * v + w * w) + 12 * v * w);
    }
    const Jet inner = u * (v + w) + v * v + w * w + 5 * v * w;
    return u * u * u * (u * u + 5 * u * (v + w) + 10 * (v + w) * (v + w) + 30 * v * w * inner);
}

Jet quotient(const Jet& u, const Jet& v, const Jet& w) {
    const auto b = [](const Jet& t) {
        const Jet other = 1 - t;
        return t * t * t / (t * t * t + other * other * other);
    };
    return b(u) / (b(u) + b(v) + b(w));
}

TEST(TriangleWeights, HaveTheSeriesOfTheirFormulasInEveryDirection) {
    const TriangleBlend rational{1, BFunction::makeRational(3, 1).value()};
    for (const Barycentric& at : {Barycentric{0.2, 0.5, 0.3}, Barycentric{0.7, 0.1, 0.2},
                                  Barycentric{0.0, 0.375, 0.625}, Barycentric{1.0, 0.0, 0.0}}) {
        for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {0.6, 0.8}, {-0.3, 0.9},
                                     {0.9, -0.5}, {-0.7, -0.2}, {0.2, 0.5}}) {
            const int degree = order;
            const Jet t = Jet::variable(0, degree);
            const std::array<Jet, 3> lambda{at[0] - (dx + dy) * t, at[1] + dx * t, at[2] + dy * t};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& [u, v, w] =
                    std::array{lambda[k], lambda[(k + 1) % 3], lambda[(k + 2) % 3]};
                for (const int which : {1, 2, 3}) {
                    const TriangleBlend blend = which == 3 ? rational : TriangleBlend{which, {}};
                    const Jet expected = which == 3 ? quotient(u, v, w) : spelledOut(which, u, v, w);
                    const TriangleWeights weights(blend, at, order, (k + 2) % 3);
                    for (std::size_t n = 0; n <= order; ++n) {
                        double along = 0;
                        for (std::size_t j = 0; j <= n && n <= weights.order(); ++j) {
                            along += weights.series(0)[gradedAt(n - j, j)] *
                                     std::pow(dx, static_cast<double>(n - j)) *
                                     std::pow(dy, static_cast<double>(j));
                        }
                        EXPECT_NEAR(along, expected[static_cast<int>(n)],
                                    gates::triangleSeries * 1e3)
                            << which << " corner " << k << " order " << n;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace knotwork
