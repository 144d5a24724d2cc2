// The colours of views: what can be read, and what more contrast makes of other colours.
#include "ui/theme.hpp"

#include "drawing/palette.hpp"

#include <gtest/gtest.h>

#include <string>

namespace knotwork::ui {
namespace {

using drawing::contrastOf;
using drawing::withContrast;

constexpr ThemeName all[] = {ThemeName::light, ThemeName::dark, ThemeName::contrast,
                             ThemeName::contrastDark};
constexpr scene::Colour white{1, 1, 1, 1};
constexpr scene::Colour black{0, 0, 0, 1};

TEST(Contrast, IsThatOfTheGuidelines) {
    EXPECT_DOUBLE_EQ(contrastOf(white, black), 21);
    EXPECT_DOUBLE_EQ(contrastOf(black, white), 21);
    EXPECT_DOUBLE_EQ(contrastOf(white, white), 1);
    // #767676 is the lightest grey that may be read on white
    EXPECT_NEAR(contrastOf(scene::parseColour("#767676").value(), white), 4.54, 0.005);
}

TEST(Themes, CanBeRead) {
    for (const ThemeName name : all) {
        const Theme& colours = theme(name);
        EXPECT_EQ(colours.name, name);
        const bool clear = hasContrast(name);
        for (const scene::Colour& ground : {colours.background, colours.plotBackground}) {
            EXPECT_GE(contrastOf(colours.text, ground), clear ? 15 : 7);
            EXPECT_GE(contrastOf(colours.mutedText, ground), clear ? 7 : 4.5);
            EXPECT_GE(contrastOf(colours.accent, ground), clear ? 7 : 4.5);
            EXPECT_GE(contrastOf(colours.axis, ground), clear ? 4.5 : 2.8);
        }
        EXPECT_GE(contrastOf(colours.accentText, colours.accent), clear ? 7 : 4.5);
        EXPECT_EQ(isDark(name), contrastOf(colours.background, black) < 2);
    }
}

TEST(Themes, HaveTheNamesOfTheElement) {
    EXPECT_EQ(themeNamed("light"), ThemeName::light);
    EXPECT_EQ(themeNamed("dark"), ThemeName::dark);
    EXPECT_EQ(themeNamed("contrast"), ThemeName::contrast);
    EXPECT_EQ(themeNamed("contrast-dark"), ThemeName::contrastDark);
    EXPECT_EQ(themeNamed("any other"), ThemeName::light);
}

TEST(MoreContrast, IsReachedAndNoMoreThanThat) {
    for (const char* text : {"#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00",
                             "#cc79a7", "#888888", "#ffffff", "#000000"}) {
        scene::Colour colour = scene::parseColour(text).value();
        colour.alpha = 0.5;
        for (const scene::Colour& ground : {white, black}) {
            const scene::Colour made = withContrast(colour, ground, 4.5);
            EXPECT_GE(contrastOf(made, ground), 4.5) << text;
            EXPECT_EQ(made.alpha, 0.5) << text;
            if (contrastOf(colour, ground) >= 4.5) EXPECT_EQ(made, colour) << text;
            else EXPECT_LT(contrastOf(made, ground), 5) << text;
        }
    }
}

}  // namespace
}  // namespace knotwork::ui
