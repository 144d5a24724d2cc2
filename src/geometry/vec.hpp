// The vectors of the core: GLM's, in double precision. A planar point has z = 0.
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace knotwork {

using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

[[nodiscard]] inline bool isFinite(const Vec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace knotwork
