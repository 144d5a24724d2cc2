// Views of scenes in space: turning, taking hold, dragging.
#include "app/hit.hpp"
#include "drawing/svg.hpp"
#include "support/playground.hpp"

#include <cmath>
#include <cstdlib>

namespace knotwork::app {
namespace {

constexpr const char* net = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"n",
    "type":"bspline-surface","degree":[2,2],"points":[[[0,0,0],[0,1,0],[0,2,0]],
    [[1,0,0],[1,1,2],[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]],
    "show":{"points":true,"polygon":true}}]})";
constexpr const char* cube = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"m",
    "type":"subdivision-surface","scheme":"catmull-clark","levels":1,
    "mesh":{"vertices":[[-1,-1,-1],[1,-1,-1],[-1,1,-1],[1,1,-1],[-1,-1,1],[1,-1,1],[-1,1,1],
    [1,1,1]],"faces":[[0,2,3,1],[4,5,7,6],[0,1,5,4],[2,6,7,3],[0,4,6,2],[1,3,7,5]]},
    "show":{"points":true}}]})";
constexpr const char* patches = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"p",
    "type":"blending-surface","bFunction":{"family":"expo-rational"},
    "model":{"type":"parametric-surface","name":"cylinder"},"locals":[6,4],"kind":"sub-surface",
    "show":{"handles":true}}]})";
constexpr const char* helix = R"({"knotwork":1,"objects":[
    {"id":"h","type":"parametric-curve","name":"helix"}]})";

const Sight& sightIn(Playground& play) { return play.view.figure()->find(Pane::curve)->sight; }

Vec3 pointAtPath(Playground& play, const char* path) {
    const Json& p = play.at(path);
    return {p[0].get<double>(), p[1].get<double>(), p.size() > 2 ? p[2].get<double>() : 0.0};
}

/// A place where nothing can be taken hold of.
constexpr Pixel nowhere{30, 30};

TEST(Space, WhatHasDepthIsSeenInSpaceAndAPlaneFromAbove) {
    EXPECT_TRUE(Playground(helix).view.spatial());
    EXPECT_TRUE(Playground(net).view.spatial());
    Playground flat(spline);
    EXPECT_FALSE(flat.view.spatial());
    EXPECT_TRUE(sightIn(flat).flat());
}

TEST(Space, APlaneSceneThatIsGivenDepthIsTurnedUntilThatIsUndone) {
    Playground play(R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve","degree":2,
        "points":[[0,0,0],[1,2,0],[3,2,0],[4,0,0]]}]})");
    EXPECT_TRUE(sightIn(play).flat());
    ASSERT_TRUE(play.scene->execute(Json{{"move", "objects[0].points[1]"}, {"by", {0, 0, 1}}}));
    EXPECT_FALSE(sightIn(play).flat());
    ASSERT_TRUE(play.scene->undo());
    EXPECT_TRUE(sightIn(play).flat());
}

TEST(Space, TheExportedPictureIsSeenFromTheSamePlace) {
    for (const char* document : {net, helix, spline}) {
        Playground play(document);
        const std::string svg = drawing::svg(play.scene->state(), {});
        const std::size_t at = svg.find("data-matrix=\"");
        ASSERT_NE(at, std::string::npos);
        const char* text = svg.c_str() + at + 13;
        double m[4];
        for (double& number : m) {
            char* end = nullptr;
            number = std::strtod(text, &end);
            text = end;
        }
        const Pixel x = sightIn(play).pixelVector({1, 0, 0});
        const Pixel y = sightIn(play).pixelVector({0, 1, 0});
        const double ratio = std::hypot(x.x, y.x) / std::hypot(m[0], m[2]);
        EXPECT_NEAR(x.x, ratio * m[0], 1e-6);
        EXPECT_NEAR(x.y, ratio * m[1], 1e-6);
        EXPECT_NEAR(y.x, ratio * m[2], 1e-6);
        EXPECT_NEAR(y.y, ratio * m[3], 1e-6);
    }
}

TEST(Space, ANetPointIsDraggedInThePlaneOfTheScreen) {
    Playground play(net);
    const char* path = "objects[0].points[2][0]";
    const Pixel from = play.pixelOf(path);
    const double depth = sightIn(play).nearness(pointAtPath(play, path));
    play.drag({from.x + 4, from.y - 3}, {from.x + 74, from.y + 42});
    const Vec3 now = pointAtPath(play, path);
    EXPECT_NE(now, Vec3(2, 0, 0));
    EXPECT_NEAR(sightIn(play).toPixels(now).x, from.x + 70, 1);
    EXPECT_NEAR(sightIn(play).toPixels(now).y, from.y + 45, 1);
    EXPECT_NEAR(sightIn(play).nearness(now), depth, 1);
    ASSERT_TRUE(play.scene->undo());
    EXPECT_EQ(pointAtPath(play, path), Vec3(2, 0, 0));
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Space, EscapePutsANetPointBackAndComingBackLeavesNoDrift) {
    Playground play(net);
    const Json before = play.scene->document();
    const Pixel from = play.pixelOf("objects[0].points[2][0]");
    play.event("down", from, 1);
    play.event("move", {from.x + 60, from.y + 31}, 1);
    EXPECT_NE(play.scene->document(), before);
    play.event("move", from, 1);
    EXPECT_EQ(play.scene->document(), before);
    play.event("move", {from.x + 60, from.y + 31}, 1);
    EXPECT_TRUE(play.view.key("Escape", true, 0));
    EXPECT_EQ(play.scene->document(), before);
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Space, ShiftKeepsADragOnTheAxisThatIsSeenNearest) {
    const char* path = "objects[0].points[2][0]";
    for (int axis = 0; axis < 3; ++axis) {
        Playground play(net);
        const Pixel from = play.pixelOf(path);
        Vec3 along{0.0};
        along[axis] = 1;
        const Pixel seen = sightIn(play).pixelVector(along);
        const Pixel across{-seen.y * 0.15, seen.x * 0.15};
        play.drag(from, {from.x + seen.x + across.x, from.y + seen.y + across.y}, shiftKey);
        const Vec3 by = pointAtPath(play, path) - Vec3(2, 0, 0);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(by[k], k == axis ? 1 : 0, k == axis ? play.unitsPerPixel() : 0);
        }
    }
}

TEST(Space, CtrlSnapsToTheGrid) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].points[2]");
    play.drag(from, {from.x + 83, from.y + 47}, commandKey);
    const double step = ui::planeGridStep(1 / play.unitsPerPixel());
    for (int k = 0; k < 2; ++k) {
        const double cells = play.at("objects[0].points[2]")[static_cast<std::size_t>(k)].get<double>() / step;
        EXPECT_NEAR(cells, std::round(cells), 1e-9);
    }
    EXPECT_NE(play.at("objects[0].points[2]"), (Json::array({-1, 2})));
}

TEST(Space, AVertexOfAMeshIsDragged) {
    Playground play(cube);
    const Pixel from = play.pixelOf("objects[0].mesh.vertices[5]");
    play.drag(from, {from.x + 40, from.y - 25});
    EXPECT_NE(pointAtPath(play, "objects[0].mesh.vertices[5]"), Vec3(1, -1, 1));
    const Pixel now = play.pixelOf("objects[0].mesh.vertices[5]");
    EXPECT_NEAR(now.x, from.x + 40, 1);
    EXPECT_NEAR(now.y, from.y - 25, 1);
}

TEST(Space, APatchIsDraggedByItsHandle) {
    Playground play(patches);
    const auto* surface = play.scene->state().objects[0]->body.as<BlendingSurface>();
    // In front, as seen from the default viewpoint.
    const std::size_t k = 5 * surface->alongV().count + 2;
    const std::string path = "objects[0].poses[" + std::to_string(k) + "]";
    const Pixel from = play.pixelOf(path);
    play.drag(from, {from.x + 30, from.y + 18});
    const Json& pose = play.at("objects[0].poses")[0];
    EXPECT_EQ(pose["local"], (Json::array({5, 2})));
    const Pixel now = play.pixelOf(path);
    EXPECT_NEAR(now.x, from.x + 30, 1);
    EXPECT_NEAR(now.y, from.y + 18, 1);
}

TEST(Space, APointOfTwoCoordinatesStaysInItsPlane) {
    Playground play(R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"s",
        "type":"bspline-curve","degree":2,"points":[[0,0],[1,2],[3,2],[4,0]]}]})");
    const Pixel from = play.pixelOf("objects[0].points[1]");
    play.drag(from, {from.x + 50, from.y + 20});
    EXPECT_EQ(play.at("objects[0].points[1]").size(), 2u);
    const Pixel now = play.pixelOf("objects[0].points[1]");
    EXPECT_NEAR(now.x, from.x + 50, 1);
    EXPECT_NEAR(now.y, from.y + 20, 1);
}

TEST(Space, OfTwoPointsBehindEachOtherTheOneInFrontIsTaken) {
    Playground play(cube);
    play.view.key("1", true, 0);  // from the front: corners 0 and 2 are one behind the other
    const Pixel at = play.pixelOf("objects[0].mesh.vertices[2]");
    const auto hit = targetAt(*play.view.figure(), at, 12);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->path(), "objects[0].mesh.vertices[0]");
}

TEST(Space, AHiddenPointIsReachedAloneButLosesAgainstAVisibleOne) {
    Playground play(R"({"knotwork":1,"view":{"mode":"3d"},"objects":[
        {"id":"wall","type":"parametric-surface","name":"plane",
         "parameters":{"width":4,"height":4}},
        {"id":"s","type":"bspline-curve","degree":2,
         "points":[[1,1,-2],[2,3,-2],[3,1,-2],[1.05,1,1]],"show":{"polygon":false}}]})");
    play.view.key("7", true, 0);
    const Figure* figure = play.view.figure();
    const Sight& sight = sightIn(play);
    const auto alone = targetAt(*figure, sight.toPixels({2, 3, -2}), 12);
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->path(), "objects[1].points[1]");
    const auto contested = targetAt(*figure, sight.toPixels({1, 1, -2}), 12);
    ASSERT_TRUE(contested);
    EXPECT_EQ(contested->path(), "objects[1].points[3]");
}

TEST(Orbit, ADragOfNothingTurnsWhatIsSeenAndNotTheDocument) {
    Playground play(net);
    const Json before = play.scene->document();
    const Viewpoint was = play.view.camera().aim().from;
    play.drag(nowhere, {nowhere.x + 100, nowhere.y + 20});
    const Viewpoint now = play.view.camera().aim().from;
    EXPECT_NEAR(now.azimuth, was.azimuth - 0.75, 1e-12);
    EXPECT_NEAR(now.elevation, was.elevation + 0.15, 1e-12);
    EXPECT_EQ(play.scene->document(), before);
}

TEST(Orbit, TheOtherButtonsMoveThePicture) {
    const auto panned = [](int buttons) {
        Playground play(net);
        const Aim was = play.view.camera().aim();
        const Vec3 there = sightIn(play).fromPixels(nowhere, was.centre);
        play.event("down", nowhere, buttons);
        play.event("move", {nowhere.x + 90, nowhere.y + 40}, buttons);
        play.event("up", {nowhere.x + 90, nowhere.y + 40}, 0);
        EXPECT_EQ(play.view.camera().aim().from, was.from);
        const Pixel now = sightIn(play).toPixels(there);
        return std::hypot(now.x - nowhere.x - 90, now.y - nowhere.y - 40);
    };
    EXPECT_NEAR(panned(2), 0, 1e-9);
    EXPECT_NEAR(panned(4), 0, 1e-9);
}

TEST(Orbit, AFingerAcrossTurnsAndTwoFingersMoveAndZoom) {
    Playground play(net);
    const Viewpoint was = play.view.camera().aim().from;
    EXPECT_TRUE(play.event("down", nowhere, 1, 0, "touch"));
    play.event("move", {nowhere.x + 60, nowhere.y}, 1, 0, "touch");
    EXPECT_NE(play.view.camera().aim().from, was);
    play.event("cancel", {nowhere.x + 60, nowhere.y}, 0, 0, "touch");
    const Aim turned = play.view.camera().aim();
    play.event("down", nowhere, 1, 0, "touch");
    play.event("move", {nowhere.x + 5, nowhere.y + 60}, 1, 0, "touch");
    EXPECT_EQ(play.view.camera().aim(), turned);
    play.event("cancel", {nowhere.x + 5, nowhere.y + 60}, 0, 0, "touch");
    const Pixel between{300, 200};
    const Vec3 there = sightIn(play).fromPixels(between, play.view.camera().aim().centre);
    const double scale = play.view.camera().aim().scale;
    EXPECT_TRUE(play.view.pinch({320, 190}, {20, -10}, 1.5));
    EXPECT_NEAR(play.view.camera().aim().scale, 1.5 * scale, 1e-9);
    EXPECT_NEAR(sightIn(play).toPixels(there).x, 320, 1e-9);
    EXPECT_NEAR(sightIn(play).toPixels(there).y, 190, 1e-9);
}

TEST(Orbit, ArrowsTurnWhereNothingIsSelectedAndDigitsAreStandardViews) {
    Playground play(net);
    const Viewpoint home = play.view.camera().aim().from;
    EXPECT_TRUE(play.view.key("ArrowRight", true, 0));
    EXPECT_LT(play.view.camera().aim().from.azimuth, home.azimuth);
    EXPECT_TRUE(play.view.key("1", true, 0));
    EXPECT_EQ(play.view.camera().aim().from, fromFront);
    EXPECT_TRUE(play.view.key("3", true, 0));
    EXPECT_EQ(play.view.camera().aim().from, fromSide);
    EXPECT_TRUE(play.view.key("7", true, 0));
    EXPECT_EQ(play.view.camera().aim().from, fromAbove);
    EXPECT_TRUE(play.view.key("0", true, 0));
    play.view.figure();
    EXPECT_EQ(play.view.camera().aim().from, home);
    Playground plane(spline);
    EXPECT_FALSE(plane.view.key("ArrowRight", true, 0));
    EXPECT_FALSE(plane.view.key("1", true, 0));
}

TEST(Orbit, ArrowsMoveASelectedPointAlongTheScreen) {
    Playground play(net);
    const char* path = "objects[0].points[1][1]";
    const Pixel before = play.pixelOf(path);
    EXPECT_TRUE(play.view.key("ArrowUp", true, 0));
    EXPECT_TRUE(play.view.key("ArrowUp", false, 0));
    const Pixel now = play.pixelOf(path);
    EXPECT_NEAR(now.x, before.x, 0.1);
    EXPECT_LT(now.y, before.y - 1);
}

TEST(Orbit, PageDownGoesFromRowToRowOfANet) {
    Playground play(net);
    play.pixelOf("objects[0].points[0][2]");
    EXPECT_TRUE(play.view.key("PageDown", true, 0));
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[1][0]");
    EXPECT_TRUE(play.view.key("PageUp", true, 0));
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[0][2]");
}

}  // namespace
}  // namespace knotwork::app
