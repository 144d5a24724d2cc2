#include "scene/followed_locals.hpp"
#include "scene/scene.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <string>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

constexpr const char* moving = R"({
    "knotwork": 1,
    "objects": [
        {"id": "cut", "type": "blending-curve", "bFunction": {"family": "linear"}, "t": 2.5,
         "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 4},
         "knots": [0, 1, 2, 4, 6], "trace": {"algorithm": "blend", "frame": 1}},
        {"id": "given", "type": "blending-curve", "bFunction": {"family": "linear"},
         "locals": [{"type": "line-curve", "from": [0,0], "to": [1,1], "domain": [-9, 9]},
                    {"type": "line-curve", "from": [2,0], "to": [1,1], "domain": [-9, 9]},
                    {"type": "line-curve", "from": [3,0], "to": [1,1], "domain": [-9, 9]},
                    {"type": "line-curve", "from": [4,0], "to": [1,1], "domain": [-9, 9]}],
         "poses": [{"local": 1, "translate": [1, 0]}, {"local": 3, "translate": [3, 0]}]},
        {"id": "patches", "type": "blending-surface", "bFunction": {"family": "linear"},
         "model": {"type": "parametric-surface", "name": "cylinder"}, "locals": [4, 3]}],
    "effects": [{"target": "cut", "kind": "translate", "by": [1, 0], "local": 1},
                {"target": "cut", "kind": "rotate", "angle": 1, "local": 3},
                {"target": "given", "kind": "translate", "by": [0, 1], "local": 2},
                {"target": "patches", "kind": "translate", "by": [0, 1, 0], "local": [2, 1]},
                {"target": "cut", "kind": "simulate"},
                {"target": "cut", "kind": "morph"},
                {"target": "cut", "kind": "colour", "to": "#ff0000"}]})";

Scene open() { return Scene::open(json(moving)).value(); }

/// Whole numbers as people write them.
std::string numberText(const Json& number) {
    return std::to_string(static_cast<int>(number.get<double>()));
}

/// What each effect moves, in one line.
std::string locals(const Scene& scene) {
    std::string text;
    for (const auto& effect : scene.state().effects) {
        const Json* local = member(effect->spec, "local");
        text += (text.empty() ? "" : " ") +
                (local == nullptr      ? stringOr(effect->spec, "kind", "")
                 : local->is_array() ? "[" + numberText((*local)[0]) + "," +
                                           numberText((*local)[1]) + "]"
                                     : numberText(*local));
    }
    return text;
}

struct Following {
    const char* command;
    const char* locals;
};

TEST(FollowedLocals, EffectsFollowTheirLocalOrGoWithItInOneStep) {
    constexpr const char* rest = " simulate morph colour";
    constexpr Following cases[] = {
        {R"({"insertKnot": {"object": "cut", "at": 1.5}})", "1 4 2 [2,1]"},
        {R"({"insertKnot": {"object": "cut", "at": 0.5}})", "2 4 2 [2,1]"},
        {R"({"remove": "objects[0].knots[2]"})", "1 2 2 [2,1]"},
        {R"({"remove": "objects[0].knots[1]"})", "2 2 [2,1]"},
        {R"({"remove": "objects[0].knots[3]"})", "1 2 [2,1]"},
        {R"({"set": "objects[0].locals.count", "value": 3})", "1 2 [2,1]"},
        {R"({"set": "objects[0].locals.count", "value": 7})", "1 3 2 [2,1]"},
        {R"({"remove": "objects[1].locals[0]"})", "1 3 1 [2,1]"},
        {R"({"remove": "objects[1].locals[2]"})", "1 3 [2,1]"},
        {R"({"remove": "objects[1].locals[3]"})", "1 3 2 [2,1]"},
        {R"({"insert": "objects[1].locals[2]", "value": {"type": "line-curve", "from": [2.5,0],
             "to": [1,1], "domain": [-9, 9]}})", "1 3 3 [2,1]"},
        {R"({"insertKnot": {"object": "patches", "at": 0.5, "along": "u"}})", "1 3 2 [3,1]"},
        {R"({"remove": "objects[2].knots[1][0]"})", "1 3 2 [2,0]"},
        {R"({"remove": "objects[2].knots[1][1]"})", "1 3 2"},
        {R"({"set": "objects[2].locals[0]", "value": 2})", "1 3 2"},
        {R"({"set": "objects[2].type", "value": "parametric-surface"})", "1 3 2"},
        {R"({"move": "objects[0].knots[1]", "to": 1.25, "recut": false})", "1 3 2 [2,1]"},
    };
    for (const Following& one : cases) {
        SCOPED_TRACE(one.command);
        Scene scene = open();
        const Json before = scene.document();
        expectDone(scene, one.command);
        EXPECT_EQ(locals(scene), std::string(one.locals) + rest);
        const Json after = scene.document();
        EXPECT_TRUE(Scene::open(after).ok());
        EXPECT_TRUE(scene.undo());
        EXPECT_FALSE(scene.canUndo());
        EXPECT_EQ(scene.document(), before);
        EXPECT_TRUE(scene.redo());
        EXPECT_EQ(scene.document(), after);
    }
}

TEST(FollowedLocals, ANewTypeKeepsTheEffectsThatItCanHave) {
    Scene scene = open();
    expectDone(scene, R"({"set": "objects[0].type", "value": "parametric-curve"})");
    EXPECT_EQ(locals(scene), "2 [2,1] morph colour");
    expectDone(scene, R"({"set": "objects[0].type", "value": "parametric-surface"})");
    EXPECT_EQ(locals(scene), "2 [2,1] colour");
}

TEST(FollowedLocals, PosesFollowTheirLocalCurveInAList) {
    Scene scene = open();
    const auto poses = [&] { return scene.document()["objects"][1]["poses"]; };
    expectDone(scene, R"({"remove": "objects[1].locals[0]"})");
    ASSERT_EQ(poses().size(), 2U);
    EXPECT_EQ(poses()[0]["local"], 0);
    EXPECT_EQ(poses()[1]["local"], 2);
    EXPECT_EQ(poses()[1]["translate"], json("[3, 0]"));
    expectDone(scene, R"({"remove": "objects[1].locals[0]"})");
    ASSERT_EQ(poses().size(), 1U);
    EXPECT_EQ(poses()[0]["local"], 1);
}

TEST(KeptParameters, AKnotMovedWithoutCuttingKeepsAllThatTheObjectHasBesidesItsShape) {
    Scene scene = open();
    const Json before = scene.document()["objects"][0];
    expectDone(scene, R"({"move": "objects[0].knots[1]", "to": 1.25, "recut": false})");
    for (const char* own : {"id", "style", "show", "t", "trace"}) {
        EXPECT_EQ(scene.document()["objects"][0][own], before[own]) << own;
    }
}

TEST(KeptParameters, ANewTypeKeepsTheParameterAndTheTraceThatItCanHave) {
    Scene scene = Scene::open(json(R"({"knotwork": 1, "objects": [
        {"type": "blending-curve", "bFunction": {"family": "linear"}, "t": 5,
         "model": {"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[3,3],[4,1],[6,2],[7,0],[8,1],
                                                                   [9,0]]},
         "locals": {"count": 4}, "trace": {"algorithm": "blend", "frame": 1}}]})")).value();
    const auto object = [&] { return scene.document()["objects"][0]; };
    expectDone(scene, R"({"set": "objects[0].type", "value": "bezier-curve"})");
    EXPECT_EQ(object()["t"], 1);  // the end of [0, 1]
    EXPECT_EQ(member(object(), "trace"), nullptr);
    expectDone(scene, R"({"set": "objects[0].type", "value": "bspline-curve"})");
    expectDone(scene, R"({"set": "objects[0].trace", "value": {"algorithm": "de-boor", "t": 0.5}})");
    expectDone(scene, R"({"set": "objects[0].type", "value": "subdivision-surface"})");
    EXPECT_EQ(member(object(), "t"), nullptr);
    EXPECT_EQ(member(object(), "trace"), nullptr);
}

TEST(KeptParameters, ATraceStaysWhereItsAlgorithmSuitsTheNewTypeToo) {
    Scene scene = Scene::open(json(R"({"knotwork": 1, "objects": [
        {"type": "blending-curve", "bFunction": {"family": "linear"}, "locals": {"count": 4},
         "model": {"type": "parametric-curve", "name": "circle"}, "trace": {"algorithm": "blend"}}]})"))
                      .value();
    expectDone(scene, R"({"set": "objects[0].type", "value": "blending-surface"})");
    EXPECT_EQ(scene.document()["objects"][0]["trace"]["algorithm"], "blend");
}

}  // namespace
}  // namespace knotwork::scene
