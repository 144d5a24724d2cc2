// A point as two lanes and a third coordinate, for kernels that gather points one by one.
#pragma once

#include "geometry/simd.hpp"
#include "geometry/vec.hpp"

namespace knotwork::simd {

struct PointLanes {
    Double2 xy;
    double z;
};

[[nodiscard]] inline PointLanes load(const Vec3& p) noexcept { return {load(&p.x), p.z}; }
inline void store(Vec3& to, const PointLanes& p) noexcept {
    store(&to.x, p.xy);
    to.z = p.z;
}

[[nodiscard]] inline PointLanes operator+(const PointLanes& a, const PointLanes& b) noexcept {
    return {a.xy + b.xy, a.z + b.z};
}
[[nodiscard]] inline PointLanes operator-(const PointLanes& a, const PointLanes& b) noexcept {
    return {a.xy - b.xy, a.z - b.z};
}
[[nodiscard]] inline PointLanes operator*(double factor, const PointLanes& p) noexcept {
    return {splat(factor) * p.xy, factor * p.z};
}

/// Of equal coordinates that coordinate, to the bit.
[[nodiscard]] inline PointLanes middle(const PointLanes& a, const PointLanes& b) noexcept {
    return 0.5 * (a + b);
}

}  // namespace knotwork::simd
