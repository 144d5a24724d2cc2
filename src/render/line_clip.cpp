#include "render/line_clip.hpp"

#include <algorithm>

namespace knotwork::render {
namespace {

/// Narrows [from, to] to where start + s * step stays within half of 0.
bool narrow(double start, double step, double half, double& from, double& to) {
    if (step == 0) return start >= -half && start <= half;
    const double low = (-half - start) / step;
    const double high = (half - start) / step;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
    return from <= to;
}

}  // namespace

std::optional<std::pair<double, double>> clipSegment(const Vec3& a, const Vec3& b, double halfX,
                                                     double halfY) noexcept {
    double from = 0;
    double to = 1;
    const bool inside = narrow(a.x, b.x - a.x, halfX, from, to) &&
                        narrow(a.y, b.y - a.y, halfY, from, to);
    if (!inside) return std::nullopt;
    return std::pair(from, to);
}

}  // namespace knotwork::render
