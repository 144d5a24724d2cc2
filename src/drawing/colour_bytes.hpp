// Colours as the vertices carry them.
#pragma once

#include "drawing/drawing.hpp"

#include <cstdint>

namespace knotwork::drawing {

[[nodiscard]] constexpr std::uint8_t toByte(double component) noexcept {
    if (!(component > 0)) return 0;
    return component < 1 ? static_cast<std::uint8_t>(component * 255 + 0.5) : std::uint8_t{255};
}

[[nodiscard]] constexpr ColourBytes toBytes(const scene::Colour& colour,
                                            double opacity = 1) noexcept {
    return {toByte(colour.red), toByte(colour.green), toByte(colour.blue),
            toByte(colour.alpha * opacity)};
}

}  // namespace knotwork::drawing
