#include "app/support.hpp"

#include "scene/effects.hpp"
#include "scene/path.hpp"

#include <algorithm>

namespace knotwork::app {

namespace {

constexpr std::size_t gridLines = 5;    // each way, both ends included
constexpr std::size_t linePoints = 25;

/// Of the basis function that begins at this knot of the extended vector, within the domain unless
/// that is closed.
std::optional<Interval> ruledByPoint(const KnotVector& knots, std::size_t index) noexcept {
    const auto all = knots.extended();
    const std::size_t end = index + static_cast<std::size_t>(knots.degree()) + 1;
    if (end >= all.size()) return std::nullopt;
    if (knots.closed()) return Interval{all[index], all[end]};
    const Interval whole = knots.domain();
    const Interval ruled{std::max(all[index], whole.start), std::min(all[end], whole.end)};
    return ruled.length() > 0 ? std::optional(ruled) : std::nullopt;
}

void append(Shape& shape, const Vec3& p) {
    shape.positions.insert(shape.positions.end(), {p.x, p.y, p.z});
}

/// One line more: the points that have been appended since `first`.
void joinFrom(Shape& shape, std::size_t first) {
    const std::size_t count = shape.positions.size() / 3;
    for (std::size_t i = first + 1; i < count; ++i) {
        shape.indices.push_back(static_cast<std::uint32_t>(i - 1));
        shape.indices.push_back(static_cast<std::uint32_t>(i));
    }
}

}  // namespace

std::optional<Interval> ruledInterval(const Curve& curve, std::size_t index) noexcept {
    if (const auto* spline = curve.as<BsplineCurve>()) {
        return ruledByPoint(spline->knotVector(), index);
    }
    if (const auto* blend = curve.as<BlendingCurve>()) {
        if (index < blend->locals().size()) return blend->support(index);
    }
    return std::nullopt;
}

std::optional<Interval> ruledByKnot(const Curve& curve, std::size_t index) noexcept {
    if (const auto* blend = curve.as<BlendingCurve>()) {
        return ruledInterval(curve, index % std::max<std::size_t>(blend->locals().size(), 1));
    }
    const auto* spline = curve.as<BsplineCurve>();
    if (spline == nullptr) return std::nullopt;
    const auto all = spline->knotVector().extended();
    const auto degree = static_cast<std::size_t>(spline->degree());
    const std::size_t at = index + (spline->closed() ? degree : 0);
    if (at >= all.size()) return std::nullopt;
    const std::size_t first = at - std::min(at, degree + 1);
    const Interval reach{all[first], all[std::min(at + degree + 1, all.size() - 1)]};
    const Interval whole = spline->domain();
    if (spline->closed()) return reach.length() < whole.length() ? reach : whole;
    const Interval ruled{std::max(reach.start, whole.start), std::min(reach.end, whole.end)};
    return ruled.length() > 0 ? std::optional(ruled) : std::nullopt;
}

std::vector<Interval> joined(std::vector<Interval> parts, double whole) {
    std::sort(parts.begin(), parts.end(),
              [](const Interval& a, const Interval& b) { return a.start < b.start; });
    std::vector<Interval> apart;
    for (const Interval& part : parts) {
        if (apart.empty() || part.start > apart.back().end) {
            apart.push_back(part);
        } else {
            apart.back().end = std::max(apart.back().end, part.end);
        }
    }
    for (Interval& part : apart) part.end = std::min(part.end, part.start + whole);
    return apart;
}

std::optional<Rectangle> ruledRectangle(const Surface& surface, std::size_t row,
                                        std::size_t index) noexcept {
    if (const auto* spline = surface.as<BsplineSurface>()) {
        const auto u = ruledByPoint(spline->knotsU(), row);
        const auto v = ruledByPoint(spline->knotsV(), index);
        return u && v ? std::optional(Rectangle{*u, *v}) : std::nullopt;
    }
    const auto* blend = surface.as<BlendingSurface>();
    if (blend == nullptr) return std::nullopt;
    const std::size_t i = index / blend->alongV().count;
    if (i >= blend->alongU().count) return std::nullopt;
    return Rectangle{blend->alongU().support(i),
                     blend->alongV().support(index % blend->alongV().count)};
}

std::size_t rowOf(std::string_view list) noexcept {
    const auto steps = scene::parsePath(list);
    return steps && steps->back().isIndex() ? steps->back().index : 0;
}

Shape stretchOf(const scene::Placed& placed, const Interval& interval, std::size_t count) {
    Shape stretch;
    stretch.object = -1;
    stretch.positions.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        append(stretch, placed.placement.point(pointAt(
                            *placed.body.curve(), uniformParameter(interval, i, count))));
    }
    stretch.colour = placed.colour;
    return stretch;
}

Shape gridOf(const scene::Placed& placed, const Rectangle& part) {
    Shape grid;
    grid.object = -1;
    grid.role = drawing::Role::isoline;
    const auto point = [&](double u, double v) {
        append(grid, placed.placement.point(
                         pointAt(*placed.body.surface(), {u, v, Side::right, Side::right})));
    };
    for (std::size_t i = 0; i < gridLines; ++i) {
        const std::size_t alongV = grid.positions.size() / 3;
        for (std::size_t k = 0; k < linePoints; ++k) {
            point(uniformParameter(part.u, i, gridLines), uniformParameter(part.v, k, linePoints));
        }
        joinFrom(grid, alongV);
        const std::size_t alongU = grid.positions.size() / 3;
        for (std::size_t k = 0; k < linePoints; ++k) {
            point(uniformParameter(part.u, k, linePoints), uniformParameter(part.v, i, gridLines));
        }
        joinFrom(grid, alongU);
    }
    return grid;
}

Shape starOf(const scene::Placed& placed, std::size_t vertex) {
    Shape star;
    star.object = -1;
    star.role = drawing::Role::polygon;
    const Mesh& control = placed.body.subdivision()->control;
    for (const MeshEdge& edge : control.edges()) {
        if (edge.v0 != vertex && edge.v1 != vertex) continue;
        const std::size_t first = star.positions.size() / 3;
        append(star, placed.placement.point(control.points()[edge.v0]));
        append(star, placed.placement.point(control.points()[edge.v1]));
        joinFrom(star, first);
    }
    return star;
}

}  // namespace knotwork::app
