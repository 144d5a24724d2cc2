// A curve of any kind: the one vocabulary in which every kind is evaluated.
//
// The kinds are a closed variant of values, visited once per batch. Each answers domain(), closed(),
// dimension(), evaluate(t, side, rows) for any t and breaks(); whatever else holds for every curve is
// made of these. A Curve is cheap to copy: what it holds is immutable and shared.
#pragma once

#include "geometry/arc_curve.hpp"
#include "geometry/bezier_curve.hpp"
#include "geometry/blending_curve.hpp"
#include "geometry/bspline_curve.hpp"
#include "geometry/formula_curve.hpp"
#include "geometry/interval.hpp"
#include "geometry/line_curve.hpp"
#include "geometry/local_curve.hpp"
#include "geometry/morph_curve.hpp"
#include "geometry/parametric_curve.hpp"
#include "geometry/subdivision_curve.hpp"
#include "geometry/vec.hpp"

#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace knotwork {

class Curve {
public:
    using Kind = std::variant<BsplineCurve, ParametricCurve, BlendingCurve, BezierCurve, LineCurve,
                              ArcCurve, LocalCurve, SubdivisionCurve, FormulaCurve,
                              MorphCurve>;

    /// Of any of the kinds.
    template <class T>
        requires std::is_constructible_v<Kind, T&&> && (!std::is_same_v<std::decay_t<T>, Curve>)
    Curve(T&& curve) : kind_(std::make_shared<const Kind>(std::forward<T>(curve))) {}

    [[nodiscard]] const Kind& kind() const noexcept { return *kind_; }
    template <class T>
    [[nodiscard]] const T* as() const noexcept { return std::get_if<T>(kind_.get()); }

private:
    std::shared_ptr<const Kind> kind_;
};

[[nodiscard]] Interval domain(const Curve& curve) noexcept;
[[nodiscard]] bool isClosed(const Curve& curve) noexcept;
/// 2 where the curve lies in the plane z = 0, otherwise 3.
[[nodiscard]] int dimension(const Curve& curve) noexcept;

/// The parameter itself where it lies in the domain, wrapped into it where the curve is closed,
/// otherwise OUT_OF_RANGE with path `t`. NOT_FINITE for NaN and infinities.
[[nodiscard]] Result<double> parameterInDomain(const Curve& curve, double t);

/// Point and derivatives, rows[k] the k-th derivative, for any t: outside its domain a curve is
/// continued (a parametric curve by its formula, a closed one by its period, any other spline by
/// its end piece).
void evaluate(const Curve& curve, double t, Side side, std::span<Vec3> rows) noexcept;
[[nodiscard]] Vec3 pointAt(const Curve& curve, double t) noexcept;

/// Parameters inside a part of the parameter, ends excluded, between which the curve is smooth
/// (analytic, for all kinds but those with a B-function that is not): its knots, ascending and each
/// once, repeated by periods where the curve is closed. The part may reach outside the domain;
/// beyond a million of them there are none.
[[nodiscard]] std::vector<double> breakParameters(const Curve& curve, const Interval& part);

/// Points first … first+count−1 of `total` spread uniformly over the domain, both ends included,
/// as x,y,z triples. What is made once per call (polynomial pieces) is made by a CurveSampler.
class CurveSampler {
public:
    explicit CurveSampler(const Curve& curve);
    ~CurveSampler();
    CurveSampler(CurveSampler&&) noexcept;
    CurveSampler& operator=(CurveSampler&&) noexcept;

    /// xyz.size() == 3·count.
    void uniform(std::size_t first, std::size_t count, std::size_t total,
                 std::span<double> xyz) const noexcept;
    /// All positions, then all first derivatives, …: xyz.size() == 3·ts.size()·(derivatives+1).
    void at(std::span<const double> ts, int derivatives, std::span<double> xyz) const noexcept;

private:
    struct Prepared;
    std::unique_ptr<const Prepared> prepared_;
};

}  // namespace knotwork
