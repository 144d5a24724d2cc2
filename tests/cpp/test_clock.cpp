#include "app/clock.hpp"

#include <gtest/gtest.h>

#include <array>

namespace knotwork::app {
namespace {

Clock tenSeconds(double now) {
    Clock clock;
    clock.setPeriod(10, now);
    return clock;
}

TEST(Clock, StandsStillUntilItPlays) {
    const Clock clock = tenSeconds(100);
    EXPECT_EQ(clock.phase(104), 0);
    EXPECT_FALSE(clock.running());
}

TEST(Clock, PlaysFromWhereItStands) {
    Clock clock = tenSeconds(0);
    clock.setPhase(0.25, 50);
    clock.play(60);
    EXPECT_DOUBLE_EQ(clock.phase(62.5), 0.5);
}

TEST(Clock, PausesWithoutAJump) {
    Clock clock = tenSeconds(0);
    clock.play(0);
    clock.pause(3);
    EXPECT_DOUBLE_EQ(clock.phase(1000), 0.3);
    clock.play(2000);
    EXPECT_DOUBLE_EQ(clock.phase(2001), 0.4);
}

TEST(Clock, IsExactAfterAYearOfFrames) {
    Clock clock = tenSeconds(0);
    clock.play(0);
    const double year = 365.25 * 86400;  // a whole number of periods
    EXPECT_NEAR(clock.phase(year + 2.5), 0.25, 1e-8);
}

TEST(Clock, StandsStillWhileHeldAndGoesOnFromThere) {
    Clock clock = tenSeconds(0);
    clock.play(0);
    clock.hold(true, 2);
    EXPECT_DOUBLE_EQ(clock.phase(7), 0.2);
    EXPECT_TRUE(clock.playing());
    EXPECT_FALSE(clock.running());
    clock.hold(false, 9);
    EXPECT_DOUBLE_EQ(clock.phase(10), 0.3);
}

TEST(Clock, ANewPeriodKeepsThePhase) {
    Clock clock = tenSeconds(0);
    clock.play(0);
    clock.setPeriod(20, 5);
    EXPECT_DOUBLE_EQ(clock.phase(5), 0.5);
    EXPECT_DOUBLE_EQ(clock.phase(7), 0.6);
}

TEST(Clock, ThePhaseIsNeverOne) {
    Clock clock = tenSeconds(0);
    clock.setPhase(1, 0);
    EXPECT_EQ(clock.phase(0), 0);
    clock.setPhase(-1e-20, 0);
    EXPECT_EQ(clock.phase(0), 0);
    clock.setPhase(0, 0);
    clock.play(0);
    EXPECT_EQ(clock.phase(10), 0);
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
