#include "ui/legend.hpp"

#include "drawing/curvature_colours.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::ui {

namespace {

// CSS pixels
constexpr double margin = 18;
constexpr double barHeight = 8;
constexpr double mostWidth = 148;
constexpr double numbersBelow = 11;
constexpr double nameAbove = 10;
constexpr double pitch = 52;  // from bar to bar
constexpr int strips = 74;

/// Two significant digits.
std::string rangeText(double value, double range) {
    const double digits = 1 - std::floor(std::log10(range));
    return drawing::numberText(value, static_cast<int>(std::clamp(digits, 0.0, 12.0)));
}

}  // namespace

Plot curvatureLegend(const Box& pane, std::size_t place, const std::string& name, double range,
                     const Theme& colours) {
    const double width = std::min(mostWidth, pane.width / 2);
    const double top = pane.bottom() - margin - numbersBelow - barHeight -
                       pitch * static_cast<double>(place);
    Plot plot;
    plot.pane = Pane::curve;
    plot.box = plot.area = {pane.x + margin, top, width, barHeight};
    plot.map = mapOnto(plot.box, {-1, 1}, {0, 1});
    for (int i = 0; i < strips; ++i) {
        const double at = (2 * i + 1.0) / strips - 1;
        Lines strip;
        strip.colour = drawing::curvatureColour(at);
        strip.width = width / strips + 0.75;  // over the next one, so that no seam is seen
        strip.add({at, -1, 0}, {at, 2, 0});
        plot.under.push_back(std::move(strip));
    }
    const auto label = [&](std::string text, double x, double y, Align align) {
        Label made{std::move(text), {x, y}, align, Baseline::middle, 11, false,
                   colours.mutedText};
        made.number = align != Align::left || x > plot.box.x;
        plot.labels.push_back(std::move(made));
    };
    const double below = plot.box.bottom() + numbersBelow;
    label(name, plot.box.x, top - nameAbove, Align::left);
    label(rangeText(-range, range), plot.box.x, below, Align::centre);
    label("0", plot.box.centre().x, below, Align::centre);
    label(rangeText(range, range), plot.box.right(), below, Align::centre);
    return plot;
}

}  // namespace knotwork::ui
