// Between checked JSON and the values of the core. These trust their input: validation came first.
#pragma once

#include "geometry/pose.hpp"
#include "scene/json.hpp"

#include <span>
#include <vector>

namespace knotwork::scene {

/// [x, y] or [x, y, z].
[[nodiscard]] Vec3 vec3Of(const Json& point) noexcept;
[[nodiscard]] std::vector<double> numbersOf(const Json& list);
[[nodiscard]] Json listOf(std::span<const double> numbers);
/// [x, y] where dimension is 2.
[[nodiscard]] Json pointJson(const Vec3& point, int dimension);
/// A canonical pose: translate, rotate { axis, angle }, scale.
[[nodiscard]] Pose poseOf(const Json& pose) noexcept;

}  // namespace knotwork::scene
