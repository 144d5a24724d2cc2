// Straight lines: C(t) = p + (t − t_0) v.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>

namespace knotwork {

class LineCurve {
public:
    /// From one point at the start of the domain to another at its end; they may be the same, and
    /// then the line rests there. Refuses coordinates as checkCoordinates() does at `from` and `to`
    /// and domains as checkDomain() does.
    [[nodiscard]] static Result<LineCurve> make(const Vec3& from, const Vec3& to,
                                                const Interval& domain);

    /// The line with this point and this derivative at t0, any t0.
    [[nodiscard]] static LineCurve tangent(double t0, const Vec3& point, const Vec3& derivative,
                                           const Interval& domain) noexcept;

    [[nodiscard]] Vec3 from() const noexcept { return at(domain_.start); }
    [[nodiscard]] Vec3 to() const noexcept { return to_; }
    /// C′, the same everywhere.
    [[nodiscard]] const Vec3& direction() const noexcept { return direction_; }

    // As every kind of curve; beyond its domain it goes on.
    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    [[nodiscard]] bool closed() const noexcept { return false; }
    [[nodiscard]] int dimension() const noexcept {
        return point_.z == 0 && direction_.z == 0 ? 2 : 3;
    }
    /// The point at t0 and at the end of the domain are exact.
    void evaluate(double t, Side, std::span<Vec3> rows) const noexcept;
    [[nodiscard]] std::span<const double> breaks() const noexcept { return {}; }

private:
    LineCurve(double t0, const Vec3& point, const Vec3& direction, const Vec3& to,
              const Interval& domain) noexcept
        : t0_(t0), point_(point), direction_(direction), to_(to), domain_(domain) {}

    [[nodiscard]] Vec3 at(double t) const noexcept {
        return t == domain_.end ? to_ : point_ + (t - t0_) * direction_;
    }

    double t0_;
    Vec3 point_;
    Vec3 direction_;
    Vec3 to_;
    Interval domain_;
};

}  // namespace knotwork
