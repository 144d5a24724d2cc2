// Independent derivatives and integrals for tests: complex steps, Cauchy's integral, tanh-sinh.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace knotwork::test {

using Complex = std::complex<double>;

/// f′(t) of a formula that is real on the real line, without cancellation.
template <class F>
double complexStepDerivative(const F& f, double t) {
    constexpr double step = 1e-40;
    return f(Complex(t, step)).imag() / step;
}

/// f^(k)(t) from values on a circle inside which f is analytic.
template <class F>
double cauchyDerivative(const F& f, double t, int k, double radius) {
    constexpr int points = 128;
    Complex sum = 0;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / points;
        sum += f(t + std::polar(radius, angle)) * std::polar(1.0, -k * angle);
    }
    return sum.real() / points * std::tgamma(k + 1.0) / std::pow(radius, k);
}

/// ∫_0^1 f(q, 1−q) dq by the double exponential rule: both distances come without cancellation, so
/// f may have any scale at the ends. (Takahasi, Mori 1974.)
template <class F>
long double integrateTanhSinh(const F& f, long double step = 1.0L / 256) {
    const long double halfPi = std::numbers::pi_v<long double> / 2;
    long double sum = 0;
    const int steps = static_cast<int>(6.5L / step);
    for (int i = -steps; i <= steps; ++i) {
        const long double x = step * static_cast<long double>(i);
        const long double exponential = std::exp(-2 * halfPi * std::sinh(std::abs(x)));
        const long double small = exponential / (1 + exponential);
        const long double large = 1 / (1 + exponential);
        const long double weight = 2 * halfPi * std::cosh(x) * small * large;
        if (weight > 0) sum += weight * (x < 0 ? f(small, large) : f(large, small));
    }
    return sum * step;
}

}  // namespace knotwork::test
