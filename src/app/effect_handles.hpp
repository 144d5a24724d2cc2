// Handles of effects: where a movement ends, about what a turn goes and how far, how large a scaling
// makes things, how far a dance may take them. They are drawn at rest, as phase 1/2 would have them,
// whatever moment is shown.
#pragma once

#include "app/drag_moves.hpp"
#include "drawing/drawing.hpp"
#include "scene/scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace knotwork::app {

struct EffectHandle {
    /// vector: `at` is `from` and the value together. place: the value is where it stands. angle:
    /// `start` about `axis` through `from`. factor: `start`, so many times as far from `from`. axis:
    /// the value points from `from` towards it.
    enum class Kind { vector, place, angle, factor, axis };
    std::string path;  ///< `effects[1].angle`
    std::size_t effect = 0;
    int object = 0;    ///< that the effect moves
    Kind kind = Kind::vector;
    Vec3 at{0.0};
    Vec3 from{0.0};
    Vec3 start{0.0};
    Vec3 axis{0.0, 0.0, 1.0};
    Vec3 value{0.0};   ///< of a number its first coordinate
};

/// The local curve or patch at which the handles of its object's dance stand.
struct NearLocal {
    int object = -1;
    std::size_t index = 0;
};

/// Of all effects; of an axis only in space.
[[nodiscard]] std::vector<EffectHandle> effectHandles(const scene::State& state, bool inSpace,
                                                      const NearLocal& near);

/// What makes the handle's meaning seen: an arrow, an arc, a box.
[[nodiscard]] std::vector<drawing::Shape> guidesOf(const EffectHandle& handle, bool inSpace,
                                                   const drawing::Colour& colour);

/// Whether its value is one number.
[[nodiscard]] bool isNumber(const EffectHandle& handle) noexcept;

}  // namespace knotwork::app
