// The curvature over the parameter, and the line that counts crossings, as drawings.
#include "geometry/differential.hpp"
#include "support/drawings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::drawing {
namespace {

using namespace test;

const std::string wave = R"("type": "bspline-curve", "degree": 3,
    "points": [[0,0],[1,3],[4,2],[5,-1],[7,1],[8,4]])";

scene::Scene shown(const std::string& curve, const std::string& more = "") {
    return sceneOf({"{" + curve + R"(, "show": {"curvature": true})" + more + "}"});
}

std::vector<const Shape*> inPane(const Drawing& drawing, Role role, Kind kind, int index) {
    auto found = withRole(drawing, role, Pane::curvature);
    std::erase_if(found, [&](const Shape* shape) {
        return shape->kind != kind || shape->index != index;
    });
    return found;
}

std::vector<const Shape*> graphs(const Drawing& drawing) {
    return inPane(drawing, Role::comb, Kind::polyline, 0);
}

const Curve& curveOf(const scene::Scene& scene) { return *scene.state().objects[0]->body.curve(); }

double curvatureAt(const Curve& curve, double t) {
    return frameAt(curve, t, t < domain(curve).end ? Side::right : Side::left).curvature;
}

TEST(CurvaturePane, IsTheSignedCurvatureOverTheParameter) {
    const scene::Scene scene = shown(wave);
    const Drawing drawing = draw(scene.state(), {});
    const auto lines = graphs(drawing);
    ASSERT_EQ(lines.size(), 1U);  // C², so without jumps
    double least = 0;
    double most = 0;
    for (std::size_t i = 0; i < lines[0]->positions.size() / 3; ++i) {
        const Vec3 p = positionIn(*lines[0], i);
        EXPECT_NEAR(p.y, curvatureAt(curveOf(scene), p.x), 1e-9);
        least = std::min(least, p.y);
        most = std::max(most, p.y);
        if (i > 0) {
            EXPECT_GE(p.x, positionIn(*lines[0], i - 1).x);
        }
    }
    EXPECT_LT(least, -0.1);
    EXPECT_GT(most, 0.1);
    EXPECT_EQ(lines[0]->positions.front(), 0);
    EXPECT_EQ(lines[0]->positions[lines[0]->positions.size() - 3], 3);
}

TEST(CurvaturePane, ItsChordsAreCloseToTheGraph) {
    const scene::Scene scene = shown(R"("type": "parametric-curve", "name": "ellipse", "parameters": {"a": 5, "b": 1})");
    const Drawing drawing = draw(scene.state(), {});
    for (const Shape* line : graphs(drawing)) {
        for (std::size_t i = 0; i + 1 < line->positions.size() / 3; ++i) {
            const Vec3 a = positionIn(*line, i), b = positionIn(*line, i + 1);
            const double middle = curvatureAt(curveOf(scene), (a.x + b.x) / 2);
            EXPECT_NEAR((a.y + b.y) / 2, middle, 0.05);
        }
    }
}

TEST(CurvaturePane, IsNotNegativeInSpaceAndConstantOfAHelix) {
    const Drawing drawing = draw(shown(R"("type": "parametric-curve", "name": "helix")").state(), {});
    const double c = 1 / (2 * 3.141592653589793);
    for (const Shape* line : graphs(drawing)) {
        for (std::size_t i = 0; i < line->positions.size() / 3; ++i) {
            EXPECT_NEAR(positionIn(*line, i).y, 1 / (1 + c * c), 1e-12);
        }
    }
    EXPECT_EQ(graphs(drawing).size(), 1U);
}

TEST(CurvaturePane, IsExactlyZeroOfALineWhateverItsDirection) {
    const Drawing drawing = draw(shown(R"("type": "bspline-curve", "degree": 3, "points": [[0.1,0.3],[0.2,0.6],[0.5,1.5],[0.9,2.7]])").state(), {});
    ASSERT_EQ(graphs(drawing).size(), 1U);
    for (std::size_t i = 1; i < graphs(drawing)[0]->positions.size(); i += 3) {
        EXPECT_EQ(graphs(drawing)[0]->positions[i], 0);
    }
}

TEST(CurvaturePane, JumpsWhereTheCurvatureDoes) {
    const Drawing drawing = draw(shown(R"("type": "bspline-curve", "degree": 2, "points": [[0,0],[1,3],[4,2],[5,-1],[7,1]])").state(), {});
    ASSERT_EQ(graphs(drawing).size(), 3U);
    EXPECT_EQ(positionIn(*graphs(drawing)[1], 0).x, 1);
    const Shape& before = *graphs(drawing)[0];
    EXPECT_EQ(before.positions[before.positions.size() - 3], 1);
}

TEST(CurvaturePane, EndsAtAHeightWhereACuspHasNone) {
    const Drawing drawing = draw(shown(R"("type": "parametric-curve", "name": "astroid")").state(), {});
    double height = 0;
    for (const Shape* line : graphs(drawing)) {
        for (std::size_t i = 0; i < line->positions.size() / 3; ++i) {
            ASSERT_TRUE(std::isfinite(positionIn(*line, i).y));
            height = std::max(height, std::abs(positionIn(*line, i).y));
        }
    }
    EXPECT_LT(height, 40);
    EXPECT_GT(height, 2);
    const auto labels = inPane(drawing, Role::comb, Kind::label, 0);
    ASSERT_EQ(labels.size(), 5U);  // four cusps, of which one is at the seam
    for (const Shape* label : labels) {
        EXPECT_EQ(label->text, "\u2212\u221e");
        EXPECT_NEAR(positionIn(*label, 0).y, -height, 1e-9);
    }
    EXPECT_NEAR(positionIn(*labels[1], 0).x, 3.141592653589793 / 2, 1e-3);
}

TEST(CurvaturePane, SaysHowHighAFinitePeakGoes) {
    // κ = a b / (…)^(3/2) of a flat ellipse has its maximum a / b² = 400 at t = 0 and π.
    const Drawing drawing = draw(shown(R"("type": "parametric-curve", "name": "ellipse", "parameters": {"a": 4, "b": 0.1})").state(), {});
    const auto labels = inPane(drawing, Role::comb, Kind::label, 0);
    ASSERT_EQ(labels.size(), 3U);
    for (const Shape* label : labels) EXPECT_EQ(label->text, "400");
}

TEST(CurvaturePane, MarksTheKnotsAndTheParameter) {
    const scene::Scene scene = shown(wave, R"(, "t": 1.25)");
    const Drawing drawing = draw(scene.state(), {});
    std::vector<double> knots;
    for (const Shape* shape : withRole(drawing, Role::knots, Pane::curvature)) {
        const Vec3 p = positionIn(*shape, 0);
        EXPECT_NEAR(p.y, curvatureAt(curveOf(scene), p.x), 1e-9);
        knots.push_back(p.x);
    }
    EXPECT_EQ(knots, (std::vector<double>{0, 1, 1, 2, 2, 3}));  // from either side
    const auto at = inPane(drawing, Role::comb, Kind::points, 1);
    ASSERT_EQ(at.size(), 1U);
    EXPECT_EQ(positionIn(*at[0], 0).x, 1.25);
    EXPECT_NEAR(positionIn(*at[0], 0).y, curvatureAt(curveOf(scene), 1.25), 1e-12);
    Options without;
    without.panes.curvature = false;
    EXPECT_TRUE(withRole(draw(scene.state(), without), Role::comb, Pane::curvature).empty());
}

TEST(Crossings, AreDrawnWithTheLineThatCountsThem) {
    const scene::Scene scene = sceneOf({"{" + wave + R"(, "line": [[0, 1], [2, 0]], "show": {"crossings": true}})"});
    const Drawing drawing = draw(scene.state(), {});
    const auto found = lineCrossings(curveOf(scene), *scene.state().objects[0]->line);
    std::size_t ofCurve = 0, ofPolygon = 0;
    std::string label;
    for (const Shape* shape : withRole(drawing, Role::frame)) {
        if (shape->index == 5) ofCurve = shape->positions.size() / 3;
        if (shape->index == 6) ofPolygon = shape->positions.size() / 3;
        if (shape->kind == Kind::label) label = shape->text;
    }
    EXPECT_EQ(ofCurve, found->curve.size());
    EXPECT_EQ(ofPolygon, found->polygon.size());
    EXPECT_EQ(label, std::to_string(ofCurve) + " \u2264 " + std::to_string(ofPolygon));
    EXPECT_EQ(ofCurve, 3U);
    const auto held = withRole(drawing, Role::handle);
    ASSERT_EQ(held.size(), 1U);
    EXPECT_EQ(held[0]->path, "objects[0].line");
    EXPECT_EQ(positionIn(*held[0], 1), Vec3(2, 1, 0));
}

TEST(Crossings, OfAnObjectWithoutALineGetOneThroughItsMiddle) {
    const scene::Scene scene = sceneOf({"{" + wave + R"(, "show": {"crossings": true}})"});
    const scene::Json& line = scene.state().objects[0]->spec["line"];
    EXPECT_EQ(scene::dumpJson(line), "[[4.0,1.5],[2.0,0.0]]");
    const scene::Scene again = sceneOf({scene::dumpJson(scene.state().objects[0]->spec)});
    EXPECT_EQ(again.document(), scene.document());
    EXPECT_EQ(scene::member(sceneOf({"{" + wave + "}"}).state().objects[0]->spec, "line"), nullptr);
}

TEST(Crossings, ALineWithoutDirectionIsRefused) {
    const auto refused = scene::Scene::open(scene::parseJson(
        R"({"knotwork": 1, "objects": [{)" + wave + R"(, "line": [[0, 1], [0, 0]]}]})").value());
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, Code::outOfRange);
    EXPECT_EQ(refused.error().path, "objects[0].line[1]");
}

TEST(BFunctions, AreInTheColourAndTheDashesOfTheirCurve) {
    const auto curve = [](const char* style) {
        return R"({"type": "blending-curve", "bFunction": {"family": "polynomial"}, "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 4}, "style": )" + std::string(style) + "}";
    };
    const Drawing drawing = drawn({curve(R"({"colour": "#123456"})"), curve(R"({"colour": "#654321", "dashed": true})")});
    for (const Shape* shape : withRole(drawing, Role::bFunction, Pane::bFunction)) {
        EXPECT_EQ(scene::formatColour(shape->colour), shape->object == 0 ? "#123456" : "#654321");
        EXPECT_EQ(shape->dashed, shape->object == 1);
    }
    for (const Shape* shape : withRole(drawing, Role::curve)) EXPECT_EQ(shape->dashed, shape->object == 1);
}

}  // namespace
}  // namespace knotwork::drawing
