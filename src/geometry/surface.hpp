// A surface of any kind: the one vocabulary in which every kind is evaluated.
//
// The kinds are a closed variant of values, visited once per batch. Each answers domain(), closed(),
// derivatives(place, orders, rows) for any parameters, breaksU() and breaksV(); whatever else holds
// for every surface is made of these. A Surface is cheap to copy: what it holds is immutable and
// shared.
#pragma once

#include "geometry/blending_surface.hpp"
#include "geometry/blending_triangle.hpp"
#include "geometry/bspline_surface.hpp"
#include "geometry/parametric_surface.hpp"
#include "geometry/result.hpp"
#include "geometry/surface_parameter.hpp"
#include "geometry/vec.hpp"

#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace knotwork {

class Surface {
public:
    using Kind = std::variant<BsplineSurface, ParametricSurface, BlendingSurface,
                              BlendingTriangle>;

    /// Of any of the kinds.
    template <class T>
        requires std::is_constructible_v<Kind, T&&> && (!std::is_same_v<std::decay_t<T>, Surface>)
    Surface(T&& surface) : kind_(std::make_shared<const Kind>(std::forward<T>(surface))) {}

    [[nodiscard]] const Kind& kind() const noexcept { return *kind_; }
    template <class T>
    [[nodiscard]] const T* as() const noexcept { return std::get_if<T>(kind_.get()); }

private:
    std::shared_ptr<const Kind> kind_;
};

[[nodiscard]] Rectangle domain(const Surface& surface) noexcept;
/// A direction is closed where S, with all derivatives that it has across the seam, goes on from its
/// end as from its start. A pole is an end, and a strip that closes turned over is not closed.
[[nodiscard]] ClosedDirections closedDirections(const Surface& surface) noexcept;

/// The place itself where it lies in the domain, wrapped into it in a closed direction; at the end
/// of an open one it is approached from the left, everywhere else from the right. OUT_OF_RANGE or
/// NOT_FINITE with path `u` or `v` otherwise.
[[nodiscard]] Result<SurfacePlace> placeInDomain(const Surface& surface, double u, double v);

/// The matrix of derivatives, rows[orders.at(a, b)] = ∂^{a+b}S/∂u^a∂v^b, orders up to 25, for any
/// place: outside its domain a surface is continued (by its formula, by its period, a spline that is
/// not closed by its end pieces). `rows` holds orders.size() vectors. (A blending triangle has those
/// with a + b ≤ 25.)
void derivatives(const Surface& surface, const SurfacePlace& at, const SurfaceOrders& orders,
                 std::span<Vec3> rows) noexcept;
/// Of that matrix of orders {order, order} the entries with a + b ≤ order; the others may be left as
/// they are.
void derivativesWithin(const Surface& surface, const SurfacePlace& at, int order,
                       std::span<Vec3> rows) noexcept;
[[nodiscard]] Vec3 pointAt(const Surface& surface, const SurfacePlace& at) noexcept;

/// The parameters, ascending, between which the surface is smooth: its knots, ends included.
[[nodiscard]] std::span<const double> breaksU(const Surface& surface) noexcept;
[[nodiscard]] std::span<const double> breaksV(const Surface& surface) noexcept;

}  // namespace knotwork
