// The plots of a picture: curvature and basis functions over their knot line, a B-function with its
// derivatives, and the hodograph.
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
    Frame hodograph;
    Frame curvature;
};

/// The curve above, curvature and basis functions on their knots below it, B-functions beside. The
/// hodograph, a plane like that of the curve, is beside the curve.
[[nodiscard]] SvgLayout svgLayout(const Frame& whole, const Drawing& drawing,
                                  std::span<const Pane> panes);

/// All plots of the layout, each with its ground, a grid and the names of its ticks; the hodograph as
/// one sees the curve, x and y to one scale.
void writePlots(XmlWriter& xml, const Drawing& drawing, const scene::State& state,
                const SvgLayout& layout, const Orientation& orientation, SvgTheme theme);

}  // namespace knotwork::drawing
