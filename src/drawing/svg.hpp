// Scenes as SVG: clean text to be read, edited and printed.
//
// Everything is in pixels, grouped and named: a group for each pane (`data-matrix` takes the world
// to pixels as SVG's matrix() does), in it one for each object, in it one for each role. Curves are
// cubic Bézier curves: exact where they are polynomials of degree 3 or less, otherwise within 0.05
// pixels; all other lines within 0.1. Nothing is fetched, no script and no style sheet: what is
// painted how are presentation attributes, which every policy allows.
#pragma once

#include "drawing/drawing.hpp"

#include <optional>
#include <string>
#include <vector>

namespace knotwork::drawing {

enum class SvgTheme { light, dark, contrast };

struct SvgOptions {
    double width = 800;   ///< CSS pixels
    double height = 600;
    SvgTheme theme = SvgTheme::light;
    scene::Moment moment{};
    std::optional<std::string> title{};      ///< in place of the document's
    std::optional<std::string> description{};
    /// Which panes there are, in any order; those that nothing of the scene is in are left out.
    std::vector<Pane> panes{Pane::curve};
    std::string background = "theme";  ///< that of the theme, `none`, or a colour as `#rrggbb`
};

/// The panes that are asked for: the curve, the plots of the first object that has some below it, and
/// its hodograph beside it. Rounding a number moves its point by less than 5e-4 pixels and less than
/// 3e-7 of the picture's smaller side; the facets of surfaces keep a tenth of a pixel.
[[nodiscard]] std::string svg(const scene::State& state, const SvgOptions& options);

}  // namespace knotwork::drawing
