#include "app/camera.hpp"

#include <gtest/gtest.h>

namespace knotwork::app {
namespace {

constexpr Box box{20, 10, 800, 400};

drawing::Bounds boundsOf(const Vec3& a, const Vec3& b) {
    drawing::Bounds bounds;
    bounds.min = a;
    bounds.max = b;
    bounds.empty = false;
    return bounds;
}

TEST(Camera, FitsBoundsIntoTheBoxWithAMargin) {
    const drawing::Bounds bounds = boundsOf({-3, 1, 0}, {5, 9, 0});
    const PlaneMap map = mapOf(fitAim(bounds, box), box);
    const Pixel low = map.toPixels(bounds.min);
    const Pixel high = map.toPixels(bounds.max);
    EXPECT_NEAR(high.y, box.y + 36, 1e-9);
    EXPECT_NEAR(low.y, box.bottom() - 36, 1e-9);
    EXPECT_NEAR((low.x + high.x) / 2, box.centre().x, 1e-9);
    EXPECT_GT(low.x, box.x);
    EXPECT_LT(high.x, box.right());
}

TEST(Camera, FitsAFlatExtentByTheOtherOne) {
    const Aim aim = fitAim(boundsOf({0, 2, 0}, {4, 2, 0}), box);
    EXPECT_NEAR(aim.scale, (800 - 72) / 4.0, 1e-9);
    EXPECT_EQ(aim.centre, Vec3(2, 2, 0));
}

TEST(Camera, ShowsASinglePointAndNothingAtAReadableScale) {
    EXPECT_NEAR(fitAim(boundsOf({7, 7, 0}, {7, 7, 0}), box).scale, 160, 1e-9);
    EXPECT_NEAR(fitAim({}, box).scale, 160, 1e-9);
}

TEST(Camera, ZoomKeepsTheWorldUnderThePointer) {
    Camera camera;
    camera.jump({{2, 3, 0}, 50});
    const Pixel pointer{613, 77};
    const Vec3 before = camera.map(box).fromPixels(pointer);
    camera.zoom(box, pointer, 3.5, false);
    EXPECT_NEAR(camera.aim().scale, 175, 1e-9);
    EXPECT_NEAR(glm::length(camera.map(box).fromPixels(pointer) - before), 0, 1e-12);
}

TEST(Camera, AGlidingZoomKeepsItTooAtEveryMoment) {
    Camera camera;
    camera.jump({{2, 3, 0}, 50});
    const Pixel pointer{613, 77};
    const Vec3 before = camera.map(box).fromPixels(pointer);
    camera.zoom(box, pointer, 4, true);
    EXPECT_EQ(camera.aim().scale, 50);
    int frames = 0;
    for (; camera.gliding() && frames < 200; ++frames) {
        camera.advance(1.0 / 60);
        EXPECT_NEAR(glm::length(camera.map(box).fromPixels(pointer) - before), 0, 1e-3);
    }
    EXPECT_LT(frames, 60);
    EXPECT_NEAR(camera.aim().scale, 200, 1e-9);
}

TEST(Camera, PanMovesTheWorldWithThePointer) {
    Camera camera;
    camera.jump({{0, 0, 0}, 40});
    const Pixel start{300, 200};
    const Vec3 grabbed = camera.map(box).fromPixels(start);
    camera.pan({35, -20});
    const Pixel end = camera.map(box).toPixels(grabbed);
    EXPECT_NEAR(end.x, 335, 1e-9);
    EXPECT_NEAR(end.y, 180, 1e-9);
}

TEST(Camera, AGlideEndsExactlyWhereItWasSent) {
    Camera camera;
    camera.jump({{0, 0, 0}, 10});
    const Aim goal{{100, -40, 0}, 10};
    camera.glide(goal);
    for (int frame = 0; frame < 100; ++frame) camera.advance(1.0 / 60);
    EXPECT_FALSE(camera.gliding());
    EXPECT_EQ(camera.aim(), goal);
}

TEST(Camera, ScalesStayFinite) {
    Camera camera;
    camera.jump({{1, 1, 0}, 1});
    for (int k = 0; k < 400; ++k) camera.zoom(box, {100, 100}, 10, false);
    EXPECT_EQ(camera.aim().scale, 1e12);
    EXPECT_TRUE(isFinite(camera.aim().centre));
}

}  // namespace
}  // namespace knotwork::app
