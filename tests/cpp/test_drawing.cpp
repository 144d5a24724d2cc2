#include "drawing/drawing.hpp"

#include "scene/builtin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace knotwork::drawing {
namespace {

using scene::Json;
using scene::Scene;

Scene opened(std::string_view text) {
    return Scene::open(scene::parseJson(text).value()).value();
}

Scene builtin(std::string_view id) {
    const auto scenes = scene::builtinScenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& scene) { return scene.id == id; });
    return opened(found->document);
}

std::vector<const Shape*> withRole(const Drawing& drawing, Role role, Pane pane = Pane::curve) {
    std::vector<const Shape*> found;
    for (const Shape& shape : drawing.shapes) {
        if (shape.role == role && shape.pane == pane) found.push_back(&shape);
    }
    return found;
}

TEST(Drawing, ASplineShowsCurvePolygonPointsAndKnots) {
    const Drawing drawing = draw(builtin("bspline-forms").state(), {});
    ASSERT_EQ(withRole(drawing, Role::curve).size(), 1U);
    ASSERT_EQ(withRole(drawing, Role::polygon).size(), 1U);
    const auto points = withRole(drawing, Role::points);
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0]->positions.size(), 21U);
    EXPECT_EQ(points[0]->path, "objects[0].points");
    EXPECT_EQ(withRole(drawing, Role::knots)[0]->positions.size(), 15U);  // 5 distinct knots
    EXPECT_EQ(withRole(drawing, Role::basis, Pane::basis).size(), 7U);
    const auto line = withRole(drawing, Role::knots, Pane::knots);
    ASSERT_EQ(line.size(), 1U);
    EXPECT_EQ(line[0]->positions.size(), 33U);
    EXPECT_EQ(line[0]->positions[10], 3.0);  // the fourth of four equal knots lies in row 3
    EXPECT_EQ(line[0]->path, "objects[0].knots");
}

TEST(Drawing, BasisFunctionsSumToOneEverywhere) {
    for (const char* form : {"clamped", "open", "closed"}) {
        const Scene scene = opened(
            R"({"knotwork": 1, "objects": [{"type": "bspline-curve", "degree": 3, "form": ")" +
            std::string(form) +
            R"(", "points": [[0,0],[1,2],[3,3],[5,0],[6,2],[7,7]]}]})");
        const Drawing drawing = draw(scene.state(), {});
        std::map<double, double> sums;
        for (const Shape* shape : withRole(drawing, Role::basis, Pane::basis)) {
            // A knot inside a polyline stands twice in it, once for each span.
            std::map<double, double> own;
            for (std::size_t i = 0; i < shape->positions.size(); i += 3) {
                own[shape->positions[i]] = shape->positions[i + 1];
            }
            for (const auto& [t, value] : own) sums[t] += value;
        }
        EXPECT_GT(sums.size(), 40U);
        for (const auto& [t, sum] : sums) EXPECT_NEAR(sum, 1, 1e-12) << form << ' ' << t;
    }
}

TEST(Drawing, ABlendShowsItsLocalsHandlesAndBFunction) {
    const Drawing drawing = draw(builtin("b-functions").state(), {});
    const auto locals = withRole(drawing, Role::local);
    EXPECT_TRUE(std::any_of(locals.begin(), locals.end(), [](auto* s) { return s->dashed; }));
    EXPECT_TRUE(std::any_of(locals.begin(), locals.end(), [](auto* s) { return !s->dashed; }));
    const auto handles = withRole(drawing, Role::handle);
    ASSERT_EQ(handles.size(), 1U);
    EXPECT_EQ(handles[0]->positions.size(), 15U);
    EXPECT_EQ(handles[0]->path, "objects[0].poses");
    const auto blend = withRole(drawing, Role::bFunction, Pane::bFunction);
    ASSERT_EQ(blend.size(), 3U);
    EXPECT_EQ(blend[0]->positions[blend[0]->positions.size() - 2], 1.0);
    EXPECT_EQ(blend[1]->index, 1);
}

TEST(Drawing, AtPhaseZeroAndOneItIsTheRestingDrawingToTheBit) {
    const Scene scene = builtin("butterfly");
    const auto at = [&](std::optional<double> phase) {
        return draw(scene.state(), {.moment = {.phase = phase, .time = {}}, .tolerance = 1e-2});
    };
    const Drawing rest = at(std::nullopt);
    for (const double phase : {0.0, 1.0}) {
        const Drawing again = at(phase);
        ASSERT_EQ(again.shapes.size(), rest.shapes.size());
        for (std::size_t i = 0; i < rest.shapes.size(); ++i) {
            EXPECT_EQ(again.shapes[i].positions, rest.shapes[i].positions);
            EXPECT_EQ(again.shapes[i].colour, rest.shapes[i].colour);
        }
    }
    EXPECT_NE(at(0.5).shapes[1].positions, rest.shapes[1].positions);
}

TEST(Drawing, APolylineOfACurveKnowsTheCurveWhereItStands) {
    const Drawing drawing = draw(builtin("b-functions").state(), {});
    std::size_t parts = 0;
    for (const Shape& shape : drawing.shapes) {
        const bool curved = shape.role == Role::curve || shape.role == Role::local;
        ASSERT_EQ(shape.source != nullptr, curved) << roleName(shape.role);
        if (!curved) continue;
        ++parts;
        const auto& [curve, part, placement] = *shape.source;
        const Vec3 first = placement.point(pointAt(curve, part.start));
        const Vec3 last = placement.point(pointAt(curve, part.end));
        const std::size_t end = shape.positions.size();
        EXPECT_NEAR(first.x, shape.positions[0], 1e-12);
        EXPECT_NEAR(first.y, shape.positions[1], 1e-12);
        EXPECT_NEAR(last.x, shape.positions[end - 3], 1e-12);
        EXPECT_NEAR(last.y, shape.positions[end - 2], 1e-12);
    }
    EXPECT_EQ(parts, 14U);  // the ends of an open one have no dashed half outside
}

TEST(Drawing, BoundsHoldAllThatIsDrawnInTheCurvePane) {
    const Drawing drawing = draw(builtin("butterfly").state(), {});
    for (const Shape& shape : drawing.shapes) {
        if (shape.pane != Pane::curve) continue;
        for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
            EXPECT_LE(drawing.bounds.min.x, shape.positions[i]);
            EXPECT_GE(drawing.bounds.max.y, shape.positions[i + 1]);
        }
    }
    EXPECT_TRUE(draw(opened(R"({"knotwork": 1})").state(), {}).bounds.empty);
}

TEST(Drawing, WhatIsSwitchedOffIsNotDrawn) {
    Scene scene = builtin("b-functions");
    for (const char* key : {"curve", "knots", "locals", "handles", "basis", "bFunction"}) {
        ASSERT_TRUE(scene.execute({{"set", std::string("objects[0].show.") + key}, {"value", false}}).ok());
    }
    EXPECT_TRUE(draw(scene.state(), {}).shapes.empty());
}

}  // namespace
}  // namespace knotwork::drawing
