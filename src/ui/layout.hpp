// Where the panes of a figure lie: the curve large; basis functions straight above their knot
// line; the B-function beside or below, whichever shape of figure there is to fill.
#pragma once

#include "ui/box.hpp"

#include <optional>

namespace knotwork::ui {

struct WantedPanes {
    bool curve = true;
    bool basis = false;
    bool knots = false;
    bool bFunction = false;
    int knotRows = 1;  ///< height of the tallest pile of knots
    double curveAspect = 1;  ///< width of the curve's picture over its height
    bool hodograph = false;
};

struct FigureLayout {
    std::optional<Box> curve;
    std::optional<Box> basis;
    std::optional<Box> knots;
    std::optional<Box> bFunction;
    std::optional<Box> hodograph;
};

/// The hodograph, a plane as the curve's is, takes a part of the curve's box, beside it or below it
/// as that is wide or tall; it is the first to be left out. Plots stand beside the curve or below it, whichever shows the curve larger. Panes that would
/// leave too little for those that matter more are left out: then the B-function, then the
/// basis functions, then the knot line.
[[nodiscard]] FigureLayout layoutFigure(const Box& figure, const WantedPanes& wanted) noexcept;

}  // namespace knotwork::ui
