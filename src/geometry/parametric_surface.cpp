#include "geometry/parametric_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace knotwork {

namespace {

using namespace surface_model;

constexpr double pi = std::numbers::pi;
constexpr double twoPi = 2 * pi;

struct Prepared {
    Any model;
    Rectangle domain;
    ClosedDirections closed = {};
};

Prepared prepare(SurfaceModel model, std::span<const double> p) noexcept {
    using enum SurfaceModel;
    const Interval turn{0, twoPi};
    switch (model) {
        case plane: return {Plane{}, {{0, p[0]}, {0, p[1]}}};
        case cylinder: return {Cone{p[0], 0}, {turn, {0, p[1]}}, {true, false}};
        case torus: return {Torus{p[0], p[1]}, {turn, turn}, {true, true}};
        case sphere: return {Torus{0, p[0]}, {turn, {-pi / 2, pi / 2}}, {true, false}};
        case cone: return {Cone{p[0], 1 / p[1]}, {turn, {0, p[1]}}, {true, false}};
        case moebius: return {Moebius{p[0]}, {turn, {-p[1] / 2, p[1] / 2}}};
        case klein: return {Klein{p[0], p[1]}, {turn, turn}, {false, true}};
        case helicoid: return {Helicoid{p[1] / twoPi}, {{0, twoPi * p[2]}, {-p[0], p[0]}}};
        case seashell: {
            const double last = twoPi * p[4];
            return {Seashell{p[0], p[1], p[2], std::log(p[3]) / twoPi, last},
                    {{0, last}, turn},
                    {false, true}};
        }
    }
    return {Plane{}, {}};  // not reached: all models stand above
}

std::string knownModels() {
    std::string names;
    for (const SurfaceModelDescription& model : surfaceModels()) {
        if (!names.empty()) names += ", ";
        names += model.name;
    }
    return names;
}

/// Derivatives of order 0 … order of each jet, one row each.
template <std::size_t N>
void writeFactors(const std::array<Jet, N>& jets, int order, std::span<double> factors) noexcept {
    const std::size_t columns = static_cast<std::size_t>(order) + 1;
    for (std::size_t k = 0; k < N; ++k) {
        double factorial = 1;
        for (int a = 0; a <= order; ++a) {
            if (a > 1) factorial *= a;
            factors[k * columns + static_cast<std::size_t>(a)] = factorial * jets[k][a];
        }
    }
}

}  // namespace

Result<ParametricSurface> ParametricSurface::make(std::string_view name,
                                                  std::span<const NamedValue> parameters) {
    const SurfaceModelDescription* description = findSurfaceModel(name);
    if (description == nullptr) {
        return refuse(
            Code::unknownName, "name",
            "there is no model surface \"" + std::string(name) + "\"; known: " + knownModels());
    }
    const auto values = readParameters(description->parameters, parameters, "parameters");
    if (!values) return values.error();
    const Prepared prepared = prepare(description->model, *values);
    ParametricSurface surface;
    surface.id_ = description->model;
    surface.model_ = prepared.model;
    std::copy(values->begin(), values->end(), surface.parameters_.begin());
    surface.domain_ = prepared.domain;
    surface.closed_ = prepared.closed;
    return surface;
}

std::span<const std::uint8_t> ParametricSurface::axes() const noexcept {
    return std::visit([](const auto& model) { return std::span<const std::uint8_t>(model.axes); },
                      model_);
}

void ParametricSurface::factorsU(double u, int order, std::span<double> factors) const noexcept {
    std::visit(
        [&](const auto& model) {
            if (order == 0) {
                const auto values = model.alongU(u);
                std::copy(values.begin(), values.end(), factors.begin());
            } else {
                writeFactors(model.alongU(Jet::variable(u, order)), order, factors);
            }
        },
        model_);
}

void ParametricSurface::factorsV(double v, int order, std::span<double> factors) const noexcept {
    std::visit(
        [&](const auto& model) {
            if (order == 0) {
                const auto values = model.alongV(v);
                std::copy(values.begin(), values.end(), factors.begin());
            } else {
                writeFactors(model.alongV(Jet::variable(v, order)), order, factors);
            }
        },
        model_);
}

void ParametricSurface::derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                                    std::span<Vec3> rows) const noexcept {
    std::array<double, maxTerms * (maxSurfaceOrder + 1)> along;
    std::array<double, maxTerms * (maxSurfaceOrder + 1)> across;
    factorsU(at.u, orders.u, along);
    factorsV(at.v, orders.v, across);
    const std::size_t rowCount = static_cast<std::size_t>(orders.u) + 1;
    const std::span<const std::uint8_t> axis = axes();
    std::fill_n(rows.begin(), orders.size(), Vec3(0));
    for (std::size_t k = 0; k < axis.size(); ++k) {
        for (std::size_t a = 0; a < rowCount; ++a) {
            const double factor = along[k * rowCount + a];
            for (std::size_t b = 0; b < orders.columns(); ++b) {
                rows[orders.at(a, b)][axis[k]] += factor * across[k * orders.columns() + b];
            }
        }
    }
}

}  // namespace knotwork
