// Colours of what surrounds a curve, for light and for dark backgrounds. Neighbours in the cycle are
// at least 0.09 apart in OKLab for everyone, also for people without one kind of cones (begun from
// Okabe and Ito, 2008, and made lighter and darker in turn where hue alone is not seen).
#pragma once

#include "drawing/drawing.hpp"

#include <optional>

namespace knotwork::drawing {

/// Polygons, points, knots, handles, local curves: the quiet colour of a role.
[[nodiscard]] Colour roleColour(Role role, bool dark) noexcept;

/// The i-th of a cycle of colours for things that stand side by side (basis functions, the orders
/// of derivative of a B-function).
[[nodiscard]] Colour cycleColour(std::size_t i, bool dark) noexcept;

/// Relative luminance (WCAG 2.2): 0 of black, 1 of white.
[[nodiscard]] double luminance(const Colour& colour) noexcept;

/// What has the colour that the author gave the object (curves, surfaces), or one made of it (the
/// lines on a surface); nothing for the other roles.
[[nodiscard]] std::optional<Colour> objectColour(Role role, const Colour& colour,
                                                 bool dark) noexcept;

/// An author's colour, lifted on a dark background until it can be seen there.
[[nodiscard]] Colour onBackground(const Colour& colour, bool dark) noexcept;

/// From 1 for the same to 21 for black and white (WCAG 2.2). Opacity is left out.
[[nodiscard]] double contrastOf(const Colour& a, const Colour& b) noexcept;
/// The colour as little darkened, on a light ground, or lightened, on a dark one, as gives this
/// contrast, hue and opacity kept; black or white where nothing less does.
[[nodiscard]] Colour withContrast(const Colour& colour, const Colour& ground,
                                         double contrast) noexcept;
/// Of lines, points and text to the ground where more contrast is asked for: 7 (WCAG 2.2, 1.4.6) and
/// what the rounding to bytes may take.
inline constexpr double clearContrast = 7.1;

}  // namespace knotwork::drawing
