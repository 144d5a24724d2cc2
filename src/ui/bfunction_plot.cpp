#include "ui/bfunction_plot.hpp"

#include "ui/knot_line.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::ui {

namespace {

constexpr double leastRow = 40;     // two ticks and a name
constexpr double namesBelow = 28;   // of the ticks, under the last row
constexpr double titleHeight = 26;
constexpr double legendLine = 19;
constexpr double sample = 30;       // of a line in the legend
constexpr double gap = 20;          // between rows
constexpr double air = 0.06;        // above and below a derivative, of its range
constexpr double bShare = 1.8;      // B's row against a derivative's

/// Of the row of a derivative when there are so many rows.
double rowHeight(double height, std::size_t rows) noexcept {
    const double derivatives = static_cast<double>(rows) - 1;
    return std::max(1.0, height - gap * derivatives) / (derivatives + bShare);
}

std::size_t rowsIn(double height, std::size_t wanted) noexcept {
    std::size_t rows = std::max<std::size_t>(wanted, 1);
    while (rows > 1 && rowHeight(height, rows) < leastRow) --rows;
    return rows;
}

int ticksOfRow(double height) noexcept { return height > 90 ? 4 : 3; }

Plot row(const Box& area, const Interval& values, std::size_t order, const Theme& colours) {
    Plot plot;
    plot.pane = Pane::bFunction;
    plot.index = static_cast<int>(order);
    plot.area = area;
    const int most = ticksOfRow(area.height);
    const Interval range = order == 0 ? Interval{std::min(0.0, values.start),
                                                 std::max(1.0, values.end)}
                                      : rowInterval(values);
    plot.map = mapOnto(area, {0, 1}, range);
    addGridX(plot, niceTicks({0, 1}, ticksAcross(area.width)), colours);
    const std::vector<Tick> ticks = niceTicks(range, most);
    addGridY(plot, ticks, colours);
    nameTicksY(plot, ticks, colours);
    return plot;
}

void name(Plot& plot, std::size_t order, const Theme& colours) {
    plot.labels.push_back({derivativeName(order), {plot.area.x + 8, plot.area.y + 5}, Align::left,
                           Baseline::top, 13, true, colours.text});
}

/// A sample of each line with its name and order.
void addLegend(Plot& plot, const Box& box, const BFunctionContent& content, const Theme& colours) {
    double y = box.y + plotMargins.top + legendLine / 2 - 2;
    for (const BFunctionEntry& entry : content.compared) {
        Lines line{{}, entry.colour, 2, entry.dashed};
        const double x = plot.area.x;
        line.add(plot.map.fromPixels({x, y}), plot.map.fromPixels({x + sample, y}));
        plot.over.push_back(std::move(line));
        plot.labels.push_back({entry.name + ": " + orderText(content.orderWords, entry.order),
                               {x + sample + 9, y}, Align::left, Baseline::middle, 12, false,
                               colours.text});
        y += legendLine;
    }
}

}  // namespace

std::string orderText(std::string words, const std::array<double, 2>& order) {
    for (std::size_t end = 0; end < order.size(); ++end) {
        const std::string place = "{" + std::to_string(end) + "}";
        const std::size_t at = words.find(place);
        if (at == std::string::npos) continue;
        words.replace(at, place.size(), std::isinf(order[end]) ? "∞" : numberText(order[end], 0));
    }
    return words;
}

std::string derivativeName(std::size_t order) {
    static constexpr std::array<const char*, 4> names{"B", "B′", "B″", "B‴"};
    if (order < names.size()) return names[order];
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                        "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string raised;
    for (const char digit : std::to_string(order)) {
        raised += digits[static_cast<std::size_t>(digit - '0')];
    }
    return "B⁽" + raised + "⁾";
}

Interval rowInterval(const Interval& values) noexcept {
    const double low = std::min(0.0, values.start);
    const double high = std::max(0.0, values.end);
    // A derivative that is 0 up to rounding is a line along the axis, not noise blown up.
    if (high - low < 1e-9) return {-1, 1};
    const double more = air * (high - low);
    return {low < 0 ? low - more : 0, high > 0 ? high + more : 0};
}

std::vector<Plot> bFunctionPlots(const Box& box, const BFunctionContent& content,
                                 const Theme& colours) {
    const double title = content.compared.empty()
                             ? titleHeight
                             : legendLine * static_cast<double>(content.compared.size()) + 8;
    const Box column = inside(box, {plotMargins.left, plotMargins.top + title,
                                    plotMargins.right, namesBelow});
    const std::size_t rows = rowsIn(column.height, content.values.size());
    const double unit = rowHeight(column.height, rows);
    std::vector<Plot> plots;
    double y = column.y;
    for (std::size_t k = 0; k < rows; ++k) {
        const double height = k == 0 ? unit * bShare : unit;
        const Interval values = k < content.values.size() ? content.values[k] : Interval{0, 1};
        plots.push_back(row({column.x, y, std::max(1.0, column.width), height}, values, k, colours));
        Plot& plot = plots.back();
        // Half of each gap belongs to either neighbour; the ends reach to the box.
        const double top = k == 0 ? box.y : y - gap / 2;
        y += height + gap;
        const double bottom = k + 1 == rows ? box.bottom() : y - gap / 2;
        plot.box = {box.x, top, box.width, bottom - top};
        name(plot, k, colours);
    }
    nameTicksX(plots.back(), niceTicks({0, 1}, ticksAcross(column.width)), colours);
    if (!content.compared.empty()) {
        addLegend(plots.front(), box, content, colours);
        return plots;
    }
    plots.front().labels.push_back({orderText(content.orderWords, content.order),
                                    {column.right(), box.y + plotMargins.top + titleHeight / 2 - 3},
                                    Align::right, Baseline::middle, 12, false, colours.text});
    return plots;
}

}  // namespace knotwork::ui
