// Where the panes of a figure lie: the curve large; curvature and basis functions straight above
// their knot line; the B-function beside or below, whichever shape of figure there is to fill.
#pragma once

#include "ui/box.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace knotwork::ui {

struct WantedPanes {
    bool curve = true;
    bool basis = false;
    bool knots = false;
    bool bFunction = false;
    int knotRows = 1;  ///< height of the tallest pile of knots
    double curveAspect = 1;  ///< width of the curve's picture over its height
    bool hodograph = false;
    bool curvature = false;
};

/// A line between panes that can be moved: between the curve and all plots, the curve and its
/// hodograph, the curvature and the basis functions below it, these and the B-function below them.
enum class SeamName { plots, hodograph, curvature, bFunction };
inline constexpr std::array<std::string_view, 4> seamNames{"plots", "hodograph", "curvature",
                                                           "bFunction"};

/// The share of what lies to its left or above it in what it parts, of each seam that was moved.
using Shares = std::array<std::optional<double>, seamNames.size()>;

struct Seam {
    Box at;              ///< a line: without width where it is upright, else without height
    bool upright = false;
    double share = 0;    ///< from `least` to `most`, which leave every pane the size that it needs
    double least = 0;
    double most = 1;
    double normal = 0;   ///< of the seam that nobody moved
    double length = 0;   ///< CSS pixels of what it parts
};

struct FigureLayout {
    std::optional<Box> curve;
    std::optional<Box> basis;
    std::optional<Box> knots;
    std::optional<Box> bFunction;
    std::optional<Box> hodograph;
    std::optional<Box> curvature;
    std::array<std::optional<Seam>, seamNames.size()> seams;

    [[nodiscard]] const std::optional<Seam>& seam(SeamName name) const noexcept {
        return seams[static_cast<std::size_t>(name)];
    }
};

/// The hodograph, a plane as the curve's is, takes a part of the curve's box, beside it or below it
/// as that is wide or tall; it is the first to be left out. Plots stand beside the curve or below
/// it, whichever shows the curve larger while nobody has moved a seam. Panes that would leave too
/// little for those that matter more are left out: then the B-function, then the curvature, the
/// basis functions and the knot line.
[[nodiscard]] FigureLayout layoutFigure(const Box& figure, const WantedPanes& wanted,
                                        const Shares& shares = {}) noexcept;

}  // namespace knotwork::ui
