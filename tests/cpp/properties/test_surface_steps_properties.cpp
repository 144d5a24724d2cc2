// First, mixed and second derivatives of model surfaces and of their blends over rectangles and over
// triangles against bicomplex steps through the formulas, which no rule of differentiation has
// touched.
#include "properties/property.hpp"
#include "properties/surface_generators.hpp"

#include "support/bicomplex.hpp"
#include "support/function_gates.hpp"
#include "support/model_formulas.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <vector>

namespace knotwork {
namespace {

using test::Bicomplex;
using test::matrixAt;
using test::placesOf;
namespace gates = test::gates;

using Point = std::array<Bicomplex, 3>;
using Formula = std::function<Point(const Bicomplex& u, const Bicomplex& v)>;

constexpr SurfaceOrders second{2, 2};

Vec3 firstSlopes(const Point& p) {
    return {firstSlope(p[0]), firstSlope(p[1]), firstSlope(p[2])};
}
Vec3 secondSlopes(const Point& p) {
    return {secondSlope(p[0]), secondSlope(p[1]), secondSlope(p[2])};
}

/// The entries a + b ≤ 2 of a matrix that was found for formula(u, v).
void expectSteps(const Formula& formula, double u, double v, const std::vector<Vec3>& found,
                 double gate) {
    const auto expectNear = [&](std::size_t k, const Vec3& expected) {
        RC_ASSERT(glm::length(found[k] - expected) <= gate);
    };
    const Point uu = formula(test::steppedBothWays(u), v);
    const Point vv = formula(u, test::steppedBothWays(v));
    const Point uv = formula(test::steppedOnce(u), test::steppedTwice(v));
    expectNear(0, {uu[0].a.real(), uu[1].a.real(), uu[2].a.real()});
    expectNear(second.at(1, 0), firstSlopes(uu));
    expectNear(second.at(0, 1), firstSlopes(vv));
    expectNear(second.at(2, 0), secondSlopes(uu));
    expectNear(second.at(1, 1), secondSlopes(uv));
    expectNear(second.at(0, 2), secondSlopes(vv));
}

double largestOf(std::span<const Vec3> rows) {
    double largest = 1;
    for (const Vec3& row : rows) largest = std::max(largest, glm::length(row));
    return largest;
}

TEST(SurfaceStepsProperty, DerivativesOfModelsAreTheStepsOfTheirFormulas) {
    test::holds(200, [] {
        const ParametricSurface surface = test::ModelCase(*test::anyModelSurface()).surface();
        const auto formula = [&](const Bicomplex& u, const Bicomplex& v) {
            return test::modelFormula(surface.name(), surface.parameters(), u, v);
        };
        for (const SurfacePlace& at : placesOf(surface)) {
            const auto found = matrixAt(surface, at, second);
            expectSteps(formula, at.u, at.v, found, gates::complexStepSlope * largestOf(found));
        }
    });
}

// ---- Blends ------------------------------------------------------------------------------------

/// A B-function with its formula.
struct BlendFormula {
    std::string name;
    BFunction function;
    std::function<Bicomplex(const Bicomplex&)> at;
};
void showValue(const BlendFormula& blend, std::ostream& out) { out << blend.name; }

Bicomplex cubicStep(const Bicomplex& t) { return t * t * (3.0 - 2.0 * t); }

std::vector<BlendFormula> blendFormulas() {
    constexpr double pi = std::numbers::pi;
    const BFunction cubic = BFunction::makePolynomial(1, 1).value();
    const BFunction skew = BFunction::makePolynomial(1, 2).value();  // t² (6 − 8t + 3t²)
    return {
        {"linear", BFunction(), [](const Bicomplex& t) { return t; }},
        {"trigonometric(1)", BFunction::makeTrigonometric(1).value(),
         [](const Bicomplex& t) { return 0.5 - 0.5 * cos(pi * t); }},
        {"trigonometric(2)", BFunction::makeTrigonometric(2).value(),
         [](const Bicomplex& t) { return t - sin(2 * pi * t) / (2 * pi); }},
        {"polynomial(1, 1)", cubic, cubicStep},
        {"polynomial(3, 3)", BFunction::makePolynomial(3, 3).value(),
         [](const Bicomplex& t) {
             return t * t * t * t * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)));
         }},
        {"polynomial(1, 2)", skew,
         [](const Bicomplex& t) { return t * t * (6.0 + t * (3.0 * t - 8.0)); }},
        {"rational(3, 2)", BFunction::makeRational(3, 2).value(),
         [](const Bicomplex& t) {
             const Bicomplex rest = 1.0 - t;
             return t * t * t / (t * t * t + 2.0 * rest * rest * rest);
         }},
        {"composed", BFunction::makeComposed(cubic, skew).value(),
         [](const Bicomplex& t) { return cubicStep(t * t * (6.0 + t * (3.0 * t - 8.0))); }},
        {"dual", BFunction::makeDual(skew).value(), [](const Bicomplex& t) {
             const Bicomplex rest = 1.0 - t;
             return 1.0 - rest * rest * (6.0 + rest * (3.0 * rest - 8.0));
         }}};
}

rc::Gen<BlendFormula> anyBlendFormula() {
    return rc::gen::exec([] {
        const auto all = blendFormulas();
        return all[static_cast<std::size_t>(*test::whole(0, static_cast<int>(all.size()) - 1))];
    });
}

/// Patch (i, j) at (u, v) of its own: the model's formula or its Taylor polynomial, then the pose.
Point patchAt(const BlendingSurface& surface, std::size_t i, std::size_t j, const Bicomplex& u,
              const Bicomplex& v) {
    Point point{};
    if (surface.cutsModel()) {
        const auto* model = surface.model().as<ParametricSurface>();
        point = test::modelFormula(model->name(), model->parameters(), u, v);
    } else {
        const SurfaceOrders degree = surface.cut().orders();
        const auto matrix = surface.matrix(i, j);
        Bicomplex powerU = 1;
        for (std::size_t a = 0; a <= static_cast<std::size_t>(degree.u); ++a) {
            Bicomplex power = powerU;
            for (std::size_t b = 0; b < degree.columns(); ++b) {
                for (int c = 0; c < 3; ++c) {
                    auto& coordinate = point[static_cast<std::size_t>(c)];
                    coordinate = coordinate + power * matrix[degree.at(a, b)][c];
                }
                power = power * (v - surface.alongV().knots[j]) / static_cast<double>(b + 1);
            }
            powerU = powerU * (u - surface.alongU().knots[i]) / static_cast<double>(a + 1);
        }
    }
    const Affine& placement = surface.place(i, j).placement();
    Point placed{};
    for (int c = 0; c < 3; ++c) {
        Bicomplex sum = placement.offset[c];
        for (int k = 0; k < 3; ++k) {
            sum = sum + placement.linear[k][c] * point[static_cast<std::size_t>(k)];
        }
        placed[static_cast<std::size_t>(c)] = sum;
    }
    return placed;
}

/// Σ β_a(u) γ_b(v) P_ab(u, v) in the cell of a place.
Point blended(const BlendingSurface& surface, const BlendFormula& blendU,
              const BlendFormula& blendV, const SurfacePlace& at, const Bicomplex& u,
              const Bicomplex& v) {
    const BlendingSpan spanU = surface.alongU().spanAt(at.u, at.sideU);
    const BlendingSpan spanV = surface.alongV().spanAt(at.v, at.sideV);
    // A parameter that goes round goes round as a whole.
    const Bicomplex s = u + (spanU.t - at.u);
    const Bicomplex t = v + (spanV.t - at.v);
    const Bicomplex beta = blendU.at((s - spanU.start) / spanU.length);
    const Bicomplex gamma = blendV.at((t - spanV.start) / spanV.length);
    Point sum{};
    for (const bool a : {false, true}) {
        for (const bool b : {false, true}) {
            const Bicomplex weight = (a ? beta : 1.0 - beta) * (b ? gamma : 1.0 - gamma);
            const Point patch = patchAt(surface, a ? spanU.second : spanU.first,
                                        b ? spanV.second : spanV.first,
                                        a ? s - spanU.shift : s, b ? t - spanV.shift : t);
            for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + weight * patch[c];
        }
    }
    return sum;
}

/// The largest derivative of the patches that meet here: what they cancel to may be less.
double largestPatch(const BlendingSurface& surface, const SurfacePlace& at) {
    const BlendingSpan spanU = surface.alongU().spanAt(at.u, at.sideU);
    const BlendingSpan spanV = surface.alongV().spanAt(at.v, at.sideV);
    std::vector<Vec3> rows(second.size());
    double largest = 1;
    for (const bool a : {false, true}) {
        for (const bool b : {false, true}) {
            const SurfacePlace own{a ? spanU.t - spanU.shift : spanU.t,
                                   b ? spanV.t - spanV.shift : spanV.t, at.sideU, at.sideV};
            surface.patch(a ? spanU.second : spanU.first, b ? spanV.second : spanV.first, own,
                          second, rows);
            largest = std::max(largest, largestOf(rows));
        }
    }
    return largest;
}

/// By how much a step over this span counts more in the second derivative.
double stretch(const BlendDirection& along, double t, Side side) {
    const double length = along.spanAt(t, side).length;
    return std::max(1.0, 1 / (length * length));
}

TEST(SurfaceStepsProperty, DerivativesOfBlendsAreTheStepsOfTheSumOfTheirPatches) {
    test::holds(200, [] {
        test::BlendingSurfaceCase given = *test::anyBlendingSurface();
        const BlendFormula blendU = *anyBlendFormula();
        const BlendFormula blendV = *anyBlendFormula();
        given.u.blend = {blendU.function, blendU.name};
        given.v.blend = {blendV.function, blendV.name};
        const BlendingSurface surface = given.surface();
        for (const SurfacePlace& at : placesOf(surface)) {
            const auto found = matrixAt(surface, at, second);
            const auto formula = [&](const Bicomplex& u, const Bicomplex& v) {
                return blended(surface, blendU, blendV, at, u, v);
            };
            const double size = largestPatch(surface, at) *
                                stretch(surface.alongU(), at.u, at.sideU) *
                                stretch(surface.alongV(), at.v, at.sideV);
            expectSteps(formula, at.u, at.v, found, gates::complexStepSlope * size);
        }
    });
}

// ---- Triangles ---------------------------------------------------------------------------------

/// The weight of u, by its order or by a B-function.
Bicomplex triangleWeight(const TriangleBlend& blend, const BlendFormula& formula,
                         const Bicomplex& u, const Bicomplex& v, const Bicomplex& w) {
    if (blend.blend) return formula.at(u) / (formula.at(u) + formula.at(v) + formula.at(w));
    if (blend.order == 1) return u * u * (3.0 - 2.0 * u + 6.0 * v * w);
    return u * u * u *
           (10.0 - 15.0 * u + 6.0 * u * u + 30.0 * v * w * (3.0 * v * w - u + 1.0));
}

TEST(SurfaceStepsProperty, DerivativesOfTrianglesAreTheStepsOfTheSumOfTheirPatches) {
    test::holds(200, [] {
        const BlendFormula formula = *anyBlendFormula();
        TriangleBlend blend{*test::whole(1, 2), {}};
        if (*test::whole(0, 1) == 1) blend.blend = formula.function;
        std::vector<ParametricSurface> patches;
        for (int k = 0; k < 3; ++k) {
            patches.push_back(test::ModelCase(*test::anyModelSurface()).surface());
        }
        const Surface surface =
            BlendingTriangle::make({patches[0], patches[1], patches[2]}, blend).value();
        const auto sum = [&](const Bicomplex& u, const Bicomplex& v) {
            const std::array<Bicomplex, 3> at{1.0 - u, u * (1.0 - v), u * v};
            Point all{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Bicomplex weight =
                    triangleWeight(blend, formula, at[k], at[(k + 1) % 3], at[(k + 2) % 3]);
                const Rectangle whole = patches[k].domain();
                const Point point = test::modelFormula(
                    patches[k].name(), patches[k].parameters(),
                    whole.u.start + at[1] * whole.u.length(),
                    whole.v.start + at[2] * whole.v.length());
                for (std::size_t c = 0; c < 3; ++c) all[c] = all[c] + weight * point[c];
            }
            return all;
        };
        double size = 1;
        for (const ParametricSurface& patch : patches) {
            const Rectangle whole = patch.domain();
            const double length = std::max(whole.u.length(), whole.v.length());
            const SurfacePlace middle{(whole.u.start + whole.u.end) / 2,
                                      (whole.v.start + whole.v.end) / 2};
            size = std::max(size, largestOf(matrixAt(patch, middle, second)) * length * length);
        }
        for (int k = 0; k < 10; ++k) {
            // The corners and the sides of the square among them.
            const double u = k < 4 ? k % 2 : std::abs(*test::real(1));
            const double v = k < 4 ? k / 2 : k < 6 ? k % 2 : std::abs(*test::real(1));
            const auto found = matrixAt(surface, {u, v}, second);
            expectSteps(sum, u, v, found, gates::complexStepSlope * size);
        }
    });
}

}  // namespace
}  // namespace knotwork
