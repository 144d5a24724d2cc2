// Drags of points, knots and local curves.
#include "support/playground.hpp"

#include <cmath>

namespace knotwork::app {
namespace {

TEST(Drag, AMovedPointEndsWhereThePointerLeftIt) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].points[2]");
    // Pressed off its middle: it must not jump to the pointer.
    play.drag({from.x + 5, from.y - 4}, {from.x + 85, from.y + 36});
    EXPECT_NEAR(play.at("objects[0].points[2]")[0].get<double>(), -1 + 80 * play.unitsPerPixel(),
                play.unitsPerPixel() / 2);
    EXPECT_NEAR(play.at("objects[0].points[2]")[1].get<double>(), 2 - 40 * play.unitsPerPixel(),
                play.unitsPerPixel() / 2);
    EXPECT_EQ(play.at("objects[0].points[2]").size(), 2u);
}

TEST(Drag, IsOneStepOfHistory) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].points[2]");
    play.drag(from, {from.x + 80, from.y + 40});
    ASSERT_TRUE(play.scene->undo());
    EXPECT_EQ(play.at("objects[0].points[2]"), (Json::array({-1, 2})));
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Drag, ComingBackLeavesNoDrift) {
    Playground play(spline);
    const Json before = play.scene->document();
    const Pixel from = play.pixelOf("objects[0].points[1]");
    play.event("down", from, 1);
    for (int k = 0; k < 500; ++k) {
        play.event("move", {from.x + 100 * std::sin(k * 0.7), from.y + k % 37}, 1);
    }
    play.event("move", from, 1);
    play.event("up", from, 0);
    EXPECT_EQ(play.scene->document(), before);
}

TEST(Drag, EscapePutsItBack) {
    Playground play(spline);
    const Json before = play.scene->document();
    const Pixel from = play.pixelOf("objects[0].points[3]");
    play.event("down", from, 1);
    play.event("move", {from.x + 60, from.y}, 1);
    EXPECT_NE(play.scene->document(), before);
    EXPECT_TRUE(play.view.key("Escape", true, 0));
    EXPECT_EQ(play.scene->document(), before);
    play.event("move", {from.x + 90, from.y}, 1);
    play.event("up", {from.x + 90, from.y}, 0);
    EXPECT_EQ(play.scene->document(), before);
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Drag, ReportsInputsAndThenOneChange) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].points[3]");
    EXPECT_EQ(play.view.editor().takeEvents(), "[]");
    play.drag(from, {from.x + 60, from.y});
    const auto events = scene::parseJson(play.view.editor().takeEvents());
    ASSERT_TRUE(events.ok());
    ASSERT_GE(events->size(), 2u);
    for (std::size_t k = 0; k + 1 < events->size(); ++k) EXPECT_EQ((*events)[k]["type"], "input");
    EXPECT_EQ(events->back()["type"], "change");
    EXPECT_EQ(events->back()["path"], "objects[0].points[3]");
    EXPECT_EQ(events->back()["source"], "pointer");
    EXPECT_EQ(events->back()["command"]["move"], "objects[0].points[3]");
}

TEST(Drag, ShiftKeepsItOnOneAxis) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].points[2]");
    play.drag(from, {from.x + 80, from.y + 11}, shiftKey);
    EXPECT_EQ(play.at("objects[0].points[2]")[1], 2);
    EXPECT_NE(play.at("objects[0].points[2]")[0], -1);
}

TEST(Drag, AKnotStopsAtItsNeighbours) {
    Playground play(spline);
    const Pixel from = play.pixelOf("objects[0].knots[4]");
    play.drag(from, {from.x + 5000, from.y});
    EXPECT_EQ(play.at("objects[0].knots[4]"), play.at("objects[0].knots[5]"));
}

TEST(Drag, OfAPileTheKnotOnTheSideOfTheMoveGoes) {
    Playground play(R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve","degree":3,
        "points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]],"knots":[0,0,0,0,1,1,2,2,2,2]}]})");
    const Pixel pile = play.pixelOf("objects[0].knots[4]");
    const double unit = play.view.figure()->find(Pane::knots)->plot.map.scaleX;
    play.drag(pile, {pile.x + 0.5 * unit, pile.y});
    EXPECT_EQ(play.at("objects[0].knots[4]"), 1);
    EXPECT_NEAR(play.at("objects[0].knots[5]").get<double>(), 1.5, 0.01);
    ASSERT_TRUE(play.scene->undo());
    // To the right and, in the same drag, to the left: the right one goes back to the pile.
    play.event("down", pile, 1);
    play.event("move", {pile.x + 0.5 * unit, pile.y}, 1);
    play.event("move", {pile.x - 0.5 * unit, pile.y}, 1);
    play.event("up", {pile.x - 0.5 * unit, pile.y}, 0);
    EXPECT_NEAR(play.at("objects[0].knots[4]").get<double>(), 0.5, 0.01);
    EXPECT_EQ(play.at("objects[0].knots[5]"), 1);
}

TEST(Drag, TheKnotAxisStaysUnderTheDraggedKnot) {
    Playground play(R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve","degree":2,
        "form":"open","points":[[0,0],[1,2],[3,2],[4,0]]}]})");
    const Pixel from = play.pixelOf("objects[0].knots[6]");
    const Interval range = play.view.figure()->axis.range;
    play.event("down", from, 1);
    play.event("move", {from.x - 30, from.y}, 1);
    EXPECT_EQ(play.view.figure()->axis.range, range);
    const PlaneMap map = play.view.figure()->find(Pane::knots)->plot.map;
    EXPECT_NEAR(map.pixelX(play.at("objects[0].knots[6]").get<double>()), from.x - 30, 1);
}

TEST(Drag, AHandleMovesItsLocalCurveAlsoWhenEffectsHaveTurnedIt) {
    Playground play(blend);
    play.view.clock().setPhase(0.5);  // a quarter turn
    play.view.touch();
    const Pixel from = play.pixelOf("objects[0].poses[1]");
    play.drag(from, {from.x + 50, from.y});
    const auto* curve = play.scene->state().objects[0]->body.as<BlendingCurve>();
    const Vec3 moved = curve->locals()[1].pose().translate;
    EXPECT_NEAR(moved.x, 0, play.unitsPerPixel());
    EXPECT_NEAR(moved.y, -50 * play.unitsPerPixel(), play.unitsPerPixel());
    const Pixel now = play.pixelOf("objects[0].poses[1]");
    EXPECT_NEAR(now.x, from.x + 50, 1.01);
    EXPECT_NEAR(now.y, from.y, 1.01);
}

TEST(Drag, ShiftTurnsALocalCurveAndAltScalesIt) {
    Playground play(blend);
    const Pixel from = play.pixelOf("objects[0].poses[1]");
    play.drag(from, {from.x + 50, from.y}, shiftKey);
    const auto poseOf = [&] {
        return play.scene->state().objects[0]->body.as<BlendingCurve>()->locals()[1].pose();
    };
    EXPECT_NEAR(poseOf().angle, 0.5, 1e-12);
    play.drag(from, {from.x, from.y - 100}, altKey);
    EXPECT_NEAR(poseOf().scale.x, 2, 1e-12);
    EXPECT_NEAR(poseOf().angle, 0.5, 1e-12);
    EXPECT_EQ(poseOf().translate, Vec3(0.0));
}

TEST(Drag, RoundsToWhatAPixelCanShow) {
    EXPECT_EQ(roundedTo(0.123456, 0.013), 0.12);
    EXPECT_EQ(roundedTo(0.3000001, 0.5), 0.3);
    EXPECT_EQ(roundedTo(1234.56, 30), 1230);
    for (double unit = 1e-6; unit < 1e4; unit *= 1.7) {
        EXPECT_LE(std::abs(roundedTo(std::sqrt(2.0), unit) - std::sqrt(2.0)), unit / 2);
    }
}

}  // namespace
}  // namespace knotwork::app
