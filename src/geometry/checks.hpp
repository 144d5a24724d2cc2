// What every kind of curve refuses alike: domains and coordinates that no arithmetic would survive.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <cmath>
#include <optional>
#include <string>

namespace knotwork {

/// Nothing for a domain whose ends are finite and within ±1e9 and which is at least 1e-6 and 1e-9
/// of its larger end long; otherwise NOT_FINITE or OUT_OF_RANGE at `domain[i]` or `domain`.
[[nodiscard]] std::optional<Error> checkDomain(const Interval& domain);

/// Nothing for coordinates that are finite and within ±1e12; otherwise NOT_FINITE or OUT_OF_RANGE
/// at `path`.
[[nodiscard]] std::optional<Error> checkCoordinates(const Vec3& point, std::string path);

inline constexpr double largestCoordinate = 1e12;
/// The same as a question, for long lists whose paths are not to be written out.
[[nodiscard]] inline bool allowedCoordinates(const Vec3& point) noexcept {
    return std::abs(point.x) <= largestCoordinate && std::abs(point.y) <= largestCoordinate &&
           std::abs(point.z) <= largestCoordinate;
}

}  // namespace knotwork
