// What is selected, told and moved without holding it.
#include "support/playground.hpp"

#include <cmath>

namespace knotwork::app {
namespace {

constexpr double pi = 3.141592653589793;

Json held(Playground& play, const char* path) {
    play.view.select(path);
    return *scene::parseJson(play.view.held());
}

Json eventsOf(Playground& play) { return *scene::parseJson(play.view.editor().takeEvents()); }

/// The last report without the name of its gesture.
Json lastChange(Playground& play) {
    const Json events = eventsOf(play);
    Json last = events.empty() ? Json() : events.back();
    if (last.contains("command") && last["command"].is_object()) last["command"].erase("gesture");
    return last;
}

TEST(Held, TellsWhichOfHowManyItIsAndWhatItsNumbersAre) {
    Playground play(spline);
    const Json point = held(play, "objects[0].points[2]");
    EXPECT_EQ(point["kind"], "point");
    EXPECT_EQ(point["number"], 3);
    EXPECT_EQ(point["count"], 6);
    EXPECT_EQ(point["value"], Json::array({-1, 2}));
    EXPECT_NEAR(point["pixel"][0].get<double>(), play.pixelOf("objects[0].points[2]").x, 1e-9);
    EXPECT_EQ(held(play, "objects[0].knots[4]")["value"], play.at("objects[0].knots[4]"));
    EXPECT_EQ(held(play, ""), Json());
}

TEST(Held, OfALocalTellsItsPose) {
    Playground play(blend);
    const Json local = held(play, "objects[0].poses[1]");
    EXPECT_EQ(local["local"], 1);
    EXPECT_EQ(local["value"]["scale"], Json::array({1.0, 1.0, 1.0}));
}

TEST(Step, IsThatOfTheArrowKeysWhereItIsSet) {
    Playground play(spline);
    play.view.setStep(0.25);
    EXPECT_EQ(held(play, "objects[0].points[2]")["step"], 0.25);
    EXPECT_TRUE(play.view.key("ArrowUp", true, shiftKey));
    EXPECT_EQ(play.at("objects[0].points[2]"), Json::array({-1.0, 4.5}));
    play.view.setStep(0);
    EXPECT_EQ(held(play, "objects[0].points[2]")["step"], 0.1);
}

TEST(Shift, IsAPressOfAnArrowKey) {
    Playground keys(spline);
    Playground fields(spline);
    for (Playground* play : {&keys, &fields}) play->view.select("objects[0].points[2]");
    keys.view.key("ArrowRight", true, 0);
    fields.view.shift({0.1, 0, 0});
    for (Playground* play : {&keys, &fields}) play->view.key("ArrowRight", false, 0);
    EXPECT_EQ(keys.scene->document(), fields.scene->document());
    EXPECT_EQ(eventsOf(keys), eventsOf(fields));
    fields.view.setReadOnly(true);
    EXPECT_FALSE(fields.view.shift({0.1, 0, 0}));
}

void expectPlacedAsDragged(const char* document, const char* path, const Pixel& by) {
    Playground drags(document);
    Playground clicks(document);
    const Pixel from = drags.pixelOf(path);
    const Pixel to{from.x + by.x, from.y + by.y};
    drags.view.select("");
    drags.drag(from, to);
    clicks.view.select(path);
    EXPECT_TRUE(clicks.view.place(to, "move"));
    EXPECT_EQ(drags.scene->document(), clicks.scene->document()) << path;
    EXPECT_EQ(lastChange(drags), lastChange(clicks)) << path;
    EXPECT_TRUE(clicks.scene->undo());
    EXPECT_FALSE(clicks.scene->canUndo());
}

TEST(Place, DoesWhatADragToThereDoes) {
    expectPlacedAsDragged(spline, "objects[0].points[2]", {61, -35});
    expectPlacedAsDragged(spline, "objects[0].knots[4]", {23, 0});
    expectPlacedAsDragged(blend, "objects[0].poses[1]", {40, 25});
}

TEST(Place, TurnsALocalUntilItsAxisPointsThere) {
    Playground play(blend);
    const Pixel at = play.pixelOf("objects[0].poses[1]");
    EXPECT_TRUE(play.view.place({at.x, at.y - 90}, "turn"));
    const auto local = posedLocal(play.scene->state().objects[0]->body, 1);
    EXPECT_NEAR(local->pose.angle, pi / 2, 0.006);
    EXPECT_EQ(lastChange(play)["source"], "pointer");
}

TEST(Place, ScalesALocalUntilItsBoxStandsThere) {
    Playground play(blend);
    const Pixel at = play.pixelOf("objects[0].poses[1]");
    const auto tool = gizmoOf(play.scene->state(), *play.view.selected(), {}, true,
                              play.view.figure()->find(Pane::curve)->plot.box);
    const Pixel box = *boxPlace(*tool, play.view.figure()->find(Pane::curve)->sight, 0);
    EXPECT_TRUE(play.view.place({at.x + 2 * (box.x - at.x), at.y + 2 * (box.y - at.y)}, "scale"));
    const auto local = posedLocal(play.scene->state().objects[0]->body, 1);
    EXPECT_EQ(local->pose.scale, Vec3(2, 2, 2));
}

TEST(Place, LeavesAloneWhatCannotBePutThere) {
    Playground play(spline);
    const Json before = play.scene->document();
    EXPECT_FALSE(play.view.place({300, 200}, "move")) << "nothing is selected";
    play.view.select("objects[0].points[2]");
    EXPECT_FALSE(play.view.place({300, 200}, "turn")) << "a point has no direction";
    EXPECT_FALSE(play.view.place(play.pixelOf("objects[0].knots[4]"), "scale"));
    play.view.setReadOnly(true);
    EXPECT_FALSE(play.view.place({300, 200}, "move"));
    EXPECT_EQ(play.scene->document(), before);
}

}  // namespace
}  // namespace knotwork::app
