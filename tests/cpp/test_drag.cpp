// Drags, clicks and keys in a view, on real scenes and without a browser.
#include "app/hit.hpp"
#include "app/view.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::app {
namespace {

using scene::Json;

std::shared_ptr<scene::Scene> sceneOf(const char* text) {
    const auto json = scene::parseJson(text);
    EXPECT_TRUE(json.ok());
    auto scene = scene::Scene::open(*json);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().path + ": " + scene.error().message);
    return std::make_shared<scene::Scene>(std::move(*scene));
}

constexpr const char* spline = R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve",
    "degree":3,"points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]]}]})";
constexpr const char* blend = R"({"knotwork":1,"view":{"panes":["curve"]},"objects":[
    {"id":"b","type":"blending-curve","bFunction":{"family":"expo-rational"},
     "model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4},"form":"closed",
     "show":{"handles":true}}],
    "effects":[{"target":"b","kind":"rotate","angle":1.5707963267948966,"period":4}]})";

/// A view of a scene with a mouse over it.
struct Playground {
    explicit Playground(const char* document) : scene(sceneOf(document)) {
        view.resize(1000, 600, 1);
        view.attach(scene);
        view.setReducedMotion(true);
        EXPECT_NE(view.figure(), nullptr);
    }
    bool event(const char* kind, const Pixel& at, int buttons, int modifiers = 0,
               const char* type = "mouse") {
        time += 0.1;
        return view.pointer({kind, at, buttons, modifiers, type, time});
    }
    bool click(const Pixel& at, const char* type = "mouse") {
        const bool taken = event("down", at, 1, 0, type);
        event("up", at, 0, 0, type);
        return taken;
    }
    void drag(const Pixel& from, const Pixel& to, int modifiers = 0) {
        event("down", from, 1);
        event("move", {(from.x + to.x) / 2 + 40, (from.y + to.y) / 2 - 30}, 1, modifiers);
        event("move", to, 1, modifiers);
        event("up", to, 0, modifiers);
    }
    Pixel pixelOf(const std::string& path) {
        const Figure* figure = view.figure();
        view.select(path);
        EXPECT_TRUE(view.selected()) << path;
        const PaneFigure* pane = figure->find(view.selected()->pane);
        return pane->plot.map.toPixels(view.selected()->at);
    }
    const Json& at(const char* path) {
        const Json* value = valueAt(scene->state(), path);
        EXPECT_NE(value, nullptr) << path;
        static const Json none;
        return value != nullptr ? *value : none;
    }
    double unitsPerPixel() { return 1 / view.figure()->find(Pane::curve)->plot.map.scaleX; }

    std::shared_ptr<scene::Scene> scene;
    View view{1};
    double time = 100;
};

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
    const auto* curve = play.scene->state().objects[0]->curve.as<BlendingCurve>();
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
        return play.scene->state().objects[0]->curve.as<BlendingCurve>()->locals()[1].pose();
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

TEST(Click, SelectsAndDeleteRemoves) {
    Playground play(spline);
    const Pixel at = play.pixelOf("objects[0].points[2]");
    play.view.select("");
    EXPECT_TRUE(play.click({at.x + 8, at.y}));
    ASSERT_TRUE(play.view.selected());
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[2]");
    EXPECT_FALSE(play.scene->canUndo());
    EXPECT_TRUE(play.view.key("Delete", true, 0));
    EXPECT_EQ(play.at("objects[0].points").size(), 5u);
    EXPECT_FALSE(play.view.selected());
}

TEST(Click, OnEmptySpaceDeselects) {
    Playground play(spline);
    play.pixelOf("objects[0].points[2]");
    play.click({30, 30});
    EXPECT_FALSE(play.view.selected());
}

TEST(DoubleClick, OnTheKnotLineInsertsAKnotWithoutMovingTheCurve) {
    Playground play(spline);
    const Figure* figure = play.view.figure();
    const PaneFigure* pane = figure->find(Pane::knots);
    ASSERT_NE(pane, nullptr);
    const Pixel at{pane->plot.map.pixelX(1.5), pane->plot.map.pixelY(0)};
    const Vec3 before = pointAt(play.scene->state().objects[0]->curve, 1.3);
    const std::size_t knots = play.at("objects[0].knots").size();
    play.click(at);
    EXPECT_TRUE(play.click(at));
    ASSERT_EQ(play.at("objects[0].knots").size(), knots + 1);
    EXPECT_NEAR(play.at("objects[0].knots[5]").get<double>(), 1.5, 0.01);
    EXPECT_NEAR(glm::distance(pointAt(play.scene->state().objects[0]->curve, 1.3), before), 0,
                1e-13);
}

TEST(DoubleClick, OnTheCurveAddsAPointWherePolygonGrowsLeast) {
    Playground play(spline);
    const Pixel a = play.pixelOf("objects[0].points[3]");
    const Pixel b = play.pixelOf("objects[0].points[4]");
    play.view.select("");
    const Pixel middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    play.click(middle);
    play.click(middle);
    ASSERT_EQ(play.at("objects[0].points").size(), 7u);
    EXPECT_NEAR(play.at("objects[0].points[4]")[0].get<double>(), 1, play.unitsPerPixel());
    ASSERT_TRUE(play.view.selected());
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[4]");
}

TEST(Pan, MovesTheCameraAndNotTheDocument) {
    Playground play(spline);
    const Json before = play.scene->document();
    const Vec3 corner = play.view.figure()->find(Pane::curve)->plot.map.fromPixels({40, 40});
    play.drag({40, 40}, {140, 90});
    const Pixel now = play.view.figure()->find(Pane::curve)->plot.map.toPixels(corner);
    EXPECT_NEAR(now.x, 140, 1e-9);
    EXPECT_NEAR(now.y, 90, 1e-9);
    EXPECT_EQ(play.scene->document(), before);
}

TEST(Manners, AFingerOnEmptySpaceIsThePages) {
    Playground play(spline);
    EXPECT_FALSE(play.event("down", {30, 30}, 1, 0, "touch"));
    EXPECT_FALSE(play.view.hits({30, 30}, "touch"));
    const Pixel point = play.pixelOf("objects[0].points[2]");
    EXPECT_TRUE(play.view.hits({point.x + 20, point.y}, "touch"));
    EXPECT_FALSE(play.view.hits({point.x + 20, point.y}, "mouse"));
    EXPECT_TRUE(play.event("down", {point.x + 20, point.y}, 1, 0, "touch"));
}

TEST(Manners, TheWheelZoomsOnlyWithAModifier) {
    Playground play(spline);
    const double scale = play.view.camera().aim().scale;
    EXPECT_FALSE(play.view.wheel({200, 200}, -100, 0));
    EXPECT_EQ(play.view.camera().aim().scale, scale);
    EXPECT_TRUE(play.view.wheel({200, 200}, -100, commandKey));
    EXPECT_GT(play.view.camera().aim().scale, scale);
}

TEST(Manners, TabAndBrowserShortcutsAreLeftAlone) {
    Playground play(spline);
    play.pixelOf("objects[0].points[2]");
    EXPECT_FALSE(play.view.key("Tab", true, 0));
    EXPECT_FALSE(play.view.key("0", true, commandKey));
    EXPECT_FALSE(play.view.key("r", true, commandKey));
}

TEST(Manners, NothingIsDrawnWhileNothingChanges) {
    Playground play(blend);
    const auto frame = [&](double now) {
        play.view.tick(now);
        if (!play.view.needsFrame()) return false;
        play.view.figure();
        play.view.painted();
        return true;
    };
    EXPECT_TRUE(frame(1));
    for (double now = 1; now < 3; now += 1.0 / 60) EXPECT_FALSE(frame(now));
    play.event("move", {300, 300}, 0);
    play.event("move", {301, 300}, 0);
    EXPECT_FALSE(frame(3));
    ASSERT_TRUE(play.scene->execute(Json{{"set", "title"}, {"value", "Turned"}}).ok());
    EXPECT_TRUE(frame(3.1));
    EXPECT_FALSE(frame(3.2));
    play.view.clock().setPlaying(true);
    EXPECT_TRUE(frame(4));
    EXPECT_TRUE(frame(4.1));
    play.view.clock().setPlaying(false);
    EXPECT_FALSE(frame(5));
}

TEST(Manners, APictureIsDrawnAgainOnlyForAReason) {
    Playground play(spline);
    const auto made = play.view.drawingsMade();
    play.event("move", {300, 300}, 0);
    play.pixelOf("objects[0].points[2]");
    play.drag({40, 40}, {140, 90});
    play.view.figure();
    EXPECT_EQ(play.view.drawingsMade(), made);
}

TEST(ReadOnly, LooksButDoesNotTouch) {
    Playground play(spline);
    play.view.setReadOnly(true);
    const Json before = play.scene->document();
    const Pixel from = play.pixelOf("objects[0].points[2]");
    play.drag(from, {from.x + 80, from.y});
    play.click({200, 200});
    play.click({200, 200});
    play.view.select("objects[0].points[2]");
    EXPECT_FALSE(play.view.key("Delete", true, 0));
    EXPECT_FALSE(play.view.key("ArrowLeft", true, 0));
    EXPECT_EQ(play.scene->document(), before);
}

TEST(Keys, ArrowsMoveTheSelectionAsOneGestureUntilTheyAreLetGo) {
    Playground play(spline);
    play.pixelOf("objects[0].points[2]");
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(play.view.key("ArrowRight", true, 0));
    EXPECT_TRUE(play.view.key("ArrowRight", false, 0));
    EXPECT_NEAR(play.at("objects[0].points[2]")[0].get<double>(), -1 + 3 * 0.1, 1e-12);
    EXPECT_TRUE(play.view.key("z", true, commandKey));
    EXPECT_EQ(play.at("objects[0].points[2]")[0], -1);
}

TEST(Keys, PageDownGoesToTheNextPointAndRound) {
    Playground play(spline);
    play.pixelOf("objects[0].points[5]");
    EXPECT_TRUE(play.view.key("PageDown", true, 0));
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[0]");
    EXPECT_TRUE(play.view.key("PageUp", true, 0));
    EXPECT_EQ(play.view.selected()->path(), "objects[0].points[5]");
}

TEST(Hit, TheNearestOfTwoIsTaken) {
    Playground play(spline);
    const Pixel a = play.pixelOf("objects[0].points[2]");
    const auto hit = targetAt(*play.view.figure(), {a.x - 9, a.y + 3}, 12);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->path(), "objects[0].points[2]");
    EXPECT_FALSE(targetAt(*play.view.figure(), {a.x - 12, a.y + 12}, 12));
}

TEST(Hover, ABasisFunctionLightsUpItsPoint) {
    Playground play(spline);
    const PaneFigure* pane = play.view.figure()->find(Pane::basis);
    ASSERT_NE(pane, nullptr);
    // The first of a clamped basis is 1 at the start of the domain.
    const Pixel at{pane->plot.map.pixelX(0.05), pane->plot.map.pixelY(std::pow(0.95, 3))};
    play.event("move", at, 0);
    bool marked = false;
    for (const Painted& painted : play.view.figure()->find(Pane::curve)->shapes) {
        if (painted.shape->path == "objects[0].points") {
            for (const Mark& mark : painted.marks) marked = marked || mark.index == 0;
        }
    }
    EXPECT_TRUE(marked);
    EXPECT_FALSE(play.view.figure()->find(Pane::curve)->below.empty());
}

}  // namespace
}  // namespace knotwork::app
