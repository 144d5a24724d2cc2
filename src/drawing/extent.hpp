// How large a scene is, about: for tolerances that are a share of it.
#pragma once

#include "drawing/drawing.hpp"

namespace knotwork::drawing {

/// A box round some points of every object as it stands: never larger than the scene, and seldom
/// much smaller.
[[nodiscard]] Bounds roughBounds(const scene::State& state, const scene::Moment& moment);

/// The longest side of that box, 1 where it has none.
[[nodiscard]] double roughSize(const scene::State& state, const scene::Moment& moment);

}  // namespace knotwork::drawing
