#include "ui/plot.hpp"

#include <algorithm>
#include <limits>

namespace knotwork::ui {

namespace {

constexpr double cellPixels = 44;  // least size of a cell of the plane's grid

Interval extent(const std::vector<const Shape*>& shapes, std::size_t coordinate) noexcept {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Shape* shape : shapes) {
        for (std::size_t i = coordinate; i < shape->positions.size(); i += 3) {
            low = std::min(low, shape->positions[i]);
            high = std::max(high, shape->positions[i]);
        }
    }
    if (!(low <= high)) return {0, 1};
    if (low == high) return {low - 0.5, high + 0.5};
    return {low, high};
}

}  // namespace

Interval extentX(const std::vector<const Shape*>& shapes) noexcept { return extent(shapes, 0); }
Interval extentY(const std::vector<const Shape*>& shapes) noexcept { return extent(shapes, 1); }

void Lines::add(const Vec3& from, const Vec3& to) {
    segments.insert(segments.end(), {from.x, from.y, from.z, to.x, to.y, to.z});
}

void addVertical(Lines& lines, const Plot& plot, double x) {
    lines.add({x, plot.map.unitY(plot.area.bottom()), 0}, {x, plot.map.unitY(plot.area.y), 0});
}

void addThrough(Lines& lines, const Plot& plot, double x) {
    const double top = plot.joinsAbove ? plot.box.y : plot.area.y;
    const double bottom = plot.joinsBelow ? plot.box.bottom() : plot.area.bottom();
    lines.add({x, plot.map.unitY(bottom), 0}, {x, plot.map.unitY(top), 0});
}

void addHorizontal(Lines& lines, const Plot& plot, double y) {
    lines.add({plot.map.unitX(plot.area.x), y, 0}, {plot.map.unitX(plot.area.right()), y, 0});
}

void addGridX(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours) {
    Lines grid{{}, colours.grid};
    for (const Tick& tick : ticks) addVertical(grid, plot, tick.at);
    plot.under.push_back(std::move(grid));
}

void addGridY(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours) {
    Lines grid{{}, colours.grid};
    Lines axis{{}, colours.axis};
    for (const Tick& tick : ticks) addHorizontal(tick.at == 0 ? axis : grid, plot, tick.at);
    plot.under.push_back(std::move(grid));
    plot.under.push_back(std::move(axis));
}

void nameTicksX(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours) {
    for (const Tick& tick : ticks) {
        plot.labels.push_back({tick.text, {plot.map.pixelX(tick.at), plot.area.bottom() + 7},
                               Align::centre, Baseline::top, 11, false, colours.mutedText,
                               true});
    }
}

void nameTicksY(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours) {
    for (const Tick& tick : ticks) {
        plot.labels.push_back({tick.text, {plot.area.x - 8, plot.map.pixelY(tick.at)},
                               Align::right, Baseline::middle, 11, false, colours.mutedText,
                               true});
    }
}

int ticksAcross(double width) noexcept { return std::clamp(static_cast<int>(width / 56), 1, 12); }
int ticksUp(double height) noexcept { return std::clamp(static_cast<int>(height / 30), 1, 8); }

double planeGridStep(double pixelsPerUnit) noexcept {
    return niceStep(cellPixels / pixelsPerUnit, 1);
}

void addPlaneGrid(Plot& plot, const Theme& colours) {
    const Interval x{plot.map.unitX(plot.area.x), plot.map.unitX(plot.area.right())};
    const Interval y{plot.map.unitY(plot.area.bottom()), plot.map.unitY(plot.area.y)};
    if (!(x.length() > 0) || !(y.length() > 0)) return;
    // One step for both directions keeps the cells square.
    const double step = planeGridStep(plot.map.scaleX);
    Lines axis{{}, colours.axis};
    axis.colour.alpha *= 0.6;
    Lines grid{{}, colours.grid};
    for (const Tick& tick : ticksEvery(x, step)) {
        addVertical(tick.at == 0 ? axis : grid, plot, tick.at);
    }
    for (const Tick& tick : ticksEvery(y, step)) {
        addHorizontal(tick.at == 0 ? axis : grid, plot, tick.at);
    }
    plot.under.push_back(std::move(grid));
    plot.under.push_back(std::move(axis));
}

void addPlaneAxes(Plot& plot, const Theme& colours) {
    addPlaneGrid(plot, colours);
    const Interval x{plot.map.unitX(plot.area.x), plot.map.unitX(plot.area.right())};
    const Interval y{plot.map.unitY(plot.area.bottom()), plot.map.unitY(plot.area.y)};
    if (!(x.length() > 0) || !(y.length() > 0)) return;
    const double step = planeGridStep(plot.map.scaleX);
    nameTicksX(plot, ticksEvery(x, step), colours);
    nameTicksY(plot, ticksEvery(y, step), colours);
}

Box boxOf(const Label& label) noexcept {
    constexpr double widthOfLetter = 0.6;  // of the size, in most fonts and a little generous
    const double width = widthOfLetter * label.size * static_cast<double>(label.text.size());
    const double before = label.align == Align::left ? 0 : label.align == Align::centre ? 0.5 : 1;
    const double above = label.baseline == Baseline::top      ? 0
                         : label.baseline == Baseline::middle ? 0.5
                                                              : 1;
    return {label.at.x - before * width, label.at.y - above * label.size, width, label.size};
}

}  // namespace knotwork::ui
