#include "geometry/b_function_families.hpp"

#include "geometry/incomplete_beta.hpp"
#include "geometry/jet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knotwork::b_function {

namespace {

constexpr double pi = std::numbers::pi;

int derivativeOrder(std::span<const double> rows) noexcept {
    return static_cast<int>(rows.size()) - 1;
}

/// rows[1…] of a function whose slope is factor · density.
void writeSlope(const Jet& density, double factor, std::span<double> rows) noexcept {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        rows[k] = factor * density.derivative(static_cast<int>(k) - 1);
    }
}

/// rows[1…] of `function`.
void writeRows(const Jet& function, std::span<double> rows) noexcept {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        rows[k] = function.derivative(static_cast<int>(k));
    }
}

void clearSlopes(std::span<double> rows) noexcept { std::fill(rows.begin() + 1, rows.end(), 0.0); }

/// ∫_0^1 sin^m(πs) ds.
double sineIntegral(int m) noexcept {
    double integral = m % 2 == 0 ? 1 : 2 / pi;
    for (int j = m % 2 == 0 ? 2 : 3; j <= m; j += 2) integral *= (j - 1.0) / j;
    return integral;
}

/// I_x(a,a) with a = (m+1)/2, x = sin²(πt/2) ≤ 1/2, as x^a (1−x)^a Σ (2a)_n/(a+1)_n x^n / (a
/// B(a,a)): positive terms, so accurate relative to B; x^a (1−x)^a = (sin(πt)/2)^(m+1).
double trigonometricSeries(int m, double slope, double t) noexcept {
    const double half = std::sin(0.5 * pi * t);
    const double x = half * half;
    const double a = 0.5 * (m + 1);
    double term = 1;
    double sum = 1;
    for (int n = 0; term > 1e-17 * sum; ++n) {
        term *= x * (2 * a + n) / (a + 1 + n);
        sum += term;
    }
    return slope / (pi * (m + 1)) * integerPower(std::sin(pi * t), static_cast<unsigned>(m + 1)) *
           sum;
}

/// Even m: integrating by parts lowers m by two, down to t − sin(πt) cos(πt)/π · (1 + …).
double trigonometricEven(int m, double t) noexcept {
    const double sine = std::sin(pi * t);
    const double square = sine * sine;
    double sum = 1;
    for (int j = m; j > 2; j -= 2) sum = 1 + sum * square * (j - 2.0) / (j - 1.0);
    return t - sine * std::cos(pi * t) / pi * sum;
}

/// t where an even order reaches 1e-3: the closed form has lost three digits there, the series has
/// not.
double findSeriesEnd(int m, double slope) noexcept {
    double low = 0;
    double high = 0.5;
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (low + high);
        (trigonometricSeries(m, slope, middle) < 1e-3 ? low : high) = middle;
    }
    return low;
}

}  // namespace

void Linear::derivatives(double, std::span<double> rows) const noexcept {
    clearSlopes(rows);
    if (rows.size() > 1) rows[1] = 1;
}

Trigonometric::Trigonometric(int m) noexcept
    : order(m), slope(1 / sineIntegral(m)), seriesBelow(findSeriesEnd(m, slope)) {}

double Trigonometric::value(double t) const noexcept {
    if (t > 0.5) return 1 - value(1 - t);
    if (order % 2 != 0) {
        const double s = std::sin(0.5 * pi * t);
        const double c = std::cos(0.5 * pi * t);
        return incompleteBeta(s * s, c * c, (order - 1) / 2, (order - 1) / 2);
    }
    return t < seriesBelow ? trigonometricSeries(order, slope, t) : trigonometricEven(order, t);
}

void Trigonometric::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    const bool right = t > 0.5;
    const Jet angle = pi * Jet::variable(right ? 1 - t : t, derivativeOrder(rows) - 1);
    writeSlope(integerPower(sin(angle), static_cast<unsigned>(order)), slope, rows);
    if (right) reflectRows(rows);
}

void Polynomial::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    const bool inside = p > 0 && q > 0;
    if (rows.size() > 3 || !inside) {
        const Jet variable = Jet::variable(t, derivativeOrder(rows) - 1);
        const Jet density = integerPower(variable, static_cast<unsigned>(p)) *
                            integerPower(1.0 - variable, static_cast<unsigned>(q));
        writeSlope(density, (p + q + 1) * binomial(p, q), rows);
    }
    if (!inside) return;
    // What curves ask for at every point takes no jets; and however many rows there are, they agree.
    const double s = 1 - t;
    const double lower = (p + q + 1) * binomial(p, q) *
                         integerPower(t, static_cast<unsigned>(p - 1)) *
                         integerPower(s, static_cast<unsigned>(q - 1));
    rows[1] = lower * t * s;
    if (rows.size() > 2) rows[2] = lower * (p * s - q * t);
}

bool Rational::integerPowers() const noexcept { return m == std::trunc(m); }

double Rational::value(double t) const noexcept {
    const double s = 1 - t;
    const double ratio = t < s ? t / s : s / t;
    const double power =
        integerPowers() ? integerPower(ratio, static_cast<unsigned>(m)) : std::pow(ratio, m);
    return t < s ? power / (power + c) : 1 / (1 + c * power);
}

// As 1 − c/(w+c) with w = (t/(1−t))^m on the left and 1/(1 + c v), v = 1/w, on the right: neither
// forms a difference of large numbers.
void Rational::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    if (!integerPowers() && (t == 0 || t == 1)) return clearSlopes(rows);
    const Jet variable = Jet::variable(t, derivativeOrder(rows));
    const Jet rest = 1.0 - variable;
    const Jet ratio = t < 0.5 ? variable / rest : rest / variable;
    const Jet power =
        integerPowers() ? integerPower(ratio, static_cast<unsigned>(m)) : pow(ratio, m);
    writeRows(t < 0.5 ? -(c / (power + c)) : 1.0 / (1.0 + c * power), rows);
}

double Logistic::value(double t) const noexcept {
    const double exponent = c * (1 - 2 * t) / (t * (1 - t));
    const double small = std::exp(-std::abs(exponent));
    return exponent > 0 ? small / (1 + small) : 1 / (1 + small);
}

void Logistic::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    const bool right = t > 0.5;
    const Jet variable = Jet::variable(right ? 1 - t : t, derivativeOrder(rows));
    if (variable.value() == 0) return clearSlopes(rows);
    const Jet small = exp(-c * (1.0 / variable - 1.0 / (1.0 - variable)));
    if (small.value() == 0) return clearSlopes(rows);
    writeRows(-(1.0 / (1.0 + small)), rows);
    if (right) reflectRows(rows);
}

}  // namespace knotwork::b_function
