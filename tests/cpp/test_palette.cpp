// The cycle of colours as people with and without all kinds of cones see it, and what opacity does.
#include "drawing/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {
namespace {

constexpr std::size_t cycleLength = 8;

/// Linear sRGB in, linear sRGB out.
struct Vision {
    const char* name;
    std::array<double, 9> matrix;
};

// G. Machado, M. Oliveira, L. Fernandes, A physiologically-based model for simulation of color
// vision deficiency, 2009, severity 1.
constexpr std::array visions{
    Vision{"all cones", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    Vision{"protanopia",
           {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
            1.051998}},
    Vision{"deuteranopia",
           {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
            0.968881}},
    Vision{"tritanopia",
           {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
            0.303900}},
};

Vec3 oklab(const Colour& colour, const Vision& vision) {
    const std::array<double, 3> rgb{scene::linearLight(colour.red), scene::linearLight(colour.green),
                                    scene::linearLight(colour.blue)};
    std::array<double, 3> seen{};
    for (std::size_t i = 0; i < 9; ++i) seen[i / 3] += vision.matrix[i] * rgb[i % 3];
    for (double& c : seen) c = std::clamp(c, 0.0, 1.0);
    const auto [r, g, b] = seen;
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(Palette, NeighboursInTheCycleAreToldApartByEveryone) {
    for (const Vision& vision : visions) {
        for (const bool dark : {false, true}) {
            for (std::size_t i = 0; i < cycleLength; ++i) {
                EXPECT_GE(glm::distance(oklab(cycleColour(i, dark), vision),
                                        oklab(cycleColour(i + 1, dark), vision)),
                          0.09)
                    << vision.name << ' ' << dark << ' ' << i;
            }
        }
    }
}

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
