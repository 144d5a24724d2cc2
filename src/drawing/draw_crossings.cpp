// A line and how often it crosses a curve and its control polygon.
#include "drawing/annotations.hpp"
#include "drawing/measures.hpp"
#include "drawing/palette.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double air = 0.12;         // of the polygon's size, that the line goes on beyond it
constexpr double leastReach = 1.35;  // of the direction, beyond the place where it is held

/// How far the line goes to both sides of its point, in lengths of its direction, to pass through
/// the box of the points.
Interval reachOf(const PlaneLine& line, std::span<const Vec3> points) {
    Bounds box;
    for (const Vec3& p : points) box.add(p);
    const double more = air * glm::length(box.max - box.min);
    Interval reach{-leastReach, leastReach};
    Interval inside{-1e300, 1e300};
    for (glm::length_t k = 0; k < 2; ++k) {
        const double low = box.min[k] - more - line.point[k];
        const double high = box.max[k] + more - line.point[k];
        const double along = line.direction[k];
        if (along == 0 && (low > 0 || high < 0)) return reach;
        if (along == 0) continue;
        inside.start = std::max(inside.start, std::min(low / along, high / along));
        inside.end = std::min(inside.end, std::max(low / along, high / along));
    }
    if (!(inside.start < inside.end)) return reach;
    return {std::min(reach.start, inside.start), std::max(reach.end, inside.end)};
}

Vec3 inPlane(const Vec3& v) noexcept { return {v.x, v.y, 0}; }

}  // namespace

void drawCrossings(Sketch& sketch, const Curve& curve) {
    const auto& given = sketch.object().line;
    const std::span<const Vec3> points = controlPolygon(curve).points;
    if (!given || points.empty()) return;
    const PlaneLine line{inPlane(given->point), inPlane(given->direction)};
    const auto crossings = lineCrossings(curve, line);
    const Interval reach = reachOf(line, points);
    const Vec3 from = line.point + reach.start * line.direction;
    const Vec3 to = line.point + reach.end * line.direction;
    Shape& whole = sketch.add(Role::frame, Kind::polyline, 1.5F);
    whole.index = 4;
    whole.dashed = true;
    append(whole, from);
    append(whole, to);
    Shape& direction = sketch.add(Role::frame, Kind::polyline, 2);
    direction.index = 4;
    append(direction, line.point);
    append(direction, line.point + line.direction);
    Shape& ofPolygon = sketch.add(Role::frame, Kind::points, 8);
    ofPolygon.index = 6;
    ofPolygon.square = true;
    ofPolygon.colour = roleColour(Role::polygon, sketch.options().dark);
    append(ofPolygon, crossings->polygon);
    Shape& ofCurve = sketch.add(Role::frame, Kind::points, 8);
    ofCurve.index = 5;
    ofCurve.colour = onBackground(sketch.object().style.colour, sketch.options().dark);
    for (const Crossing& crossing : crossings->curve) append(ofCurve, crossing.point);
    Shape& held = sketch.add(Role::handle, Kind::points, 10);
    held.path = sketch.path("line");
    append(held, line.point);
    append(held, line.point + line.direction);
}

std::vector<Wanted> crossingLabels(const Sketch& sketch) {
    const Curve* curve = sketch.body().curve();
    const auto& line = sketch.object().line;
    if (!sketch.show().crossings || curve == nullptr || !line) return {};
    const auto crossings = lineCrossings(*curve, *line);
    if (!crossings) return {};
    const std::size_t ofCurve = crossings->curve.size();
    const std::size_t ofPolygon = crossings->polygon.size();
    const std::string relation = ofCurve <= ofPolygon ? " \u2264 " : " > ";
    return {{std::to_string(ofCurve) + relation + std::to_string(ofPolygon),
             inPlane(line->point + line->direction), Role::frame}};
}

}  // namespace knotwork::drawing
