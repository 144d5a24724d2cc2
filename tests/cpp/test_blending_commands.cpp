// Commands on blending curves: knots that move with and without their local curves, kinds, spacing.
#include "scene/scene.hpp"
#include "support/blends.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

Scene lines() {
    return Scene::open(json(R"({"knotwork": 1, "objects": [
        {"id": "blend", "type": "blending-curve", "bFunction": {"family": "expo-rational"},
         "model": {"type": "parametric-curve", "name": "trefoil"}, "form": "open",
         "locals": {"count": 5, "kind": "line"}, "knots": [0, 1, 2, 3, 4],
         "poses": [{"local": 2, "rotate": {"angle": 1}, "translate": [1, 0]}],
         "style": {"width": 4}}]})"))
        .value();
}

const Object& blend(const Scene& scene) { return *scene.state().objects[0]; }

Vec3 slopeAt(const Scene& scene, double t) {
    return test::rowsOf<2>(*blend(scene).body.curve(), t)[1];
}

TEST(BlendingCommand, AMovedKnotCutsItsLocalCurveAnewUnlessItIsToStay) {
    Scene scene = lines();
    const Vec3 before = slopeAt(scene, 1);
    expectDone(scene, R"({"move": "objects[0].knots[1]", "to": 1.4})");
    EXPECT_GT(glm::length(slopeAt(scene, 1.4) - before), 0.1);
    EXPECT_TRUE(blend(scene).spec.contains("model"));
    EXPECT_TRUE(scene.undo());
    expectDone(scene, R"({"move": "objects[0].knots[1]", "by": 0.4, "recut": false})");
    EXPECT_LT(glm::length(slopeAt(scene, 1.4) - before), 1e-13);
    EXPECT_TRUE(blend(scene).spec["locals"].is_array());
    EXPECT_EQ(blend(scene).id, "blend");
    EXPECT_EQ(blend(scene).spec["style"]["width"], 4.0);
    // And on, with what is now given one by one.
    expectDone(scene, R"({"move": "objects[0].knots[1]", "to": 0.7, "recut": false})");
    EXPECT_LT(glm::length(slopeAt(scene, 0.7) - before), 1e-13);
    EXPECT_TRUE(scene.undo());
    EXPECT_TRUE(scene.undo());
    EXPECT_TRUE(blend(scene).spec.contains("model"));
}

TEST(BlendingCommand, AKnotOnItsNeighbourIsABreakAndAThirdIsRefused) {
    for (const char* recut : {"true", "false"}) {
        Scene scene = lines();
        const std::string end = std::string(R"(, "recut": )") + recut + "}";
        expectDone(scene, R"({"move": "objects[0].knots[2]", "to": 1)" + end);
        const auto& curve = *blend(scene).body.curve();
        const Vec3 jump = test::rowsOf<1>(curve, 1, Side::right)[0] -
                          test::rowsOf<1>(curve, 1, Side::left)[0];
        EXPECT_GT(glm::length(jump), 0.5);
        expectRefused(scene, R"({"move": "objects[0].knots[3]", "to": 1)" + end,
                      Code::knotsMultiplicity, "objects[0].knots[3]");
        expectRefused(scene, R"({"move": "objects[0].knots[3]", "to": 0.5)" + end,
                      Code::knotsDecreasing, "objects[0].knots[3]");
    }
}

TEST(BlendingCommand, RecutIsForKnotsOfBlendingCurvesOnly) {
    Scene scene = lines();
    expectRefused(scene, R"({"move": "objects[0].knots[1]", "to": 1, "recut": 0})", Code::wrongType,
                  "recut");
    expectRefused(scene, R"({"move": "objects[0].poses[0].translate", "to": [1, 1], "recut": false})",
                  Code::notSupported, "recut");
    expectRefused(scene, R"({"set": "objects[0].locals.count", "value": 4, "recut": false})",
                  Code::unknownField, "recut");
    expectRefused(scene, R"({"move": "objects[0].knots[1]", "to": "1", "recut": false})",
                  Code::wrongType, "objects[0].knots[1]");
    expectRefused(scene, R"({"move": "objects[0].knots[9]", "to": 1, "recut": false})",
                  Code::unknownField, "objects[0].knots[9]");
}

TEST(BlendingCommand, AnotherKindHasItsOwnDegree) {
    Scene scene = lines();
    expectDone(scene, R"({"set": "objects[0].locals.kind", "value": "bezier"})");
    expectDone(scene, R"({"set": "objects[0].locals.degree", "value": 9})");
    expectDone(scene, R"({"set": "objects[0].locals.kind", "value": "bspline"})");
    EXPECT_EQ(numberOr(blend(scene).spec["locals"], "degree", 0), 3);
    expectDone(scene, R"({"set": "objects[0].locals.kind", "value": "arc"})");
    EXPECT_EQ(member(blend(scene).spec["locals"], "degree"), nullptr);
}

TEST(BlendingCommand, SpacingPutsTheKnotsAndAMovedKnotEndsIt) {
    Scene scene = lines();
    expectDone(scene, R"({"set": "objects[0].spacing", "value": "length"})");
    EXPECT_NE(blend(scene).spec["knots"], json("[0,1,2,3,4]"));
    const Json spaced = blend(scene).spec["knots"];
    expectDone(scene, R"({"set": "objects[0].model.parameters.scale", "value": 3})");
    EXPECT_EQ(blend(scene).spec["spacing"], "length");
    expectDone(scene, R"({"set": "objects[0].locals.count", "value": 7})");
    EXPECT_EQ(blend(scene).spec["knots"].size(), 7U);
    EXPECT_EQ(blend(scene).spec["spacing"], "length");
    expectDone(scene, R"({"move": "objects[0].knots[1]", "to": 0.5})");
    EXPECT_EQ(blend(scene).spec["spacing"], "parameter");
    EXPECT_EQ(blend(scene).spec["knots"][1], 0.5);
    expectDone(scene, R"({"set": "objects[0].spacing", "value": "length"})");
    expectDone(scene, R"({"insertKnot": {"object": "blend", "at": 0.7}})");
    EXPECT_EQ(blend(scene).spec["spacing"], "parameter");
    expectDone(scene, R"({"set": "objects[0].spacing", "value": "parameter"})");
}

}  // namespace
}  // namespace knotwork::scene
