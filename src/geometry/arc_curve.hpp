// Circular arcs with a given point and first two derivatives at one parameter.
//
// With σ = |p′|, x = p′/σ and κ = (p″ − (x·p″)x)/σ², the vector towards the centre whose length is
// the curvature k, the arc runs with constant speed, s = σ(t − t_0):
//     C(t) = p + x sin(ks)/k + κ (1 − cos ks)/k²,
// written as p + x s S(ks) + κ s²/2 S(ks/2)² with S(θ) = sin θ/θ, so that k → 0 is the line and
// nothing cancels. It keeps p, p′ and the curvature; of p″ it loses what lies along the tangent.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>

namespace knotwork {

class ArcCurve {
public:
    /// Refuses coordinates as checkCoordinates() does at `point`, `first` and `second`; a first
    /// derivative of 0, which has no direction (OUT_OF_RANGE `first`); `at` that is not finite or
    /// beyond ±1e9 (OUT_OF_RANGE `at`); and domains as checkDomain() does.
    [[nodiscard]] static Result<ArcCurve> make(double at, const Vec3& point, const Vec3& first,
                                               const Vec3& second, const Interval& domain);

    // What it was made from.
    [[nodiscard]] double at() const noexcept { return at_; }
    [[nodiscard]] const Vec3& point() const noexcept { return point_; }
    [[nodiscard]] const Vec3& first() const noexcept { return first_; }
    [[nodiscard]] const Vec3& second() const noexcept { return second_; }

    // As every kind of curve; beyond its domain it goes on round its circle.
    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    [[nodiscard]] bool closed() const noexcept { return false; }
    [[nodiscard]] int dimension() const noexcept {
        return point_.z == 0 && first_.z == 0 && second_.z == 0 ? 2 : 3;
    }
    /// Derivatives of every order, in closed form.
    void evaluate(double t, Side, std::span<Vec3> rows) const noexcept;
    [[nodiscard]] std::span<const double> breaks() const noexcept { return {}; }

private:
    ArcCurve(double at, const Vec3& point, const Vec3& first, const Vec3& second,
             const Interval& domain) noexcept;

    double at_;
    Vec3 point_;
    Vec3 first_;
    Vec3 second_;
    Interval domain_;
    double speed_;     // σ
    Vec3 tangent_;     // x
    Vec3 curvature_;   // κ
    double bend_;      // k
};

}  // namespace knotwork
