// B-spline curves, polynomial or rational, open, clamped or closed.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/knot_vector.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>
#include <vector>

namespace knotwork {

class BsplineCurve {
public:
    /// Refusals: WRONG_LENGTH `points` or `weights` (one per point of the knot vector, or no
    /// weights at all); NOT_FINITE and OUT_OF_RANGE `points[i]` (|coordinate| ≤ 1e12) and
    /// `weights[i]` (1e-9 … 1e9); OUT_OF_RANGE `dimension` (2 or 3; z must be 0 for 2).
    [[nodiscard]] static Result<BsplineCurve> make(KnotVector knots, std::vector<Vec3> points,
                                                   int dimension, std::vector<double> weights = {});

    [[nodiscard]] const KnotVector& knotVector() const noexcept { return knots_; }
    [[nodiscard]] std::span<const Vec3> points() const noexcept { return points_; }
    /// Empty, or one per point.
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    [[nodiscard]] int dimension() const noexcept { return dimension_; }
    [[nodiscard]] int degree() const noexcept { return knots_.degree(); }
    [[nodiscard]] Interval domain() const noexcept { return knots_.domain(); }
    [[nodiscard]] bool closed() const noexcept { return knots_.closed(); }
    /// Whether the weights matter: given and not all equal.
    [[nodiscard]] bool rational() const noexcept { return rational_; }

    /// The point at any t: a closed curve wraps, another is continued by its end pieces. De Boor's
    /// algorithm, O(d²); exact at the ends of a clamped curve.
    [[nodiscard]] Vec3 point(double t) const noexcept;

    /// rows[k] becomes the k-th derivative at t, rows[0] the point, for as many rows as there are;
    /// continued as point(). O(d² · rows).
    void derivatives(double t, Side side, std::span<Vec3> rows) const noexcept;

    // As every kind of curve.
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
        derivatives(t, side, rows);
    }
    [[nodiscard]] std::span<const double> breaks() const noexcept { return knots_.knots(); }

    friend bool operator==(const BsplineCurve&, const BsplineCurve&) = default;

private:
    BsplineCurve(KnotVector knots, std::vector<Vec3> points, int dimension,
                 std::vector<double> weights);

    KnotVector knots_;
    std::vector<Vec3> points_;
    std::vector<double> weights_;
    int dimension_;
    bool rational_;
};

}  // namespace knotwork
