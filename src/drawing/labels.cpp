#include "drawing/annotations.hpp"
#include "drawing/letters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double letterWidth = 7.2;   // CSS pixels of a letter at the size of labels, 13
constexpr double lineHeight = 16;
constexpr double gap = 7;             // between the place and its label
constexpr double pictureWidth = 640;  // of an object whose scale nobody says
constexpr std::size_t mostSegments = 512;

/// In the order of preference where nothing is in the way: right above first, as on maps (E. Imhof,
/// Positioning names on maps, 1975).
constexpr std::array<std::array<double, 2>, 8> directions{
    {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}}};

struct Spot {
    double x = 0;
    double y = 0;
};

struct Box {
    Spot low;
    Spot high;

    [[nodiscard]] bool holds(const Spot& p) const noexcept {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
    }
    [[nodiscard]] double overlap(const Box& o) const noexcept {
        const double w = std::min(high.x, o.high.x) - std::max(low.x, o.low.x);
        const double h = std::min(high.y, o.high.y) - std::max(low.y, o.low.y);
        return w > 0 && h > 0 ? w * h : 0;
    }
    /// Whether a segment meets it (A. Liang, B. Barsky, A new concept and method for line clipping,
    /// 1984).
    [[nodiscard]] bool meets(const Spot& a, const Spot& b) const noexcept {
        double first = 0;
        double last = 1;
        const auto clip = [&](double from, double along, double least, double most) {
            if (along == 0) return least <= from && from <= most;
            const double s = (least - from) / along;
            const double e = (most - from) / along;
            first = std::max(first, std::min(s, e));
            last = std::min(last, std::max(s, e));
            return first <= last;
        };
        return clip(a.x, b.x - a.x, low.x, high.x) && clip(a.y, b.y - a.y, low.y, high.y);
    }
};

/// What is in the picture already, in pixels.
class Scenery {
public:
    Scenery(const Sketch& sketch, double pixel) : pixel_(pixel) {
        for (const Shape& shape : sketch.shapes()) {
            if (shape.pane != Pane::curve) continue;
            if (shape.kind == Kind::points) addPoints(shape);
            if (shape.kind == Kind::polyline) addLine(shape);
        }
    }

    [[nodiscard]] Spot at(const Vec3& p) const noexcept { return {p.x / pixel_, p.y / pixel_}; }

    /// How much a label there would cover.
    [[nodiscard]] double cost(const Box& box) const noexcept {
        double sum = 0;
        for (const Box& label : labels_) sum += 4 * box.overlap(label);
        for (const Spot& p : points_) sum += box.holds(p) ? 60 : 0;
        for (const auto& [a, b] : segments_) sum += box.meets(a, b) ? 12 : 0;
        return sum;
    }
    void add(const Box& label) { labels_.push_back(label); }

private:
    void addPoints(const Shape& shape) {
        for (std::size_t i = 0; i < shape.positions.size() / 3; ++i) {
            points_.push_back(at(positionAt(shape, i)));
        }
    }
    void addLine(const Shape& shape) {
        const std::size_t count = shape.positions.size() / 3;
        if (!shape.indices.empty()) {
            for (std::size_t i = 0; i + 1 < std::min(shape.indices.size(), 2 * mostSegments); i += 2) {
                segments_.push_back({at(positionAt(shape, shape.indices[i])),
                                     at(positionAt(shape, shape.indices[i + 1]))});
            }
            return;
        }
        const std::size_t step = count / mostSegments + 1;
        for (std::size_t i = 0; i + step < count; i += step) {
            segments_.push_back({at(positionAt(shape, i)), at(positionAt(shape, i + step))});
        }
    }

    double pixel_;
    std::vector<Spot> points_;
    std::vector<std::array<Spot, 2>> segments_;
    std::vector<Box> labels_;
};

double pixelOf(const Sketch& sketch) noexcept {
    if (sketch.options().pixel > 0) return sketch.options().pixel;
    Bounds bounds;
    for (const Shape& shape : sketch.shapes()) bounds.add(shape);
    const Vec3 size = bounds.max - bounds.min;
    const double across = std::max(size.x, size.y);
    return across > 0 ? across / pictureWidth : 1;
}

void addNumbered(std::vector<Wanted>& wanted, std::string_view letter,
                 std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        wanted.push_back({std::string(letter) + std::to_string(i), points[i]});
    }
}

/// `P2,3` at the points of a net, row by row.
void addNet(std::vector<Wanted>& wanted, std::string_view letter, std::span<const Vec3> points,
            std::size_t columns) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        wanted.push_back({std::string(letter) + std::to_string(k / columns) + "," +
                              std::to_string(k % columns),
                          points[k]});
    }
}

/// `t3` at every knot of the domain, `t0–3` where several are equal.
void addKnots(std::vector<Wanted>& wanted, const Curve& curve, std::span<const double> knots) {
    const Interval whole = domain(curve);
    for (std::size_t i = 0; i < knots.size();) {
        std::size_t last = i;
        while (last + 1 < knots.size() && knots[last + 1] == knots[i]) ++last;
        if (whole.contains(knots[i])) {
            const std::string range = last > i ? "–" + std::to_string(last) : "";
            wanted.push_back({"t" + std::to_string(i) + range, pointAt(curve, knots[i])});
        }
        i = last + 1;
    }
}

void addCurve(std::vector<Wanted>& wanted, const Sketch& sketch, const Curve& curve) {
    const scene::Show& show = sketch.show();
    if (show.points || show.polygon) addNumbered(wanted, "P", controlPolygon(curve).points);
    const auto* blend = curve.as<BlendingCurve>();
    const auto* spline = curve.as<BsplineCurve>();
    if (blend != nullptr && show.handles) addNumbered(wanted, "c", handlePoints(*blend));
    if (spline != nullptr && show.knots) addKnots(wanted, curve, spline->knotVector().knots());
    if (blend != nullptr && show.knots && !show.handles) addKnots(wanted, curve, blend->knots());
    const bool measured = show.osculating || show.hodograph ||
                          scene::member(sketch.object().spec, "t") != nullptr;
    if (!measured) return;
    const double t = sketch.parameterOn(curve);
    wanted.push_back({"t = " + formatNumber(std::round(t * 1e4) / 1e4), pointAt(curve, t)});
}

std::vector<Wanted> namesOf(const Sketch& sketch) {
    std::vector<Wanted> wanted;
    const scene::Body& body = sketch.body();
    const scene::Show& show = sketch.show();
    if (const Curve* curve = body.curve()) addCurve(wanted, sketch, *curve);
    const auto* spline = body.as<BsplineSurface>();
    const auto* blend = body.as<BlendingSurface>();
    if (spline != nullptr && show.points) {
        addNet(wanted, "P", spline->points(), spline->columnCount());
    }
    if (blend != nullptr && show.handles) {
        addNet(wanted, "c", handlePoints(*blend), blend->alongV().count);
    }
    if (const auto* mesh = body.subdivision(); mesh != nullptr && show.points) {
        addNumbered(wanted, "P", mesh->control.points());
    }
    if (const auto* cloud = body.cloud()) {
        if (show.points) addNumbered(wanted, "Q", cloud->points);
        if (cloud->fit && show.polygon) addNumbered(wanted, "P", cloud->fit->curve.points());
    }
    return wanted;
}

}  // namespace

void placeLabels(Sketch& sketch, const std::vector<Wanted>& wanted) {
    const double pixel = pixelOf(sketch);
    Scenery scenery(sketch, pixel);
    for (const Wanted& one : wanted) {
        const double width = letterWidth * static_cast<double>(lettersIn(one.text));
        const Spot anchor = scenery.at(one.anchor);
        const auto boxAt = [&](const std::array<double, 2>& to) {
            const Spot middle{anchor.x + to[0] * (gap + width / 2),
                              anchor.y + to[1] * (gap + lineHeight / 2)};
            return Box{{middle.x - width / 2, middle.y - lineHeight / 2},
                       {middle.x + width / 2, middle.y + lineHeight / 2}};
        };
        std::size_t best = 0;
        double least = scenery.cost(boxAt(directions[0]));
        for (std::size_t k = 1; k < directions.size() && least > 0; ++k) {
            const double cost = scenery.cost(boxAt(directions[k]));
            if (cost < least) {
                least = cost;
                best = k;
            }
        }
        scenery.add(boxAt(directions[best]));
        Shape& shape = sketch.add(one.role, Kind::label, 13);
        shape.text = one.text;
        append(shape, one.anchor);
        shape.offset = {static_cast<float>(directions[best][0] * (gap + width / 2)),
                        static_cast<float>(-directions[best][1] * (gap + lineHeight / 2))};
    }
}

void drawLabels(Sketch& sketch) {
    std::vector<Wanted> wanted;
    if (sketch.show().labels) wanted = namesOf(sketch);
    if (wanted.size() > mostLabels) wanted.clear();
    for (Wanted& one : traceLabels(sketch.object())) wanted.push_back(std::move(one));
    for (Wanted& one : crossingLabels(sketch)) wanted.push_back(std::move(one));
    for (Wanted& one : stencilLabels(sketch)) wanted.push_back(std::move(one));
    if (!wanted.empty()) placeLabels(sketch, wanted);
}

}  // namespace knotwork::drawing
