#include "drawing/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace knotwork::drawing {

namespace {

int decimalsOf(double step) noexcept {
    // The small addition keeps 0.001, whose logarithm is just above −3, at three decimals.
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 15);
}

}  // namespace

double niceStep(double length, int most) noexcept {
    const double rough = length / std::max(1, most);
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    // A length of exactly `most` nice steps must not fall to the next size by rounding.
    for (const double mantissa : {1.0, 2.0, 5.0}) {
        if (mantissa * decade >= rough * (1 - 1e-9)) return mantissa * decade;
    }
    return 10 * decade;
}

std::vector<Tick> niceTicks(const Interval& interval, int most) {
    if (!(interval.length() > 0) || !std::isfinite(interval.length())) return {};
    return ticksEvery(interval, niceStep(interval.length(), most));
}

std::vector<Tick> ticksEvery(const Interval& interval, double step) {
    std::vector<Tick> ticks;
    const int decimals = decimalsOf(step);
    const double first = std::ceil(interval.start / step - 1e-9);
    const double last = std::floor(interval.end / step + 1e-9);
    for (double k = first; k <= last && ticks.size() < 1000; k += 1) {
        const double at = k == 0 ? 0.0 : k * step;
        ticks.push_back({at, numberText(at, decimals)});
    }
    return ticks;
}

std::string numberText(double value, int decimals) {
    char buffer[64];
    const double size = std::abs(value);
    const bool exponent = size != 0 && (size >= 1e7 || size < 1e-6);
    if (exponent) {
        std::snprintf(buffer, sizeof buffer, "%.3g", size);
    } else {
        std::snprintf(buffer, sizeof buffer, "%.*f", decimals, size);
    }
    std::string text = buffer;
    if (!exponent && text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    return value < 0 && !zero ? "\u2212" + text : text;
}

}  // namespace knotwork::drawing
