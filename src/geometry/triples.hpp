// Points as x, y, z triples of a long list of numbers.
#pragma once

#include "geometry/vec.hpp"

namespace knotwork {

inline void write(const Vec3& p, double* to) noexcept {
    to[0] = p.x;
    to[1] = p.y;
    to[2] = p.z;
}

}  // namespace knotwork
