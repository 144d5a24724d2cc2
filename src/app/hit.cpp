#include "app/hit.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace knotwork::app {

namespace {

constexpr double asNear = 4;         // pixels that a hand does not tell apart
constexpr double asDeep = 2;         // pixels of depth that make no difference
constexpr double slackInDepth = 4;   // what lies on a surface is not behind it

double distance(const Pixel& a, const Pixel& b) noexcept { return std::hypot(a.x - b.x, a.y - b.y); }

/// An element of a list of points near the pointer.
struct Candidate {
    const Shape* shape = nullptr;
    std::size_t index = 0;
    double away = 0;      ///< pixels from the pointer
    double nearness = 0;  ///< pixels towards the eye
    bool hidden = false;  ///< behind a surface
};

bool covers(const std::array<Pixel, 3>& t, const Pixel& p, std::array<double, 3>& weights) noexcept {
    const auto cross = [](const Pixel& o, const Pixel& a, const Pixel& b) {
        return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    };
    const double whole = cross(t[0], t[1], t[2]);
    if (whole == 0) return false;
    weights = {cross(p, t[1], t[2]) / whole, cross(p, t[2], t[0]) / whole,
               cross(p, t[0], t[1]) / whole};
    return weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0;
}

/// Whether a triangle lies between the eye and the point, and not only under it.
bool isHidden(const PaneFigure& pane, const Vec3& world) noexcept {
    const Pixel at = pane.sight.toPixels(world);
    const double behind = pane.sight.nearness(world) + slackInDepth;
    std::array<double, 3> weights{};
    const Orientation& turned = pane.sight.orientation();
    const Vec3 right{turned[0][0], turned[1][0], turned[2][0]};
    for (const Painted& painted : pane.shapes) {
        const Shape& shape = *painted.shape;
        if (shape.kind != drawing::Kind::triangles) continue;
        for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
            const std::array corners{positionOf(shape, shape.indices[i]),
                                     positionOf(shape, shape.indices[i + 1]),
                                     positionOf(shape, shape.indices[i + 2])};
            // Nearly all triangles lie wholly to one side.
            const auto aside = [&](std::size_t k) { return glm::dot(right, corners[k] - world); };
            const double first = aside(0);
            if (first * aside(1) > 0 && first * aside(2) > 0) continue;
            const std::array seen{pane.sight.toPixels(corners[0]), pane.sight.toPixels(corners[1]),
                                  pane.sight.toPixels(corners[2])};
            if (!covers(seen, at, weights)) continue;
            const Vec3 there =
                weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
            if (pane.sight.nearness(there) > behind) return true;
        }
    }
    return false;
}

std::vector<Candidate> candidates(const PaneFigure& pane, const Pixel& p, double radius) {
    std::vector<Candidate> found;
    for (const Painted& painted : pane.shapes) {
        if (!offers(*painted.shape)) continue;
        const std::size_t count = painted.shape->positions.size() / 3;
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 world = positionOf(*painted.shape, k);
            const double away = distance(p, pane.sight.toPixels(world));
            if (away > radius) continue;
            const bool hidden = pane.reach > 0 && isHidden(pane, world);
            found.push_back({painted.shape, k, away, pane.sight.nearness(world), hidden});
        }
    }
    return found;
}

/// Of those about as near to the pointer as the nearest the one in front; of equally deep ones the
/// nearest, of equally near ones that painted last.
const Candidate* foremost(const std::vector<Candidate>& near, bool hidden) noexcept {
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& one : near) {
        if (one.hidden == hidden) least = std::min(least, one.away);
    }
    const auto close = [&](const Candidate& one) {
        return one.hidden == hidden && one.away <= least + asNear;
    };
    double front = -std::numeric_limits<double>::infinity();
    for (const Candidate& one : near) {
        if (close(one)) front = std::max(front, one.nearness);
    }
    const Candidate* best = nullptr;
    for (const Candidate& one : near) {
        if (!close(one) || one.nearness < front - asDeep) continue;
        if (best == nullptr || one.away <= best->away) best = &one;
    }
    return best;
}

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
    const std::vector<Candidate> near = candidates(*pane, p, radius);
    const Candidate* best = foremost(near, false);
    if (best == nullptr) best = foremost(near, true);
    if (best == nullptr) return std::nullopt;
    const Shape& shape = *best->shape;
    return Target{shape.object, shape.pane, *kindOfList(shape.path), shape.path, best->index,
                  positionOf(shape, best->index)};
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
    const bool ofPlace = plot.pane == Pane::curve || plot.pane == Pane::hodograph;
    if (ofPlace || p.x < plot.area.x - slack || p.x > plot.area.right() + slack) {
        return std::nullopt;
    }
    return plot.map.unitX(std::clamp(p.x, plot.area.x, plot.area.right()));
}

}  // namespace knotwork::app
