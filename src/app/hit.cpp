#include "app/hit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knotwork::app {

namespace {

double distance(const Pixel& a, const Pixel& b) noexcept { return std::hypot(a.x - b.x, a.y - b.y); }

double distanceToGraph(const Shape& shape, const PlaneMap& map, const Pixel& p) noexcept {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t count = shape.positions.size() / 3;
    for (std::size_t k = 1; k < count; ++k) {
        least = std::min(least, distanceToSegment(p, map.toPixels(positionOf(shape, k - 1)),
                                                  map.toPixels(positionOf(shape, k))));
    }
    return least;
}

}  // namespace

double hitRadius(std::string_view pointerType) noexcept { return pointerType == "touch" ? 22 : 12; }

double distanceToSegment(const Pixel& p, const Pixel& a, const Pixel& b) noexcept {
    const Pixel along{b.x - a.x, b.y - a.y};
    const double square = along.x * along.x + along.y * along.y;
    if (!(square > 0)) return distance(p, a);
    const double s =
        std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square, 0.0, 1.0);
    return distance(p, {a.x + s * along.x, a.y + s * along.y});
}

std::optional<Target> targetAt(const Figure& figure, const Pixel& p, double radius) {
    const PaneFigure* pane = figure.paneAt(p);
    if (pane == nullptr) return std::nullopt;
    const Shape* best = nullptr;
    std::size_t bestIndex = 0;
    double least = radius;
    for (const Painted& painted : pane->shapes) {
        if (!offers(*painted.shape)) continue;
        const std::size_t count = painted.shape->positions.size() / 3;
        for (std::size_t k = 0; k < count; ++k) {
            const double away = distance(p, pane->plot.map.toPixels(positionOf(*painted.shape, k)));
            if (away > least) continue;
            least = away;
            best = painted.shape;
            bestIndex = k;
        }
    }
    if (best == nullptr) return std::nullopt;
    return Target{best->object, best->pane, *kindOfList(best->path), best->path, bestIndex,
                  positionOf(*best, bestIndex)};
}

std::optional<BasisHit> basisAt(const Figure& figure, const Pixel& p, double radius) {
    const PaneFigure* pane = figure.paneAt(p);
    if (pane == nullptr || pane->plot.pane != Pane::basis) return std::nullopt;
    std::optional<BasisHit> best;
    double least = radius;
    for (const Painted& painted : pane->shapes) {
        if (painted.shape->kind != drawing::Kind::polyline) continue;
        const double away = distanceToGraph(*painted.shape, pane->plot.map, p);
        if (away > least) continue;
        least = away;
        best = BasisHit{painted.shape->object, painted.shape->index};
    }
    return best;
}

std::optional<double> parameterAt(const PaneFigure& pane, const Pixel& p) noexcept {
    const ui::Plot& plot = pane.plot;
    constexpr double slack = 6;  // the ends of an axis can be reached without aiming
    if (plot.pane == Pane::curve || p.x < plot.area.x - slack || p.x > plot.area.right() + slack) {
        return std::nullopt;
    }
    return plot.map.unitX(std::clamp(p.x, plot.area.x, plot.area.right()));
}

}  // namespace knotwork::app
