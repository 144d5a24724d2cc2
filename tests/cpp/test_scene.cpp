#include "scene/scene.hpp"

#include "scene/builtin.hpp"
#include "scene/fields.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;
using test::twoScene;

const Json& object(const Scene& scene, std::size_t i) { return scene.state().objects[i]->spec; }

TEST(Scene, ADocumentIsCompletedAndStable) {
    const Scene scene = twoScene();
    const Json document = scene.document();
    EXPECT_EQ(document["objects"][0]["id"], "c1");
    EXPECT_EQ(document["objects"][0]["style"]["width"], 2.5);
    EXPECT_EQ(document["effects"][1]["to"], "#ffcc00");
    EXPECT_EQ(document["effects"][0]["period"], 10.0);
    EXPECT_EQ(document["view"]["mode"], "2d");
    EXPECT_EQ(dumpJson(Scene::open(document)->document()), dumpJson(document));
}

TEST(Scene, EveryBuiltInSceneOpensAndIsListed) {
    ASSERT_GE(builtinScenes().size(), 20U);
    EXPECT_EQ(builtinScenes()[0].id, "butterfly");
    for (const BuiltinScene& scene : builtinScenes()) {
        const auto opened = Scene::open(json(scene.document));
        ASSERT_TRUE(opened.ok()) << scene.id << opened.error().path << opened.error().message;
        EXPECT_FALSE(opened->state().objects.empty());
    }
    EXPECT_EQ(describeScenes().size(), builtinScenes().size());
}

TEST(Scene, BadDocumentsAreRefusedWithTheirPlace) {
    const std::array<std::tuple<const char*, Code, const char*>, 12> refusals{{
        {"[]", Code::wrongType, ""},
        {"{}", Code::wrongType, "knotwork"},
        {R"({"knotwork": 2})", Code::version, "knotwork"},
        {R"({"knotwork": 0})", Code::outOfRange, "knotwork"},
        {R"({"knotwork": 1, "__proto__": {}})", Code::unknownField, "__proto__"},
        {R"({"knotwork": 1, "objects": {}})", Code::wrongType, "objects"},
        {R"({"knotwork": 1, "objects": [3]})", Code::wrongType, "objects[0]"},
        {R"({"knotwork": 1, "objects": [{"type": "parametric-curve", "name": "circle", "id": "a"},
            {"type": "parametric-curve", "name": "rose", "id": "a"}]})", Code::outOfRange,
         "objects[1].id"},
        {R"({"knotwork": 1, "objects": [{"type": "parametric-curve", "name": "circle",
            "style": {"colour": "red"}}]})", Code::syntax, "objects[0].style.colour"},
        {R"({"knotwork": 1, "effects": [{"target": "x", "kind": "rotate"}]})", Code::unknownName,
         "effects[0].target"},
        {R"({"knotwork": 1, "objects": [{"type": "parametric-curve", "name": "circle"}],
            "effects": [{"target": "c1", "kind": "simulate"}]})", Code::notSupported,
         "effects[0].kind"},
        {R"({"knotwork": 1, "view": {"panes": ["curve", "sound"]}})", Code::unknownName,
         "view.panes[1]"},
    }};
    for (const auto& [text, code, path] : refusals) {
        const auto opened = Scene::open(json(text));
        ASSERT_FALSE(opened.ok()) << text;
        EXPECT_EQ(codeName(opened.error().code), codeName(code)) << text << opened.error().message;
        EXPECT_EQ(opened.error().path, path) << text;
    }
}

TEST(Commands, SetAndMoveChangeOneFieldAndUndoTakesItBack) {
    Scene scene = twoScene();
    const std::string first = dumpJson(scene.document());
    expectDone(scene, R"({"set": "objects[1].bFunction.beta", "value": 3})");
    expectDone(scene, R"({"move": "objects[0].points[1]", "to": [1, 5]})");
    expectDone(scene, R"({"move": "objects[0].points[1]", "by": [0.5, 0]})");
    EXPECT_EQ(object(scene, 0)["points"][1], json("[1.5, 5]"));
    expectDone(scene, R"({"set": "title", "value": "Three"})");
    const std::string last = dumpJson(scene.document());
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(scene.undo());
    EXPECT_FALSE(scene.undo());
    EXPECT_EQ(dumpJson(scene.document()), first);
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(scene.redo());
    EXPECT_FALSE(scene.canRedo());
    EXPECT_EQ(dumpJson(scene.document()), last);
}

TEST(Commands, AGestureIsOneStepAndCanBeCancelled) {
    Scene scene = twoScene();
    const std::string first = dumpJson(scene.document());
    expectDone(scene, R"({"move": "objects[0].points[0]", "to": [1, 1], "gesture": "g1"})");
    expectDone(scene, R"({"move": "objects[0].points[0]", "to": [2, 2], "gesture": "g1"})");
    expectDone(scene, R"({"move": "objects[0].points[0]", "to": [9, 9], "gesture": "g2"})");
    scene.undo();
    EXPECT_EQ(object(scene, 0)["points"][0], json("[2, 2]"));
    scene.undo();
    EXPECT_EQ(dumpJson(scene.document()), first);
    expectDone(scene, R"({"move": "objects[0].points[0]", "to": [3, 3], "gesture": "g3"})");
    EXPECT_TRUE(scene.cancelGesture("g3"));
    EXPECT_FALSE(scene.cancelGesture("g3"));
    EXPECT_EQ(dumpJson(scene.document()), first);
    EXPECT_FALSE(scene.canRedo());
}

TEST(Commands, AnUntouchedObjectIsSharedBetweenSteps) {
    Scene scene = twoScene();
    const auto other = scene.state().objects[1];
    expectDone(scene, R"({"move": "objects[0].points[0]", "to": [1, 1]})");
    EXPECT_EQ(scene.state().objects[1], other);
}

TEST(Commands, PointsComeAndGoWithAKnotEach) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[0].knots", "value": [0, 0, 0, 1.1, 3.4, 4, 4, 4]})");
    expectDone(scene, R"({"insert": "objects[0].points[2]", "value": [2, 2]})");
    EXPECT_EQ(object(scene, 0)["points"].size(), 6U);
    EXPECT_EQ(object(scene, 0)["knots"].size(), 9U);
    expectDone(scene, R"({"insert": "objects[0].points[6]", "value": [7, 7]})");
    expectDone(scene, R"({"remove": "objects[0].points[0]"})");
    expectDone(scene, R"({"remove": "objects[0].points[3]"})");
    EXPECT_EQ(object(scene, 0)["points"].size(), 5U);
    EXPECT_EQ(object(scene, 0)["knots"].size(), 8U);
    EXPECT_EQ(object(scene, 0)["knots"][0], 0.0);
    EXPECT_EQ(object(scene, 0)["knots"][7], 4.0);
    expectDone(scene, R"({"remove": "objects[0].points[0]"})");
    expectDone(scene, R"({"remove": "objects[0].points[0]"})");
    expectRefused(scene, R"({"remove": "objects[0].points[0]"})", Code::wrongLength,
                  "objects[0].points");
}

TEST(Commands, WeightsFollowTheirPoints) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[0].weights", "value": [1, 2, 3, 4, 5]})");
    expectDone(scene, R"({"insert": "objects[0].points[1]", "value": [0.5, 1]})");
    EXPECT_EQ(object(scene, 0)["weights"], json("[1, 1, 2, 3, 4, 5]"));
    expectDone(scene, R"({"remove": "objects[0].points[3]"})");
    EXPECT_EQ(object(scene, 0)["weights"], json("[1, 1, 2, 4, 5]"));
}

TEST(Commands, DegreeAndFormTakeTheKnotsWithThem) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[0].form", "value": "open"})");
    EXPECT_EQ(object(scene, 0)["knots"][2], 0.0);
    EXPECT_LT(object(scene, 0)["knots"][1].get<double>(), 0);
    EXPECT_EQ(object(scene, 0)["knots"][3], 1.0);
    expectDone(scene, R"({"set": "objects[0].form", "value": "clamped"})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0, 0, 0, 1, 3, 4, 4, 4]"));
    expectDone(scene, R"({"set": "objects[0].form", "value": "closed"})");
    // The knots of the domain stay; the period closes with steps of their mean length.
    const Json& closed = object(scene, 0)["knots"];
    ASSERT_EQ(closed.size(), 6U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(closed[i], json("[0, 1, 3, 4]")[i]);
    EXPECT_NEAR(closed[5].get<double>(), 4 + 8 / 3.0, 1e-14);
    expectDone(scene, R"({"set": "objects[0].degree", "value": 4})");
    expectRefused(scene, R"({"set": "objects[0].degree", "value": 5})", Code::wrongLength,
                  "objects[0].points");
}

TEST(Commands, AnEndKnotOfAClampedCurveMovesWithItsEquals) {
    Scene scene = twoScene();
    expectDone(scene, R"({"move": "objects[0].knots[1]", "to": -1})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[-1, -1, -1, 1, 3, 4, 4, 4]"));
    expectDone(scene, R"({"move": "objects[0].knots[3]", "to": 3})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[-1, -1, -1, 3, 3, 4, 4, 4]"));
    expectRefused(scene, R"({"move": "objects[0].knots[3]", "to": 4.5})", Code::knotsDecreasing,
                  "objects[0].knots[5]");
}

TEST(Commands, InsertingAKnotDoesNotMoveTheCurve) {
    Scene scene = twoScene();
    const Curve before = *scene.state().objects[0]->body.curve();
    expectDone(scene, R"({"insertKnot": {"object": "c1", "at": 2}})");
    const Curve after = *scene.state().objects[0]->body.curve();
    EXPECT_EQ(object(scene, 0)["points"].size(), 6U);
    for (double t = 0; t <= 4; t += 0.125) {
        EXPECT_LE(glm::length(pointAt(before, t) - pointAt(after, t)), 5e-14);
    }
    expectDone(scene, R"({"pose": {"object": "blend", "local": 3, "translate": [1, 0, 0]}})");
    expectDone(scene, R"({"insertKnot": {"object": "blend", "at": 2}})");
    EXPECT_EQ(object(scene, 1)["locals"]["count"], 6.0);
    EXPECT_EQ(object(scene, 1)["poses"][0]["local"], 4.0);
}

TEST(Commands, AFamilyBringsItsOwnParameters) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[1].bFunction.family", "value": "rational"})");
    EXPECT_EQ(object(scene, 1)["bFunction"], json(R"({"family": "rational", "m": 2, "c": 1})"));
    expectDone(scene, R"({"set": "objects[1].bFunction.family", "value": "dual"})");
    EXPECT_EQ(object(scene, 1)["bFunction"]["of"]["family"], "rational");
    expectDone(scene, R"({"set": "objects[1].bFunction.family", "value": "tabulated"})");
    EXPECT_EQ(object(scene, 1)["bFunction"]["values"].size(), 17U);
    expectRefused(scene, R"({"set": "objects[1].bFunction.family", "value": "erb"})",
                  Code::unknownName, "objects[1].bFunction.family");
}

TEST(Commands, AModelBringsItsOwnDomainAndKnots) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[1].model.name", "value": "butterfly"})");
    EXPECT_EQ(object(scene, 1)["knots"].back(), 12 * std::acos(-1.0));
    expectDone(scene, R"({"set": "objects[1].model.name", "value": "spiral"})");
    expectDone(scene, R"({"set": "objects[1].model.parameters.turns", "value": 1})");
    EXPECT_EQ(object(scene, 1)["knots"].back(), 2 * std::acos(-1.0));
}

TEST(Commands, TheNumberOfLocalsKeepsTheSpacingAndDropsPosesThatAreGone) {
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "objects[1].form", "value": "open"})");
    expectDone(scene, R"({"set": "objects[1].knots", "value": [0, 1, 2, 3, 6]})");
    expectDone(scene, R"({"pose": {"object": "blend", "local": 4, "translate": [1, 0, 0]}})");
    expectDone(scene, R"({"pose": {"object": "blend", "local": 1, "rotate": {"angle": 1}}})");
    expectDone(scene, R"({"pose": {"object": "blend", "local": 1, "translate": [0, 1]}})");
    EXPECT_EQ(object(scene, 1)["poses"].size(), 2U);
    EXPECT_EQ(object(scene, 1)["poses"][1]["rotate"]["angle"], 1.0);
    expectDone(scene, R"({"set": "objects[1].locals.count", "value": 3})");
    EXPECT_EQ(object(scene, 1)["knots"], json("[0, 2, 6]"));
    EXPECT_EQ(object(scene, 1)["poses"].size(), 1U);
}

TEST(Commands, ObjectsAreAddedRenamedAndRemovedWithTheirEffects) {
    Scene scene = twoScene();
    expectDone(scene, R"({"add": {"type": "parametric-curve", "name": "heart"}})");
    EXPECT_EQ(object(scene, 2)["id"], "c2");
    expectDone(scene, R"({"set": "objects[1].id", "value": "wings"})");
    EXPECT_EQ(scene.state().effects[0]->target, "wings");
    expectDone(scene, R"({"remove": "objects[1]"})");
    EXPECT_EQ(scene.state().effects.size(), 1U);
    expectDone(scene, R"({"insert": "effects[0]", "value": {"kind": "translate", "target": "c2"}})");
    EXPECT_EQ(scene.state().effects.size(), 2U);
    scene.undo();
    scene.undo();
    EXPECT_EQ(scene.state().objects.size(), 3U);
}

TEST(Commands, BadOnesAreRefusedAndChangeNothing) {
    Scene scene = twoScene();
    expectRefused(scene, R"({})", Code::wrongType, "");
    expectRefused(scene, R"([])", Code::wrongType, "");
    expectRefused(scene, R"({"paint": "x"})", Code::unknownField, "paint");
    expectRefused(scene, R"({"set": 3, "value": 1})", Code::wrongType, "set");
    expectRefused(scene, R"({"set": "objects[0]..x", "value": 1})", Code::syntax, "set");
    expectRefused(scene, R"({"set": "objects[0].degree"})", Code::wrongType, "value");
    expectRefused(scene, R"({"set": "objects[9].degree", "value": 1})", Code::unknownField,
                  "objects[9].degree");
    expectRefused(scene, R"({"set": "objects[0].speed", "value": 1})", Code::unknownField,
                  "objects[0].speed");
    expectRefused(scene, R"({"move": "objects[0].points[9]", "to": [1, 1]})", Code::unknownField,
                  "objects[0].points[9]");
    expectRefused(scene, R"({"move": "objects[0].points[1]"})", Code::wrongType,
                  "objects[0].move");
    expectRefused(scene, R"({"move": "objects[0].points[1]", "to": ["a", 1]})", Code::wrongType,
                  "objects[0].points[1][0]");
    expectRefused(scene, R"({"pose": {"object": "nobody", "local": 0}})", Code::unknownName,
                  "pose.object");
    expectRefused(scene, R"({"pose": {"object": "blend", "local": 5}})", Code::outOfRange,
                  "objects[1].poses[0].local");
    expectRefused(scene, R"({"pose": {"object": "blend", "local": 0.5}})", Code::notInteger,
                  "pose.local");
    expectRefused(scene, R"({"insertKnot": {"object": "c1", "at": 9}})", Code::outOfRange,
                  "insertKnot.at");
    expectRefused(scene, R"({"set": "effects[0].target", "value": "c1"})", Code::notSupported,
                  "effects[0].kind");
    expectRefused(scene, R"({"set": "objects[0].degree", "value": 3, "gesture": 4})",
                  Code::wrongType, "gesture");
    EXPECT_FALSE(scene.canUndo());
}

TEST(Colours, MixThroughOklchWithExactEnds) {
    const Colour red = parseColour("#ff0000").value();
    const Colour blue = parseColour("#0000FF").value();
    EXPECT_EQ(mixColours(red, blue, 0), red);
    EXPECT_EQ(mixColours(red, blue, 1), blue);
    EXPECT_EQ(formatColour(blue), "#0000ff");
    // Between black and white lies the grey of half the lightness, without a tint.
    const Colour grey = mixColours(parseColour("#000000").value(), parseColour("#ffffff").value(), 0.5);
    EXPECT_NEAR(grey.red, 0.3885, 1e-3);
    EXPECT_NEAR(grey.red, grey.green, 1e-6);
    EXPECT_NEAR(grey.red, grey.blue, 1e-6);
    EXPECT_EQ(parseColour("#12345g").error().code, Code::syntax);
}

TEST(Schema, NamesEveryEditableFieldOnceWithItsValue) {
    const Scene scene = twoScene();
    const Json schema = scene.schema();
    ASSERT_EQ(schema.size(), 2U);
    EXPECT_EQ(schema[1]["object"], "blend");
    std::vector<std::string> paths;
    for (const Json& field : schema[1]["fields"]) paths.push_back(field["path"]);
    for (const char* path : {"bFunction.family", "bFunction.alpha", "model.name",
                             "model.parameters.radius", "locals.count", "form", "knots", "poses",
                             "id", "style.colour", "show.locals"}) {
        EXPECT_EQ(std::count(paths.begin(), paths.end(), path), 1) << path;
    }
}

TEST(Schema, EveryFieldCanBeSetToItsOwnValue) {
    for (const BuiltinScene& builtin : builtinScenes()) {
        Scene scene = Scene::open(json(builtin.document)).value();
        const std::string before = dumpJson(scene.document());
        const Json schema = scene.schema();
        for (std::size_t i = 0; i < schema.size(); ++i) {
            for (const Json& field : schema[i]["fields"]) {
                const std::string path =
                    indexed("objects", i) + "." + field["path"].get<std::string>();
                const auto done = scene.execute({{"set", path}, {"value", field["value"]}});
                ASSERT_TRUE(done.ok()) << path << done.error().message;
                if (!path.ends_with(".family")) {
                    EXPECT_EQ(dumpJson(scene.document()), before) << path;
                }
                scene.undo();
            }
        }
    }
}

}  // namespace
}  // namespace knotwork::scene
