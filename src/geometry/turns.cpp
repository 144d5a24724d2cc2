#include "geometry/turns.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace knotwork {

Turn compose(const Turn& outer, const Turn& inner) noexcept {
    if (outer.angle == 0) return inner;
    if (inner.angle == 0) return outer;
    const double a = std::cos(outer.angle / 2);
    const double b = std::cos(inner.angle / 2);
    const Vec3 u = std::sin(outer.angle / 2) * glm::normalize(outer.axis);
    const Vec3 v = std::sin(inner.angle / 2) * glm::normalize(inner.axis);
    const double cosine = a * b - glm::dot(u, v);
    const Vec3 axis = a * v + b * u + glm::cross(u, v);
    const double sine = glm::length(axis);
    // Two turns that take each other back are none, about whatever axis.
    if (!(sine > 0)) return {inner.axis, 0};
    return {axis / sine, 2 * std::atan2(sine, cosine)};
}

}  // namespace knotwork
