#include "ui/theme.hpp"

#include <cstdint>

namespace knotwork::ui {
namespace {

constexpr scene::Colour hex(std::uint32_t rgb, double alpha = 1) {
    const auto component = [rgb](unsigned shift) {
        return static_cast<double>((rgb >> shift) & 0xffU) / 255;
    };
    return {component(16), component(8), component(0), alpha};
}

constexpr Theme light{
    .name = ThemeName::light,
    .background = hex(0xfcfcfe),
    .plotBackground = hex(0xf5f6f9),
    .panel = hex(0xffffff, 0.96),
    .panelBorder = hex(0xd5dae3),
    .field = hex(0xedf0f5),
    .fieldHovered = hex(0xe3e8f0),
    .fieldActive = hex(0xd5deed),
    .text = hex(0x1b2130),
    .mutedText = hex(0x525c70),
    .axis = hex(0x8791a5),
    .grid = hex(0xe1e5ec),
    .accent = hex(0x2f5fd0),
    .accentText = hex(0xffffff),
    .halo = hex(0xf0a030, 0.42),
    .pointBorder = hex(0xffffff),
    .error = hex(0xb3261e),
};

constexpr Theme dark{
    .name = ThemeName::dark,
    .background = hex(0x12151b),
    .plotBackground = hex(0x171b23),
    .panel = hex(0x1b2029, 0.96),
    .panelBorder = hex(0x363e4d),
    .field = hex(0x272e3a),
    .fieldHovered = hex(0x313a48),
    .fieldActive = hex(0x3b475a),
    .text = hex(0xe7eaf0),
    .mutedText = hex(0xa0abbd),
    .axis = hex(0x6f7b91),
    .grid = hex(0x262d39),
    .accent = hex(0x86aaff),
    .accentText = hex(0x0d1320),
    .halo = hex(0xffb84d, 0.42),
    .pointBorder = hex(0x12151b),
    .error = hex(0xff8f86),
};

constexpr Theme contrastLight{
    .name = ThemeName::contrast,
    .background = hex(0xffffff),
    .plotBackground = hex(0xffffff),
    .panel = hex(0xffffff),
    .panelBorder = hex(0x000000),
    .field = hex(0xe6e6e6),
    .fieldHovered = hex(0xd6d6d6),
    .fieldActive = hex(0xc4d2ff),
    .text = hex(0x000000),
    .mutedText = hex(0x1c1c1c),
    .axis = hex(0x4a4a4a),
    .grid = hex(0xb4b4b4),
    .accent = hex(0x0b2f9c),
    .accentText = hex(0xffffff),
    .halo = hex(0xe07800, 0.7),
    .pointBorder = hex(0xffffff),
    .error = hex(0x8c0b0b),
};

constexpr Theme contrastDark{
    .name = ThemeName::contrastDark,
    .background = hex(0x000000),
    .plotBackground = hex(0x000000),
    .panel = hex(0x000000),
    .panelBorder = hex(0xffffff),
    .field = hex(0x262626),
    .fieldHovered = hex(0x3a3a3a),
    .fieldActive = hex(0x27407f),
    .text = hex(0xffffff),
    .mutedText = hex(0xe6e6e6),
    .axis = hex(0xb8b8b8),
    .grid = hex(0x5c5c5c),
    .accent = hex(0xa9c2ff),
    .accentText = hex(0x000000),
    .halo = hex(0xffc34d, 0.7),
    .pointBorder = hex(0x000000),
    .error = hex(0xffb3ad),
};

}  // namespace

const Theme& theme(ThemeName name) noexcept {
    switch (name) {
        case ThemeName::dark: return dark;
        case ThemeName::contrast: return contrastLight;
        case ThemeName::contrastDark: return contrastDark;
        default: return light;
    }
}

ThemeName themeNamed(std::string_view name) noexcept {
    if (name == "dark") return ThemeName::dark;
    if (name == "contrast") return ThemeName::contrast;
    return name == "contrast-dark" ? ThemeName::contrastDark : ThemeName::light;
}

}  // namespace knotwork::ui
