// The part of a figure over which a point, a knot, a local curve or a patch has a say.
#pragma once

#include "app/target.hpp"

#include <optional>
#include <vector>

namespace knotwork::app {

/// The parameters over which a control point or a local curve has a say in the curve; those of a
/// closed curve may begin before its domain.
[[nodiscard]] std::optional<Interval> ruledInterval(const Curve& curve, std::size_t index) noexcept;
/// The same of a knot: where the functions differ that stand on it.
[[nodiscard]] std::optional<Interval> ruledByKnot(const Curve& curve, std::size_t index) noexcept;

/// The same parameters as intervals that do not overlap, in ascending order; of a closed curve at
/// most the whole of its period.
[[nodiscard]] std::vector<Interval> joined(std::vector<Interval> parts, double whole);

/// The parameters over which a point of a net or a patch has a say in the surface. `row` is the
/// point's, `index` its place in the row or the number of the patch.
[[nodiscard]] std::optional<Rectangle> ruledRectangle(const Surface& surface, std::size_t row,
                                                      std::size_t index) noexcept;
/// The row that a list such as `objects[0].points[2]` is, else 0.
[[nodiscard]] std::size_t rowOf(std::string_view list) noexcept;

/// The part of a placed curve over an interval as a polyline of `count` points.
[[nodiscard]] Shape stretchOf(const scene::Placed& placed, const Interval& interval,
                              std::size_t count);
/// The part of a placed surface over a rectangle as lines of constant u and v.
[[nodiscard]] Shape gridOf(const scene::Placed& placed, const Rectangle& part);
/// The edges of a placed control mesh that meet in a vertex.
[[nodiscard]] Shape starOf(const scene::Placed& placed, std::size_t vertex);

}  // namespace knotwork::app
