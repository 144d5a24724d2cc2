// Turns in space, one after the other.
#pragma once

#include "geometry/vec.hpp"

namespace knotwork {

/// By `angle` radians, right-handed about `axis` of any length but zero.
struct Turn {
    Vec3 axis{0.0, 0.0, 1.0};
    double angle = 0;
};

/// The turn that `inner` and then `outer` make, as a product of quaternions, so that no angle is
/// worse than another; its angle lies in [0, 2π]. One of the two where the other is none, exactly.
[[nodiscard]] Turn compose(const Turn& outer, const Turn& inner) noexcept;

}  // namespace knotwork
