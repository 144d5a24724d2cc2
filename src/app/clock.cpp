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

void Clock::setPeriod(double period) noexcept {
    if (period == period_) return;
    period_ = std::max(0.0, period);
    anchored_ = false;
}

void Clock::setPlaying(bool playing) noexcept {
    if (playing == playing_) return;
    playing_ = playing;
    anchored_ = false;
}

void Clock::hold(bool held) noexcept {
    if (held == held_) return;
    held_ = held;
    anchored_ = false;
}

void Clock::setPhase(double phase) noexcept {
    phase_ = std::isfinite(phase) ? fraction(phase) : 0;
    anchored_ = false;
}

void Clock::advance(double now) noexcept {
    if (!running()) return;
    if (!anchored_) {
        anchorTime_ = now;
        anchorPhase_ = phase_;
        anchored_ = true;
    }
    phase_ = fraction(anchorPhase_ + (now - anchorTime_) / period_);
}

}  // namespace knotwork::app
