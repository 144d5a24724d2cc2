#include "geometry/bspline_curve.hpp"
#include "scene/scene.hpp"
#include "support/curves.hpp"
#include "support/gates.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <string>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

constexpr const char* curves = R"({
    "knotwork": 1,
    "objects": [
        {"id": "a", "type": "bspline-curve", "degree": 2, "knots": [0,0,0,1,3,4,4,4],
         "points": [[0,0],[1,2],[3,3],[5,0],[6,2]], "weights": [1,2,1,1,3],
         "style": {"colour": "#123456"}},
        {"id": "b", "type": "bspline-curve", "degree": 3, "form": "closed",
         "points": [[0,0],[1,0],[2,1],[1,2],[0,2],[-1,1]]},
        {"id": "c", "type": "blending-curve", "bFunction": {"family": "linear"},
         "model": {"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[3,3],[5,0]]},
         "locals": {"count": 4}, "poses": [{"local": 1, "translate": [1, 0]}, {"local": 3}]}]})";

Scene open() { return Scene::open(json(curves)).value(); }

const Json& object(const Scene& scene, std::size_t i) { return scene.state().objects[i]->spec; }

TEST(KnotEdits, InsertingAKnotByItsListDoesNotMoveTheCurve) {
    for (const auto& [index, path] : {std::pair{0U, "objects[0].knots"}, {0U, "objects[0].knots[4]"},
                                     {1U, "objects[1].knots"}, {2U, "objects[2].model.knots"}}) {
        Scene scene = open();
        const Curve before = *scene.state().objects[index]->body.curve();
        const Json was = object(scene, index);
        expectDone(scene, R"({"insert": ")" + std::string(path) + R"(", "value": 1.5})");
        EXPECT_LE(test::distanceBetween(before, *scene.state().objects[index]->body.curve()),
                  5 * test::gates::refinement);
        EXPECT_NE(object(scene, index), was);
        EXPECT_EQ(object(scene, index)["style"], was["style"]);
        EXPECT_TRUE(scene.undo());
        EXPECT_EQ(object(scene, index), was);
    }
}

TEST(KnotEdits, RemovingAnInsertedKnotGivesTheCurveBack) {
    Scene scene = open();
    const Curve before = *scene.state().objects[0]->body.curve();
    expectDone(scene, R"({"insert": "objects[0].knots", "value": 2})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0, 0, 0, 1, 2, 3, 4, 4, 4]"));
    EXPECT_EQ(object(scene, 0)["weights"].size(), 6U);
    expectDone(scene, R"({"remove": "objects[0].knots[4]"})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0, 0, 0, 1, 3, 4, 4, 4]"));
    EXPECT_LE(test::distanceBetween(before, *scene.state().objects[0]->body.curve()), 5e-13);
}

TEST(KnotEdits, RemovingAKnotTakesAPointWithIt) {
    Scene scene = open();
    expectDone(scene, R"({"remove": "objects[0].knots[3]"})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0, 0, 0, 3, 4, 4, 4]"));
    EXPECT_EQ(object(scene, 0)["points"].size(), 4U);
    EXPECT_EQ(object(scene, 0)["weights"].size(), 4U);
    EXPECT_EQ(object(scene, 0)["points"][0], json("[0, 0]"));
    EXPECT_EQ(object(scene, 0)["points"][3], json("[6, 2]"));
    expectDone(scene, R"({"remove": "objects[1].knots[2]"})");
    EXPECT_EQ(object(scene, 1)["knots"], json("[0, 1, 3, 4, 5, 6]"));
    EXPECT_EQ(object(scene, 1)["points"].size(), 5U);
}

TEST(KnotEdits, OfABlendingCurveBringAndTakeALocalCurve) {
    Scene scene = open();
    expectDone(scene, R"({"insert": "objects[2].knots", "value": 0.1})");
    EXPECT_EQ(object(scene, 2)["locals"]["count"], 5.0);
    EXPECT_EQ(object(scene, 2)["knots"][1], 0.1);
    EXPECT_EQ(object(scene, 2)["poses"][0]["local"], 2.0);
    EXPECT_EQ(object(scene, 2)["poses"][1]["local"], 4.0);
    expectDone(scene, R"({"remove": "objects[2].knots[2]"})");
    EXPECT_EQ(object(scene, 2)["locals"]["count"], 4.0);
    ASSERT_EQ(object(scene, 2)["poses"].size(), 1U);
    EXPECT_EQ(object(scene, 2)["poses"][0]["local"], 3.0);
}

TEST(KnotEdits, RefusalsNameTheKnot) {
    Scene scene = open();
    expectRefused(scene, R"({"remove": "objects[0].knots[0]"})", Code::outOfRange, "objects[0].knots[0]");
    expectRefused(scene, R"({"remove": "objects[0].knots[7]"})", Code::outOfRange, "objects[0].knots[7]");
    expectRefused(scene, R"({"remove": "objects[0].knots[8]"})", Code::unknownField, "objects[0].knots[8]");
    expectRefused(scene, R"({"remove": "objects[1].knots[6]"})", Code::outOfRange, "objects[1].knots[6]");
    expectRefused(scene, R"({"insert": "objects[0].knots", "value": 5})", Code::outOfRange,
                  "objects[0].knots");
    expectRefused(scene, R"({"insert": "objects[0].knots", "value": 0})", Code::knotsMultiplicity,
                  "objects[0].knots");
    expectRefused(scene, R"({"insert": "objects[0].knots", "value": "1"})", Code::wrongType,
                  "objects[0].knots");
    expectRefused(scene, R"({"insert": "objects[2].knots[1]", "value": 7})", Code::outOfRange,
                  "objects[2].knots[1]");
}

TEST(KnotEdits, RemovingTheWholeListBringsTheDefaultBack) {
    Scene scene = open();
    expectDone(scene, R"({"remove": "objects[0].knots"})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0, 0, 0, 1, 2, 3, 3, 3]"));
    EXPECT_EQ(object(scene, 0)["points"].size(), 5U);
}

}  // namespace
}  // namespace knotwork::scene
