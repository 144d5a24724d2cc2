#include "geometry/arc_curve.hpp"

#include "geometry/checks.hpp"

#include <cmath>

namespace knotwork {

namespace {

/// sin θ / θ, 1 at 0.
double sinc(double angle) noexcept { return angle == 0 ? 1 : std::sin(angle) / angle; }

}  // namespace

ArcCurve::ArcCurve(double at, const Vec3& point, const Vec3& first, const Vec3& second,
                   const Interval& domain) noexcept
    : at_(at), point_(point), first_(first), second_(second), domain_(domain),
      speed_(glm::length(first)), tangent_(first / speed_),
      curvature_((second - glm::dot(tangent_, second) * tangent_) / (speed_ * speed_)),
      bend_(glm::length(curvature_)) {}

Result<ArcCurve> ArcCurve::make(double at, const Vec3& point, const Vec3& first,
                                const Vec3& second, const Interval& domain) {
    if (!std::isfinite(at) || std::abs(at) > 1e9) {
        return refuse(std::isfinite(at) ? Code::outOfRange : Code::notFinite, "at",
                      "the parameter of the given point is " + formatNumber(at) +
                          "; it must lie within ±1e9");
    }
    if (auto error = checkCoordinates(point, "point")) return *std::move(error);
    if (auto error = checkCoordinates(first, "first")) return *std::move(error);
    if (auto error = checkCoordinates(second, "second")) return *std::move(error);
    if (auto error = checkDomain(domain)) return *std::move(error);
    ArcCurve arc(at, point, first, second, domain);
    // Below 1e-100 the square of the speed is lost, and with it the curvature.
    if (!(arc.speed_ >= 1e-100) || !isFinite(arc.curvature_)) {
        return refuse(Code::outOfRange, "first",
                      "the first derivative is 0 (or next to it) and has no direction; an arc needs "
                      "one");
    }
    return arc;
}

// The m-th derivatives of sin(ks)/k and (1 − cos ks)/k² are σ^m k^(m−1) sin(ks + mπ/2) and
// −σ^m k^(m−2) cos(ks + mπ/2).
void ArcCurve::evaluate(double t, Side, std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    const double along = speed_ * (t - at_);
    const double angle = bend_ * along;
    const double half = along * sinc(angle / 2);
    rows[0] = point_ + along * sinc(angle) * tangent_ + 0.5 * half * half * curvature_;
    if (rows.size() == 1) return;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    rows[1] = speed_ * (cosine * tangent_ + along * sinc(angle) * curvature_);
    Vec3 tangential = speed_ * speed_ * bend_ * tangent_;
    Vec3 radial = speed_ * speed_ * curvature_;
    for (std::size_t m = 2; m < rows.size(); ++m) {
        // The four quarter turns of ks + mπ/2.
        const double turnedSine = m % 2 == 0 ? (m % 4 == 0 ? sine : -sine)
                                             : (m % 4 == 1 ? cosine : -cosine);
        const double turnedCosine = m % 2 == 0 ? (m % 4 == 0 ? cosine : -cosine)
                                               : (m % 4 == 1 ? -sine : sine);
        rows[m] = turnedSine * tangential - turnedCosine * radial;
        tangential *= speed_ * bend_;
        radial *= speed_ * bend_;
    }
}

}  // namespace knotwork
