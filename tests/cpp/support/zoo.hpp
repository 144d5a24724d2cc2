// Curves of every kind that are hard in some way: cusps, corners, jumps, straight and flat parts,
// coordinates far from the origin, spans of very different lengths.
#pragma once

#include "geometry/curve.hpp"
#include "support/model_curves.hpp"
#include "support/splines.hpp"

#include <string>
#include <vector>

namespace knotwork::test {

struct Animal {
    std::string name;
    Curve curve;
};

inline Curve spline(int degree, Form form, std::vector<double> knots, std::vector<Vec3> points,
                    std::vector<double> weights = {}, int dimension = 0) {
    const int count = static_cast<int>(points.size());
    auto vector = knots.empty() ? KnotVector::uniform(degree, count, form)
                                : KnotVector::make(std::move(knots), degree, count, form);
    EXPECT_TRUE(vector.ok());
    if (dimension == 0) {
        dimension = std::all_of(points.begin(), points.end(),
                                [](const Vec3& p) { return p.z == 0; })
                        ? 2
                        : 3;
    }
    auto made = BsplineCurve::make(std::move(vector).value(), std::move(points), dimension,
                                   std::move(weights));
    EXPECT_TRUE(made.ok());
    return Curve(std::move(made).value());
}

inline std::vector<Vec3> sShape() {
    return {{0, 0, 0}, {1, 2, 0}, {2, -2, 0}, {3, 0, 0}};
}

/// A quarter of a unit circle four times, exactly.
inline Curve rationalCircle() {
    const double w = std::sqrt(0.5);
    return spline(2, Form::clamped, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                  {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0},
                   {0, -1, 0}, {1, -1, 0}, {1, 0, 0}},
                  {1, w, 1, w, 1, w, 1, w, 1});
}

inline std::vector<Animal> models() {
    std::vector<Animal> all;
    for (const auto& model : parametricCurveModels()) {
        all.push_back({std::string(model.name), Curve(make(model.name))});
    }
    return all;
}

inline std::vector<Animal> splines() {
    std::vector<Animal> all{
        {"S", spline(3, Form::clamped, {}, sShape())},
        {"loop", spline(3, Form::clamped, {}, {{0, 0, 0}, {4, 3, 0}, {-3, 3, 0}, {1, 0, 0}})},
        {"cusp", spline(3, Form::clamped, {}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}})},
        {"straight, back and forth",
         spline(2, Form::clamped, {}, {{0, 0, 0}, {3, 3, 0}, {1, 1, 0}})},
        {"three equal points at the start",
         spline(3, Form::clamped, {}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 2, 1}, {3, 0, 0}})},
        {"all points equal", spline(3, Form::clamped, {}, std::vector<Vec3>(5, Vec3(2, -1, 3)))},
        {"straight part in space",
         spline(2, Form::clamped, {0, 0, 0, 1, 2, 3, 4, 4, 4},
                {{0, 0, 1}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 2}})},
        {"polygon", spline(1, Form::closed, {}, {{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 0}})},
        {"jump", spline(2, Form::clamped, {0, 0, 0, 1, 1, 1, 2, 2, 2},
                        {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 3, 0}, {3, 4, 0}, {4, 3, 0}})},
        {"short beside long", spline(3, Form::clamped, {0, 0, 0, 0, 1e-6, 1, 1e3, 1e3, 1e3, 1e3},
                                     {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 1, 0}, {4, 0, 0}, {5, 1, 1}})},
        {"far away", spline(3, Form::clamped, {},
                            {{1e6, 1e6, 0}, {1e6 + 1, 1e6 + 2, 0}, {1e6 + 2, 1e6 - 2, 0},
                             {1e6 + 3, 1e6, 0}})},
        {"rational circle", rationalCircle()}};
    RandomSplines random(4711);
    for (const Form form : allForms) {
        for (const bool rational : {false, true}) {
            for (int i = 0; i < 2; ++i) {
                SplineKind kind;
                kind.rational = rational;
                kind.dimension = 2 + i;
                all.push_back({"random " + std::to_string(all.size()),
                               Curve(random.curve(form, kind))});
            }
        }
    }
    return all;
}

inline std::vector<Animal> blends() {
    std::vector<Pose> poses(5);
    poses[1].translate = {0.4, 0.3, 0};
    poses[3].translate = {-0.2, 0.5, 0.6};
    std::vector<Animal> all;
    const auto add = [&](std::string name, const Curve& model, BFunction blend, BlendForm form) {
        auto made = BlendingCurve::fromModel(model, 5, form, std::move(blend), {}, poses);
        EXPECT_TRUE(made.ok());
        all.push_back({std::move(name), Curve(std::move(made).value())});
    };
    const Curve circle(make("circle"));
    add("expo-rational blend of a circle", circle, BFunction::makeExpoRational().value(),
        BlendForm::closed);
    add("blend with a kink inside", circle,
        BFunction::makeExpoRational(1, 1, 0.3, 0.4).value(), BlendForm::closed);
    add("linear blend of a circle", circle, BFunction(), BlendForm::open);
    add("blend by a table", circle,
        BFunction::makeTabulated(std::vector{0.0, 0.1, 0.15, 0.8, 1.0}).value(), BlendForm::open);
    add("blend of a spline with knots of its own",
        spline(2, Form::closed, {}, {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {1, 1, 1}, {0, 2, 0}, {-1, 1, 0}}),
        BFunction::makePolynomial(2, 2).value(), BlendForm::closed);
    auto broken = BlendingCurve::fromModel(circle, 5, BlendForm::open, BFunction(),
                                           {0, 1, 2, 2, 3}, poses);
    EXPECT_TRUE(broken.ok());
    all.push_back({"blend with a break", Curve(std::move(broken).value())});
    return all;
}

/// Formulas with corners and with vertical tangents, whose derivatives are infinite.
inline std::vector<Animal> formulas() {
    const auto formula = [](const char* x, const char* y, const char* z, Interval domain) {
        FormulaCurveParts parts{.x = x, .y = y, .domain = domain};
        if (*z != 0) parts.z = z;
        auto made = FormulaCurve::make(parts);
        EXPECT_TRUE(made.ok());
        return Curve(std::move(made).value());
    };
    return {{"corner of abs", formula("t", "abs(t - 0.3)", "", {-1, 1})},
            {"corner of abs in space", formula("t", "abs(t - 0.3)^3", "abs(t)", {-1, 1})},
            {"root", formula("t", "sqrt(t)", "", {0, 1})},
            {"half circle of roots", formula("t", "sqrt(1 - t^2)", "", {-1, 1})},
            {"wave", formula("t", "sin(40*t)/t^2", "exp(-t)", {0.5, 4})}};
}

/// Of one piece.
inline std::vector<Animal> segments() {
    auto bezier = BezierCurve::make({{0, 0, 0}, {1, 3, 1}, {4, -3, 0}, {5, 0, 2}, {2, 2, 2}},
                                    {1, 2, 0.5, 3, 1}, Interval{-1, 2});
    EXPECT_TRUE(bezier.ok());
    return {{"rational Bézier curve", Curve(std::move(bezier).value())}};
}

/// On the way from one kind of curve to another.
inline std::vector<Animal> morphs() {
    const Curve rose(make("rose"));
    return {{"circle on its way to a rose", morphed(rationalCircle(), rose, 0.4)},
            {"spline on its way to a helix",
             morphed(spline(3, Form::clamped, {}, sShape()), Curve(make("helix")), 0.2)}};
}

inline std::vector<Animal> zoo() {
    std::vector<Animal> all = models();
    for (auto& animal : morphs()) all.push_back(std::move(animal));
    for (auto& animal : splines()) all.push_back(std::move(animal));
    for (auto& animal : blends()) all.push_back(std::move(animal));
    for (auto& animal : segments()) all.push_back(std::move(animal));
    return all;
}

/// The zoo, and what it cannot integrate to the last digit.
inline std::vector<Animal> wholeZoo() {
    std::vector<Animal> all = zoo();
    for (auto& animal : formulas()) all.push_back(std::move(animal));
    return all;
}

}  // namespace knotwork::test
