// One small struct per family of B-functions; BFunction wraps them.
//
// Every family has, for t in (0,1): value(t); and, for t in [0,1]: derivatives(t, rows) into 1 to
// 26 rows, one-sided at the ends. powers() are the exponents {e0, e1} with B ~ t^e0 at 0 and
// 1 − B ~ (1−t)^e1 at 1: they follow the algebra exactly (composition multiplies them) where
// Hermite orders, ⌈e⌉ − 1, do not. All are total and noexcept.
#pragma once

#include "geometry/b_function_expo_rational.hpp"
#include "geometry/result.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace knotwork {
class BFunction;
}

namespace knotwork::b_function {

using Powers = std::array<double, 2>;
inline constexpr double infinitePower = std::numeric_limits<double>::infinity();

/// Rows of B at 1−t become those of its dual, 1 − B(1−t), at t.
inline void reflectRows(std::span<double> rows) noexcept {
    if (rows.empty()) return;
    rows[0] = 1 - rows[0];
    for (std::size_t k = 2; k < rows.size(); k += 2) rows[k] = -rows[k];
}

struct Linear {
    [[nodiscard]] double value(double t) const noexcept { return t; }
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return {1, 1}; }
    [[nodiscard]] bool symmetric() const noexcept { return true; }
};

/// B′ = c_m sin^m(πt). With x = sin²(πt/2) it is the incomplete Beta function I_x(a,a),
/// a = (m+1)/2: a polynomial in x for odd m, else t minus a cosine sum, or a series near 0.
struct Trigonometric {
    explicit Trigonometric(int order) noexcept;
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return {order + 1.0, order + 1.0}; }
    [[nodiscard]] bool symmetric() const noexcept { return true; }

    int order;
    double slope;        ///< c_m, the slope at the middle
    double seriesBelow;  ///< t below which an even order takes its series: there B = 1e-3
};

/// B′ = (p+q+1)!/(p!q!) t^p (1−t)^q.
struct Polynomial {
    [[nodiscard]] double value(double t) const noexcept;
    /// At any parameters, two at a time; the values may take their places.
    void sample(std::span<const double> ts, std::span<double> values) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return {p + 1.0, q + 1.0}; }
    [[nodiscard]] bool symmetric() const noexcept { return p == q; }

    int p;
    int q;
};

/// t^m / (t^m + c (1−t)^m). For m that is not an integer, derivatives beyond m do not exist at the
/// ends.
struct Rational {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return {m, m}; }
    [[nodiscard]] bool symmetric() const noexcept { return c == 1; }
    [[nodiscard]] bool integerPowers() const noexcept;

    double m;
    double c;
};

/// 1 / (1 + exp(c (1/t − 1/(1−t)))).
struct Logistic {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return {infinitePower, infinitePower}; }
    [[nodiscard]] bool symmetric() const noexcept { return true; }

    double c;
};

/// Piecewise cubic on a uniform grid. Slopes: of the quartic through the five nearest values (so
/// cubics are reproduced where the limit is not active), limited to three times the smaller
/// neighbouring difference, which keeps each piece monotone (Fritsch, Carlson, SIAM J. Numer. Anal.
/// 17, 1980).
class Tabulated {
public:
    /// At least two checked values.
    explicit Tabulated(std::span<const double> values);
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept { return powers_; }
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    [[nodiscard]] std::span<const double> values() const noexcept { return *values_; }

private:
    struct Cell {
        std::array<double, 4> coefficients;  // powers of x in [0,1]
    };
    std::shared_ptr<const std::vector<double>> values_;
    std::shared_ptr<const std::vector<Cell>> cells_;
    Powers powers_{};
    bool symmetric_ = false;
};

/// What a person typed. It has passed the axioms on a grid of 2 500 points that comes close to the
/// ends; an end where the formula has a limit only (1/t in an exponent) counts with that limit.
class UserFormula {
public:
    /// Refusals at `expression`: those of Formula; OUT_OF_RANGE or NOT_FINITE with the axiom that
    /// does not hold, what was found and where. Cost: some 2 500 evaluations with two derivatives.
    static Result<UserFormula> make(std::string_view expression);

    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    /// From the Taylor series at the ends: a coefficient below 1e-10 counts as 0. Where there is no
    /// series, measured close to the end.
    [[nodiscard]] Powers powers() const noexcept { return powers_; }
    /// To 1e-12 on a grid.
    [[nodiscard]] bool symmetric() const noexcept { return symmetric_; }
    [[nodiscard]] std::string_view warning() const noexcept { return warning_; }
    [[nodiscard]] std::string_view expression() const noexcept;

private:
    UserFormula() = default;

    struct Checked;  // the formula and its derivatives at both ends
    std::shared_ptr<const Checked> checked_;
    Powers powers_{};
    bool symmetric_ = false;
    std::string_view warning_{};
};

using Operand = std::shared_ptr<const BFunction>;

struct Dual {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept;
    [[nodiscard]] bool symmetric() const noexcept;
    Operand of;
};

struct Symmetrised {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept;
    [[nodiscard]] bool symmetric() const noexcept { return true; }
    Operand of;
};

struct Composed {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept;
    [[nodiscard]] bool symmetric() const noexcept;
    Operand outer;
    Operand inner;
};

struct Mixed {
    [[nodiscard]] double value(double t) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] Powers powers() const noexcept;
    [[nodiscard]] bool symmetric() const noexcept;
    Operand first;
    Operand second;
    double weight;
};

}  // namespace knotwork::b_function
