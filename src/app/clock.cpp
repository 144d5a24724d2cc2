#include "app/clock.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

constexpr int mostLoops = 60;
constexpr double wholeEnough = 1e-9;

double fraction(double x) noexcept {
    const double part = x - std::floor(x);
    return part < 1 ? part : 0;  // a tiny negative x rounds up to 1
}

bool divides(double period, double whole) noexcept {
    const double times = whole / period;
    return std::abs(times - std::round(times)) <= wholeEnough * times;
}

}  // namespace

double loopPeriod(std::span<const double> periods) noexcept {
    if (periods.empty()) return 0;
    const double longest = *std::max_element(periods.begin(), periods.end());
    for (int loops = 1; loops <= mostLoops; ++loops) {
        const double whole = longest * loops;
        const auto fits = [whole](double period) { return divides(period, whole); };
        if (std::all_of(periods.begin(), periods.end(), fits)) return whole;
    }
    return longest;
}

void Clock::anchorAt(double now) noexcept {
    anchorPhase_ = phase(now);
    anchorTime_ = now;
}

void Clock::setPeriod(double period, double now) noexcept {
    if (period == period_) return;
    anchorAt(now);
    period_ = std::max(0.0, period);
}

void Clock::play(double now) noexcept {
    anchorAt(now);
    playing_ = true;
}

void Clock::pause(double now) noexcept {
    anchorAt(now);
    playing_ = false;
}

void Clock::hold(bool held, double now) noexcept {
    anchorAt(now);
    held_ = held;
}

void Clock::setPhase(double phase, double now) noexcept {
    anchorPhase_ = std::isfinite(phase) ? fraction(phase) : 0;
    anchorTime_ = now;
}

double Clock::phase(double now) const noexcept {
    if (!running()) return anchorPhase_;
    return fraction(anchorPhase_ + (now - anchorTime_) / period_);
}

}  // namespace knotwork::app
