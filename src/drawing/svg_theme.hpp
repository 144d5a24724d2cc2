// The colours of a picture on paper or on a page: its ground, and what of a shape is seen on it.
#pragma once

#include "drawing/svg.hpp"

namespace knotwork::drawing {

struct SvgColours {
    std::string_view ground;
    std::string_view plot;     ///< ground of the plots
    std::string_view ink;      ///< words
    std::string_view quiet;    ///< words of axes
    std::string_view grid;
    std::string_view border;   ///< round points, so that they part from lines
    bool dark = false;
    double strength = 1;       ///< of the widths of lines
};

[[nodiscard]] const SvgColours& svgColours(SvgTheme theme) noexcept;

/// `#rrggbb` of a shape's colour; in the theme `contrast` darkened to at least 7 : 1 on white.
[[nodiscard]] std::string svgColour(const Colour& colour, SvgTheme theme);

}  // namespace knotwork::drawing
