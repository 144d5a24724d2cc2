#include "scene/counted_line.hpp"

#include "scene/json_values.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace knotwork::scene {

namespace {

constexpr double share = 0.25;  // of the box, for the length of the direction

std::span<const Vec3> controlPoints(const Body& body) noexcept {
    if (const auto* spline = body.as<BsplineCurve>()) return spline->points();
    if (const auto* bezier = body.as<BezierCurve>()) return bezier->points();
    if (const auto* made = body.as<SubdivisionCurve>()) return made->subdivision().points;
    return {};
}

/// As a person would have typed it: about a thousandth of the size is left out.
double readable(double value, double size) noexcept {
    const double step = std::pow(10.0, std::floor(std::log10(size)) - 2);
    const double steps = std::round(1 / step);  // a power of ten: dividing by it rounds but once
    return step >= 1 ? std::round(value / step) * step : std::round(value * steps) / steps;
}

}  // namespace

void fillLine(Json& spec, const Body& body) {
    const Json* show = member(spec, "show");
    const bool wanted = show != nullptr && flagOr(*show, "crossings", false);
    const std::span<const Vec3> points = controlPoints(body);
    if (!wanted || member(spec, "line") != nullptr || points.empty()) return;
    Vec3 low = points.front();
    Vec3 high = low;
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
    }
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double size = extent > 0 ? extent : 1;
    const auto list = [&](double x, double y) {
        return Json::array({readable(x, size), readable(y, size)});
    };
    spec["line"] = Json::array({list((low.x + high.x) / 2, (low.y + high.y) / 2),
                                list(share * size, 0)});
}

Result<std::optional<PlaneLine>> lineOf(const Json& spec) {
    const Json* given = member(spec, "line");
    if (given == nullptr) return std::optional<PlaneLine>();
    PlaneLine line{vec3Of((*given)[0]), vec3Of((*given)[1])};
    const double length = std::hypot(line.direction.x, line.direction.y);
    if (length > 0) return std::optional(line);
    return refuse(Code::outOfRange, "line[1]",
                  "The direction of the line has no length in the plane; give it an x or a y.");
}

}  // namespace knotwork::scene
