// What the colours of a surface that shows its curvature stand for: a bar from the one end of the
// range over zero to the other, in the lower left corner of a pane.
#pragma once

#include "ui/plot.hpp"

#include <cstddef>
#include <string>

namespace knotwork::ui {

/// The bar as a plot of its own, its name above it and three numbers below. `place` counts bars from
/// the lowest upwards; `range` is positive.
[[nodiscard]] Plot curvatureLegend(const Box& pane, std::size_t place, const std::string& name,
                                   double range, const Theme& colours);

}  // namespace knotwork::ui
