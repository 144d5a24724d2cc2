#include "render/line_vertices.hpp"

#include "render/line_clip.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::render {
namespace {

/// Points nearer to their predecessor than this do not change the picture, but cost a capsule each
/// and make segments too short to have a direction in float. Device pixels.
constexpr double thinning = 1.0 / 4;
/// Lines that deviate less than this from upright or level are moved to whole pixels.
constexpr double straightness = 1.0 / 16;

Vec3 tripleAt(std::span<const double> positions, std::size_t i) {
    return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
}

double planarDistance(const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// How far beyond the pane's edge a segment can still colour a pixel inside.
double reach(const LineStyle& style) { return 0.5 * style.width + 2; }

/// Moves a centre line so that both edges of a line of whole width lie between pixels. `half` is
/// half the pane's size: whole device pixels lie at half integers when that is not whole.
double snapped(double centre, double half, double width) {
    const double offset = std::fmod(width, 2) == 1 ? 0.5 : 0.0;
    return std::floor(centre + half - offset + 0.5) + offset - half;
}

}  // namespace

double dashPeriod(double width, double pixelRatio) noexcept {
    return std::max(4 * width, 9.0) * pixelRatio;
}

void LineVertices::emit(const Vec3& at, double arc, const LineStyle& style) {
    records_.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                        static_cast<float>(at.z), static_cast<float>(arc),
                        static_cast<float>(style.width), static_cast<float>(style.period),
                        style.colour, 0});
}

void LineVertices::begin(const Point& start, const Point* before, const LineStyle& style) {
    turnOver_ = style.period > 0 ? std::floor(start.arc / style.period) * style.period : 0;
    if (before) emit(before->at, neighbourOnly, style);
    else emit(start.at, noNeighbour, style);
    emit(start.at, std::max(start.arc - turnOver_, 0.0), style);
}

void LineVertices::end(const Point& last, const Point* after, const LineStyle& style) {
    if (after) emit(after->at, neighbourOnly, style);
    else emit(last.at, noNeighbour, style);
}

void LineVertices::collect(const Vec3& at) {
    if (points_.empty()) {
        points_.push_back({at, 0});
        return;
    }
    const double step = planarDistance(points_.back().at, at);
    if (step >= thinning) points_.push_back({at, points_.back().arc + step});
}

/// Emits the parts of points_ that can be seen in the pane.
void LineVertices::run(const Rect& pane, const LineStyle& style, bool closed) {
    const double halfX = 0.5 * pane.width + reach(style);
    const double halfY = 0.5 * pane.height + reach(style);
    const std::size_t last = points_.size() - 1;
    const Point* before = closed ? &points_[last - 1] : nullptr;
    bool open = false;
    for (std::size_t i = 0; i < std::max<std::size_t>(last, 1); ++i) {
        const Point& a = points_[i];
        const Point& b = points_[std::min(i + 1, last)];
        const auto part = clipSegment(a.at, b.at, halfX, halfY);
        if (!part) {
            if (open) end(a, &b, style);
            open = false;
            continue;
        }
        const auto [from, to] = *part;
        const auto pointAt = [&](double s) {
            return s == 1 ? b : Point{a.at + s * (b.at - a.at), a.arc + s * (b.arc - a.arc)};
        };
        if (!open) begin(pointAt(from), i == 0 && from == 0 ? before : nullptr, style);
        const Point reached = pointAt(to);
        emit(reached.at, std::max(reached.arc - turnOver_, 0.0), style);
        open = to == 1;
        if (!open) end(reached, nullptr, style);
    }
    if (open) end(points_[last], closed ? &points_[1] : nullptr, style);
}

void LineVertices::stroke(const Rect& pane, const LineStyle& style) {
    if (points_.empty()) return;
    const bool closed = points_.size() > 3 && planarDistance(points_.front().at,
                                                             points_.back().at) < thinning;
    LineStyle fitted = style;
    const double length = points_.back().arc;
    if (closed && style.period > 0 && length > style.period) {
        fitted.period = length / std::round(length / style.period);
    }
    run(pane, fitted, closed);
    points_.clear();
}

void LineVertices::polyline(const Projection& projection, std::span<const double> positions,
                            const LineStyle& style) {
    points_.clear();
    for (std::size_t i = 0; i < positions.size() / 3; ++i) {
        const Vec3 at = projection.toPane(tripleAt(positions, i)) - Vec3(0, 0, style.nearer);
        if (isFinite(at)) collect(at);
        else stroke(projection.pane(), style);
    }
    stroke(projection.pane(), style);
}

void LineVertices::segments(const Projection& projection, std::span<const double> positions,
                            const LineStyle& style) {
    LineStyle whole = style;
    if (style.crisp) whole.width = std::max(1.0, std::round(style.width));
    const Rect& pane = projection.pane();
    for (std::size_t i = 0; i + 1 < positions.size() / 3; i += 2) {
        Vec3 a = projection.toPane(tripleAt(positions, i));
        Vec3 b = projection.toPane(tripleAt(positions, i + 1));
        if (!isFinite(a) || !isFinite(b)) continue;
        a.z -= style.nearer;
        b.z -= style.nearer;
        if (style.crisp && std::abs(a.x - b.x) < straightness) {
            a.x = b.x = snapped(a.x, 0.5 * pane.width, whole.width);
        }
        if (style.crisp && std::abs(a.y - b.y) < straightness) {
            a.y = b.y = snapped(a.y, 0.5 * pane.height, whole.width);
        }
        points_.clear();
        collect(a);
        collect(b);
        stroke(pane, whole);
    }
}

}  // namespace knotwork::render
