// What pointing at something lights up elsewhere.
#pragma once

#include "app/figure.hpp"

namespace knotwork::app {

/// The parameters over which a control point or a local curve has a say in the curve; those of a
/// closed curve may begin before its domain.
[[nodiscard]] std::optional<Interval> ruledInterval(const Curve& curve, std::size_t index) noexcept;

/// The part of a placed curve over an interval as a polyline of `count` points.
[[nodiscard]] Shape stretchOf(const scene::Placed& placed, const Interval& interval,
                              std::size_t count);

/// Marks, widths and opacities of a shape under this emphasis.
[[nodiscard]] Painted painted(const Shape& shape, const Emphasis& emphasis);

/// Adds the ruled part of the curve under the shapes, and the point at the pointed-at parameter
/// above them, to the pane of the curve; the parameter's line to the plots.
void addEmphasis(Figure& figure, const FigureRequest& request);

}  // namespace knotwork::app
