// Colours: sRGB as documents write them, blended through OKLCH (Ottosson, 2020).
#pragma once

#include "geometry/result.hpp"

#include <string>
#include <string_view>

namespace knotwork::scene {

/// sRGB components and opacity in [0, 1].
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// `#rrggbb` (SYNTAX otherwise).
[[nodiscard]] Result<Colour> parseColour(std::string_view text);
[[nodiscard]] std::string formatColour(const Colour& colour);

/// A component of sRGB as linear light (IEC 61966-2-1).
[[nodiscard]] double linearLight(double component) noexcept;

/// From `a` at s = 0 to `b` at s = 1 along lightness, chroma and the shorter way round in hue; the
/// ends are exact and the result is clamped to the sRGB gamut.
[[nodiscard]] Colour mixColours(const Colour& a, const Colour& b, double s) noexcept;

}  // namespace knotwork::scene
