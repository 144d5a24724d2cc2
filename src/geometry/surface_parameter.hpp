// Where on a surface: a parameter in each direction, with the side from which each is approached.
#pragma once

#include "geometry/interval.hpp"

#include <cstddef>

namespace knotwork {

/// The parameters of a surface: [u.start, u.end] × [v.start, v.end].
struct Rectangle {
    Interval u;
    Interval v;
    friend constexpr bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// In which directions a surface is periodic.
struct ClosedDirections {
    bool u = false;
    bool v = false;
    friend constexpr bool operator==(const ClosedDirections&, const ClosedDirections&) = default;
};

struct SurfacePlace {
    double u = 0;
    double v = 0;
    Side sideU = Side::right;
    Side sideV = Side::right;
};

/// The derivatives ∂^{a+b}S/∂u^a∂v^b with a ≤ u and b ≤ v: a matrix of u+1 rows, row a holding
/// b = 0 … v, flat.
struct SurfaceOrders {
    int u = 0;
    int v = 0;

    [[nodiscard]] constexpr std::size_t columns() const noexcept {
        return static_cast<std::size_t>(v) + 1;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept {
        return (static_cast<std::size_t>(u) + 1) * columns();
    }
    /// Where derivative (a, b) stands.
    [[nodiscard]] constexpr std::size_t at(std::size_t a, std::size_t b) const noexcept {
        return a * columns() + b;
    }
};

/// As far as derivatives go in either direction.
inline constexpr int maxSurfaceOrder = 25;

}  // namespace knotwork
