// Clicks, keys, hovering and manners of a view.
#include "app/hit.hpp"
#include "support/playground.hpp"

#include <cmath>

namespace knotwork::app {
namespace {

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
    const Vec3 before = pointAt(*play.scene->state().objects[0]->body.curve(), 1.3);
    const std::size_t knots = play.at("objects[0].knots").size();
    play.click(at);
    EXPECT_TRUE(play.click(at));
    ASSERT_EQ(play.at("objects[0].knots").size(), knots + 1);
    EXPECT_NEAR(play.at("objects[0].knots[5]").get<double>(), 1.5, 0.01);
    const Vec3 after = pointAt(*play.scene->state().objects[0]->body.curve(), 1.3);
    EXPECT_NEAR(glm::distance(after, before), 0,
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

TEST(Hover, AKnotShowsItsPlaceInAllPanes) {
    Playground play(spline);
    const Pixel at = play.pixelOf("objects[0].knots[4]");
    play.view.select("");
    play.event("move", at, 0);
    const Figure* figure = play.view.figure();
    ASSERT_EQ(figure->find(Pane::curve)->above.size(), 1u);
    const Vec3 dot = positionOf(figure->find(Pane::curve)->above.front(), 0);
    EXPECT_EQ(dot, pointAt(*play.scene->state().objects[0]->body.curve(), 1));
    EXPECT_EQ(figure->find(Pane::basis)->plot.over.size(), 1u);
    EXPECT_EQ(figure->find(Pane::knots)->plot.over.size(), 1u);
}

TEST(Hover, FollowsWhatMovesAwayFromARestingPointer) {
    Playground play(blend);
    const Pixel at = play.pixelOf("objects[0].poses[1]");
    play.view.select("");
    play.event("move", at, 0);
    EXPECT_EQ(play.view.cursor(), "grab");
    play.view.clock().setPlaying(true);
    play.view.tick(10);
    play.view.tick(11);  // a quarter of the loop on
    EXPECT_EQ(play.view.cursor(), "default");
}

TEST(Hodograph, IsAPaneWithOneScaleAndTheDerivativeAtTheParameter) {
    const auto document = [](const char* show) {
        return std::string(R"({"knotwork":1,"view":{"panes":["curve","knots","hodograph"]},"objects":[
            {"type":"bspline-curve","degree":2,"points":[[0,0],[1,3],[4,1],[5,5]],"show":)") + show + "}]}";
    };
    Playground without(document("{}").c_str());
    EXPECT_EQ(without.view.figure()->find(Pane::hodograph), nullptr);
    Playground playground(document(R"({"hodograph":true})").c_str());
    const PaneFigure* pane = playground.view.figure()->find(Pane::hodograph);
    ASSERT_NE(pane, nullptr);
    EXPECT_EQ(pane->plot.map.scaleX, pane->plot.map.scaleY);
    EXPECT_EQ(pane->reach, 0);
    for (const Painted& painted : pane->shapes) {
        for (std::size_t i = 0; i < painted.shape->positions.size() / 3; ++i) {
            EXPECT_TRUE(pane->plot.area.contains(pane->sight.toPixels(positionOf(*painted.shape, i))));
        }
    }
    EXPECT_TRUE(pane->above.empty());
    const Pixel knot = playground.pixelOf("objects[0].knots[3]");
    playground.event("move", knot, 0);
    pane = playground.view.figure()->find(Pane::hodograph);
    ASSERT_EQ(pane->above.size(), 1U);
    EXPECT_NEAR(pane->above[0].positions[0], 3, 1e-12);  // 2 · (P2 − P1) / 2
    EXPECT_NEAR(pane->above[0].positions[1], -2, 1e-12);
    EXPECT_FALSE(parameterAt(*pane, pane->plot.area.centre()));
}

TEST(Hodograph, OfACurveInSpaceIsSeenFromWhereTheCurveIsSeen) {
    Playground playground(R"({"knotwork":1,"view":{"mode":"3d","panes":["curve","hodograph"],
        "camera":{"azimuth":0.4,"elevation":0.3}},"objects":[
            {"type":"parametric-curve","name":"trefoil","show":{"hodograph":true}}]})");
    const Figure* figure = playground.view.figure();
    const PaneFigure* pane = figure->find(Pane::hodograph);
    ASSERT_NE(pane, nullptr);
    EXPECT_EQ(pane->sight.orientation(), figure->find(Pane::curve)->sight.orientation());
    EXPECT_GT(pane->reach, 0);
}

TEST(Handles, LeaveAPlayingPictureAloneUntilSomeonePoints) {
    Playground play(blend);
    const auto handles = [&] {
        int shown = 0;
        for (const Painted& painted : play.view.figure()->find(Pane::curve)->shapes) {
            shown += painted.shape->role == drawing::Role::handle ? 1 : 0;
        }
        return shown;
    };
    EXPECT_GT(handles(), 0);
    play.view.clock().setPlaying(true);
    play.view.touch();
    EXPECT_EQ(handles(), 0);
    play.event("move", {20, 20}, 0);
    EXPECT_GT(handles(), 0);
    play.event("leave", {20, 20}, 0);
    EXPECT_EQ(handles(), 0);
    play.click({20, 20}, "touch");
    play.event("leave", {20, 20}, 0, 0, "touch");
    EXPECT_GT(handles(), 0);
    play.view.blur();
    EXPECT_EQ(handles(), 0);
}

TEST(Labels, AreInTheReadersLanguage) {
    Playground play(spline);
    EXPECT_NE(play.view.labels().find("\"0.5\""), std::string::npos);
    Words words;
    words.decimalPoint = ",";
    play.view.setWords(words);
    play.view.figure();
    EXPECT_NE(play.view.labels().find("\"0,5\""), std::string::npos);
    EXPECT_EQ(play.view.labels().find("\"0.5\""), std::string::npos);
}

}  // namespace
}  // namespace knotwork::app
