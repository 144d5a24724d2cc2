// The formulas of the model surfaces, templates over the scalar: double, Jet or
// std::complex<double>.
//
// Every coordinate is a sum of products: S = Σ_k f_k(u) g_k(v) e_k with e_k an axis. So all mixed
// derivatives come from those of functions of one variable, and a grid from a table a direction.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/jet.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace knotwork::surface_model {

inline constexpr std::size_t maxTerms = 8;

/// The numbers of the axes x, y, z.
template <std::size_t N>
using Axes = std::array<std::uint8_t, N>;

struct Plane {
    static constexpr Axes<2> axes{0, 1};
    template <class S>
    [[nodiscard]] std::array<S, 2> alongU(const S& u) const noexcept {
        return {u, oneLike(u)};
    }
    template <class S>
    [[nodiscard]] std::array<S, 2> alongV(const S& v) const noexcept {
        return {oneLike(v), v};
    }
};

/// What turns about the z axis: (ρ cos u, ρ sin u, z), ρ and z functions of v.
struct Revolution {
    static constexpr Axes<3> axes{0, 1, 2};
    template <class S>
    [[nodiscard]] std::array<S, 3> alongU(const S& u) const noexcept {
        const auto [s, c] = angle(u);
        return {c, s, oneLike(u)};
    }
};

/// ρ and z linear: cylinder and cone.
struct Cone : Revolution {
    double radius;
    double taper;  ///< how much of the radius a unit of v takes away
    Cone(double radiusOf, double taperOf) noexcept : radius(radiusOf), taper(taperOf) {}
    template <class S>
    [[nodiscard]] std::array<S, 3> alongV(const S& v) const noexcept {
        const S rho = radius * (1.0 - taper * v);
        return {rho, rho, v};
    }
};

/// The sphere is the torus with R = 0.
struct Torus : Revolution {
    double R;
    double r;
    Torus(double outer, double tube) noexcept : R(outer), r(tube) {}
    template <class S>
    [[nodiscard]] std::array<S, 3> alongV(const S& v) const noexcept {
        const auto [s, c] = angle(v);
        const S rho = R + r * c;
        return {rho, rho, r * s};
    }
};

struct Moebius {
    static constexpr Axes<5> axes{0, 0, 1, 1, 2};
    double radius;
    template <class S>
    [[nodiscard]] std::array<S, 5> alongU(const S& u) const noexcept {
        const auto [s, c] = angle(u);
        const auto [halfS, halfC] = angle(S(0.5 * u));
        return {radius * c, halfC * c, radius * s, halfC * s, halfS};
    }
    template <class S>
    [[nodiscard]] std::array<S, 5> alongV(const S& v) const noexcept {
        const S one = oneLike(v);
        return {one, v, one, v, v};
    }
};

/// The figure of eight (sin v, sin 2v) turns by half a turn while it goes round.
struct Klein {
    static constexpr Axes<8> axes{0, 0, 0, 1, 1, 1, 2, 2};
    double R;
    double r;
    template <class S>
    [[nodiscard]] std::array<S, 8> alongU(const S& u) const noexcept {
        const auto [s, c] = angle(u);
        const auto [halfS, halfC] = angle(S(0.5 * u));
        return {R * c, halfC * c, -(halfS * c), R * s, halfC * s, -(halfS * s), halfS, halfC};
    }
    template <class S>
    [[nodiscard]] std::array<S, 8> alongV(const S& v) const noexcept {
        using std::sin;
        const S one = oneLike(v);
        const S single = r * sin(v);
        const S twice = r * sin(2.0 * v);
        return {one, single, twice, one, single, twice, single, twice};
    }
};

struct Helicoid {
    static constexpr Axes<3> axes{0, 1, 2};
    double risePerRadian;
    template <class S>
    [[nodiscard]] std::array<S, 3> alongU(const S& u) const noexcept {
        const auto [s, c] = angle(u);
        return {c, s, risePerRadian * u};
    }
    template <class S>
    [[nodiscard]] std::array<S, 3> alongV(const S& v) const noexcept {
        return {v, v, oneLike(v)};
    }
};

struct Seashell {
    static constexpr Axes<3> axes{0, 1, 2};
    double R;
    double r;
    double height;
    double rate;  ///< of growth, a radian
    double last;  ///< the u at which the size is 1
    template <class S>
    [[nodiscard]] std::array<S, 3> alongU(const S& u) const noexcept {
        using std::exp;
        const auto [s, c] = angle(u);
        const S size = exp(rate * (u - last));
        return {size * c, size * s, size};
    }
    template <class S>
    [[nodiscard]] std::array<S, 3> alongV(const S& v) const noexcept {
        const auto [s, c] = angle(v);
        const S rho = R + r * c;
        return {rho, rho, r * s - height};
    }
};

/// Visited once per batch.
using Any = std::variant<Plane, Cone, Torus, Moebius, Klein, Helicoid, Seashell>;

}  // namespace knotwork::surface_model
