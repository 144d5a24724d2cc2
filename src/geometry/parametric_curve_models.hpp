// The formulas of the model curves, templates over the scalar: double, Jet or std::complex<double>.
//
// Planar models answer {x, y}, the others {x, y, z}. Butterfly: T. H. Fay, The butterfly curve,
// Amer. Math. Monthly 96 (1989), with the parameter reversed. The others are in any handbook.
#pragma once

#include "geometry/angle.hpp"
#include "geometry/jet.hpp"
#include "geometry/parametric_curve_descriptions.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <variant>

namespace knotwork::parametric_model {

template <class S>
using Planar = std::array<S, 2>;
template <class S>
using Spatial = std::array<S, 3>;

/// Circle (a = b = radius) and ellipse.
struct Ellipse {
    double a;
    double b;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        return {a * c, b * s};
    }
};

struct Lissajous {
    double a;
    double b;
    double kx;
    double ky;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        using std::cos, std::sin;
        return {a * cos(kx * t), b * sin(ky * t)};
    }
};

struct Rose {
    double a;
    double k;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        using std::cos;
        const auto [s, c] = angle(t);
        const S r = a * cos(k * t);
        return {r * c, r * s};
    }
};

struct Butterfly {
    double scale;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        using std::exp, std::sin;
        const auto [s, c] = angle(t);
        const S c2 = c * c;
        const S cos4t = 8.0 * (c2 * c2 - c2) + 1.0;
        const S r = scale * (exp(c) - 2.0 * cos4t - integerPower(S(sin(t / 12.0)), 5));
        return {s * r, c * r};
    }
};

/// Both kinds: centre·(cos t, sin t) + d·(cos, ±sin)(ratio t), the signs in dx and dy.
struct Trochoid {
    double centre;
    double ratio;
    double dx;
    double dy;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        const auto [rollS, rollC] = angle(S(ratio * t));
        return {centre * c + dx * rollC, centre * s + dy * rollS};
    }
};

struct Astroid {
    double a;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        return {a * (c * c * c), a * (s * s * s)};
    }
};

/// Cardioid (n = 2) and nephroid (n = 3): a(n cos t − cos nt), a(n sin t − sin nt).
struct Epicycloid {
    double a;
    double n;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        const auto [sn, cn] = angle(S(n * t));
        return {a * (n * c - cn), a * (n * s - sn)};
    }
};

struct Heart {
    double scale;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        using std::cos;
        const auto [s, c] = angle(t);
        return {16.0 * scale * (s * s * s),
                scale * (13.0 * c - 5.0 * cos(2.0 * t) - 2.0 * cos(3.0 * t) - cos(4.0 * t))};
    }
};

struct Lemniscate {
    double a;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        const S x = a * c / (1.0 + s * s);
        return {x, s * x};
    }
};

struct Spiral {
    double a;
    double b;
    template <class S>
    [[nodiscard]] Planar<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        const S r = a + b * t;
        return {r * c, r * s};
    }
};

struct Helix {
    double radius;
    double risePerRadian;
    template <class S>
    [[nodiscard]] Spatial<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(t);
        return {radius * c, radius * s, risePerRadian * t};
    }
};

struct Viviani {
    double a;
    template <class S>
    [[nodiscard]] Spatial<S> at(const S& t) const noexcept {
        using std::sin;
        const auto [s, c] = angle(t);
        return {a * (1.0 + c), a * s, 2.0 * a * sin(0.5 * t)};
    }
};

struct Trefoil {
    double scale;
    template <class S>
    [[nodiscard]] Spatial<S> at(const S& t) const noexcept {
        using std::sin;
        const auto [s, c] = angle(t);
        const auto [s2, c2] = angle(S(2.0 * t));
        return {scale * (s + 2.0 * s2), scale * (c - 2.0 * c2), -scale * sin(3.0 * t)};
    }
};

struct TorusKnot {
    double p;
    double q;
    double R;
    double r;
    template <class S>
    [[nodiscard]] Spatial<S> at(const S& t) const noexcept {
        const auto [s, c] = angle(S(p * t));
        const auto [tubeS, tubeC] = angle(S(q * t));
        const S distance = R + r * tubeC;
        return {distance * c, distance * s, r * tubeS};
    }
};

/// Visited once per batch.
using Any = std::variant<Ellipse, Lissajous, Rose, Butterfly, Trochoid, Astroid, Epicycloid, Heart,
                         Lemniscate, Spiral, Helix, Viviani, Trefoil, TorusKnot>;

}  // namespace knotwork::parametric_model
