#include "drawing/svg_theme.hpp"

#include "drawing/palette.hpp"

namespace knotwork::drawing {

namespace {

// A page is white where it is printed, so the light ground is, too; the others are the view's.
constexpr SvgColours light{"#ffffff", "#f5f6f9", "#1b2130", "#525c70", "#e1e5ec", "#ffffff", false, 1};
constexpr SvgColours dark{"#12151b", "#171b23", "#e7eaf0", "#a0abbd", "#262d39", "#12151b", true, 1};
constexpr SvgColours contrast{"#ffffff", "#ffffff", "#000000", "#000000", "#767676", "#ffffff",
                              false, 1.4};

}  // namespace

const SvgColours& svgColours(SvgTheme theme) noexcept {
    switch (theme) {
        case SvgTheme::dark: return dark;
        case SvgTheme::contrast: return contrast;
        case SvgTheme::light: break;
    }
    return light;
}

std::string svgColour(const Colour& colour, SvgTheme theme) {
    if (theme != SvgTheme::contrast) return scene::formatColour(colour);
    return scene::formatColour(withContrast(colour, {1, 1, 1, 1}, clearContrast));
}

}  // namespace knotwork::drawing
