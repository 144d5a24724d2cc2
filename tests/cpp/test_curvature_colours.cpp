#include "drawing/curvature_colours.hpp"
#include "drawing/palette.hpp"
#include "support/drawings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::drawing {
namespace {

/// A strip of triangles round a cylinder of radius 1, open at both ends.
Shape cylinder(std::size_t parts) {
    Shape shape;
    shape.kind = Kind::triangles;
    for (std::size_t i = 0; i < parts; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(parts);
        for (const double z : {0.0, 1.0}) {
            shape.positions.insert(shape.positions.end(), {std::cos(angle), std::sin(angle), z});
            shape.normals.insert(shape.normals.end(), {std::cos(angle), std::sin(angle), 0});
        }
        const auto a = static_cast<std::uint32_t>(2 * i);
        const auto b = static_cast<std::uint32_t>(2 * ((i + 1) % parts));
        shape.indices.insert(shape.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
    return shape;
}

TEST(CurvatureColours, ACylinderBendsOneWayOnly) {
    const Shape shape = cylinder(64);
    const CurvatureColours mean = curvatureColours(shape, scene::Colouring::mean);
    EXPECT_NEAR(mean.range, 0.5, 1e-3);
    ASSERT_EQ(mean.colours.size(), 128U);
    // negative: outward normals
    for (const ColourBytes& c : mean.colours) EXPECT_GT(c[2], c[0] + 100);
    const CurvatureColours gaussian = curvatureColours(shape, scene::Colouring::gaussian);
    EXPECT_EQ(gaussian.range, 0);
    for (const ColourBytes& c : gaussian.colours) EXPECT_EQ(c[0], c[2]);
}

TEST(CurvatureColours, ZeroIsGreyAndBothSidesAreEquallyFarFromIt) {
    const Colour zero = curvatureColour(0);
    EXPECT_EQ(zero.red, zero.green);
    EXPECT_EQ(zero.green, zero.blue);
    for (const double share : {0.25, 0.5, 1.0}) {
        EXPECT_NEAR(luminance(curvatureColour(-share)), luminance(curvatureColour(share)), 0.08);
    }
    EXPECT_EQ(curvatureColour(7), curvatureColour(1));
}

TEST(CurvatureColours, TheStyleOfASurfaceAsksForThem) {
    const Drawing drawing = test::drawn({R"({"id": "s", "type": "parametric-surface",
        "name": "torus", "style": {"colourBy": "gaussian", "opacity": 0.5}})"});
    const auto surfaces = test::withRole(drawing, Role::surface);
    ASSERT_EQ(surfaces.size(), 1U);
    EXPECT_EQ(surfaces[0]->colours.size(), surfaces[0]->positions.size() / 3);
    EXPECT_GT(surfaces[0]->range, 0);
    EXPECT_EQ(surfaces[0]->colour.alpha, 0.5);
    EXPECT_NE(surfaces[0]->identity, nullptr);
}

}  // namespace
}  // namespace knotwork::drawing
