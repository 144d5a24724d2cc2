// Several points or local curves at once: by pointer, by keys, by clicks and by commands the same.
#include "app/hit.hpp"
#include "support/playground.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace knotwork::app {
namespace {

constexpr double pi = 3.141592653589793;
constexpr const char* cubeInSpace = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"m",
    "type":"subdivision-surface","scheme":"catmull-clark","levels":1,"mesh":{"vertices":[[-1,-1,-1],
    [1,-1,-1],[-1,1,-1],[1,1,-1],[-1,-1,1],[1,-1,1],[-1,1,1],[1,1,1]],
    "faces":[[0,2,3,1],[4,5,7,6],[0,1,5,4],[2,6,7,3],[0,4,6,2],[1,3,7,5]]},
    "show":{"points":true}}]})";
constexpr const char* two = R"({"knotwork":1,"objects":[
    {"id":"a","type":"bspline-curve","degree":2,"points":[[-4,-2],[-3,2],[-1,2]]},
    {"id":"b","type":"bspline-curve","degree":2,"points":[[0,-1],[2,-2],[4,0]]}],
    "effects":[{"target":"b","kind":"rotate","angle":3.141592653589793,"period":4}]})";

std::string point(int k) { return "objects[0].points[" + std::to_string(k) + "]"; }

void clickWith(Playground& play, const Pixel& at, int modifiers) {
    play.event("down", at, 1, modifiers);
    play.event("up", at, 0, modifiers);
}

/// Selects points of the spline as a hand does that holds Ctrl.
void gather(Playground& play, std::initializer_list<int> points) {
    std::vector<Pixel> places;
    for (const int k : points) places.push_back(play.pixelOf(point(k)));
    play.view.select("");
    for (const Pixel& at : places) clickWith(play, at, commandKey);
}

std::vector<std::string> selectedPaths(Playground& play) {
    const Json selection = *scene::parseJson(play.view.selection());
    std::vector<std::string> paths;
    if (selection.is_object()) {
        for (const Json& path : selection["paths"]) paths.push_back(path.get<std::string>());
    }
    return paths;
}

using Paths = std::vector<std::string>;

Json lastCommand(Playground& play) {
    const Json events = *scene::parseJson(play.view.editor().takeEvents());
    if (events.empty()) return nullptr;
    Json command = events.back()["command"];
    command.erase("gesture");
    return command;
}

Vec3 placeAt(Playground& play, const std::string& path) {
    const Json& p = play.at(path.c_str());
    return {p[0].get<double>(), p[1].get<double>(), p.size() > 2 ? p[2].get<double>() : 0.0};
}

TEST(Gathering, CtrlAndShiftClicksAddAndTakeOut) {
    Playground play(spline);
    gather(play, {1, 3, 4});
    EXPECT_EQ(selectedPaths(play), (Paths{point(1), point(3), point(4)}));
    clickWith(play, play.view.figure()->find(Pane::curve)->sight.toPixels({0, -1, 0}), shiftKey);
    EXPECT_EQ(selectedPaths(play), (Paths{point(1), point(4)}));
    play.click(play.view.figure()->find(Pane::curve)->sight.toPixels({2, -2, 0}));
    EXPECT_EQ(selectedPaths(play), (Paths{point(4)})) << "a plain click selects one alone";
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Gathering, AKnotIsSelectedAlone) {
    Playground play(spline);
    const Pixel knot = play.pixelOf("objects[0].knots[4]");
    gather(play, {1, 3});
    clickWith(play, knot, commandKey);
    EXPECT_EQ(selectedPaths(play), (Paths{"objects[0].knots[4]"}));
}

TEST(Gathering, ABandSelectsWhatItHoldsAndEscapePutsBackWhatWasSelected) {
    Playground play(spline);
    const Sight sight = play.view.figure()->find(Pane::curve)->sight;
    const Pixel from = sight.toPixels({0.7, -1.7, 0});
    const Pixel to = sight.toPixels({-3.5, 2.15, 0});
    play.view.select(point(5));
    play.event("down", from, 1, shiftKey);
    play.event("move", to, 1, shiftKey);
    EXPECT_EQ(selectedPaths(play), (Paths{point(1), point(2), point(3)}));
    const auto& tools = play.view.figure()->find(Pane::curve)->tools;
    EXPECT_TRUE(std::any_of(tools.begin(), tools.end(), [](const Shape& s) { return s.dashed; }));
    play.view.key("Escape", true, 0);
    EXPECT_EQ(selectedPaths(play), (Paths{point(5)}));
    play.event("up", to, 0);
    play.drag(from, to);
    EXPECT_EQ(selectedPaths(play), (Paths{point(5)})) << "without Shift the picture moves";
}

TEST(Gathering, ABandUnderCtrlAddsToWhatIsSelected) {
    Playground play(spline);
    const Sight sight = play.view.figure()->find(Pane::curve)->sight;
    play.view.select(point(5));
    play.event("down", sight.toPixels({0.7, -1.7, 0}), 1, commandKey);
    play.event("move", sight.toPixels({-3.5, 2.15, 0}), 1, commandKey);
    play.event("up", sight.toPixels({-3.5, 2.15, 0}), 0, commandKey);
    EXPECT_EQ(selectedPaths(play), (Paths{point(5), point(1), point(2), point(3)}));
}

TEST(Gathering, TakesAFingerWhileItsButtonIsPressed) {
    Playground play(spline);
    const Sight sight = play.view.figure()->find(Pane::curve)->sight;
    const Pixel from = sight.toPixels({0.7, -1.7, 0});
    EXPECT_FALSE(play.view.hits(from, "touch"));
    play.view.setGathering(true);
    EXPECT_TRUE(play.view.hits(from, "touch"));
    play.event("down", from, 1, 0, "touch");
    play.event("move", sight.toPixels({-3.5, 2.15, 0}), 1, 0, "touch");
    play.event("up", sight.toPixels({-3.5, 2.15, 0}), 0, 0, "touch");
    EXPECT_EQ(selectedPaths(play).size(), 3u);
    play.click(sight.toPixels({-4, -2, 0}), "touch");
    EXPECT_EQ(selectedPaths(play).size(), 4u);
    play.view.setGathering(false);
    play.click(from, "touch");
    EXPECT_EQ(selectedPaths(play), Paths{});
}

TEST(Gathering, KeysSelectAllAndOneMore) {
    Playground play(spline);
    play.view.select(point(2));
    EXPECT_TRUE(play.view.key("PageDown", true, shiftKey));
    EXPECT_TRUE(play.view.key("PageDown", true, shiftKey));
    EXPECT_EQ(selectedPaths(play), (Paths{point(2), point(3), point(4)}));
    EXPECT_TRUE(play.view.key("PageUp", true, shiftKey));
    EXPECT_EQ(selectedPaths(play).back(), point(1));
    EXPECT_TRUE(play.view.key("a", true, commandKey));
    EXPECT_EQ(selectedPaths(play).size(), 6u);
    EXPECT_TRUE(play.view.key("Escape", true, 0));
    EXPECT_EQ(selectedPaths(play), Paths{});
}

TEST(GroupMove, IsTheSameByPointerKeysClicksAndCommand) {
    Playground drags(spline), keys(spline), clicks(spline), commands(spline);
    const double pixels = 0.3 / drags.unitsPerPixel();
    for (Playground* play : {&drags, &keys, &clicks}) gather(*play, {1, 2, 4});
    const Pixel from = drags.view.figure()->find(Pane::curve)->sight.toPixels({-1, 2, 0});
    drags.drag(from, {from.x + pixels, from.y});
    for (int k = 0; k < 3; ++k) keys.view.key("ArrowRight", true, 0);
    keys.view.key("ArrowRight", false, 0);
    const Json held = *scene::parseJson(clicks.view.held());
    EXPECT_EQ(held["kind"], "group");
    EXPECT_EQ(held["count"], 3);
    EXPECT_TRUE(clicks.view.place({held["pixel"][0].get<double>() + pixels,
                                   held["pixel"][1].get<double>()}, "move"));
    const Json command{{"move", {point(1), point(2), point(4)}}, {"by", {0.3, 0.0}}};
    ASSERT_TRUE(commands.scene->execute(command));
    for (Playground* play : {&drags, &keys, &clicks}) {
        EXPECT_EQ(lastCommand(*play), command);
        EXPECT_EQ(play->scene->document(), commands.scene->document());
        EXPECT_TRUE(play->scene->undo());
        EXPECT_FALSE(play->scene->canUndo());
        EXPECT_EQ(selectedPaths(*play).size(), 3u);
    }
}

TEST(GroupMove, EscapePutsAllBack) {
    Playground play(spline);
    gather(play, {1, 2});
    const Json before = play.scene->document();
    const Pixel from = play.view.figure()->find(Pane::curve)->sight.toPixels({-1, 2, 0});
    play.event("down", from, 1);
    play.event("move", {from.x + 50, from.y + 20}, 1);
    EXPECT_NE(play.scene->document(), before);
    const auto& labels = play.view.figure()->find(Pane::curve)->plot.labels;
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const ui::Label& label) {
        return label.text.rfind("Δ", 0) == 0;
    }));
    EXPECT_FALSE(play.view.figure()->find(Pane::curve)->below.empty()) << "the former shape";
    play.view.key("Escape", true, 0);
    EXPECT_EQ(play.scene->document(), before);
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(GroupMove, OfObjectsThatEffectsHavePlacedGoesWhereItIsSeenToGo) {
    Playground play(two);
    play.view.clock().setPhase(0.5);
    play.view.touch();
    std::vector<Pixel> places{play.pixelOf("objects[0].points[2]"),
                              play.pixelOf("objects[1].points[0]")};
    play.view.select("");
    for (const Pixel& at : places) clickWith(play, at, commandKey);
    ASSERT_EQ(selectedPaths(play).size(), 2u);
    play.drag(places[0], {places[0].x + 30, places[0].y});
    EXPECT_EQ(lastCommand(play)["all"].size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        const std::string path = "objects[" + std::to_string(k) + "].points[" +
                                 std::to_string(k == 0 ? 2 : 0) + "]";
        EXPECT_NEAR(play.pixelOf(path).x, places[k].x + 30, 1) << path;
    }
    EXPECT_GT(placeAt(play, "objects[0].points[2]").x, -1);
    EXPECT_LT(placeAt(play, "objects[1].points[0]").x, 0) << "turned by half a turn";
}

TEST(GroupMove, ByCtrlGoesWholeStepsOfTheGrid) {
    Playground play(spline);
    gather(play, {1, 2});
    const Pixel from = play.view.figure()->find(Pane::curve)->sight.toPixels({-1, 2, 0});
    play.event("down", from, 1);
    play.event("move", {from.x + 61, from.y}, 1, commandKey);
    play.event("up", {from.x + 61, from.y}, 0, commandKey);
    const double step = stepOfGrid(play.view.figure()->find(Pane::curve)->sight);
    const double moved = placeAt(play, point(1)).x + 3;
    EXPECT_GT(moved, 0);
    EXPECT_NEAR(std::remainder(moved, step), 0, 1e-12);
}

TEST(GroupTurn, KeepsTheCentreAndTheDistancesToIt) {
    Playground play(spline);
    gather(play, {1, 2, 4});
    const Vec3 centre = (Vec3(-3, 2, 0) + Vec3(-1, 2, 0) + Vec3(2, -2, 0)) / 3.0;
    for (int k = 0; k < 6; ++k) EXPECT_TRUE(play.view.key("r", true, 0));
    play.view.key("r", false, 0);
    const double pixel = play.unitsPerPixel();
    for (const auto& [k, was] : {std::pair{1, Vec3(-3, 2, 0)}, {2, Vec3(-1, 2, 0)},
                                 {4, Vec3(2, -2, 0)}}) {
        const Vec3 arm = was - centre;
        const Vec3 expected = centre + Vec3(-arm.y, arm.x, 0);  // by six times 15 degrees
        EXPECT_NEAR(glm::distance(placeAt(play, point(k)), expected), 0, 3 * pixel) << k;
    }
    EXPECT_TRUE(play.scene->undo());
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(GroupTurn, ByTheRingUnderCtrlIsTheSameAsByKeys) {
    Playground drags(spline), keys(spline);
    for (Playground* play : {&drags, &keys}) gather(*play, {1, 2, 4});
    const Json held = *scene::parseJson(drags.view.held());
    const Pixel at{held["pixel"][0].get<double>(), held["pixel"][1].get<double>()};
    constexpr double ring = 32;
    const auto onRing = [&](double angle) {
        return Pixel{at.x + ring * std::cos(angle), at.y - ring * std::sin(angle)};
    };
    drags.event("down", onRing(0.7), 1);
    drags.event("move", onRing(0.7 + pi / 10), 1, commandKey);
    drags.event("up", onRing(0.7 + pi / 12), 0, commandKey);
    keys.view.key("r", true, 0);
    keys.view.key("r", false, 0);
    EXPECT_EQ(lastCommand(drags), lastCommand(keys));
    EXPECT_EQ(drags.scene->document(), keys.scene->document());
}

TEST(GroupScale, GoesOutFromTheCentreInAllDirections) {
    Playground play(spline);
    gather(play, {1, 2});
    EXPECT_TRUE(play.view.key("s", true, 0));
    EXPECT_TRUE(play.view.key("S", true, shiftKey));
    EXPECT_TRUE(play.view.key("s", true, 0));
    play.view.key("s", false, 0);
    EXPECT_NEAR(placeAt(play, point(1)).x, -3.1, play.unitsPerPixel());
    EXPECT_NEAR(placeAt(play, point(2)).x, -0.9, play.unitsPerPixel());
    EXPECT_EQ(placeAt(play, point(1)).y, 2);
}

TEST(GroupScale, ByABoxGoesAlongItsAxis) {
    Playground play(spline);
    gather(play, {1, 3});
    const Json held = *scene::parseJson(play.view.held());
    const Pixel at{held["pixel"][0].get<double>(), held["pixel"][1].get<double>()};
    const Pixel box{at.x + 84, at.y};
    play.event("down", box, 1);
    play.event("move", {at.x + 160, at.y}, 1);
    play.event("move", {at.x + 168, at.y}, 1);
    play.event("up", {at.x + 168, at.y}, 0);
    EXPECT_NEAR(placeAt(play, point(1)).x, -1.5 - 3, play.unitsPerPixel());
    EXPECT_NEAR(placeAt(play, point(3)).x, -1.5 + 3, play.unitsPerPixel());
    EXPECT_EQ(placeAt(play, point(1)).y, 2);
}

TEST(GroupOfLocals, MovesTurnsAndScalesAsOneCommand) {
    Playground play(blend);
    const Pixel first = play.pixelOf("objects[0].poses[0]");
    const Pixel second = play.pixelOf("objects[0].poses[1]");
    play.view.select("");
    clickWith(play, first, commandKey);
    clickWith(play, second, commandKey);
    play.drag(first, {first.x + 30, first.y});
    const Json moved = lastCommand(play);
    EXPECT_EQ(moved["pose"]["locals"], Json::array({0, 1}));
    EXPECT_NEAR(moved["pose"]["by"]["translate"][0].get<double>(), 30 * play.unitsPerPixel(),
                play.unitsPerPixel());
    const auto pose = [&](std::size_t k) {
        return posedLocal(play.scene->state().objects[0]->body, k)->pose;
    };
    EXPECT_EQ(pose(0).translate, pose(1).translate);
    EXPECT_EQ(pose(2).translate, Vec3(0.0));
    play.view.key("s", true, 0);
    play.view.key("r", true, 0);
    play.view.key("r", false, 0);
    EXPECT_EQ(pose(0).scale, Vec3(1.1));
    EXPECT_NEAR(pose(1).angle, pi / 12, 1e-12);
    int steps = 0;
    while (play.scene->undo()) ++steps;
    EXPECT_EQ(steps, 3) << "a move, a scaling and a turn";
}

TEST(GroupOfVertices, IsMovedAndScaled) {
    Playground play(cubeInSpace);
    play.view.select("objects[0].mesh.vertices[0]");
    EXPECT_TRUE(play.view.key("a", true, commandKey));
    EXPECT_EQ(selectedPaths(play).size(), 8u);
    play.view.setStep(0.5);
    EXPECT_TRUE(play.view.shift({0.5, 0, 0}));
    play.view.key("ArrowRight", false, 0);
    EXPECT_EQ(placeAt(play, "objects[0].mesh.vertices[0]"), Vec3(-0.5, -1, -1));
    Playground fresh(cubeInSpace);
    fresh.view.select("objects[0].mesh.vertices[0]");
    fresh.view.key("a", true, commandKey);
    EXPECT_TRUE(fresh.view.key("s", true, 0));
    fresh.view.key("s", false, 0);
    EXPECT_NEAR(glm::distance(placeAt(fresh, "objects[0].mesh.vertices[0]"), Vec3(-1.1)), 0,
                2 * fresh.unitsPerPixel());
}

TEST(GroupRemoval, TakesAllOfThemInOneStep) {
    Playground play(spline);
    gather(play, {3, 1});
    EXPECT_TRUE(play.view.key("Delete", true, 0));
    EXPECT_EQ(play.at("objects[0].points"), (Json{{-4, -2}, {-1, 2}, {2, -2}, {4, 0}}));
    EXPECT_EQ(selectedPaths(play), Paths{});
    EXPECT_TRUE(play.scene->undo());
    EXPECT_EQ(play.at("objects[0].points").size(), 6u);
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(GroupRemoval, ThatLeavesTooFewIsRefusedWhole) {
    Playground play(spline);
    play.view.select(point(0));
    play.view.key("a", true, commandKey);
    const Json before = play.scene->document();
    play.view.key("Delete", true, 0);
    EXPECT_EQ(play.scene->document(), before);
    EXPECT_EQ(selectedPaths(play).size(), 6u);
}

TEST(Groups, MayBeSelectedButNotChangedWhereNothingMay) {
    Playground play(spline);
    play.view.setReadOnly(true);
    gather(play, {1, 2});
    EXPECT_EQ(selectedPaths(play).size(), 2u);
    const Json before = play.scene->document();
    const Pixel from = play.view.figure()->find(Pane::curve)->sight.toPixels({-1, 2, 0});
    play.drag(from, {from.x + 40, from.y});
    for (const char* key : {"ArrowRight", "r", "s", "Delete"}) play.view.key(key, true, 0);
    EXPECT_EQ(play.scene->document(), before);
    EXPECT_TRUE(play.view.figure()->find(Pane::curve)->tools.empty());
}

TEST(Groups, LightUpAllThatTheyRuleOnce) {
    Playground play(spline);
    const auto below = [&] { return play.view.figure()->find(Pane::curve)->below.size(); };
    gather(play, {0, 1});
    play.event("leave", {0, 0}, 0);
    EXPECT_EQ(below(), 1u) << "neighbours rule one part together";
    gather(play, {0, 5});
    play.event("leave", {0, 0}, 0);
    EXPECT_EQ(below(), 2u);
}

TEST(PoseKeys, TurnAndScaleALocalAsOneStep) {
    Playground play(blend);
    play.view.select("objects[0].poses[1]");
    EXPECT_TRUE(play.view.key("r", true, 0));
    EXPECT_TRUE(play.view.key("r", true, 0));
    EXPECT_TRUE(play.view.key("R", true, shiftKey));
    EXPECT_TRUE(play.view.key("s", true, 0));
    play.view.key("s", false, 0);
    const Pose pose = posedLocal(play.scene->state().objects[0]->body, 1)->pose;
    EXPECT_NEAR(pose.angle, pi / 12, 1e-15);
    EXPECT_EQ(pose.axis, Vec3(0, 0, 1));
    EXPECT_EQ(pose.scale, Vec3(1.1));
    EXPECT_TRUE(play.scene->undo());
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(PoseKeys, MeanNothingToAPoint) {
    Playground play(spline);
    play.view.select(point(2));
    const Json before = play.scene->document();
    EXPECT_FALSE(play.view.key("r", true, 0));
    EXPECT_FALSE(play.view.key("s", true, 0));
    EXPECT_EQ(play.scene->document(), before);
}

TEST(KnotDrag, ByCtrlGoesOntoTheGrid) {
    Playground play(spline);
    const Pixel at = play.pixelOf("objects[0].knots[4]");
    const PaneFigure* pane = play.view.figure()->find(Pane::knots);
    const double step = stepOfGrid(pane->sight);
    const double pixels = 1.3 * step / pane->sight.unitsPerPixel();
    play.view.select("");
    play.event("down", at, 1);
    play.event("move", {at.x + pixels, at.y}, 1, commandKey);
    play.event("up", {at.x + pixels, at.y}, 0, commandKey);
    EXPECT_NEAR(play.at("objects[0].knots[4]").get<double>(), 1 + step, 1e-12);
}

}  // namespace
}  // namespace knotwork::app
