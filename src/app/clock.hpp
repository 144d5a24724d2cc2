// The clock of an animation: absolute page time to a phase in [0, 1).
//
// Nothing is accumulated: while it plays, the phase is that of an anchor and the time since then,
// so a day of playing is as exact as the first second. Whatever changes the run of the clock takes
// effect at the phase that was last shown and goes on from the next time it is told, so the
// animation never jumps, however long nobody asked.
#pragma once

#include <span>

namespace knotwork::app {

/// The shortest time after which effects with these periods all begin anew: a whole multiple (up to
/// 60) of the longest that every other one divides, else the longest. No periods: 0.
[[nodiscard]] double loopPeriod(std::span<const double> periods) noexcept;

class Clock {
public:
    /// Seconds of one loop; 0 stops the clock for good. The phase stays.
    void setPeriod(double period) noexcept;
    [[nodiscard]] double period() const noexcept { return period_; }

    void setPlaying(bool playing) noexcept;
    [[nodiscard]] bool playing() const noexcept { return playing_; }
    /// While held (during a drag) a playing clock stands still.
    void hold(bool held) noexcept;
    [[nodiscard]] bool running() const noexcept { return playing_ && !held_ && period_ > 0; }

    void setPhase(double phase) noexcept;
    [[nodiscard]] double phase() const noexcept { return phase_; }
    /// Tells the time, in seconds.
    void advance(double now) noexcept;

private:
    double period_ = 0;
    double phase_ = 0;
    double anchorTime_ = 0;
    double anchorPhase_ = 0;
    bool anchored_ = false;  ///< whether the clock has run since it was last changed
    bool playing_ = false;
    bool held_ = false;
};

}  // namespace knotwork::app
