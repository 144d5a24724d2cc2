#include "drawing/svg_plots.hpp"

#include "drawing/plots.hpp"
#include "drawing/sketch.hpp"
#include "drawing/svg_theme.hpp"
#include "drawing/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double plotShare = 0.42;      // of the height, for basis functions or a B-function
constexpr double basisShare = 0.6;      // of the width, beside a B-function
constexpr double hodographWidth = 0.42; // of the width, beside the curve
constexpr double knotRow = 12;          // pixels of an equal knot more
constexpr double knotHeight = 50;       // of the knot line with one row and the names below it
constexpr double left = 44, right = 16, top = 12, bottom = 24;  // round the area of a plot
constexpr double fontSize = 11;
constexpr double legendLine = 17;       // of a legend
constexpr double sample = 30;           // of a line in it
constexpr double curvatureShare = 0.5;  // of the height beside basis functions
constexpr double cell = 56;             // of the grid, at least

bool has(const Drawing& drawing, Pane pane) {
    return std::any_of(drawing.shapes.begin(), drawing.shapes.end(),
                       [&](const Shape& shape) { return shape.pane == pane; });
}

/// The first object that has a shape in the pane.
int objectIn(const Drawing& drawing, Pane pane) {
    const auto found = std::find_if(drawing.shapes.begin(), drawing.shapes.end(),
                                    [&](const Shape& shape) { return shape.pane == pane; });
    return found != drawing.shapes.end() ? found->object : -1;
}

/// The box of what the pane shows of its object.
Bounds boundsOf(const Drawing& drawing, const PanePicture& picture) {
    Bounds bounds;
    for (const Shape& shape : drawing.shapes) {
        if (!picture.shows(shape)) continue;
        for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
            const Vec3 p(shape.positions[i], shape.positions[i + 1], 0);
            if (isFinite(p)) bounds.add(p);
        }
    }
    return bounds;
}

/// The interval, or one about its only value.
Interval ranged(double low, double high) noexcept {
    return low < high ? Interval{low, high} : Interval{low - 1, high + 1};
}

Affine mapOnto(const Frame& area, const Interval& x, const Interval& y) noexcept {
    Mat3 scale{1.0};
    scale[0][0] = area.width / x.length();
    scale[1][1] = -area.height / y.length();
    return {scale, Vec3(area.x - scale[0][0] * x.start,
                        area.y + area.height - scale[1][1] * y.start, 0)};
}

class PlotWriter {
public:
    PlotWriter(XmlWriter& xml, const Drawing& drawing, const scene::State& state, SvgTheme theme)
        : xml_(xml), drawing_(drawing), state_(state), theme_(theme), colours_(svgColours(theme)) {}

    /// Curvature, basis functions and the knot line have one axis, where they are of one object.
    void parameterPlots(const SvgLayout& layout) {
        PanePicture functions = pictureOf(Pane::basis);
        PanePicture line = pictureOf(Pane::knots);
        PanePicture graph = pictureOf(Pane::curvature);
        const bool basis = layout.basis.height > 0;
        const bool knots = layout.knots.height > 0;
        const Bounds all = boundsOf(drawing_, knots ? line : basis ? functions : graph);
        const Interval x = ranged(all.min.x, all.max.x);
        if (layout.curvature.height > 0) {
            const bool shared = graph.object == (knots ? line.object : functions.object);
            curvaturePlot(layout.curvature, graph, shared && (basis || knots), x);
        }
        if (basis) {
            const Bounds values = boundsOf(drawing_, functions);
            begin(functions, layout.basis, x,
                  {std::min(0.0, values.min.y), std::max(1.0, values.max.y)},
                  knots ? top / 2 : bottom);
            if (!knots) ticksBelow(x);
            ticksBeside();
            end(functions);
        }
        if (knots) {
            const Bounds piles = boundsOf(drawing_, line);
            begin(line, layout.knots, x, {0, std::max(1.0, piles.max.y)}, bottom);
            ticksBelow(x);
            end(line);
        }
    }

    /// B and its derivatives in rows, each with values of its own; of several objects where these
    /// are compared, with a legend.
    void bFunctionPlot(const Frame& whole) {
        constexpr int rows = 3;
        constexpr std::array names{"B", "B\u2032", "B\u2033"};
        const int object = objectIn(drawing_, Pane::bFunction);
        const std::vector<int> compared = comparedObjects(drawing_, object);
        const auto lines = static_cast<double>(compared.size());
        const double legend = compared.size() > 1 ? legendLine * lines : 0;
        const Frame frame{whole.x, whole.y + legend, whole.width, whole.height - legend};
        for (int order = 0; order < rows; ++order) {
            PanePicture picture{Pane::bFunction, {}, theme_, object, order};
            picture.besides = compared;
            const Bounds values = boundsOf(drawing_, picture);
            if (values.empty) continue;
            const Frame row{frame.x, frame.y + order * frame.height / rows, frame.width,
                            frame.height / rows};
            const Interval y = ranged(std::min(0.0, values.min.y),
                                      std::max(order == 0 ? 1.0 : 0.0, values.max.y));
            begin(picture, row, {0, 1}, y, order + 1 == rows ? bottom : top / 2);
            if (order + 1 == rows) ticksBelow({0, 1});
            ticksBeside();
            name(names[static_cast<std::size_t>(order)]);
            end(picture);
        }
        if (legend > 0) writeLegend(whole, compared);
    }

    /// The derivative as a curve about the origin; of a plane with the grid of its coordinates.
    void hodographPlot(const Frame& frame, const Orientation& orientation) {
        PanePicture picture{Pane::hodograph, {}, theme_, objectIn(drawing_, Pane::hodograph), -1};
        Bounds seen;
        for (const Shape& shape : drawing_.shapes) {
            if (!picture.shows(shape)) continue;
            for (std::size_t i = 0; i < shape.positions.size() / 3; ++i) {
                const Vec3 p = orientation * positionAt(shape, i);
                if (isFinite(p)) seen.add(p);
            }
        }
        const Frame area = inner(frame, bottom);
        const Aim aim = aimAt(seen, area);
        const auto range = [&](double middle, double pixels) {
            return Interval{middle - pixels / aim.scale / 2, middle + pixels / aim.scale / 2};
        };
        const Interval x = range(aim.x, area.width);
        begin(picture, frame, x, range(aim.y, area.height), bottom);
        if (orientation == planeOrientation()) {
            ticksBelow(x);
            ticksBeside();
        }
        picture.screen = screenOf(orientation, aim, area_);
        name("C\u2032");
        end(picture);
    }

private:
    /// Where the lines of a plot are, with the names of its ticks around.
    [[nodiscard]] static Frame inner(const Frame& frame, double below) noexcept {
        return {frame.x + left, frame.y + top, std::max(1.0, frame.width - left - right),
                std::max(1.0, frame.height - top - below)};
    }

    void begin(PanePicture& picture, const Frame& frame, const Interval& x, const Interval& y,
               double below) {
        area_ = inner(frame, below);
        y_ = y;
        picture.screen = mapOnto(area_, x, y);
        screen_ = picture.screen;
        xml_.begin("g").attribute("class", "knotwork-pane");
        xml_.attribute("data-pane", paneName(picture.pane));
        xml_.begin("rect").attribute("class", "knotwork-plot");
        xml_.number("x", area_.x).number("y", area_.y);
        xml_.number("width", area_.width).number("height", area_.height);
        xml_.attribute("fill", colours_.plot).attribute("stroke", colours_.grid);
        xml_.end();
    }

    void end(const PanePicture& picture) {
        writeShapes(xml_, drawing_, state_, picture);
        xml_.end();
    }

    void beginNames(std::string_view anchor) {
        xml_.begin("g").attribute("class", "knotwork-ticks").attribute("fill", colours_.quiet);
        xml_.attribute("font-family", "sans-serif").number("font-size", fontSize);
        xml_.attribute("text-anchor", anchor);
    }

    void gridLine(const Vec3& from, const Vec3& to) {
        std::string data = "M";
        appendNumber(data, from.x, 2);
        data += ',';
        appendNumber(data, from.y, 2);
        data += 'L';
        appendNumber(data, to.x, 2);
        data += ',';
        appendNumber(data, to.y, 2);
        xml_.begin("path").attribute("stroke", colours_.grid).attribute("d", data).end();
    }

    [[nodiscard]] PanePicture pictureOf(Pane pane) const {
        return {pane, {}, theme_, objectIn(drawing_, pane), -1};
    }

    void curvaturePlot(const Frame& frame, PanePicture& picture, bool shared, Interval x) {
        const Bounds values = boundsOf(drawing_, picture);
        if (!shared) x = ranged(values.min.x, values.max.x);
        begin(picture, frame, x, ranged(std::min(0.0, values.min.y), std::max(0.0, values.max.y)),
              shared ? top / 2 : bottom);
        if (!shared) ticksBelow(x);
        ticksBeside();
        name("\u03ba");
        picture.frame = area_;
        end(picture);
    }

    /// A sample of each object's line with its name.
    void writeLegend(const Frame& frame, const std::vector<int>& objects) {
        xml_.begin("g").attribute("class", "knotwork-legend");
        double y = frame.y + top;
        for (const int object : objects) {
            legendEntry(object, frame.x + left, y);
            y += legendLine;
        }
        xml_.end();
    }

    void legendEntry(int object, double x, double y) {
        const auto shape = std::find_if(
            drawing_.shapes.begin(), drawing_.shapes.end(),
            [&](const Shape& s) { return s.pane == Pane::bFunction && s.object == object; });
        xml_.begin("line").number("x1", x).number("x2", x + sample).number("y1", y).number("y2", y);
        xml_.attribute("stroke", svgColour(shape->colour, theme_)).number("stroke-width", 2);
        if (shape->dashed) xml_.attribute("stroke-dasharray", "6 5");
        xml_.end();
        xml_.begin("text").attribute("fill", colours_.ink);
        xml_.attribute("font-family", "sans-serif").number("font-size", fontSize);
        xml_.number("x", x + sample + 8).number("y", y + fontSize / 3);
        xml_.text(state_.objects[static_cast<std::size_t>(object)]->id);
    }

    void ticksBelow(const Interval& x) {
        beginNames("middle");
        const int most = std::max(1, static_cast<int>(area_.width / cell));
        for (const Tick& tick : niceTicks(x, most)) {
            const double at = screen_.point({tick.at, 0, 0}).x;
            gridLine({at, area_.y, 0}, {at, area_.y + area_.height, 0});
            xml_.begin("text").number("x", at).number("y", area_.y + area_.height + fontSize + 5);
            xml_.text(tick.text);
        }
        xml_.end();
    }

    void name(std::string_view text) {
        xml_.begin("text").attribute("class", "knotwork-name").attribute("fill", colours_.ink);
        xml_.attribute("font-family", "sans-serif").number("font-size", fontSize + 2);
        xml_.number("x", area_.x + 7).number("y", area_.y + fontSize + 6);
        xml_.text(text);
    }

    void ticksBeside() {
        beginNames("end");
        for (const Tick& tick : niceTicks(y_, area_.height < 90 ? 2 : 3)) {
            const double at = screen_.point({0, tick.at, 0}).y;
            gridLine({area_.x, at, 0}, {area_.x + area_.width, at, 0});
            xml_.begin("text").number("x", area_.x - 7).number("y", at + fontSize / 3);
            xml_.text(tick.text);
        }
        xml_.end();
    }

    XmlWriter& xml_;
    const Drawing& drawing_;
    const scene::State& state_;
    SvgTheme theme_;
    const SvgColours& colours_;
    Frame area_;
    Interval y_;
    Affine screen_;
};

double knotsHeight(const Drawing& drawing) {
    const PanePicture line{Pane::knots, {}, SvgTheme::light, objectIn(drawing, Pane::knots), -1};
    return knotHeight + knotRow * std::clamp(boundsOf(drawing, line).max.y, 1.0, 6.0);
}

/// The place of the curve parted between both planes.
template <class Wanted>
SvgLayout withHodograph(SvgLayout layout, const Wanted& wanted) {
    if (!wanted(Pane::hodograph)) return layout;
    layout.hodograph = layout.curve;
    if (!wanted(Pane::curve)) {
        layout.curve.height = 0;
        return layout;
    }
    const double width = std::min(hodographWidth * layout.curve.width, layout.curve.height);
    layout.curve.width -= width;
    layout.hodograph.x += layout.curve.width;
    layout.hodograph.width = width;
    return layout;
}

}  // namespace

SvgLayout svgLayout(const Frame& whole, const Drawing& drawing, std::span<const Pane> panes) {
    const auto wanted = [&](Pane pane) {
        const bool asked = std::find(panes.begin(), panes.end(), pane) != panes.end();
        return asked && (pane == Pane::curve || has(drawing, pane));
    };
    SvgLayout layout;
    layout.curve = whole;
    const bool basis = wanted(Pane::basis), knots = wanted(Pane::knots);
    const bool bFunction = wanted(Pane::bFunction), curvature = wanted(Pane::curvature);
    if (!basis && !knots && !bFunction && !curvature) return withHodograph(layout, wanted);
    const double line = knots ? std::min(knotsHeight(drawing), whole.height / 2) : 0;
    const double share = basis && curvature ? 1.4 * plotShare : plotShare;
    double plots = basis || bFunction || curvature ? std::max(share * whole.height, line) : line;
    if (!wanted(Pane::curve) && !wanted(Pane::hodograph)) plots = whole.height;
    layout.curve.height = whole.height - plots;
    double y = whole.y + layout.curve.height;
    const bool parameters = basis || knots || curvature;
    const double width = parameters && bFunction ? basisShare * whole.width : whole.width;
    const double side = parameters ? width : 0;
    if (bFunction) layout.bFunction = {whole.x + side, y, whole.width - side, plots};
    const double flexible = plots - (basis || curvature ? line : 0);
    const double ofCurvature = !curvature ? 0 : basis ? curvatureShare * flexible : flexible;
    if (curvature) layout.curvature = {whole.x, y, width, ofCurvature};
    y += ofCurvature;
    if (basis) layout.basis = {whole.x, y, width, flexible - ofCurvature};
    if (basis) y += flexible - ofCurvature;
    if (knots) layout.knots = {whole.x, y, width, basis || curvature ? line : plots};
    return withHodograph(layout, wanted);
}

void writePlots(XmlWriter& xml, const Drawing& drawing, const scene::State& state,
                const SvgLayout& layout, const Orientation& orientation, SvgTheme theme) {
    PlotWriter plots(xml, drawing, state, theme);
    plots.parameterPlots(layout);
    if (layout.bFunction.height > 0) plots.bFunctionPlot(layout.bFunction);
    if (layout.hodograph.height > 0) plots.hodographPlot(layout.hodograph, orientation);
}

}  // namespace knotwork::drawing
