#include "ui/knot_line.hpp"

#include <algorithm>

namespace knotwork::ui {

namespace {

constexpr double labelHeight = 24;   // below the line, for the names of the ticks
constexpr double mostSpacing = 13;   // of rows: a handle's own size and a little air
constexpr double headRoom = 16;      // above the top handle, so that it is whole

/// Beyond this many verticals they would be a grey wash.
constexpr std::size_t mostVerticals = 64;

void addBand(Plot& plot, const Interval& domain, const Theme& colours) {
    Lines axis{{}, colours.axis, 1.25};
    addHorizontal(axis, plot, 0);
    Lines band{{}, colours.axis, 5};
    band.add({domain.start, 0, 0}, {domain.end, 0, 0});
    plot.under.push_back(std::move(band));
    plot.under.push_back(std::move(axis));
}

void addTickMarks(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours) {
    Lines marks{{}, colours.axis};
    const double down = plot.map.unitY(plot.area.bottom() + 6);
    for (const Tick& tick : ticks) marks.add({tick.at, 0, 0}, {tick.at, down, 0});
    plot.under.push_back(std::move(marks));
}

}  // namespace

void addKnotLines(Plot& plot, const ParameterAxis& axis, const std::vector<double>& knots,
                  const Theme& colours) {
    std::vector<double> distinct = knots;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() > mostVerticals) return;
    Lines lines{{}, colours.grid};
    for (const double knot : distinct) {
        if (axis.range.contains(knot)) addThrough(lines, plot, knot);
    }
    plot.under.push_back(std::move(lines));
}

ParameterAxis parameterAxis(const Box& column, const Interval& range) noexcept {
    return {range, column.x + plotMargins.left, std::max(column.x + plotMargins.left + 1,
                                                         column.right() - plotMargins.right)};
}

std::vector<int> pileRows(const std::vector<double>& knots) {
    std::vector<int> rows(knots.size(), 0);
    for (std::size_t k = 1; k < knots.size(); ++k) {
        rows[k] = knots[k] == knots[k - 1] ? rows[k - 1] + 1 : 0;
    }
    return rows;
}

int tallestPile(const std::vector<double>& knots) {
    const std::vector<int> rows = pileRows(knots);
    return rows.empty() ? 1 : *std::max_element(rows.begin(), rows.end()) + 1;
}

double rowSpacing(double height, int rows) noexcept {
    const double room = height - labelHeight - headRoom - plotMargins.bottom;
    return std::clamp(room / std::max(1, rows - 1), 1.0, mostSpacing);
}

Plot knotLine(const Box& box, const ParameterAxis& axis, const KnotLineContent& content,
              const Theme& colours) {
    Plot plot;
    plot.pane = Pane::knots;
    plot.box = box;
    plot.area = {axis.left, box.y, axis.right - axis.left,
                 std::max(1.0, box.height - labelHeight - plotMargins.bottom)};
    const double spacing = rowSpacing(box.height, tallestPile(content.knots));
    const double scaleX = plot.area.width / axis.range.length();
    plot.map = {axis.left - scaleX * axis.range.start, plot.area.bottom(), scaleX, spacing};
    plot.joinsAbove = content.underBasis;
    if (content.underBasis) addKnotLines(plot, axis, content.knots, colours);
    addBand(plot, content.domain, colours);
    const std::vector<Tick> ticks = niceTicks(axis.range, ticksAcross(plot.area.width));
    addTickMarks(plot, ticks, colours);
    nameTicksX(plot, ticks, colours);
    plot.labels.push_back({"t", {axis.right + 12, plot.area.bottom()}, Align::left,
                           Baseline::middle, 12, false, colours.mutedText});
    return plot;
}

}  // namespace knotwork::ui
