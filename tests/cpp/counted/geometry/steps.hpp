// In the place of the library's header: steps are counted.
#pragma once

#include "geometry/counts.hpp"

namespace knotwork {

inline void step() noexcept { ++counted.steps; }

}  // namespace knotwork
