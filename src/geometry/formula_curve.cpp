#include "geometry/formula_curve.hpp"

#include "geometry/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
/// Divisible by all numbers up to 10, so that the usual fractions of the domain are among them.
constexpr std::size_t samples = 2521;
constexpr double seamTolerance = 1e-9;

Error notFinite(std::string_view name, const Formula& formula, double t) {
    return refuse(Code::notFinite, std::string(name),
                  std::string(name) + " = " + formula.text().substr(0, 60) +
                      " has no finite value at t = " + formatNumber(t) +
                      "; choose a domain without it, or another formula.");
}

/// Whether the change of sign between a and b is that of a pole: the values grow as it is enclosed.
std::optional<double> poleBetween(const Formula& formula, double a, double b) noexcept {
    const double before = std::max(std::abs(formula.value(a)), std::abs(formula.value(b)));
    const bool rising = formula.value(a) < 0;
    double enclosed = before;
    for (int i = 0; i < 60; ++i) {
        const double middle = a + (b - a) / 2;
        if (middle <= a || middle >= b) break;
        const double value = formula.value(middle);
        if (!std::isfinite(value)) return middle;
        ((value < 0) == rising ? a : b) = middle;
        enclosed = std::max(std::abs(formula.value(a)), std::abs(formula.value(b)));
    }
    if (enclosed > 1e6 * before) return a;
    return std::nullopt;
}

std::optional<Error> checkValues(std::string_view name, const Formula& formula,
                                 const Interval& domain) {
    double before = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double t = uniformParameter(domain, i, samples);
        const double value = formula.value(t);
        if (!std::isfinite(value)) return notFinite(name, formula, t);
        if (std::abs(value) > largestCoordinate) {
            return refuse(Code::outOfRange, std::string(name),
                          std::string(name) + " is " + formatNumber(value) + " at t = " +
                              formatNumber(t) + "; coordinates go to 1e12.");
        }
        if (i > 0 && ((before < 0 && value > 0) || (before > 0 && value < 0))) {
            const double last = uniformParameter(domain, i - 1, samples);
            if (const auto pole = poleBetween(formula, last, t)) {
                return notFinite(name, formula, *pole);
            }
        }
        before = value;
    }
    return std::nullopt;
}

/// The largest coordinate at some of the samples.
double sizeOf(std::span<const Formula> formulas, const Interval& domain) noexcept {
    double size = 0;
    for (const Formula& formula : formulas) {
        for (std::size_t i = 0; i < samples; i += 20) {
            size = std::max(size, std::abs(formula.value(uniformParameter(domain, i, samples))));
        }
    }
    return size;
}

}  // namespace

Result<FormulaCurve> FormulaCurve::make(const FormulaCurveParts& parts) {
    if (auto error = checkFormulaParameters(parts.parameters, "parameters")) {
        return *std::move(error);
    }
    if (auto error = checkDomain(parts.domain)) return *std::move(error);
    FormulaCurve curve;
    curve.domain_ = parts.domain;
    const std::array texts{&parts.x, &parts.y, parts.z ? &*parts.z : nullptr};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (texts[i] == nullptr) break;
        auto formula = Formula::make(*texts[i], names[i], parts.parameters);
        if (!formula) return formula.error();
        if (auto error = checkValues(names[i], *formula, parts.domain)) return *std::move(error);
        if (i < 2 || formula->constant() != 0.0) curve.formulas_.push_back(std::move(*formula));
    }
    curve.closed_ = parts.closed;
    if (!parts.closed) return curve;
    const double gap =
        glm::length(curve.point(parts.domain.end) - curve.point(parts.domain.start));
    if (gap > seamTolerance * sizeOf(curve.formulas_, parts.domain)) {
        return refuse(Code::outOfRange, "closed",
                      "A closed curve ends where it begins, but between the ends of the domain [" +
                          formatNumber(parts.domain.start) + ", " +
                          formatNumber(parts.domain.end) + "] lies a distance of " +
                          formatNumber(gap) + "; choose a domain that is a period, or leave "
                          "\"closed\" out.");
    }
    return curve;
}

Vec3 FormulaCurve::point(double t) const noexcept {
    return {formulas_[0].value(t), formulas_[1].value(t),
            formulas_.size() < 3 ? 0 : formulas_[2].value(t)};
}

void FormulaCurve::evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    std::fill(rows.begin(), rows.end(), Vec3(0));
    rows[0] = point(t);
    if (rows.size() == 1) return;
    if (!closed_ && t == domain_.start) side = Side::right;  // the other side is not there
    if (!closed_ && t == domain_.end) side = Side::left;
    const auto computed = std::min<std::size_t>(rows.size(), Jet::maxOrder + 1);
    const Jet variable = Jet::variable(t, static_cast<int>(computed) - 1);
    for (std::size_t i = 0; i < formulas_.size(); ++i) {
        const Jet jet = formulas_[i].jet(variable, side);
        for (std::size_t k = 1; k < computed; ++k) {
            rows[k][static_cast<int>(i)] = jet.derivative(static_cast<int>(k));
        }
    }
}

}  // namespace knotwork
