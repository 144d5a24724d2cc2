// The panes of a view: seams that people move, and what the panes say of one another.
#include "app/hit.hpp"
#include "geometry/differential.hpp"
#include "support/playground.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::app {
namespace {

using ui::layoutFigure;
using ui::SeamName;

constexpr const char* bent = R"({"knotwork":1,"view":{"panes":["curve","basis","knots","curvature"]},"objects":[
    {"id":"s","type":"bspline-curve","degree":3,"points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]],
     "show":{"curvature":true}}]})";

Json panesOf(Playground& play) { return *scene::parseJson(play.view.panes()); }

ui::WantedPanes all() {
    ui::WantedPanes wanted;
    wanted.basis = wanted.knots = wanted.bFunction = wanted.hodograph = wanted.curvature = true;
    return wanted;
}

TEST(Seams, StandWhereTheyAreMovedAndNoPaneBecomesTooSmall) {
    const ui::Box figure{0, 0, 1000, 700};
    const ui::FigureLayout normal = layoutFigure(figure, all());
    for (std::size_t k = 0; k < ui::seamNames.size(); ++k) {
        ASSERT_TRUE(normal.seams[k]) << ui::seamNames[k];
        const ui::Seam& seam = *normal.seams[k];
        EXPECT_LE(seam.least, seam.share);
        EXPECT_GE(seam.most, seam.share);
        for (const double wanted : {-1.0, 0.45, 2.0}) {
            ui::Shares shares;
            shares[k] = wanted;
            const ui::FigureLayout layout = layoutFigure(figure, all(), shares);
            EXPECT_DOUBLE_EQ(layout.seams[k]->share, std::clamp(wanted, seam.least, seam.most));
            for (const auto& box : {layout.curve, layout.basis, layout.bFunction, layout.hodograph, layout.curvature}) {
                ASSERT_TRUE(box);
                EXPECT_GT(box->width, 89);
                EXPECT_GT(box->height, 89);
            }
            EXPECT_EQ(layout.basis->bottom(), layout.knots->y);
            EXPECT_EQ(layout.curvature->bottom(), layout.basis->y);
        }
    }
}

TEST(Seams, DoNotTurnTheFigureOverWhenTheyAreMoved) {
    const ui::Box figure{0, 0, 1000, 700};
    const bool upright = layoutFigure(figure, all()).seam(SeamName::plots)->upright;
    for (double share = 0; share <= 1; share += 0.05) {
        EXPECT_EQ(layoutFigure(figure, all(), {share}).seam(SeamName::plots)->upright, upright);
    }
}

TEST(Seams, OfAViewAreToldAndMovedByShares) {
    Playground play(bent);
    const Json before = panesOf(play);
    EXPECT_EQ(before["shown"], Json::parse(R"(["curve","basis","knots","curvature"])"));
    ASSERT_EQ(before["seams"].size(), 2U);
    EXPECT_EQ(before["seams"][0]["name"], "plots");
    EXPECT_TRUE(play.view.moveSeam("plots", 0.3));
    EXPECT_FALSE(play.view.moveSeam("plots", 0.3));
    const Json moved = panesOf(play);
    EXPECT_EQ(moved["seams"][0]["share"], 0.3);
    EXPECT_TRUE(play.view.moveSeam("plots", 7.0));
    EXPECT_EQ(panesOf(play)["seams"][0]["share"], before["seams"][0]["most"]);
    EXPECT_TRUE(play.view.moveSeam("plots", std::nullopt));
    EXPECT_EQ(panesOf(play), before);
    EXPECT_FALSE(play.view.moveSeam("nothing", 0.5));
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Seams, AreKeptFromSceneToScene) {
    Playground play(bent);
    play.view.moveSeam("plots", 0.3);
    play.view.attach(sceneOf(bent));
    EXPECT_EQ(panesOf(play)["seams"][0]["share"], 0.3);
}

TEST(CurvaturePlot, HasTheAxisOfTheKnotsAndShowsWhereThePointerIs) {
    Playground play(bent);
    const Figure* figure = play.view.figure();
    const PaneFigure* pane = figure->find(Pane::curvature);
    ASSERT_NE(pane, nullptr);
    const PaneFigure* knots = figure->find(Pane::knots);
    EXPECT_EQ(pane->plot.map.pixelX(1.5), knots->plot.map.pixelX(1.5));
    const Pixel at{pane->plot.map.pixelX(1.25), pane->plot.area.centre().y};
    play.event("move", at, 0);
    figure = play.view.figure();
    pane = figure->find(Pane::curvature);
    ASSERT_EQ(pane->above.size(), 1U);
    EXPECT_NEAR(pane->above[0].positions[0], 1.25, 1e-9);
    const Curve& curve = *play.scene->state().objects[0]->body.curve();
    EXPECT_NEAR(pane->above[0].positions[1], frameAt(curve, 1.25, Side::right).curvature, 1e-6);
    const PaneFigure& plane = figure->panes.front();
    ASSERT_EQ(plane.above.size(), 1U);
    EXPECT_NEAR(plane.above[0].positions[0], pointAt(curve, 1.25).x, 1e-6);
    EXPECT_FALSE(figure->find(Pane::basis)->plot.over.empty());
}

TEST(CurvaturePlot, OfACurveWithoutKnotsHasAnAxisOfItsOwn) {
    Playground play(R"({"knotwork":1,"view":{"panes":["curve","curvature"]},"objects":[
        {"type":"parametric-curve","name":"astroid","show":{"curvature":true}}]})");
    const PaneFigure* pane = play.view.figure()->find(Pane::curvature);
    ASSERT_NE(pane, nullptr);
    EXPECT_NEAR(pane->plot.map.pixelX(0), pane->plot.area.x, 1e-9);
    bool unbounded = false;
    for (const ui::Label& label : pane->plot.labels) unbounded |= label.text == "\u2212\u221e";
    EXPECT_TRUE(unbounded);
    play.event("move", pane->plot.area.centre(), 0);
    EXPECT_EQ(play.view.figure()->panes.front().above.size(), 1U);
}

constexpr const char* lined = R"({"knotwork":1,"view":{"panes":["curve"]},"objects":[
    {"id":"s","type":"bspline-curve","degree":3,"points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]],
     "line":[[0,0],[1,0]],"show":{"crossings":true}}]})";

TEST(Line, IsMovedByItsPointAndTurnedByItsDirection) {
    Playground play(lined);
    const Pixel point = play.pixelOf("objects[0].line[0]");
    play.drag(point, {point.x, point.y - 1 / play.unitsPerPixel()});
    EXPECT_NEAR(play.at("objects[0].line[0]")[1].get<double>(), 1, 0.02);
    EXPECT_EQ(play.at("objects[0].line[1]"), Json::parse("[1,0]"));
    const Pixel end = play.pixelOf("objects[0].line[1]");
    play.drag(end, {end.x, end.y - 1 / play.unitsPerPixel()});
    EXPECT_NEAR(play.at("objects[0].line[1]")[1].get<double>(), 1, 0.02);
    EXPECT_NEAR(play.at("objects[0].line[0]")[1].get<double>(), 1, 0.02);
    EXPECT_TRUE(play.scene->undo() && play.scene->undo());
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(Line, KeysAndClicksMoveItAsADragDoes) {
    Playground keys(lined);
    keys.pixelOf("objects[0].line[0]");
    keys.view.setStep(0.5);
    EXPECT_TRUE(keys.view.key("ArrowUp", true, 0));
    EXPECT_TRUE(keys.view.key("ArrowUp", false, 0));
    Playground clicks(lined);
    const Pixel at = clicks.pixelOf("objects[0].line[0]");
    EXPECT_TRUE(clicks.view.place({at.x, at.y - 0.5 / clicks.unitsPerPixel()}, "move"));
    EXPECT_NEAR(clicks.at("objects[0].line[0]")[1].get<double>(), 0.5, 0.01);
    EXPECT_EQ(keys.at("objects[0].line[0]"), Json::parse("[0,0.5]"));
    EXPECT_EQ(scene::parseJson(keys.view.held())->value("kind", ""), "line");
    EXPECT_TRUE(keys.view.key("Delete", true, 0));
    EXPECT_EQ(keys.at("objects[0].line").size(), 2U);
    EXPECT_TRUE(keys.view.key("PageDown", true, 0));
    EXPECT_EQ(keys.view.selected()->path(), "objects[0].line[1]");
}

TEST(Line, HasNoStretchOfTheCurveThatItRules) {
    Playground play(lined);
    play.pixelOf("objects[0].line[1]");
    EXPECT_TRUE(play.view.figure()->panes.front().below.empty());
}

TEST(Compared, BFunctionsStandInTheSameRowsWithALegend) {
    const auto curve = [](const char* id, const char* family) {
        return std::string(R"({"id":")") + id + R"(","type":"blending-curve","bFunction":{"family":")" + family +
               R"("},"model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4},"form":"closed"})";
    };
    const auto document = [&](const std::string& objects) {
        return R"({"knotwork":1,"view":{"panes":["curve","bFunction"]},"objects":[)" + objects + "]}";
    };
    Playground two(document(curve("a", "polynomial") + "," + curve("b", "linear") + "," + curve("c", "linear")).c_str());
    const PaneFigure* rows = two.view.figure()->find(Pane::bFunction);
    const auto graphs = [](const PaneFigure& pane) {
        return std::count_if(pane.shapes.begin(), pane.shapes.end(), [](const Painted& painted) {
            return painted.shape->kind == drawing::Kind::polyline;
        });
    };
    EXPECT_EQ(graphs(*rows), 2);
    std::vector<std::string> legend;
    for (const ui::Label& label : rows->plot.labels) {
        if (label.text.find(": ") != std::string::npos) legend.push_back(label.text);
    }
    EXPECT_EQ(legend, (std::vector<std::string>{"a: order 1 at 0, 1 at 1", "b: order 0 at 0, 0 at 1"}));
    Playground one(document(curve("a", "polynomial") + "," + curve("b", "polynomial")).c_str());
    EXPECT_EQ(graphs(*one.view.figure()->find(Pane::bFunction)), 1);
}

TEST(Names, OfATraceStayInThePane) {
    Playground play(R"({"knotwork":1,"view":{"panes":["curve"]},"objects":[
        {"type":"bspline-curve","degree":3,"points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]],
         "trace":{"algorithm":"factor-matrices","t":2.9,"frame":2}}]})");
    play.view.resize(376, 226, 2);
    const PaneFigure& pane = play.view.figure()->panes.front();
    bool named = false;
    for (const ui::Label& label : pane.plot.labels) {
        if (label.text.rfind("Factor", 0) != 0) continue;
        named = true;
        const ui::Box box = ui::boxOf(label);
        EXPECT_GE(box.x, pane.plot.box.x);
        EXPECT_LE(box.right(), pane.plot.box.right());
        EXPECT_LE(box.bottom(), pane.plot.box.bottom());
    }
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace knotwork::app
