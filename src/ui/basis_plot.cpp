#include "ui/basis_plot.hpp"

#include <algorithm>

namespace knotwork::ui {

Plot basisPlot(const Box& box, const ParameterAxis& axis, const BasisContent& content,
               bool namesBelow, const Theme& colours) {
    Plot plot;
    plot.pane = Pane::basis;
    plot.box = box;
    plot.joinsBelow = !namesBelow;
    plot.joinsAbove = content.joinsAbove;
    const double below = namesBelow ? 28 : plotMargins.bottom;
    plot.area = inside(box, {0, plotMargins.top + 6, 0, below});
    plot.area.x = axis.left;
    plot.area.width = axis.right - axis.left;
    plot.area.height = std::max(plot.area.height, 1.0);
    // Basis functions lie between 0 and 1: the scale stays while one edits.
    const Interval values{std::min(0.0, content.values.start), std::max(1.0, content.values.end)};
    plot.map = mapOnto(plot.area, axis.range, values);
    addKnotLines(plot, axis, content.knots, colours);
    const std::vector<Tick> ticks = niceTicks(values, plot.area.height < 90 ? 1 : 2);
    addGridY(plot, ticks, colours);
    nameTicksY(plot, ticks, colours);
    if (namesBelow) nameTicksX(plot, niceTicks(axis.range, ticksAcross(plot.area.width)), colours);
    return plot;
}

}  // namespace knotwork::ui
