#include "geometry/blending_knots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace knotwork {

namespace {

constexpr double maximumParameter = 1e9;

Result<Done> checkOneKnot(std::span<const double> knots, std::size_t i) {
    const std::string path = indexed("knots", i);
    const double t = knots[i];
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, path, "The knot is " + formatNumber(t) + ", not a number.");
    }
    if (std::abs(t) > maximumParameter) {
        return refuse(Code::outOfRange, path,
                      "The knot is " + formatNumber(t) + "; knots lie within ±1e9.");
    }
    if (i > 0 && t < knots[i - 1]) {
        return refuse(Code::knotsDecreasing, path,
                      "The knot " + formatNumber(t) + " comes after " +
                          formatNumber(knots[i - 1]) + "; knots must not decrease.");
    }
    if (i > 1 && t == knots[i - 2]) {
        return refuse(Code::knotsMultiplicity, path,
                      "The knot " + formatNumber(t) +
                          " stands three times; two equal knots make a break, more have no meaning.");
    }
    return Done{};
}

Result<Done> checkGaps(std::span<const double> knots) {
    const double length = knots.back() - knots.front();
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    if (!(length >= 1e-6) || length < 1e-9 * largest) {
        return refuse(Code::outOfRange, "knots",
                      "The knots span only " + formatNumber(length) +
                          "; the domain must be at least 1e-6 and 1e-9 of the largest knot.");
    }
    const double least =
        std::max(1e-12 * length, 8 * std::numeric_limits<double>::epsilon() * largest);
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double gap = knots[i] - knots[i - 1];
        if (gap != 0 && gap < least) {
            return refuse(Code::outOfRange, indexed("knots", i),
                          "The knot lies " + formatNumber(gap) +
                              " after the one before it; make them equal or part them by at least " +
                              formatNumber(least) + ".");
        }
    }
    return Done{};
}

}  // namespace

Result<Done> checkBlendingKnots(std::span<const double> knots, std::size_t count,
                                BlendForm form) {
    const std::size_t needed = blendingKnotCount(count, form);
    if (knots.size() != needed) {
        return refuse(Code::knotsCount, "knots",
                      std::to_string(knots.size()) + " knots for " + std::to_string(count) +
                          " local curves; " +
                          (form == BlendForm::closed ? "a closed" : "an open") +
                          " blending curve needs " + std::to_string(needed) + ".");
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (auto checked = checkOneKnot(knots, i); !checked) return checked;
    }
    const bool seamIsDouble = form == BlendForm::closed && knots[0] == knots[1] &&
                              knots[needed - 1] == knots[needed - 2];
    if (seamIsDouble) {
        return refuse(Code::knotsMultiplicity, indexed("knots", needed - 1),
                      "The seam is one knot where the form is closed: it is doubled at both ends, "
                      "which makes three equal knots.");
    }
    return checkGaps(knots);
}

std::vector<double> uniformKnots(const Interval& over, std::size_t number) {
    std::vector<double> knots(number);
    for (std::size_t i = 0; i < number; ++i) knots[i] = uniformParameter(over, i, number);
    return knots;
}

Interval blendingSupport(std::span<const double> knots, std::size_t j, BlendForm form) noexcept {
    const std::size_t last = knots.size() - 1;
    if (form == BlendForm::open) {
        return {knots[j == 0 ? 0 : j - 1], knots[std::min(j + 1, last)]};
    }
    const double period = knots.back() - knots.front();
    return {j == 0 ? knots[last - 1] - period : knots[j - 1], knots[j + 1]};
}

Interval blendingDomain(std::span<const double> knots, std::size_t j, BlendForm form) noexcept {
    const Interval support = blendingSupport(knots, j, form);
    if (support.length() > 0) return support;
    // Only the outermost of a doubled end knot has no support, and three are never equal.
    return j == 0 ? Interval{knots[0], knots[2]} : Interval{knots[j - 2], knots[j]};
}

Side blendingSide(std::span<const double> knots, std::size_t j) noexcept {
    return j + 1 == knots.size() || knots[j + 1] == knots[j] ? Side::left : Side::right;
}

BlendingSpan blendingSpan(std::span<const double> knots, BlendForm form, double t,
                          Side side) noexcept {
    const double from = knots.front();
    const double to = knots.back();
    const double period = to - from;
    if (form == BlendForm::closed) {
        const bool inside = side == Side::right ? from <= t && t < to : from < t && t <= to;
        if (!inside) {
            // The other end is met exactly, whatever rounding makes of the period.
            const double end = side == Side::right ? to : from;
            if (t != end) t -= period * std::floor((t - from) / period);
            if (side == Side::right && t >= to) t = from;
            if (side == Side::left && t <= from) t = to;
        }
    }
    const auto begin = knots.begin();
    const auto after = side == Side::right ? std::upper_bound(begin, knots.end(), t)
                                           : std::lower_bound(begin, knots.end(), t);
    std::size_t end = std::clamp<std::size_t>(static_cast<std::size_t>(after - begin), 1,
                                              knots.size() - 1);
    // Only at the two ends can the span found be empty (a double end knot): go inwards.
    while (knots[end] == knots[end - 1] && knots[end] < to) ++end;
    while (knots[end] == knots[end - 1]) --end;
    const bool wraps = form == BlendForm::closed && end + 1 == knots.size();
    return {end - 1, wraps ? 0 : end, knots[end - 1], knots[end] - knots[end - 1],
            wraps ? period : 0, t};
}

}  // namespace knotwork
