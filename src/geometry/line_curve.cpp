#include "geometry/line_curve.hpp"

#include "geometry/checks.hpp"

#include <algorithm>

namespace knotwork {

Result<LineCurve> LineCurve::make(const Vec3& from, const Vec3& to, const Interval& domain) {
    if (auto error = checkCoordinates(from, "from")) return *std::move(error);
    if (auto error = checkCoordinates(to, "to")) return *std::move(error);
    if (auto error = checkDomain(domain)) return *std::move(error);
    return LineCurve(domain.start, from, (to - from) / domain.length(), to, domain);
}

LineCurve LineCurve::tangent(double t0, const Vec3& point, const Vec3& derivative,
                             const Interval& domain) noexcept {
    return {t0, point, derivative, point + (domain.end - t0) * derivative, domain};
}

void LineCurve::evaluate(double t, Side, std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    std::fill(rows.begin(), rows.end(), Vec3(0.0));
    rows[0] = at(t);
    if (rows.size() > 1) rows[1] = direction_;
}

}  // namespace knotwork
