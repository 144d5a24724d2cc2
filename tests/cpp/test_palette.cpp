#include "drawing/palette.hpp"

#include <gtest/gtest.h>

namespace knotwork::drawing {
namespace {

constexpr std::size_t cycleLength = 8;

TEST(Palette, TheCycleStandsOutFromItsGround) {
    constexpr double light = 0.92;  // of the plots' grounds
    constexpr double dark = 0.011;
    for (std::size_t i = 0; i < cycleLength; ++i) {
        EXPECT_GE((light + 0.05) / (luminance(cycleColour(i, false)) + 0.05), 3) << i;
        EXPECT_GE((luminance(cycleColour(i, true)) + 0.05) / (dark + 0.05), 3) << i;
    }
    EXPECT_EQ(cycleColour(cycleLength, false), cycleColour(0, false));
}

TEST(Palette, AnOpacityOutlastsTheThemeAndLinesOnAVeilAreWhole) {
    const Colour veil{0, 0, 0.2, 0.25};
    EXPECT_EQ(objectColour(Role::surface, veil, true)->alpha, 0.25);
    EXPECT_EQ(objectColour(Role::surface, veil, false)->alpha, 0.25);
    EXPECT_EQ(objectColour(Role::isoline, veil, false)->alpha, 1);
}

}  // namespace
}  // namespace knotwork::drawing
