#include "app/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// In space

constexpr Viewpoint oblique{-0.95, 0.45};
constexpr Pixel middle{420, 210};  // of the box

TEST(CameraInSpace, StandardViewsHaveTheirAxesWhereTextbooksHaveThem) {
    const auto seen = [](const Viewpoint& from, const Vec3& v) {
        return sightOf({Vec3(0.0), 1, from}, box).pixelVector(v);
    };
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    EXPECT_NEAR(seen(fromFront, x).x, 1, 1e-15);
    EXPECT_NEAR(seen(fromFront, z).y, -1, 1e-15);
    EXPECT_NEAR(seen(fromSide, y).x, 1, 1e-15);
    EXPECT_NEAR(seen(fromSide, z).y, -1, 1e-15);
    EXPECT_EQ(orientationOf(fromAbove), Orientation(1.0));
    for (const Vec3& axis : {x, y, z}) {
        const Pixel p = seen(fromCorner, axis);
        EXPECT_NEAR(std::hypot(p.x, p.y), std::sqrt(2.0 / 3), 1e-15);
    }
}

TEST(CameraInSpace, OrbitTurnsWhatIsInFrontWithTheHandAndKeepsTheTarget) {
    Camera camera;
    camera.jump({{1, 2, 3}, 50, oblique});
    const Vec3 front = Vec3(1, 2, 3) + camera.sight(box).towardsEye();
    camera.orbit({40, 24}, false);
    const Sight sight = camera.sight(box);
    EXPECT_NEAR(sight.toPixels({1, 2, 3}).x, middle.x, 1e-10);
    EXPECT_NEAR(sight.toPixels({1, 2, 3}).y, middle.y, 1e-10);
    EXPECT_GT(sight.toPixels(front).x, middle.x + 5);
    EXPECT_GT(sight.toPixels(front).y, middle.y + 5);
    EXPECT_NEAR(sight.pixelVector({0, 0, 1}).x, 0, 1e-12);  // up stays up
}

TEST(CameraInSpace, OrbitStopsStraightAboveAndBelow) {
    Camera camera;
    camera.jump({{0, 0, 0}, 50, oblique});
    camera.orbit({0, 5000}, false);
    EXPECT_EQ(camera.aim().from.elevation, fromAbove.elevation);
    camera.orbit({0, -9000}, false);
    EXPECT_EQ(camera.aim().from.elevation, -fromAbove.elevation);
}

TEST(CameraInSpace, AHandStopsAGlideAndKeysAddUp) {
    Camera camera;
    camera.jump({{0, 0, 0}, 50, oblique});
    camera.orbit({100, 0}, true);
    camera.orbit({100, 0}, true);
    for (int frame = 0; frame < 100; ++frame) camera.advance(1.0 / 60);
    EXPECT_NEAR(camera.aim().from.azimuth, oblique.azimuth - 1.5, 1e-12);
    camera.orbit({100, 0}, true);
    camera.advance(1.0 / 60);
    const double reached = camera.aim().from.azimuth;
    camera.orbit({0, 1}, false);
    EXPECT_FALSE(camera.gliding());
    EXPECT_EQ(camera.aim().from.azimuth, reached);
}

TEST(CameraInSpace, AGlideTakesTheShorterWayRoundAndEndsExactly) {
    Camera camera;
    camera.jump({{0, 0, 0}, 10, {3.0 + 4 * 3.141592653589793, 0.2}});
    const Aim goal{{1, 0, 2}, 20, {-3.0, -0.3}};
    camera.glide(goal);
    double turned = 0;
    double last = camera.aim().from.azimuth;
    for (int frame = 0; frame < 100; ++frame) {
        camera.advance(1.0 / 60);
        turned += std::abs(camera.aim().from.azimuth - last);
        last = camera.aim().from.azimuth;
    }
    EXPECT_EQ(camera.aim(), goal);
    EXPECT_NEAR(turned, 2 * 3.141592653589793 - 6, 1e-9);
}

TEST(CameraInSpace, ZoomAndPanStayUnderThePointer) {
    Camera camera;
    camera.jump({{2, 3, -1}, 50, oblique});
    const Pixel pointer{613, 77};
    const Vec3 grabbed = camera.sight(box).fromPixels(pointer, camera.aim().centre);
    camera.zoom(box, pointer, 3.5, false);
    EXPECT_NEAR(camera.sight(box).toPixels(grabbed).x, pointer.x, 1e-9);
    EXPECT_NEAR(camera.sight(box).toPixels(grabbed).y, pointer.y, 1e-9);
    const double depth = glm::dot(camera.sight(box).towardsEye(), camera.aim().centre);
    camera.pan({35, -20});
    EXPECT_NEAR(camera.sight(box).toPixels(grabbed).x, pointer.x + 35, 1e-9);
    EXPECT_NEAR(camera.sight(box).toPixels(grabbed).y, pointer.y - 20, 1e-9);
    EXPECT_NEAR(glm::dot(camera.sight(box).towardsEye(), camera.aim().centre), depth, 1e-12);
}

TEST(CameraInSpace, FitsWhatIsSeenIntoTheBox) {
    const Orientation turned = orientationOf(oblique);
    drawing::Bounds seen;
    const Vec3 corners[] = {{0, 0, 0}, {5, 0, 0}, {0, 3, 0}, {0, 0, 2}};
    for (const Vec3& corner : corners) seen.add(turned * corner);
    const Sight sight = sightOf(fitAim(seen, box, oblique), box);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Vec3& corner : corners) {
        const Pixel p = sight.toPixels(corner);
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    EXPECT_NEAR(left + right, 2 * middle.x, 1e-9);
    EXPECT_NEAR(top + bottom, 2 * middle.y, 1e-9);
    EXPECT_NEAR(std::min(left - box.x, top - box.y), 36, 1e-9);
}

}  // namespace
}  // namespace knotwork::app
