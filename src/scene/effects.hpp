// Effects: pure functions of phase. Nothing is accumulated, so a day of animation leaves no drift,
// and at phase 0 and 1 everything stands where it began, to the bit.
#pragma once

#include "scene/scene.hpp"

#include <optional>

namespace knotwork::scene {

/// When a scene is looked at: `phase` for all effects, or `time` in seconds, each effect then at
/// the fraction of time / period.
struct Moment {
    std::optional<double> phase;
    std::optional<double> time;
};

/// An object as it stands at a moment.
struct Placed {
    const Object* object = nullptr;
    Body body;          ///< with the effects on its locals applied
    Affine placement;   ///< of the object as a whole
    Colour colour;
};

/// The weight of an effect at phase p in [0, 1]: easing(2p) on the way there, easing(2(1−p)) back.
[[nodiscard]] double effectWeight(const BFunction& easing, double phase) noexcept;
/// The phase of a period at an absolute time, in [0, 1).
[[nodiscard]] double phaseAt(double time, double period) noexcept;

[[nodiscard]] std::vector<Placed> place(const State& state, const Moment& moment);

}  // namespace knotwork::scene
