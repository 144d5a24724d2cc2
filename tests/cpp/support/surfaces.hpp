// Surfaces for tests, and what is asked of all of them.
#pragma once

#include "geometry/surface.hpp"

#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::test {

inline ParametricSurface model(std::string_view name, std::vector<NamedValue> parameters = {}) {
    return ParametricSurface::make(name, parameters).value();
}

inline std::vector<Vec3> matrixAt(const Surface& surface, const SurfacePlace& at,
                                  const SurfaceOrders& orders) {
    std::vector<Vec3> rows(orders.size(), Vec3(99));
    derivatives(surface, at, orders, rows);
    return rows;
}

/// An eighth of the unit sphere: a quarter turn of a quarter circle, rational and biquadratic; v = 1
/// is its pole.
inline BsplineSurface eighthOfSphere() {
    const double half = std::numbers::sqrt2 / 2;
    const auto arc = KnotVector::uniform(2, 3, Form::clamped).value();
    return BsplineSurface::make(arc, arc,
                                {{1, 0, 0}, {1, 0, 1}, {0, 0, 1},
                                 {1, 1, 0}, {1, 1, 1}, {0, 0, 1},
                                 {0, 1, 0}, {0, 1, 1}, {0, 0, 1}},
                                {1, half, 1, half, 0.5, half, 1, half, 1})
        .value();
}

/// Knots of this form with uneven gaps, one of them doubled where the degree allows it.
inline KnotVector someKnots(int degree, int count, Form form, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> gap(0.5, 2);
    const std::size_t number = KnotVector::knotCount(degree, count, form);
    std::vector<double> knots{gap(engine)};
    while (knots.size() < number) knots.push_back(knots.back() + gap(engine));
    if (degree > 1 && count > degree + 3) {
        const std::size_t middle = number / 2;
        knots[middle] = knots[middle - 1];
    }
    if (form == Form::clamped) {
        const auto order = static_cast<std::size_t>(degree) + 1;
        std::fill_n(knots.begin(), order, knots[order - 1]);
        std::fill_n(knots.rbegin(), order, knots[number - order]);
    }
    return KnotVector::make(std::move(knots), degree, count, form).value();
}

struct NetOptions {
    int degreeU = 3;
    int degreeV = 2;
    Form formU = Form::clamped;
    Form formV = Form::clamped;
    int rows = 7;
    int columns = 6;
    bool weighted = false;
    unsigned seed = 1;
};

/// Points in [-1, 1]³, weights in [0.25, 3].
inline BsplineSurface someSurface(const NetOptions& options = {}) {
    std::mt19937 engine(options.seed);
    std::uniform_real_distribution<double> share(-1, 1);
    std::uniform_real_distribution<double> weight(0.25, 3);
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (int k = 0; k < options.rows * options.columns; ++k) {
        points.emplace_back(share(engine), share(engine), share(engine));
        if (options.weighted) weights.push_back(weight(engine));
    }
    return BsplineSurface::make(
               someKnots(options.degreeU, options.rows, options.formU, options.seed + 1),
               someKnots(options.degreeV, options.columns, options.formV, options.seed + 2),
               std::move(points), std::move(weights))
        .value();
}

/// All nine pairs of forms, polynomial and rational.
inline std::vector<BsplineSurface> surfacesOfEveryForm(int degreeU, int degreeV) {
    std::vector<BsplineSurface> all;
    unsigned seed = 10;
    for (const Form u : {Form::clamped, Form::open, Form::closed}) {
        for (const Form v : {Form::clamped, Form::open, Form::closed}) {
            for (const bool weighted : {false, true}) {
                all.push_back(someSurface({degreeU, degreeV, u, v, degreeU + 4, degreeV + 5,
                                           weighted, seed++}));
            }
        }
    }
    return all;
}

/// Both ends, every knot and places between them.
inline std::vector<double> telling(const Interval& domain, std::span<const double> knots) {
    std::vector<double> all{domain.start, domain.end};
    for (int i = 1; i < 7; ++i) all.push_back(domain.start + domain.length() * (i + 0.37) / 8);
    for (const double knot : knots) {
        if (domain.contains(knot)) all.push_back(knot);
    }
    return all;
}

}  // namespace knotwork::test
