// Curves that are given by formulas in t: x(t), y(t) and perhaps z(t), as a person types them.
#pragma once

#include "geometry/formula.hpp"
#include "geometry/interval.hpp"
#include "geometry/vec.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork {

/// What a formula curve is made of.
struct FormulaCurveParts {
    std::string x;
    std::string y;
    std::optional<std::string> z = std::nullopt;
    std::vector<NamedValue> parameters = {};
    Interval domain;
    bool closed = false;
};

class FormulaCurve {
public:
    /// Refusals: those of Formula at `x`, `y`, `z`; of checkFormulaParameters() at
    /// `parameters.<name>`; of checkDomain(); NOT_FINITE at the formula that has no value somewhere
    /// on the domain, with the t (2521 parameters are looked at, and between them every change of
    /// sign, which may be that of a pole); OUT_OF_RANGE there for coordinates beyond 1e12, and at
    /// `closed` for a curve that does not end where it began, to 1e-9 of its size.
    static Result<FormulaCurve> make(const FormulaCurveParts& parts);

    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    /// Only what is said to be closed is: outside its domain it is wrapped.
    [[nodiscard]] bool closed() const noexcept { return closed_; }
    /// 2 where z is left out or is the number 0.
    [[nodiscard]] int dimension() const noexcept { return formulas_.size() < 3 ? 2 : 3; }
    [[nodiscard]] std::span<const double> breaks() const noexcept { return {}; }

    /// C(t), C′(t), C″(t), … into at most 26 rows for any t, exact up to rounding; outside the
    /// domain the formulas go on. Where a derivative does not exist (√t at 0) its row is infinite or
    /// NaN; the side decides at a kink of abs.
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept;

private:
    FormulaCurve() = default;
    [[nodiscard]] Vec3 point(double t) const noexcept;

    std::vector<Formula> formulas_;  // x, y and, in space, z
    Interval domain_;
    bool closed_ = false;
};

}  // namespace knotwork
