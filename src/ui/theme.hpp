// The colours of everything that is not part of a document: surfaces, text, axes, handles, states.
// Light and dark, for everyone and with more contrast; that of text to its surface is at least 4.5
// (7 for plain text), in the sets of more contrast 7 and of axes 4.5.
#pragma once

#include "scene/colour.hpp"

#include <string_view>

namespace knotwork::ui {

enum class ThemeName { light, dark, contrast, contrastDark };

[[nodiscard]] constexpr bool isDark(ThemeName name) noexcept {
    return name == ThemeName::dark || name == ThemeName::contrastDark;
}
[[nodiscard]] constexpr bool hasContrast(ThemeName name) noexcept {
    return name == ThemeName::contrast || name == ThemeName::contrastDark;
}

struct Theme {
    ThemeName name = ThemeName::light;
    scene::Colour background;     ///< of a view
    scene::Colour plotBackground; ///< of basis, knot and B-function panes
    scene::Colour panel;          ///< surface of the panel, slightly translucent
    scene::Colour panelBorder;
    scene::Colour field;          ///< surface of an input
    scene::Colour fieldHovered;
    scene::Colour fieldActive;
    scene::Colour text;
    scene::Colour mutedText;
    scene::Colour axis;           ///< axes and frames
    scene::Colour grid;           ///< grid lines
    scene::Colour accent;         ///< what is selected, sliders, the parameter
    scene::Colour accentText;     ///< on the accent
    scene::Colour halo;           ///< round what the pointer is over (translucent)
    scene::Colour pointBorder;    ///< round points, so that they part from lines
    scene::Colour error;          ///< messages of refusals
};

[[nodiscard]] const Theme& theme(ThemeName name) noexcept;
/// Of "dark", "contrast" and "contrast-dark"; the light theme for anything else.
[[nodiscard]] ThemeName themeNamed(std::string_view name) noexcept;

}  // namespace knotwork::ui
