#include "render/projection.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::render {
namespace {

constexpr Rect pane{40, 20, 600, 401};

void expectNear(const Vec3& actual, const Vec3& expected, double tolerance) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

TEST(Projection, TheCentreOfAFlatViewIsTheMiddleOfItsPane) {
    const auto projection = Projection::flat(pane, {3, -2, 0}, 0.01, 0.01);
    expectNear(projection.toPixels({3, -2, 0}), {340, 220.5, 0}, 0);
    expectNear(projection.toPane({3, -2, 0}), {0, 0, 0}, 0);
}

TEST(Projection, AFlatViewScalesXAndYIndependently) {
    const auto projection = Projection::flat(pane, {0, 0, 0}, 0.5, 0.02);
    expectNear(projection.toPixels({10, 1, 7}), {340 + 20, 220.5 + 50, 0}, 1e-10);
    expectNear(projection.unitsPerPixel(), {0.5, 0.02, 0}, 1e-12);
}

TEST(Projection, ABoxSpansItsPaneFromCornerToCorner) {
    const auto projection = Projection::spanning(pane, {-1, 4}, {0, 1});
    expectNear(projection.toPixels({-1, 0, 0}), {40, 20, 0}, 1e-10);
    expectNear(projection.toPixels({4, 1, 0}), {640, 421, 0}, 1e-10);
}

TEST(Projection, CssPixelsCountFromTheLowerLeftCornerOfThePane) {
    const auto projection = Projection::cssPixels(pane, 2);
    expectNear(projection.toPixels({0, 0, 0}), {40, 20, 0}, 1e-10);
    expectNear(projection.toPixels({10, 5, 0}), {60, 30, 0}, 1e-10);
}

TEST(Projection, PixelsGoBackToWhereTheyCameFrom) {
    const auto projection = Projection::flat(pane, {100, 200, 0}, 0.013, 0.7);
    const Vec3 world(101.5, 123.25, 0);
    expectNear(projection.fromPixels(projection.toPixels(world)), world, 1e-10);
}

TEST(Projection, AZoomByATrillionStillTellsNeighboursApart) {
    const Vec3 centre(1234.5, -987.25, 0);
    const auto projection = Projection::flat(pane, centre, 1e-12, 1e-12);
    const double step = std::ldexp(1.0, -39);  // representable beside both coordinates
    expectNear(projection.toPane(centre + Vec3(step, -step, 0)), {step / 1e-12, -step / 1e-12, 0},
               1e-9);
}

TEST(Projection, APerspectiveIsInvertedAndHasNoImageBehindTheEye) {
    const Vec3 centre(1, 2, 3);
    const glm::dmat4 clip = glm::perspective(1.0, 1.5, 0.1, 100.0) *
                            glm::lookAt(Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(0, 1, 0));
    const auto projection = Projection::general(pane, centre, clip);
    const Vec3 world = centre + Vec3(0.5, -0.25, 1);
    expectNear(projection.fromPixels(projection.toPixels(world)), world, 1e-9);
    EXPECT_FALSE(isFinite(projection.toPixels(centre + Vec3(0, 0, 6))));
}

TEST(Projection, APaneWithoutAreaDoesNotDivideByZero) {
    const auto projection = Projection::spanning({0, 0, 0, 0}, {0, 1}, {0, 1});
    EXPECT_TRUE(isFinite(projection.toPixels({0.3, 0.4, 0})));
    EXPECT_TRUE(isFinite(projection.fromPixels({1, 1, 0})));
}

TEST(Projection, AParallelOneTurnsTheWorldAndKnowsWhatIsNearer) {
    const Vec3 centre(4, 5, 6);
    const Mat3 fromTheRight(0, 0, 1, 1, 0, 0, 0, 1, 0);  // y to the right, z up, x to the eye
    const auto projection = Projection::parallel(pane, centre, fromTheRight, 0.5, 20);
    EXPECT_TRUE(projection.deep());
    expectNear(projection.toPane(centre), {0, 0, 0}, 1e-12);
    expectNear(projection.toPane(centre + Vec3(2, 3, -1)), {6, -2, -0.1}, 1e-12);
    expectNear(projection.fromPixels(projection.toPixels(centre + Vec3(2, 3, -1))),
               centre + Vec3(2, 3, -1), 1e-12);
    expectNear(projection.unitsPerPixel(), {0.5, 0.5, 0}, 1e-12);
}

TEST(Projection, ClipCoordinatesMayBeTakenFromAnyOrigin) {
    const Vec3 centre(4, 5, 6);
    const Vec3 origin(-1, 2, 8);
    const auto projection = Projection::parallel(pane, centre, Mat3(1.0), 0.5, 20);
    const glm::dvec4 clip = projection.clipFrom(origin) * glm::dvec4(3, 1, 2, 1);
    const Vec3 at = projection.toPane(origin + Vec3(3, 1, 2));
    expectNear({clip.x * 0.5 * pane.width, clip.y * 0.5 * pane.height, clip.z}, at, 1e-12);
    EXPECT_FALSE(Projection::flat(pane, centre, 1, 1).deep());
}

}  // namespace
}  // namespace knotwork::render
