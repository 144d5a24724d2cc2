// Named model curves: circle, rose, butterfly, torus knot, …, given by a formula in one parameter.
//
// The formulas are in parametric_curve_models.hpp, as templates over the scalar: positions with
// double, derivatives with Jet. A curve is a value, checked when made and total afterwards.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/parametric_curve_models.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace knotwork {

class ParametricCurve {
public:
    /// The model `name` of parametricCurveModels() with these parameters (defaults for the others)
    /// on `domain`, by default one period (or the turns of a spiral). A ratio (k of a rose, R/r of
    /// a trochoid) within 1e-9 of p/q, q ≤ 64, counts as p/q, in the formula too.
    ///
    /// Refusals: UNKNOWN_NAME at `name`; UNKNOWN_FIELD, NOT_FINITE, NOT_INTEGER, OUT_OF_RANGE at
    /// `parameters.<name>`; a ratio that is not recognised and has no domain is OUT_OF_RANGE at
    /// `parameters.k` or `parameters.r`; NOT_FINITE or OUT_OF_RANGE at `domain`, `domain[i]`
    /// (|t| ≤ 1e9, length at least 1e-6 and 1e-9 of the larger end).
    static Result<ParametricCurve> make(std::string_view name,
                                        std::span<const NamedValue> parameters = {},
                                        std::optional<Interval> domain = std::nullopt);

    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    /// The domain spans whole periods and its end points agree to rounding (1e-9 of the curve's
    /// size). A loop that ends where it began but is no period is not closed. The butterfly counts
    /// 12π as a period where it returns with four derivatives, that is from a multiple of 12π.
    [[nodiscard]] bool closed() const noexcept { return closed_; }
    /// 2 when the curve stays in the plane z = 0, else 3.
    [[nodiscard]] int dimension() const noexcept { return description().dimension; }

    /// The point at any t: the formula continues outside the domain. Error a few ulp of the
    /// coordinates' size (times |t| for |t| ≫ 1).
    [[nodiscard]] Vec3 point(double t) const noexcept;
    /// C(t), C′(t), C″(t), … into at most 26 rows, exact up to rounding; O(rows²).
    void derivatives(double t, std::span<Vec3> rows) const noexcept;
    /// out[i] = point(ts[i]), the model looked up once. Both of the same length.
    void samplePoints(std::span<const double> ts, std::span<Vec3> out) const noexcept;
    /// out.size() points, uniform in the parameter over the domain, both ends included.
    void sampleUniform(std::span<Vec3> out) const noexcept;

    // As every kind of curve; it has no sides and no knots.
    void evaluate(double t, Side, std::span<Vec3> rows) const noexcept {
        if (rows.size() == 1) {
            rows[0] = point(t);  // jets of order 0 cost several times as much
        } else {
            derivatives(t, rows);
        }
    }
    [[nodiscard]] std::span<const double> breaks() const noexcept { return {}; }

    // What it was made from.
    [[nodiscard]] std::string_view name() const noexcept { return description().name; }
    [[nodiscard]] const ParametricModelDescription& description() const noexcept {
        return parametricCurveModels()[static_cast<std::size_t>(id_)];
    }
    /// In the order of description().parameters, as given (not rounded to p/q).
    [[nodiscard]] std::span<const double> parameters() const noexcept {
        return std::span(parameters_).first(description().parameters.size());
    }
    /// The domain was given, not derived from the parameters.
    [[nodiscard]] bool hasOwnDomain() const noexcept { return ownDomain_; }

    friend bool operator==(const ParametricCurve& a, const ParametricCurve& b) noexcept;

private:
    ParametricCurve() = default;

    ParametricModel id_ = ParametricModel::circle;
    parametric_model::Any model_;
    std::array<double, 4> parameters_{};
    Interval domain_;
    bool closed_ = false;
    bool ownDomain_ = false;
};

}  // namespace knotwork
