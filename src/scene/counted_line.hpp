// The line of an object, whose crossings with the curve and its control polygon are counted.
#pragma once

#include "geometry/line_crossings.hpp"
#include "scene/body.hpp"
#include "scene/json.hpp"

#include <optional>

namespace knotwork::scene {

/// Gives a canonical object that shows crossings and has no line yet one of its own: level, through
/// the middle of the box of its curve's control points. Other objects stay as they are.
void fillLine(Json& spec, const Body& body);

/// `line` of a canonical object: a point and a direction. OUT_OF_RANGE `line[1]` for a direction
/// without length in the plane.
[[nodiscard]] Result<std::optional<PlaneLine>> lineOf(const Json& spec);

}  // namespace knotwork::scene
