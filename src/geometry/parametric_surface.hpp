// Named model surfaces: plane, cylinder, torus, sphere, …, given by a formula in two parameters.
//
// The formulas are in parametric_surface_models.hpp. A surface is a value, checked when made and
// total afterwards.
#pragma once

#include "geometry/parametric_surface_descriptions.hpp"
#include "geometry/parametric_surface_models.hpp"
#include "geometry/surface_parameter.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace knotwork {

class ParametricSurface {
public:
    /// The model `name` of surfaceModels() with these parameters (defaults for the others).
    /// Refusals: UNKNOWN_NAME at `name`; UNKNOWN_FIELD, NOT_FINITE and OUT_OF_RANGE at
    /// `parameters.<name>`.
    [[nodiscard]] static Result<ParametricSurface> make(
        std::string_view name, std::span<const NamedValue> parameters = {});

    // As every kind of surface. It has no sides and no knots; outside its domain the formula goes
    // on. Derivatives are exact up to rounding; O(orders.size()).
    [[nodiscard]] Rectangle domain() const noexcept { return domain_; }
    [[nodiscard]] ClosedDirections closed() const noexcept { return closed_; }
    void derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                     std::span<Vec3> rows) const noexcept;
    [[nodiscard]] std::span<const double> breaksU() const noexcept { return {}; }
    [[nodiscard]] std::span<const double> breaksV() const noexcept { return {}; }

    // S = Σ_k f_k(u) g_k(v) e_k, for tables.
    /// e_k as the number of the axis, one a term.
    [[nodiscard]] std::span<const std::uint8_t> axes() const noexcept;
    /// f_k and its derivatives up to `order` (at most 25) at [k · (order+1) …]; `factors` holds a
    /// row a term.
    void factorsU(double u, int order, std::span<double> factors) const noexcept;
    /// The same for g_k.
    void factorsV(double v, int order, std::span<double> factors) const noexcept;

    // What it was made from.
    [[nodiscard]] std::string_view name() const noexcept { return description().name; }
    [[nodiscard]] const SurfaceModelDescription& description() const noexcept {
        return surfaceModels()[static_cast<std::size_t>(id_)];
    }
    /// In the order of description().parameters.
    [[nodiscard]] std::span<const double> parameters() const noexcept {
        return std::span(parameters_).first(description().parameters.size());
    }

private:
    ParametricSurface() = default;

    SurfaceModel id_ = SurfaceModel::plane;
    surface_model::Any model_;
    std::array<double, 5> parameters_{};
    Rectangle domain_;
    ClosedDirections closed_;
};

}  // namespace knotwork
