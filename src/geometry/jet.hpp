// Truncated Taylor arithmetic in one variable: a value and its derivatives, carried together.
//
// A Jet of order n at t stands for c_0 + c_1 h + … + c_n h^n with c_k = f^(k)(t) / k!. A formula
// that is a template over its scalar gives positions with double, exact derivatives with Jet, and
// complex-step checks with std::complex<double>. (Griewank, Walther: Evaluating Derivatives, 2nd
// ed. 2008, ch. 13.)
#pragma once

#include "geometry/interval.hpp"

#include <algorithm>
#include <array>
#include <complex>

namespace knotwork {

/// Order is chosen at run time, up to maxOrder; copying copies only the coefficients in use. A sum
/// or product of two jets has the smaller of the two orders. Costs: +, − and double factors O(n),
/// all else O(n²). Where a function has no derivative (log of 0, …) the rows are not finite.
class Jet {
public:
    static constexpr int maxOrder = 25;

    Jet() noexcept : order_(0) { coefficients_[0] = 0; }
    Jet(const Jet& other) noexcept : order_(other.order_) { copy(other); }
    Jet& operator=(const Jet& other) noexcept {
        order_ = other.order_;
        copy(other);
        return *this;
    }
    ~Jet() = default;

    /// The constant function; `order` in [0, maxOrder].
    [[nodiscard]] static Jet constant(double value, int order) noexcept;
    /// The identity at t: value t, first derivative 1.
    [[nodiscard]] static Jet variable(double t, int order) noexcept;

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] double value() const noexcept { return coefficients_[0]; }
    /// The Taylor coefficient c_k, 0 ≤ k ≤ order().
    [[nodiscard]] double operator[](int k) const noexcept {
        return coefficients_[static_cast<std::size_t>(k)];
    }
    [[nodiscard]] double& operator[](int k) noexcept {
        return coefficients_[static_cast<std::size_t>(k)];
    }
    /// The k-th derivative, k! c_k.
    [[nodiscard]] double derivative(int k) const noexcept;

    Jet& operator+=(const Jet& other) noexcept;
    Jet& operator-=(const Jet& other) noexcept;
    Jet& operator*=(double factor) noexcept;
    Jet& operator+=(double offset) noexcept {
        coefficients_[0] += offset;
        return *this;
    }

private:
    // The value by itself: GCC cannot see that order_ + 1 is never 0, and warns at every sum.
    void copy(const Jet& other) noexcept {
        coefficients_[0] = other.coefficients_[0];
        std::copy_n(other.coefficients_.begin() + 1, order_, coefficients_.begin() + 1);
    }

    int order_;
    std::array<double, maxOrder + 1> coefficients_;  // beyond order_ not initialised, never read
};

[[nodiscard]] Jet operator*(const Jet& a, const Jet& b) noexcept;
[[nodiscard]] Jet operator/(const Jet& a, const Jet& b) noexcept;
[[nodiscard]] Jet operator/(double a, const Jet& b) noexcept;

[[nodiscard]] inline Jet operator+(Jet a, const Jet& b) noexcept { return a += b; }
[[nodiscard]] inline Jet operator-(Jet a, const Jet& b) noexcept { return a -= b; }
[[nodiscard]] inline Jet operator-(Jet a) noexcept { return a *= -1.0; }
[[nodiscard]] inline Jet operator+(Jet a, double b) noexcept { return a += b; }
[[nodiscard]] inline Jet operator+(double a, Jet b) noexcept { return b += a; }
[[nodiscard]] inline Jet operator-(Jet a, double b) noexcept { return a += -b; }
[[nodiscard]] inline Jet operator-(double a, const Jet& b) noexcept { return -b + a; }
[[nodiscard]] inline Jet operator*(Jet a, double b) noexcept { return a *= b; }
[[nodiscard]] inline Jet operator*(double a, Jet b) noexcept { return b *= a; }
[[nodiscard]] inline Jet operator/(Jet a, double b) noexcept { return a *= 1.0 / b; }

struct SinCos {
    Jet sin;
    Jet cos;
};
/// Both at the price of one: their recurrences are coupled.
[[nodiscard]] SinCos sinCos(const Jet& a) noexcept;

[[nodiscard]] Jet sin(const Jet& a) noexcept;
[[nodiscard]] Jet cos(const Jet& a) noexcept;
[[nodiscard]] Jet tan(const Jet& a) noexcept;
[[nodiscard]] Jet atan(const Jet& a) noexcept;
[[nodiscard]] Jet sinh(const Jet& a) noexcept;
[[nodiscard]] Jet cosh(const Jet& a) noexcept;
[[nodiscard]] Jet tanh(const Jet& a) noexcept;
[[nodiscard]] Jet exp(const Jet& a) noexcept;
[[nodiscard]] Jet log(const Jet& a) noexcept;

// At a zero of a (asin, acos: of 1 − a²) these have derivatives from one side only: those of the
// side from which the variable comes. They are taken from the first term of a that does not vanish:
// |t| has the slope 1 on the right of 0 and −1 on its left, √t an infinite one, √(t⁴) none up to
// the second derivative, 2. NaN where a function is not real on that side, and in the last rows
// where they depend on terms of a beyond its order.
[[nodiscard]] Jet asin(const Jet& a, Side side = Side::right) noexcept;
[[nodiscard]] Jet acos(const Jet& a, Side side = Side::right) noexcept;
[[nodiscard]] Jet sqrt(const Jet& a, Side side = Side::right) noexcept;
[[nodiscard]] Jet abs(const Jet& a, Side side = Side::right) noexcept;
/// a^exponent for any real exponent; a value a < 0 needs an integer. 0^0 is 1.
[[nodiscard]] Jet pow(const Jet& a, double exponent, Side side = Side::right) noexcept;
/// The same for an exponent that varies, where a value a < 0 has no derivatives.
[[nodiscard]] Jet pow(const Jet& a, const Jet& exponent, Side side = Side::right) noexcept;
/// base^a.
[[nodiscard]] Jet pow(double base, const Jet& a) noexcept;

/// outer ∘ inner, where outer holds the Taylor coefficients at inner.value() (Horner, O(n³)).
[[nodiscard]] Jet compose(const Jet& outer, const Jet& inner) noexcept;

/// base^exponent for an exponent ≥ 0 by repeated squaring, for every scalar of the formulas. Exact
/// zeros stay exact: t^p at t = 0 has p vanishing coefficients.
template <class Scalar>
[[nodiscard]] Scalar integerPower(Scalar base, unsigned exponent) noexcept;

/// The constant 1 in the kind (and order) of `like`.
[[nodiscard]] inline double oneLike(double) noexcept { return 1; }
[[nodiscard]] inline std::complex<double> oneLike(const std::complex<double>&) noexcept {
    return 1;
}
[[nodiscard]] inline Jet oneLike(const Jet& like) noexcept {
    return Jet::constant(1, like.order());
}

template <class Scalar>
Scalar integerPower(Scalar base, unsigned exponent) noexcept {
    Scalar power = oneLike(base);
    for (; exponent != 0; exponent >>= 1U) {
        if ((exponent & 1U) != 0) power = power * base;
        if (exponent > 1) base = base * base;
    }
    return power;
}

}  // namespace knotwork
