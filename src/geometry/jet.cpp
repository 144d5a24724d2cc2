#include "geometry/jet.hpp"

#include <cmath>

namespace knotwork {

namespace {

// Every elementary function f(a) obeys a differential equation f′ = g · a′; comparing coefficients
// gives k f_k = Σ_{j=1..k} j a_j g_{k−j}. This is that sum.
double convolveDerivative(const Jet& a, const Jet& g, int k) noexcept {
    double sum = 0;
    for (int j = 1; j <= k; ++j) sum += j * a[j] * g[k - j];
    return sum;
}

}  // namespace

Jet Jet::constant(double value, int order) noexcept {
    Jet jet;
    jet.order_ = order;
    std::fill_n(jet.coefficients_.begin(), order + 1, 0.0);
    jet.coefficients_[0] = value;
    return jet;
}

Jet Jet::variable(double t, int order) noexcept {
    Jet jet = constant(t, order);
    if (order > 0) jet[1] = 1;
    return jet;
}

double Jet::derivative(int k) const noexcept {
    double factorial = 1;
    for (int i = 2; i <= k; ++i) factorial *= i;
    return factorial * (*this)[k];
}

Jet& Jet::operator+=(const Jet& other) noexcept {
    order_ = std::min(order_, other.order_);
    for (int k = 0; k <= order_; ++k) (*this)[k] += other[k];
    return *this;
}

Jet& Jet::operator-=(const Jet& other) noexcept {
    order_ = std::min(order_, other.order_);
    for (int k = 0; k <= order_; ++k) (*this)[k] -= other[k];
    return *this;
}

Jet& Jet::operator*=(double factor) noexcept {
    for (int k = 0; k <= order_; ++k) (*this)[k] *= factor;
    return *this;
}

Jet operator*(const Jet& a, const Jet& b) noexcept {
    Jet product = Jet::constant(0, std::min(a.order(), b.order()));
    for (int k = 0; k <= product.order(); ++k) {
        for (int j = 0; j <= k; ++j) product[k] += a[j] * b[k - j];
    }
    return product;
}

Jet operator/(const Jet& a, const Jet& b) noexcept {
    Jet quotient = Jet::constant(0, std::min(a.order(), b.order()));
    for (int k = 0; k <= quotient.order(); ++k) {
        double rest = a[k];
        for (int j = 1; j <= k; ++j) rest -= b[j] * quotient[k - j];
        quotient[k] = rest / b[0];
    }
    return quotient;
}

Jet operator/(double a, const Jet& b) noexcept { return Jet::constant(a, b.order()) / b; }

SinCos sinCos(const Jet& a) noexcept {
    SinCos result{Jet::constant(std::sin(a[0]), a.order()),
                  Jet::constant(std::cos(a[0]), a.order())};
    for (int k = 1; k <= a.order(); ++k) {
        result.sin[k] = convolveDerivative(a, result.cos, k) / k;
        result.cos[k] = -convolveDerivative(a, result.sin, k) / k;
    }
    return result;
}

Jet sin(const Jet& a) noexcept { return sinCos(a).sin; }

Jet cos(const Jet& a) noexcept { return sinCos(a).cos; }

Jet exp(const Jet& a) noexcept {
    Jet result = Jet::constant(std::exp(a[0]), a.order());
    for (int k = 1; k <= a.order(); ++k) result[k] = convolveDerivative(a, result, k) / k;
    return result;
}

Jet log(const Jet& a) noexcept {
    // a · log(a)′ = a′
    Jet result = Jet::constant(std::log(a[0]), a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double rest = k * a[k];
        for (int j = 1; j < k; ++j) rest -= j * result[j] * a[k - j];
        result[k] = rest / (k * a[0]);
    }
    return result;
}

Jet sqrt(const Jet& a) noexcept {
    // result² = a
    Jet result = Jet::constant(std::sqrt(a[0]), a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double rest = a[k];
        for (int j = 1; j < k; ++j) rest -= result[j] * result[k - j];
        result[k] = rest / (2 * result[0]);
    }
    return result;
}

Jet pow(const Jet& a, double exponent) noexcept {
    // a · (a^e)′ = e · a′ · a^e
    Jet result = Jet::constant(std::pow(a[0], exponent), a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double sum = 0;
        for (int j = 1; j <= k; ++j) sum += (exponent * j - (k - j)) * a[j] * result[k - j];
        result[k] = sum / (k * a[0]);
    }
    return result;
}

Jet compose(const Jet& outer, const Jet& inner) noexcept {
    const int order = std::min(outer.order(), inner.order());
    Jet step = inner;
    step[0] = 0;
    Jet result = Jet::constant(outer[order], order);
    for (int k = order - 1; k >= 0; --k) result = result * step + outer[k];
    return result;
}

}  // namespace knotwork
