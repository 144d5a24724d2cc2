#include "geometry/jet.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace knotwork {

namespace {

// Every elementary function f(a) obeys a differential equation f′ = g · a′; comparing coefficients
// gives k f_k = Σ_{j=1..k} j a_j g_{k−j}. This is that sum.
double convolveDerivative(const Jet& a, const Jet& g, int k) noexcept {
    double sum = 0;
    for (int j = 1; j <= k; ++j) sum += j * a[j] * g[k - j];
    return sum;
}

/// The same for an a whose coefficients vanish beyond `reach`: those of kt + c, of which most angles
/// are, do beyond 1.
double convolveDerivative(const Jet& a, int reach, const Jet& g, int k) noexcept {
    double sum = 0;
    for (int j = 1; j <= std::min(k, reach); ++j) sum += j * a[j] * g[k - j];
    return sum;
}

int reachOf(const Jet& a) noexcept {
    int k = a.order();
    while (k > 0 && a[k] == 0) --k;
    return k;
}

// Products of the orders that curves are asked for, without loops.

template <int k, int... j>
double productTerm(const Jet& a, const Jet& b, std::integer_sequence<int, j...>) noexcept {
    return (0.0 + ... + (a[j] * b[k - j]));
}

template <int... k>
void multiply(const Jet& a, const Jet& b, Jet& product, std::integer_sequence<int, k...>) noexcept {
    ((product[k] = productTerm<k>(a, b, std::make_integer_sequence<int, k + 1>())), ...);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

bool isInteger(double x) noexcept { return x == std::trunc(x); }

/// The number of leading coefficients that vanish.
int zeros(const Jet& a) noexcept {
    int count = 0;
    while (count <= a.order() && a[count] == 0) ++count;
    return count;
}

/// a(−h) as a jet in h: what lies on the left comes to the right.
Jet mirrored(Jet a) noexcept {
    for (int k = 1; k <= a.order(); k += 2) a[k] = -a[k];
    return a;
}

/// From row `first` on.
void forget(Jet& a, int first) noexcept {
    for (int k = std::max(first, 0); k <= a.order(); ++k) a[k] = notANumber;
}

/// a^exponent where a = h^m u(h) vanishes, on the right: h^(m exponent) u^exponent.
Jet powerAtZero(const Jet& a, double exponent) noexcept {
    Jet result = Jet::constant(std::pow(0.0, exponent), a.order());
    const int m = zeros(a);
    if (!(exponent > 0) || (m <= a.order() && a[m] < 0 && !isInteger(exponent))) {
        forget(result, 1);
        return result;
    }
    const double leading = std::min(m * exponent, Jet::maxOrder + 1.0);
    if (m > a.order()) {  // all that is known is that a is O(h^m)
        forget(result, static_cast<int>(std::ceil(leading)));
        return result;
    }
    Jet u = Jet::constant(0, a.order() - m);
    for (int k = 0; k <= u.order(); ++k) u[k] = a[k + m];
    const Jet power = pow(u, exponent);
    const double nearest = std::round(leading);
    const bool whole = std::abs(leading - nearest) <= 1e-12 * leading;
    double falling = power[0];  // times leading (leading − 1) …: the sign of an infinite row
    for (int k = 0; k <= a.order(); ++k) {
        if (whole && k >= nearest) {
            const int from = k - static_cast<int>(nearest);
            result[k] = from <= power.order() ? power[from] : notANumber;
        } else {
            result[k] = k < leading ? 0 : std::copysign(infinity, falling);
        }
        falling *= leading - k;
    }
    return result;
}

/// The function with this value and the derivative a′ / slope.
Jet integrateQuotient(const Jet& a, const Jet& slope, double value) noexcept {
    Jet result = Jet::constant(value, a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double rest = k * a[k];
        for (int j = 1; j < k; ++j) rest -= j * result[j] * slope[k - j];
        result[k] = rest / (k * slope[0]);
    }
    if (a.order() > 0 && std::isnan(slope[1])) result[1] = notANumber;  // and not infinite
    return result;
}

/// 1 − a², without cancellation where |a| is nearly 1.
Jet oneMinusSquare(const Jet& a) noexcept {
    Jet result = a * a;
    result *= -1.0;
    result[0] = (1 - a[0]) * (1 + a[0]);
    return result;
}

SinCos sinhCosh(const Jet& a) noexcept {
    SinCos result{Jet::constant(std::sinh(a[0]), a.order()),
                  Jet::constant(std::cosh(a[0]), a.order())};
    for (int k = 1; k <= a.order(); ++k) {
        result.sin[k] = convolveDerivative(a, result.cos, k) / k;
        result.cos[k] = convolveDerivative(a, result.sin, k) / k;
    }
    return result;
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
    switch (product.order()) {
        case 0: multiply(a, b, product, std::make_integer_sequence<int, 1>()); return product;
        case 1: multiply(a, b, product, std::make_integer_sequence<int, 2>()); return product;
        case 2: multiply(a, b, product, std::make_integer_sequence<int, 3>()); return product;
        case 3: multiply(a, b, product, std::make_integer_sequence<int, 4>()); return product;
        case 4: multiply(a, b, product, std::make_integer_sequence<int, 5>()); return product;
        case 5: multiply(a, b, product, std::make_integer_sequence<int, 6>()); return product;
        default: break;
    }
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
    const int reach = reachOf(a);
    for (int k = 1; k <= a.order(); ++k) {
        result.sin[k] = convolveDerivative(a, reach, result.cos, k) / k;
        result.cos[k] = -convolveDerivative(a, reach, result.sin, k) / k;
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

Jet tan(const Jet& a) noexcept {
    // tan′ = (1 + tan²) a′
    Jet result = Jet::constant(std::tan(a[0]), a.order());
    Jet slope = Jet::constant(1 + result[0] * result[0], a.order());
    for (int k = 1; k <= a.order(); ++k) {
        result[k] = convolveDerivative(a, slope, k) / k;
        for (int j = 0; j <= k; ++j) slope[k] += result[j] * result[k - j];
    }
    return result;
}

Jet tanh(const Jet& a) noexcept {
    // tanh′ = (1 − tanh²) a′; the slope itself as 1/cosh², which keeps its digits where tanh is
    // nearly 1
    const double reciprocal = 1 / std::cosh(a[0]);
    Jet result = Jet::constant(std::tanh(a[0]), a.order());
    Jet slope = Jet::constant(reciprocal * reciprocal, a.order());
    for (int k = 1; k <= a.order(); ++k) {
        result[k] = convolveDerivative(a, slope, k) / k;
        for (int j = 0; j <= k; ++j) slope[k] -= result[j] * result[k - j];
    }
    return result;
}

Jet atan(const Jet& a) noexcept { return integrateQuotient(a, 1.0 + a * a, std::atan(a[0])); }

Jet asin(const Jet& a, Side side) noexcept {
    return integrateQuotient(a, sqrt(oneMinusSquare(a), side), std::asin(a[0]));
}

Jet acos(const Jet& a, Side side) noexcept {
    return integrateQuotient(-a, sqrt(oneMinusSquare(a), side), std::acos(a[0]));
}

Jet sinh(const Jet& a) noexcept { return sinhCosh(a).sin; }

Jet cosh(const Jet& a) noexcept { return sinhCosh(a).cos; }

Jet sqrt(const Jet& a, Side side) noexcept {
    if (a[0] == 0) return pow(a, 0.5, side);
    // result² = a
    Jet result = Jet::constant(std::sqrt(a[0]), a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double rest = a[k];
        for (int j = 1; j < k; ++j) rest -= result[j] * result[k - j];
        result[k] = rest / (2 * result[0]);
    }
    return result;
}

Jet abs(const Jet& a, Side side) noexcept {
    const int m = zeros(a);
    if (m > a.order()) return a;
    const bool flipped = m % 2 != 0 && side == Side::left;
    return (a[m] < 0) != flipped ? -a : a;
}

Jet pow(const Jet& a, double exponent, Side side) noexcept {
    if (exponent == 0) return oneLike(a);
    if (a[0] == 0) {
        return side == Side::right ? powerAtZero(a, exponent)
                                   : mirrored(powerAtZero(mirrored(a), exponent));
    }
    // a · (a^e)′ = e · a′ · a^e
    Jet result = Jet::constant(std::pow(a[0], exponent), a.order());
    for (int k = 1; k <= a.order(); ++k) {
        double sum = 0;
        for (int j = 1; j <= k; ++j) sum += (exponent * j - (k - j)) * a[j] * result[k - j];
        result[k] = sum / (k * a[0]);
    }
    return result;
}

Jet pow(double base, const Jet& a) noexcept {
    if (!(base > 0)) return pow(Jet::constant(base, a.order()), a);
    const double rate = std::log(base);
    Jet result = Jet::constant(std::pow(base, a[0]), a.order());
    for (int k = 1; k <= a.order(); ++k) result[k] = rate * convolveDerivative(a, result, k) / k;
    return result;
}

Jet pow(const Jet& a, const Jet& exponent, Side side) noexcept {
    Jet change = exponent;
    change[0] = 0;
    if (zeros(change) > change.order()) return pow(a, exponent[0], side);
    if (a[0] > 0) {
        Jet result = exp(exponent * log(a));
        result[0] = std::pow(a[0], exponent[0]);
        return result;
    }
    // Next to a zero a^(b(0) + b′(0) h + …) is a^b(0) (1 + O(h log h)): beyond the first term of
    // a^b(0) there are no derivatives.
    Jet result = pow(a, exponent[0], side);
    const double leading = a[0] == 0 && exponent[0] > 0 ? zeros(a) * exponent[0] : 0;
    forget(result, static_cast<int>(std::min(leading, Jet::maxOrder + 1.0)) + 1);
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
