// In the place of the library's header: vectors that count what is done with them.
#pragma once

#include "geometry/counts.hpp"

#include <cmath>
#include <cstddef>

namespace knotwork {

struct Vec3 {
    double x;
    double y;
    double z;

    Vec3() = default;
    /// Of numbers of any kind.
    template <class X, class Y, class Z>
    constexpr Vec3(X first, Y second, Z third)
        : x(static_cast<double>(first)),
          y(static_cast<double>(second)),
          z(static_cast<double>(third)) {}
    constexpr explicit Vec3(double all) : x(all), y(all), z(all) {}

    [[nodiscard]] double operator[](int axis) const noexcept {
        return axis == 0 ? x : axis == 1 ? y : z;
    }
    Vec3& operator+=(const Vec3& b) noexcept {
        ++counted.arithmetic;
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline Vec3 operator+(Vec3 a, const Vec3& b) noexcept { return a += b; }
inline Vec3 operator*(double factor, const Vec3& a) noexcept {
    ++counted.arithmetic;
    return {factor * a.x, factor * a.y, factor * a.z};
}
inline Vec3 operator*(const Vec3& a, double factor) noexcept { return factor * a; }
inline Vec3 operator/(const Vec3& a, double divisor) noexcept {
    ++counted.arithmetic;
    return {a.x / divisor, a.y / divisor, a.z / divisor};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    ++counted.arithmetic;
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline bool isFinite(const Vec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace knotwork

namespace glm {

inline double dot(const knotwork::Vec3& a, const knotwork::Vec3& b) noexcept {
    ++knotwork::counted.arithmetic;
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(const knotwork::Vec3& a) noexcept { return std::sqrt(dot(a, a)); }
inline knotwork::Vec3 cross(const knotwork::Vec3& a, const knotwork::Vec3& b) noexcept {
    ++knotwork::counted.arithmetic;
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace glm
