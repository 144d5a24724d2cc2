#include "geometry/surface.hpp"

#include "support/calculus.hpp"
#include "support/model_formulas.hpp"
#include "support/surface_gates.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::Complex;
using test::matrixAt;
using test::model;

constexpr double pi = std::numbers::pi;
using Point = std::array<Complex, 3>;

struct Described {
    std::string name;
    std::vector<NamedValue> parameters;

    [[nodiscard]] ParametricSurface surface() const { return model(name, parameters); }
    [[nodiscard]] Point at(const Complex& u, const Complex& v) const {
        return test::modelFormula(name, surface().parameters(), u, v);
    }
};

/// Parameters unlike the defaults.
std::vector<Described> described() {
    return {{"plane", {{"width", 3}, {"height", 2}}},
            {"cylinder", {{"radius", 2}, {"height", 3}}},
            {"torus", {{"R", 3}, {"r", 0.5}}},
            {"sphere", {{"radius", 1.5}}},
            {"cone", {{"radius", 2}, {"height", 4}}},
            {"moebius", {{"radius", 2}, {"width", 0.5}}},
            {"klein", {{"R", 3}, {"r", 0.7}}},
            {"helicoid", {{"radius", 2}, {"pitch", 3}, {"turns", 1.5}}},
            {"seashell", {{"R", 1.2}, {"r", 0.8}, {"height", 2}, {"growth", 1.5}, {"turns", 3}}}};
}

/// Cauchy's integral in both variables.
Vec3 cauchy(const Described& one, double u, double v, int a, int b) {
    constexpr int points = 24;
    constexpr double radius = 0.75;
    std::array<Complex, 3> sum{};
    for (int i = 0; i < points; ++i) {
        for (int j = 0; j < points; ++j) {
            const double alpha = 2 * pi * (i + 0.5) / points;
            const double beta = 2 * pi * (j + 0.5) / points;
            const Point value = one.at(u + std::polar(radius, alpha), v + std::polar(radius, beta));
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += value[c] * std::polar(1.0, -a * alpha - b * beta);
            }
        }
    }
    const double factor = std::tgamma(a + 1.0) * std::tgamma(b + 1.0) /
                          std::pow(radius, a + b) / (points * points);
    return factor * Vec3(sum[0].real(), sum[1].real(), sum[2].real());
}

TEST(ParametricSurface, EveryModelIsTheFormulaOfItsDescription) {
    for (const Described& one : described()) {
        const ParametricSurface surface = one.surface();
        const Rectangle whole = surface.domain();
        for (int i = 0; i <= 4; ++i) {
            for (int j = 0; j <= 4; ++j) {
                const double u = uniformParameter(whole.u, static_cast<std::size_t>(i), 5);
                const double v = uniformParameter(whole.v, static_cast<std::size_t>(j), 5);
                const Point expected = one.at(u, v);
                const Vec3 point = pointAt(surface, {u, v});
                EXPECT_NEAR(point.x, expected[0].real(), gates::modelPoint) << one.name;
                EXPECT_NEAR(point.y, expected[1].real(), gates::modelPoint) << one.name;
                EXPECT_NEAR(point.z, expected[2].real(), gates::modelPoint) << one.name;
            }
        }
    }
}

TEST(ParametricSurface, MixedDerivativesAreThoseOfTheFormula) {
    constexpr SurfaceOrders orders{4, 3};
    for (const Described& one : described()) {
        const ParametricSurface surface = one.surface();
        const Rectangle whole = surface.domain();
        for (const double share : {0.0, 0.31, 1.0}) {
            const double u = whole.u.start + share * whole.u.length();
            const double v = whole.v.end - share * whole.v.length();
            const auto rows = matrixAt(surface, {u, v}, orders);
            for (int a = 0; a <= 4; ++a) {
                for (int b = 0; b <= 3; ++b) {
                    const Vec3 expected = cauchy(one, u, v, a, b);
                    const Vec3 found =
                        rows[orders.at(static_cast<std::size_t>(a), static_cast<std::size_t>(b))];
                    EXPECT_LE(glm::length(found - expected), gates::cauchyInTwo)
                        << one.name << " a " << a << " b " << b;
                }
            }
        }
    }
}

TEST(ParametricSurface, AMatrixHasTheEntriesOfASmallerOne) {
    for (const auto& description : surfaceModels()) {
        const ParametricSurface surface = model(description.name);
        const SurfacePlace at{0.4, 0.3};
        const auto large = matrixAt(surface, at, {9, 7});
        const auto small = matrixAt(surface, at, {2, 3});
        for (std::size_t a = 0; a <= 2; ++a) {
            for (std::size_t b = 0; b <= 3; ++b) {
                const Vec3 difference =
                    large[SurfaceOrders{9, 7}.at(a, b)] - small[SurfaceOrders{2, 3}.at(a, b)];
                EXPECT_LE(glm::length(difference), gates::modelPoint) << description.name;
            }
        }
    }
}

TEST(ParametricSurface, AClosedDirectionRepeatsAndNoOtherDoes) {
    const auto gap = [](const ParametricSurface& surface, bool alongU) {
        const Rectangle whole = surface.domain();
        const Interval other = alongU ? whole.v : whole.u;
        double largest = 0;
        for (const double share : {0.2, 0.7}) {
            const double t = other.start + share * other.length();
            const SurfacePlace start = alongU ? SurfacePlace{whole.u.start, t}
                                              : SurfacePlace{t, whole.v.start};
            const SurfacePlace end = alongU ? SurfacePlace{whole.u.end, t}
                                            : SurfacePlace{t, whole.v.end};
            const auto first = matrixAt(surface, start, {2, 2});
            const auto last = matrixAt(surface, end, {2, 2});
            for (std::size_t k = 0; k < first.size(); ++k) {
                largest = std::max(largest, glm::length(first[k] - last[k]));
            }
        }
        return largest;
    };
    for (const auto& description : surfaceModels()) {
        const ParametricSurface surface = model(description.name);
        const ClosedDirections closed = surface.closed();
        EXPECT_EQ(closed.u, gap(surface, true) < 1e-9) << description.name;
        EXPECT_EQ(closed.v, gap(surface, false) < 1e-9) << description.name;
    }
}

TEST(ParametricSurface, AStripThatTurnsOverMeetsItselfMirrored) {
    for (const char* name : {"moebius", "klein"}) {
        const ParametricSurface surface = model(name);
        for (const double v : {-0.4, 0.1, 0.5}) {
            const Vec3 there = pointAt(surface, {2 * pi, v});
            const Vec3 here = pointAt(surface, {0, -v});
            EXPECT_LE(glm::length(there - here), gates::modelPoint) << name;
        }
    }
}

TEST(ParametricSurface, RefusesWhatItDoesNotKnow) {
    const auto refusal = [](std::string_view name, std::vector<NamedValue> parameters) {
        const auto made = ParametricSurface::make(name, parameters);
        return made ? std::string("none")
                    : std::string(codeName(made.error().code)) + " " + made.error().path;
    };
    EXPECT_EQ(refusal("sponge", {}), "UNKNOWN_NAME name");
    EXPECT_EQ(refusal("torus", {{"radius", 1}}), "UNKNOWN_FIELD parameters.radius");
    EXPECT_EQ(refusal("torus", {{"R", std::nan("")}}), "NOT_FINITE parameters.R");
    EXPECT_EQ(refusal("plane", {{"width", 0}}), "OUT_OF_RANGE parameters.width");
    EXPECT_EQ(refusal("helicoid", {{"turns", 0}}), "OUT_OF_RANGE parameters.turns");
    EXPECT_EQ(refusal("sphere", {{"radius", 2}}), "none");
}

// --- places --------------------------------------------------------------------------------------

TEST(SurfacePlaces, WrapWhereTheSurfaceIsClosedAndAreRefusedElsewhere) {
    const Surface cylinder = model("cylinder");
    const auto wrapped = placeInDomain(cylinder, 7, 0.5);
    ASSERT_TRUE(wrapped.ok());
    EXPECT_NEAR(wrapped->u, 7 - 2 * pi, 1e-15);
    EXPECT_EQ(placeInDomain(cylinder, 2 * pi, 0.5)->u, 0);
    const auto outside = placeInDomain(cylinder, 0, 1.5);
    ASSERT_FALSE(outside.ok());
    EXPECT_EQ(outside.error().code, Code::outOfRange);
    EXPECT_EQ(outside.error().path, "v");
    EXPECT_EQ(placeInDomain(cylinder, std::nan(""), 0).error().path, "u");
}

TEST(SurfacePlaces, AnEndIsApproachedFromInside) {
    const Surface plane = model("plane");
    EXPECT_EQ(placeInDomain(plane, 1, 0)->sideU, Side::left);
    EXPECT_EQ(placeInDomain(plane, 1, 0)->sideV, Side::right);
    EXPECT_EQ(placeInDomain(plane, 0.5, 1)->sideV, Side::left);
    EXPECT_EQ(placeInDomain(model("torus"), 2 * pi, 2 * pi)->sideU, Side::right);
}

}  // namespace
}  // namespace knotwork
