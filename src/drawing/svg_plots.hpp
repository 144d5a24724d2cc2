// The plots of a picture: basis functions over their knot line, and a B-function with its
// derivatives.
#pragma once

#include "drawing/screen.hpp"
#include "drawing/svg_shapes.hpp"

#include <span>

namespace knotwork::drawing {

/// Where the panes of a picture lie; those without height are not there.
struct SvgLayout {
    Frame curve;
    Frame basis;
    Frame knots;
    Frame bFunction;
};

/// The curve above, basis functions on their knots below it, and the B-function beside these.
[[nodiscard]] SvgLayout svgLayout(const Frame& whole, const Drawing& drawing,
                                  std::span<const Pane> panes);

/// All plots of the layout, each with its ground, a grid and the names of its ticks.
void writePlots(XmlWriter& xml, const Drawing& drawing, const scene::State& state,
                const SvgLayout& layout, SvgTheme theme);

}  // namespace knotwork::drawing
