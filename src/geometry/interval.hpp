// A closed interval of parameters, and the side from which a knot is approached.
#pragma once

#include <cstddef>

namespace knotwork {

/// From which side a derivative at a knot is taken. At the right end of an open domain the right
/// side does not exist, and Side::right means the left one there.
enum class Side { left, right };

/// [start, end] with start < end.
struct Interval {
    double start = 0;
    double end = 1;

    [[nodiscard]] constexpr double length() const noexcept { return end - start; }
    [[nodiscard]] constexpr bool contains(double t) const noexcept {
        return start <= t && t <= end;
    }
    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

/// The i-th of `total` parameters spread uniformly over the interval, both ends included and exact.
/// A single sample is the start.
[[nodiscard]] constexpr double uniformParameter(const Interval& interval, std::size_t i,
                                                std::size_t total) noexcept {
    if (total < 2) return interval.start;
    if (i + 1 == total) return interval.end;
    return interval.start + interval.length() * static_cast<double>(i) /
                                static_cast<double>(total - 1);
}

}  // namespace knotwork
