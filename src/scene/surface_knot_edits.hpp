// Knots of surfaces put in and taken out: rows and columns, or lines of local patches, go with them.
#pragma once

#include "scene/json.hpp"

#include <cstddef>

namespace knotwork::scene {

/// The canonical specification of a surface with the knot `at` in direction 0 (u) or 1 (v). A
/// B-spline surface does not move; a blending surface gets a line of local patches there. Refusals
/// at `t`, as those of knotwork::insertKnot(), and NOT_SUPPORTED for surfaces without knots.
[[nodiscard]] Result<Json> withKnotAlong(const Json& surface, std::size_t direction, double at);

/// The same without knot `index` of its list: the B-spline surface that comes nearest, or the
/// blending surface without the patches there. Refusals as knotwork::removeKnot(), at `t`.
[[nodiscard]] Result<Json> withoutKnotAlong(const Json& surface, std::size_t direction,
                                            std::size_t index);

}  // namespace knotwork::scene
