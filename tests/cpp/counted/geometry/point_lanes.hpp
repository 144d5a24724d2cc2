// In the place of the library's header: loads, stores and arithmetic are counted.
#pragma once

#include "geometry/vec.hpp"

namespace knotwork::simd {

struct PointLanes {
    Vec3 p;
};

inline PointLanes load(const Vec3& p) noexcept {
    ++counted.arithmetic;
    return {p};
}
inline void store(Vec3& to, const PointLanes& p) noexcept {
    ++counted.arithmetic;
    to = p.p;
}
inline PointLanes operator+(const PointLanes& a, const PointLanes& b) noexcept {
    return {a.p + b.p};
}
inline PointLanes operator-(const PointLanes& a, const PointLanes& b) noexcept {
    return {a.p - b.p};
}
inline PointLanes operator*(double factor, const PointLanes& p) noexcept { return {factor * p.p}; }
inline PointLanes middle(const PointLanes& a, const PointLanes& b) noexcept { return 0.5 * (a + b); }

}  // namespace knotwork::simd
