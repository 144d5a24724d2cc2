#include "ui/curvature_plot.hpp"

#include "ui/bfunction_plot.hpp"

#include <algorithm>

namespace knotwork::ui {

namespace {

constexpr double namesBelow = 28;
constexpr double labelAside = 7;  // of a mark

bool overlap(const Box& a, const Box& b) noexcept {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// The greatest value where the graph leaves the plot, beside its mark, unless another is there.
void addMarkLabel(Plot& plot, const Shape& shape, const Theme& colours) {
    const double x = plot.map.pixelX(shape.positions[0]);
    const double y = plot.map.pixelY(shape.positions[1]);
    const bool left = x > plot.area.right() - 40;
    Label label{shape.text, {x + (left ? -labelAside : labelAside), y},
                left ? Align::right : Align::left, Baseline::middle, 11, false,
                colours.mutedText, true, true};
    const bool crowded =
        std::any_of(plot.labels.begin(), plot.labels.end(),
                    [&](const Label& other) { return overlap(boxOf(label), boxOf(other)); });
    if (!crowded) plot.labels.push_back(std::move(label));
}

}  // namespace

Plot curvaturePlot(const Box& box, const ParameterAxis& axis, const CurvatureContent& content,
                   const Theme& colours) {
    Plot plot;
    plot.pane = Pane::curvature;
    plot.box = box;
    plot.joinsBelow = content.joinsBelow;
    plot.area = inside(box, {0, plotMargins.top + 6, 0,
                             content.joinsBelow ? plotMargins.bottom : namesBelow});
    plot.area.x = axis.left;
    plot.area.width = axis.right - axis.left;
    plot.area.height = std::max(plot.area.height, 1.0);
    plot.map = mapOnto(plot.area, axis.range, rowInterval(content.values));
    addKnotLines(plot, axis, content.knots, colours);
    const Interval values{plot.map.unitY(plot.area.bottom()), plot.map.unitY(plot.area.y)};
    const std::vector<Tick> ticks = niceTicks(values, std::max(3, ticksUp(plot.area.height)));
    addGridY(plot, ticks, colours);
    nameTicksY(plot, ticks, colours);
    const std::vector<Tick> along = niceTicks(axis.range, ticksAcross(plot.area.width));
    if (!content.joinsBelow) nameTicksX(plot, along, colours);
    if (content.knots.empty()) addGridX(plot, along, colours);
    plot.labels.push_back({"\u03ba", {plot.area.x + 8, plot.area.y + 2}, Align::left,
                           Baseline::top, 14, true, colours.text, false, true});
    for (const Shape* label : content.labels) addMarkLabel(plot, *label, colours);
    return plot;
}

}  // namespace knotwork::ui
