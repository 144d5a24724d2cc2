// Knots and control points by indices that may lie in other periods of a closed curve.
#pragma once

#include "geometry/knot_vector.hpp"

#include <cstddef>

namespace knotwork {

/// Knot i of the extended vector; of a closed one for any i, by whole periods, and equal knots of
/// one period are equal in every other.
[[nodiscard]] inline double knotAt(const KnotVector& knots, std::ptrdiff_t i) noexcept {
    const auto all = knots.extended();
    if (i >= 0 && i < static_cast<std::ptrdiff_t>(all.size())) {
        return all[static_cast<std::size_t>(i)];
    }
    const Interval domain = knots.domain();
    const std::ptrdiff_t count = knots.pointCount();
    const std::ptrdiff_t fromSeam = i - knots.degree();
    const std::ptrdiff_t turns = fromSeam >= 0 ? fromSeam / count : -((count - 1 - fromSeam) / count);
    const double knot = all[static_cast<std::size_t>(i - turns * count)];
    // As the extended vector continues the period: differences first.
    return turns > 0 ? domain.end + (knot - domain.start) +
                           static_cast<double>(turns - 1) * domain.length()
                     : domain.start - (domain.end - knot) +
                           static_cast<double>(turns + 1) * domain.length();
}

/// i modulo count, not negative.
[[nodiscard]] inline std::size_t cyclic(std::ptrdiff_t i, std::size_t count) noexcept {
    const auto period = static_cast<std::ptrdiff_t>(count);
    const std::ptrdiff_t rest = i % period;
    return static_cast<std::size_t>(rest < 0 ? rest + period : rest);
}

/// The index of the first of the knots that stand at the start of a closed vector's period, those
/// repeated at its end included, in the extended vector: degree minus their number.
[[nodiscard]] inline std::size_t seamIndex(const KnotVector& knots) noexcept {
    const auto all = knots.extended();
    auto first = static_cast<std::size_t>(knots.degree());
    while (first > 0 && all[first - 1] == all[first]) --first;
    return first;
}

}  // namespace knotwork
