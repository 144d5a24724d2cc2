// What pointing at something lights up elsewhere.
#pragma once

#include "app/figure.hpp"

namespace knotwork::app {

/// Marks, widths and opacities of a shape under this emphasis.
[[nodiscard]] Painted painted(const Shape& shape, const Emphasis& emphasis);

/// Adds the ruled part of the curve under the shapes, and the point at the pointed-at parameter
/// above them, to the pane of the curve; the parameter's line to the plots.
void addEmphasis(Figure& figure, const FigureRequest& request);

}  // namespace knotwork::app
