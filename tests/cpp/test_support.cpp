// What a point, a knot, a patch and a vertex rule, and what a view shows of that and of a drag.
#include "app/support.hpp"
#include "support/playground.hpp"

#include <algorithm>

namespace knotwork::app {
namespace {

constexpr const char* net = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"n",
    "type":"bspline-surface","degree":[2,1],"points":[[[0,0,0],[0,1,0],[0,2,0]],
    [[1,0,0],[1,1,2],[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]],[[3,0,0],[3,1,0],[3,2,1]],
    [[4,0,0],[4,1,0],[4,2,0]]],"show":{"points":true,"polygon":true}}]})";
constexpr const char* tetrahedron = R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"m",
    "type":"subdivision-surface","scheme":"loop","levels":1,
    "mesh":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
    "faces":[[0,2,1],[0,1,3],[1,2,3],[2,0,3]]},"show":{"points":true}}]})";
constexpr const char* ring = R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve",
    "degree":2,"form":"closed","points":[[0,0],[2,0],[3,1],[3,3],[1,4],[-1,2],[-1,1]]}]})";

double distanceAt(const scene::Scene& a, const scene::Scene& b, double u, double v) {
    const SurfacePlace at{u, v, Side::right, Side::right};
    return glm::distance(pointAt(*a.state().objects[0]->body.surface(), at),
                         pointAt(*b.state().objects[0]->body.surface(), at));
}

TEST(Support, ANetPointMovesTheSurfaceInItsRectangleAndNowhereElse) {
    const auto before = sceneOf(net);
    const auto after = sceneOf(net);
    ASSERT_TRUE(after->execute(Json{{"move", "objects[0].points[3][0]"}, {"by", {0, 0, 1}}}));
    const auto part = ruledRectangle(*before->state().objects[0]->body.surface(), 3, 0);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->u, (Interval{1, 3}));
    EXPECT_EQ(part->v, (Interval{0, 1}));
    for (double u = 0.05; u < 3; u += 0.1) {
        for (double v = 0.05; v < 2; v += 0.1) {
            const bool inside = part->u.contains(u) && part->v.contains(v);
            EXPECT_EQ(distanceAt(*before, *after, u, v) > 0, inside) << u << ' ' << v;
        }
    }
}

TEST(Support, AKnotMovesTheCurveWhereTheFunctionsOnItLive) {
    const auto moves = [](const char* document, std::size_t knot, double t) {
        const auto before = sceneOf(document);
        const auto after = sceneOf(document);
        const std::string path = "objects[0].knots[" + std::to_string(knot) + "]";
        EXPECT_TRUE(after->execute(Json{{"move", path}, {"by", 0.1}}));
        return glm::distance(pointAt(*before->state().objects[0]->body.curve(), t),
                             pointAt(*after->state().objects[0]->body.curve(), t)) > 1e-15;
    };
    // Of the clamped cubic with knots 0, 0, 0, 0, 1, 2, 3, 3, 3, 3 each inner knot rules all; of a
    // quadratic ring knot 3 rules [0, 6] of [0, 7].
    const auto all = ruledByKnot(*sceneOf(spline)->state().objects[0]->body.curve(), 4);
    ASSERT_TRUE(all);
    EXPECT_EQ(*all, (Interval{0, 3}));
    const auto most = ruledByKnot(*sceneOf(ring)->state().objects[0]->body.curve(), 3);
    ASSERT_TRUE(most);
    EXPECT_EQ(*most, (Interval{0, 6}));
    EXPECT_FALSE(moves(ring, 3, 6.5));
    EXPECT_TRUE(moves(ring, 3, 3.5));
}

const PaneFigure& pane(Playground& play) { return *play.view.figure()->find(Pane::curve); }

TEST(Support, APointedAtNetPointLightsUpItsPartOfTheSurface) {
    Playground play(net);
    const Pixel at = play.pixelOf("objects[0].points[4][2]");
    play.view.select("");
    EXPECT_TRUE(pane(play).below.empty());
    play.event("move", at, 0);
    ASSERT_EQ(pane(play).below.size(), 1u);
    const Shape& lines = pane(play).below.front();
    // Degree 2 and 1: the last point rules [2, 3] × [1, 2], whose far corner is the point itself.
    double nearest = 1e9;
    double leastX = 1e9;
    for (std::size_t k = 0; k < lines.positions.size() / 3; ++k) {
        nearest = std::min(nearest, glm::distance(positionOf(lines, k), Vec3(4, 2, 0)));
        leastX = std::min(leastX, lines.positions[3 * k]);
    }
    EXPECT_NEAR(nearest, 0, 1e-12);
    const auto& surface = *play.scene->state().objects[0]->body.surface();
    EXPECT_NEAR(leastX, pointAt(surface, {2, 1, Side::right, Side::right}).x, 1e-9);
}

TEST(Support, ASelectedVertexLightsUpItsEdges) {
    Playground play(tetrahedron);
    play.pixelOf("objects[0].mesh.vertices[3]");
    ASSERT_EQ(pane(play).below.size(), 1u);
    EXPECT_EQ(pane(play).below.front().indices.size(), 6u);
}

TEST(Support, ASelectedKnotLightsUpWhatItRules) {
    Playground play(spline);
    play.pixelOf("objects[0].knots[5]");
    EXPECT_EQ(pane(play).below.size(), 1u);
}

TEST(Reading, StandsBesideWhatIsDraggedInTheReadersLanguage) {
    Playground play(spline);
    Words words;
    words.decimalPoint = ",";
    play.view.setWords(words);
    const Pixel from = play.pixelOf("objects[0].points[2]");
    play.event("down", from, 1);
    play.event("move", {from.x + 40, from.y - 25}, 1);
    play.view.figure();
    const Json& p = play.at("objects[0].points[2]");
    const std::string x = ui::numberText(p[0].get<double>(), 2);
    std::string expected = "(" + x + "; ";
    std::replace(expected.begin(), expected.end(), '.', ',');
    EXPECT_NE(play.view.labels().find(expected), std::string::npos) << play.view.labels();
    play.event("up", {from.x + 40, from.y - 25}, 0);
    play.view.figure();
    EXPECT_EQ(play.view.labels().find(expected), std::string::npos);
}

TEST(Ghost, TheFormerShapeStaysWhileADragLasts) {
    Playground play(net);
    const Pixel from = play.pixelOf("objects[0].points[1][1]");
    play.event("down", from, 1);
    play.event("move", {from.x + 20, from.y - 40}, 1);
    bool former = false;
    for (const Shape& shape : pane(play).below) {
        for (std::size_t k = 0; k < shape.positions.size() / 3; ++k) {
            former = former || (shape.width == 1 && positionOf(shape, k) == Vec3(1, 1, 2));
        }
    }
    EXPECT_TRUE(former);
    play.event("up", {from.x + 20, from.y - 40}, 0);
    for (const Shape& shape : pane(play).below) EXPECT_NE(shape.width, 1);
}

}  // namespace
}  // namespace knotwork::app
