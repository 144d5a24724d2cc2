// The colours of a surface that shows its curvature: from blue, where it is negative, over a light
// grey at zero to orange, two hues that people tell apart whatever colours they see (Okabe and Ito,
// 2008), equally light and equally strong at equal distances from zero.
#pragma once

#include "drawing/drawing.hpp"

#include <span>
#include <vector>

namespace knotwork::drawing {

/// The share of values that lie within the range: single vertices at a crease or a pole must not
/// make all others grey.
inline constexpr double rangeShare = 0.95;

/// The colour of a value that is `share` of the range, between −1 and 1 (and those beyond).
[[nodiscard]] Colour curvatureColour(double share) noexcept;

/// The colours at the positions of triangles with normals, and what value the strongest stands for.
struct CurvatureColours {
    std::vector<ColourBytes> colours;
    double range = 0;  ///< 0 where the surface is as good as flat
};
[[nodiscard]] CurvatureColours curvatureColours(const Shape& triangles, scene::Colouring by);

}  // namespace knotwork::drawing
