// Unit normals as triples of numbers: how they go along with a map, and what stands where there is
// none.
#pragma once

#include "geometry/vec.hpp"

#include <span>

namespace knotwork::drawing {

/// Whether a map turns faces over.
[[nodiscard]] bool mirrors(const Mat3& map) noexcept;

/// Turns normals with a map of their points: by its cofactors, the other way where it mirrors. One
/// that the map leaves no direction stays as it is.
void turnNormals(std::span<double> normals, const Mat3& map) noexcept;

/// Poles, cusps and vertices without faces have no normal of their own: any is as good as another.
void completeNormals(std::span<double> normals) noexcept;

}  // namespace knotwork::drawing
