// What of a segment lies in a rectangle round the origin (Liang and Barsky, 1984).
#pragma once

#include <optional>
#include <utility>

#include "geometry/vec.hpp"

namespace knotwork::render {

/// The parameters [from, to] in [0, 1] between which a + s(b - a) has |x| <= halfX and
/// |y| <= halfY; nothing when the segment passes outside.
[[nodiscard]] std::optional<std::pair<double, double>> clipSegment(const Vec3& a, const Vec3& b,
                                                                   double halfX,
                                                                   double halfY) noexcept;

}  // namespace knotwork::render
