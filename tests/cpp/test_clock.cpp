#include "app/clock.hpp"

#include <gtest/gtest.h>

#include <array>

namespace knotwork::app {
namespace {

Clock playingTenSeconds(double now) {
    Clock clock;
    clock.setPeriod(10);
    clock.setPlaying(true);
    clock.advance(now);
    return clock;
}

double phaseAt(Clock& clock, double now) {
    clock.advance(now);
    return clock.phase();
}

TEST(Clock, StandsStillUntilItPlays) {
    Clock clock;
    clock.setPeriod(10);
    EXPECT_EQ(phaseAt(clock, 104), 0);
    EXPECT_FALSE(clock.running());
}

TEST(Clock, PlaysFromWhereItStands) {
    Clock clock = playingTenSeconds(40);
    clock.setPhase(0.25);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 60), 0.25);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 62.5), 0.5);
}

TEST(Clock, PausesAndGoesOnWithoutAJump) {
    Clock clock = playingTenSeconds(0);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 3), 0.3);
    clock.setPlaying(false);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 1000), 0.3);
    clock.setPlaying(true);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 2000), 0.3);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 2001), 0.4);
}

TEST(Clock, IsExactAfterAYearOfFrames) {
    Clock clock = playingTenSeconds(0);
    const double year = 365.25 * 86400;  // a whole number of periods
    for (double now = 0; now < year; now += 7919.7) clock.advance(now);
    EXPECT_NEAR(phaseAt(clock, year + 2.5), 0.25, 1e-8);
}

TEST(Clock, StandsStillWhileHeldAndGoesOnFromThere) {
    Clock clock = playingTenSeconds(0);
    clock.advance(2);
    clock.hold(true);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 7), 0.2);
    EXPECT_TRUE(clock.playing());
    EXPECT_FALSE(clock.running());
    clock.hold(false);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 9), 0.2);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 10), 0.3);
}

TEST(Clock, ANewPeriodKeepsThePhase) {
    Clock clock = playingTenSeconds(0);
    clock.advance(5);
    clock.setPeriod(20);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 6), 0.5);
    EXPECT_DOUBLE_EQ(phaseAt(clock, 8), 0.6);
}

TEST(Clock, ThePhaseIsNeverOne) {
    Clock clock;
    clock.setPhase(1);
    EXPECT_EQ(clock.phase(), 0);
    clock.setPhase(-1e-20);
    EXPECT_EQ(clock.phase(), 0);
    Clock playing = playingTenSeconds(0);
    EXPECT_EQ(phaseAt(playing, 10), 0);
}

TEST(LoopPeriod, IsTheShortestThatAllPeriodsDivide) {
    EXPECT_EQ(loopPeriod({}), 0);
    EXPECT_EQ(loopPeriod(std::array{10.0, 10.0}), 10);
    EXPECT_EQ(loopPeriod(std::array{10.0, 5.0, 2.5}), 10);
    EXPECT_EQ(loopPeriod(std::array{4.0, 6.0}), 12);
    EXPECT_NEAR(loopPeriod(std::array{0.1, 0.3}), 0.3, 1e-15);
}

TEST(LoopPeriod, IsTheLongestWhereNoneFits) {
    EXPECT_EQ(loopPeriod(std::array{1.0, 3.14159265}), 3.14159265);
}

}  // namespace
}  // namespace knotwork::app
