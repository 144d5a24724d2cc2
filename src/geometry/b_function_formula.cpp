// B-functions that a person types: the check against the axioms, and what is found out about them.
#include "geometry/b_function_axioms.hpp"
#include "geometry/b_function_families.hpp"
#include "geometry/formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace knotwork::b_function {

namespace {

/// Taylor coefficients at an end that are smaller than this are roundings: those of a function
/// that rises from 0 to 1 on [0,1] are of the size of 1.
constexpr double coefficientTolerance = 1e-10;
constexpr double smallestPower = 1.0 / 64;

constexpr std::string_view kinkWarning =
    "the formula contains abs: derivatives need not exist where its argument changes sign";
constexpr std::string_view powerWarning =
    "at an end only derivatives below the power of t, or of 1−t, exist there";

Error violation(Code code, std::string_view axiom, const std::string& found) {
    return refuse(code, "expression", std::string(axiom) + ", but " + found + ".");
}

std::string at(double t, double value) {
    return "B(" + formatNumber(t) + ") = " + formatNumber(value);
}

Error endError(double end, double value) {
    const std::string_view axiom =
        end == 0 ? "B(0) must be 0 (axiom D2)" : "B(1) must be 1 (axiom D3)";
    return violation(std::isfinite(value) ? Code::outOfRange : Code::notFinite, axiom,
                     at(end, value));
}

Error rangeError(const AxiomBreach& breach) {
    return violation(std::isfinite(breach.found) ? Code::outOfRange : Code::notFinite,
                     "B must map [0, 1] to [0, 1] (axiom D1)", at(breach.t, breach.found));
}

Error slopeError(const AxiomBreach& breach) {
    const std::string t = formatNumber(breach.t);
    return violation(Code::outOfRange, "B must not decrease (axiom D4)",
                     breach.found < 0 ? "its slope at t = " + t + " is " + formatNumber(breach.found)
                                      : "it has fallen before t = " + t);
}

/// The first thing that keeps a formula from being a B-function: at an end, else in the order of t.
/// A value that is taken for a while is let pass.
std::optional<Error> firstBreach(const AxiomBreaches& breaches) {
    const auto& [range, start, end, slope, symmetry] = breaches;
    if (start) return endError(0, start->found);
    if (end) return endError(1, end->found);
    const bool leaves = range && !(range->found >= 0 && range->found <= 1);
    if (leaves && (!slope || range->t < slope->t || !std::isfinite(range->found))) {
        return rangeError(*range);
    }
    if (slope) return slopeError(*slope);
    return std::nullopt;
}

/// The fraction that a measured power is meant to be, where there is one close to it.
double snapped(double power) noexcept {
    for (int q = 1; q <= 6; ++q) {
        const double p = std::round(power * q);
        if (std::abs(power * q - p) < 1e-3) return std::max(p / q, smallestPower);
    }
    return std::max(power, smallestPower);
}

/// The power with which the function leaves an end, measured from the slopes at halving distances.
/// Infinite where it is beyond all orders, where it still grows (as that of exp(−1/t) does), or
/// where the slope underflows first.
double measuredPower(const Formula& formula, double end) noexcept {
    constexpr double clearSlope = 1e-8;  // smaller ones may have been lost to cancellation
    double before = 0;
    double power = infinitePower;  // the last that was measured on clear slopes
    bool grows = false;
    for (int k = 2; k <= 30; ++k) {
        const double distance = std::ldexp(1.0, -k);
        const double t = end == 0 ? distance : 1 - distance;
        const double slope = formula.jet(Jet::variable(t, 1))[1];
        const double rise = distance * slope;
        if (!(rise > 0) || std::isinf(rise)) return infinitePower;
        if (k > 2) {
            const double measured = std::log2(before / rise);
            if (measured > Jet::maxOrder + 1) return infinitePower;
            if (slope > clearSlope || std::isinf(power)) {
                grows = std::isfinite(power) && power > 1 && measured > 1.25 * power;
                power = measured;
            }
        }
        before = rise;
    }
    return grows ? infinitePower : snapped(power);
}

/// What is known about the function at an end.
struct End {
    double power;  ///< with which it leaves 0 at 0, or reaches 1 at 1
    Jet jet;       ///< of the highest order; rows that do not exist are 0
};

/// Taylor coefficients at an end where the formula has a limit only, but the function goes on
/// smoothly, as 1/(1 + (1/t − 1)²) does: those of two points inside, as far as they agree.
Jet limitJet(const Formula& formula, double end) noexcept {
    const auto from = [&](double distance) {
        const double t = end == 0 ? distance : 1 - distance;
        const Jet inside = formula.jet(Jet::variable(t, Jet::maxOrder));
        Jet moved = Jet::constant(0, Jet::maxOrder);
        for (int k = Jet::maxOrder; k >= 0; --k) {
            moved = moved * Jet::variable(end - t, Jet::maxOrder) + inside[k];
        }
        return moved;
    };
    // Closer, roundings grow with the powers of the distance; further, the series ends too early.
    // Measured: the third derivative to 1e-9, the fourth to 3e-7.
    Jet near = from(1.0 / 16);
    const Jet far = from(3.0 / 32);
    for (int k = 0; k <= Jet::maxOrder; ++k) {
        const bool agree = std::abs(near[k] - far[k]) <= 1e-7 * std::max(1.0, std::abs(near[k]));
        if (!agree) near[k] = std::numeric_limits<double>::quiet_NaN();
    }
    return near;
}

End endOf(const Formula& formula, double end) noexcept {
    const Side side = end == 0 ? Side::right : Side::left;
    End found{infinitePower, formula.jet(Jet::variable(end, Jet::maxOrder), side)};
    int k = 1;
    while (k <= Jet::maxOrder && std::abs(found.jet[k]) <= coefficientTolerance) ++k;
    if (k <= Jet::maxOrder) {
        found.power = k;
        if (!std::isfinite(found.jet[k])) {
            found.power = measuredPower(formula, end);
            if (k > 1) found.power = std::max(found.power, k - 1 + smallestPower);
            if (found.power == std::trunc(found.power)) found.jet = limitJet(formula, end);
        }
    }
    for (k = 1; k <= Jet::maxOrder; ++k) {
        if (k < found.power || !std::isfinite(found.jet[k])) found.jet[k] = 0;
    }
    return found;
}

bool isFractional(double power) noexcept {
    return std::isfinite(power) && power != std::trunc(power);
}

}  // namespace

struct UserFormula::Checked {
    Formula formula;
    Jet start;
    Jet end;
};

Result<UserFormula> UserFormula::make(std::string_view expression) {
    auto formula = Formula::make(expression, "expression");
    if (!formula) return formula.error();
    const AxiomBreaches breaches = axiomBreaches(*formula);
    if (auto error = firstBreach(breaches)) return *std::move(error);
    UserFormula made;
    const End start = endOf(*formula, 0);
    const End end = endOf(*formula, 1);
    made.powers_ = {start.power, end.power};
    made.symmetric_ = !breaches.back();
    const auto program = formula->program();
    if (std::any_of(program.begin(), program.end(),
                    [](const auto& each) { return each.op == formula::Op::abs; })) {
        made.warning_ = kinkWarning;
    } else if (isFractional(made.powers_[0]) || isFractional(made.powers_[1])) {
        made.warning_ = powerWarning;
    }
    made.checked_ = std::make_shared<const Checked>(
        Checked{*std::move(formula), start.jet, end.jet});
    return made;
}

double UserFormula::value(double t) const noexcept {
    const double value = checked_->formula.value(t);
    return std::isnan(value) ? (t < 0.5 ? 0 : 1) : value;  // the grid found none
}

void UserFormula::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    const Jet jet = t == 0   ? checked_->start
                    : t == 1 ? checked_->end
                             : checked_->formula.jet(
                                   Jet::variable(t, static_cast<int>(rows.size()) - 1));
    for (std::size_t k = 1; k < rows.size(); ++k) rows[k] = jet.derivative(static_cast<int>(k));
    rows[1] = std::max(rows[1], 0.0);
}

std::string_view UserFormula::expression() const noexcept { return checked_->formula.text(); }

}  // namespace knotwork::b_function
