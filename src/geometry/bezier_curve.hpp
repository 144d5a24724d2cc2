// Bézier curves, polynomial or rational: C(t) = Σ binomial(d, j) b_j u^j (1−u)^(d−j) over the
// domain, u = (t − start)/length.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/interval.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <optional>
#include <span>
#include <vector>

namespace knotwork {

class BezierCurve {
public:
    /// Degree = points − 1. Refuses fewer than 2 points (WRONG_LENGTH `points`) and more than 26
    /// (TOO_LARGE `points`), points and weights as BsplineCurve does, domains as checkDomain().
    [[nodiscard]] static Result<BezierCurve> make(std::vector<Vec3> points,
                                                  std::vector<double> weights,
                                                  const Interval& domain);

    /// The polynomial Σ taylor[k] (t − t0)^k, its control points over the domain by its blossom:
    /// b_j = f[start, …, end, …] with j times the end. 2 to 26 coefficients; O(d³).
    [[nodiscard]] static BezierCurve fromTaylor(std::span<const Vec3> taylor, double t0,
                                                const Interval& domain);

    [[nodiscard]] std::span<const Vec3> points() const noexcept { return points_; }
    /// Empty, or one per point.
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    [[nodiscard]] std::size_t degree() const noexcept { return points_.size() - 1; }
    [[nodiscard]] bool rational() const noexcept { return rational_; }

    // As every kind of curve; beyond its domain the polynomial (or quotient) goes on.
    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    [[nodiscard]] bool closed() const noexcept { return false; }
    [[nodiscard]] int dimension() const noexcept { return dimension_; }
    /// De Casteljau's algorithm, O(d²) and O(d) more a row; both ends exact.
    void evaluate(double t, Side, std::span<Vec3> rows) const noexcept;
    [[nodiscard]] std::span<const double> breaks() const noexcept { return {}; }

private:
    BezierCurve(std::vector<Vec3> points, std::vector<double> weights, const Interval& domain);

    std::vector<Vec3> points_;
    std::vector<double> weights_;
    Interval domain_;
    int dimension_;
    bool rational_;
};

/// The same curve as one span of a clamped B-spline, for what is made for those; nothing where its
/// domain or points are not allowed there.
[[nodiscard]] std::optional<BsplineCurve> asBspline(const BezierCurve& curve);

}  // namespace knotwork
