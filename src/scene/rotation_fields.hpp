// The fields of a rotation, which poses and effects share.
#pragma once

#include "scene/fields.hpp"

#include <array>

namespace knotwork::scene {

inline constexpr std::array rotateFields{
    Field{.name = "axis", .label = "Axis", .kind = FieldKind::point,
          .help = "Axis of rotation.", .defaultJson = "[0,0,1]"},
    Field{.name = "angle", .label = "Angle", .kind = FieldKind::number,
          .help = "Radians, against the clock seen from the tip of the axis.", .min = -100, .max = 100,
          .defaultJson = "0"},
};

}  // namespace knotwork::scene
