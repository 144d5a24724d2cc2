// Ticks at round numbers (Heckbert, Nice Numbers for Graph Labels, Graphics Gems 1990).
#pragma once

#include "geometry/interval.hpp"

#include <string>
#include <vector>

namespace knotwork::drawing {

struct Tick {
    double at = 0;
    std::string text;
};

/// The smallest of 1, 2, 5 × 10^k that divides `length` (> 0) into at most `most` (>= 1) steps.
[[nodiscard]] double niceStep(double length, int most) noexcept;

/// The multiples of the nice step in the interval, both ends included, named with just the decimals
/// that the step needs and a true minus sign. Zero is exactly 0.
[[nodiscard]] std::vector<Tick> niceTicks(const Interval& interval, int most);

/// The multiples of `step` (> 0) in the interval, at most a thousand.
[[nodiscard]] std::vector<Tick> ticksEvery(const Interval& interval, double step);

/// A number as a label: at most `decimals` of them, no trailing zeros, a true minus sign.
[[nodiscard]] std::string numberText(double value, int decimals);

}  // namespace knotwork::drawing
