// Numbers a + j b with complex a and b and j² = −1, beside i: a step of h along i and one along j are
// taken at once, and the coefficient of i j is h² times the second derivative, without cancellation.
// (G. Lantoine, R. Russell, T. Dargent, Using multicomplex variables for automatic computation of
// high-order derivatives, 2012.)
#pragma once

#include <cmath>
#include <complex>

namespace knotwork::test {

struct Bicomplex {
    std::complex<double> a;
    std::complex<double> b;

    Bicomplex(double real = 0) : a(real), b(0) {}
    Bicomplex(const std::complex<double>& first, const std::complex<double>& second)
        : a(first), b(second) {}
};

/// Small enough that its square is lost beside 1, and large enough that it is a number.
inline constexpr double bicomplexStep = 1e-40;

/// t + i h and t + j h.
inline Bicomplex steppedOnce(double t) { return {{t, bicomplexStep}, 0}; }
inline Bicomplex steppedTwice(double t) { return {t, {bicomplexStep, 0}}; }
/// t + i h + j h.
inline Bicomplex steppedBothWays(double t) { return {{t, bicomplexStep}, {bicomplexStep, 0}}; }

/// The derivative by what was stepped along i, and that by both steps.
inline double firstSlope(const Bicomplex& x) { return x.a.imag() / bicomplexStep; }
inline double secondSlope(const Bicomplex& x) {
    return x.b.imag() / bicomplexStep / bicomplexStep;
}

inline Bicomplex oneLike(const Bicomplex&) { return 1; }

inline Bicomplex operator+(const Bicomplex& x, const Bicomplex& y) {
    return {x.a + y.a, x.b + y.b};
}
inline Bicomplex operator-(const Bicomplex& x, const Bicomplex& y) {
    return {x.a - y.a, x.b - y.b};
}
inline Bicomplex operator-(const Bicomplex& x) { return {-x.a, -x.b}; }
inline Bicomplex operator*(const Bicomplex& x, const Bicomplex& y) {
    return {x.a * y.a - x.b * y.b, x.a * y.b + x.b * y.a};
}
inline Bicomplex operator/(const Bicomplex& x, const Bicomplex& y) {
    const std::complex<double> size = y.a * y.a + y.b * y.b;
    return {(x.a * y.a + x.b * y.b) / size, (x.b * y.a - x.a * y.b) / size};
}

inline Bicomplex sin(const Bicomplex& x) {
    return {std::sin(x.a) * std::cosh(x.b), std::cos(x.a) * std::sinh(x.b)};
}
inline Bicomplex cos(const Bicomplex& x) {
    return {std::cos(x.a) * std::cosh(x.b), -(std::sin(x.a) * std::sinh(x.b))};
}
inline Bicomplex exp(const Bicomplex& x) {
    const std::complex<double> size = std::exp(x.a);
    return {size * std::cos(x.b), size * std::sin(x.b)};
}

}  // namespace knotwork::test
