// Commands on places, groups and lists of them; knots that merge and come off; selection.
#include "geometry/turns.hpp"
#include "scene/commands.hpp"
#include "support/gates.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

constexpr const char* several = R"({
    "knotwork": 1, "objects": [
        {"id": "spline", "type": "bspline-curve", "degree": 2, "knots": [0,0,0,1,3,4,4,4],
         "points": [[0,0],[1,2],[3,3],[5,0],[6,2]]},
        {"id": "blend", "type": "blending-curve", "bFunction": {"family": "linear"},
         "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 5}},
        {"id": "tube", "type": "blending-surface", "bFunction": {"family": "linear"},
         "model": {"type": "parametric-surface", "name": "cylinder"}, "locals": [5, 3]},
        {"id": "ball", "type": "subdivision-surface", "levels": 1, "mesh": {"solid": "cube"}},
        {"id": "net", "type": "bspline-surface", "degree": [1, 2],
         "points": [[[0,0,0],[0,1,1],[0,2,0],[0,3,0]],[[1,0,0],[1,1,1],[1,2,0],[1,3,0]],
                    [[2,0,0],[2,1,1],[2,2,0],[2,3,0]]]},
        {"id": "data", "type": "point-cloud", "points": [[0,0],[1,1],[2,0],[3,1],[4,0]],
         "fit": {"degree": 2, "count": 4}}],
    "effects": [{"target": "blend", "kind": "simulate"}, {"target": "spline", "kind": "rotate"}]})";

Scene open() { return Scene::open(json(several)).value(); }

const Json& object(const Scene& scene, std::size_t i) { return scene.state().objects[i]->spec; }

Json poseOfLocal(const Scene& scene, std::size_t i, const Json& local) {
    for (const Json& pose : object(scene, i)["poses"]) {
        if (pose["local"] == local) return pose;
    }
    return nullptr;
}

// --- lists and groups ----------------------------------------------------------------------------

TEST(CommandList, IsOneStepAndAllOrNothing) {
    Scene scene = open();
    const std::string first = dumpJson(scene.document());
    expectDone(scene, R"({"all": [{"set": "title", "value": "A"},
        {"move": "objects[0].points[0]", "to": [9, 9]}, {"remove": "objects[5]"}]})");
    EXPECT_EQ(scene.state().objects.size(), 5U);
    EXPECT_EQ(object(scene, 0)["points"][0], json("[9, 9]"));
    EXPECT_TRUE(scene.undo());
    EXPECT_FALSE(scene.canUndo());
    EXPECT_EQ(dumpJson(scene.document()), first);
    expectRefused(scene, R"({"all": [{"set": "title", "value": "A"},
        {"set": "objects[0].degree", "value": 9}]})", Code::wrongLength, "all[1].objects[0].points");
    expectRefused(scene, R"({"all": []})", Code::wrongType, "all");
    expectRefused(scene, R"({"all": [3]})", Code::wrongType, "all[0]");
    expectRefused(scene, R"({"all": [{"all": [{"remove": "objects[0]"}]}]})", Code::unknownField,
                  "all[0].all");
    expectRefused(scene, R"({"all": [{"remove": "objects[0]", "gesture": "g"}]})",
                  Code::unknownField, "all[0].gesture");
}

TEST(GroupMove, MovesEveryPlaceByTheSameAmountOnce) {
    Scene scene = open();
    const auto other = scene.state().objects[1];
    const auto change = scene.execute(json(R"({"by": [1, -1], "move": ["objects[0].points[1]",
        "objects[0].points[3]", "objects[0].points[1]", "objects[5].points[0]",
        "objects[4].points[1][2]"]})"));
    ASSERT_TRUE(change.ok()) << change.error().message;
    EXPECT_EQ(change->path, "objects");
    EXPECT_EQ(object(scene, 0)["points"], json("[[0,0],[2,1],[3,3],[6,-1],[6,2]]"));
    EXPECT_EQ(object(scene, 5)["points"][0], json("[1, -1]"));
    EXPECT_EQ(object(scene, 4)["points"][1][2], json("[2, 1, 0]"));
    EXPECT_EQ(scene.state().objects[1], other);
    EXPECT_NEAR(pointAt(*scene.state().objects[0]->body.curve(), 0).x, 0, 0);
    EXPECT_TRUE(scene.undo());
    EXPECT_FALSE(scene.canUndo());
}

TEST(GroupMove, TakesKnotsAndVerticesOfASolid) {
    Scene scene = open();
    expectDone(scene, R"({"move": ["objects[0].knots[3]", "objects[0].knots[4]",
        "objects[0].knots[6]", "objects[0].knots[7]"], "by": 0.5})");
    EXPECT_EQ(object(scene, 0)["knots"], json("[0,0,0,1.5,3.5,4.5,4.5,4.5]"));
    const Vec3 before = scene.state().objects[3]->body.subdivision()->control.points()[2];
    expectDone(scene, R"({"move": ["objects[3].mesh.vertices[2]", "objects[3].mesh.vertices[3]"],
                          "by": [0, 0, 2]})");
    EXPECT_EQ(member(object(scene, 3)["mesh"], "solid"), nullptr);
    EXPECT_EQ(scene.state().objects[3]->body.subdivision()->control.points()[2],
              before + Vec3(0, 0, 2));
    expectRefused(scene, R"({"move": ["objects[0].points[0]", "objects[0].points[7]"], "by": [1, 1]})",
                  Code::unknownField, "objects[0].points[7]");
    expectRefused(scene, R"({"move": ["title"], "by": 1})", Code::notSupported, "move[0]");
    expectRefused(scene, R"({"move": [], "by": 1})", Code::wrongLength, "move");
    expectRefused(scene, R"({"move": ["objects[0].points[0]"], "to": [1, 1]})", Code::notSupported,
                  "to");
    expectRefused(scene, R"({"move": ["objects[0].points[0]", 4], "by": [1, 1]})", Code::wrongType,
                  "move[1]");
}

TEST(Entries, MoveToAnotherPlaceInTheirList) {
    Scene scene = open();
    expectDone(scene, R"({"move": "objects[0]", "to": 2})");
    EXPECT_EQ(scene.state().objects[2]->id, "spline");
    EXPECT_EQ(scene.state().objects[0]->id, "blend");
    expectDone(scene, R"({"move": "effects[1]", "to": 0})");
    EXPECT_EQ(scene.state().effects[0]->target, "spline");
    expectRefused(scene, R"({"move": "objects[0]", "to": 6})", Code::outOfRange, "to");
    expectRefused(scene, R"({"move": "objects[0]", "to": 0.5})", Code::notInteger, "to");
    expectRefused(scene, R"({"move": "objects[9]", "to": 0})", Code::unknownField, "objects[9]");
    expectRefused(scene, R"({"move": "objects[0]", "by": 1})", Code::wrongType, "to");
}

TEST(Entries, AreInsertedAndSetWhereTheyAreSaid) {
    Scene scene = open();
    expectDone(scene, R"({"insert": "objects[1]", "value": {"type": "line-curve", "from": [0,0],
                          "to": [1,1]}})");
    EXPECT_EQ(scene.state().objects[1]->id, "c1");
    expectDone(scene, R"({"set": "objects[0]", "value": {"type": "parametric-curve",
                          "name": "rose", "style": {"width": 7}}})");
    EXPECT_EQ(scene.state().objects[0]->id, "spline");
    EXPECT_EQ(scene.state().objects[0]->style.width, 7);
    EXPECT_EQ(scene.state().effects[1]->target, "spline");
    expectRefused(scene, R"({"insert": "objects[9]", "value": {}})", Code::unknownField,
                  "objects[9]");
    expectRefused(scene, R"({"insert": "objects[0]", "value": {"type": "line-curve"}})",
                  Code::wrongType, "objects[0].from");
    expectRefused(scene, R"({"insert": "effects[0]", "value": {"kind": "rotate", "target": "x"}})",
                  Code::unknownName, "effects[0].target");
}

// --- poses ---------------------------------------------------------------------------------------

TEST(GroupPose, PlacesEveryLocalOfTheList) {
    Scene scene = open();
    expectDone(scene, R"({"pose": {"object": "blend", "local": 2, "scale": 2}})");
    expectDone(scene, R"({"pose": {"object": "blend", "locals": [0, 2], "translate": [1, 0, 0]}})");
    EXPECT_EQ(poseOfLocal(scene, 1, 0)["translate"], json("[1,0,0]"));
    EXPECT_EQ(poseOfLocal(scene, 1, 2)["scale"], 2.0);
    expectDone(scene, R"({"pose": {"object": "tube", "locals": [[0, 1], [4, 2]], "scale": 3}})");
    EXPECT_EQ(poseOfLocal(scene, 2, json("[4,2]"))["scale"], 3.0);
    expectDone(scene, R"({"pose": {"object": "tube", "local": [0, 1], "translate": [0,0,5]}})");
    EXPECT_EQ(poseOfLocal(scene, 2, json("[0,1]"))["scale"], 3.0);
    EXPECT_EQ(scene.state().objects[2]->body.as<BlendingSurface>()->place(0, 1).pose().translate.z,
              5);
}

TEST(GroupPose, ByAnAmountAddsToThePoseThatIsThere) {
    Scene scene = open();
    expectDone(scene, R"({"pose": {"object": "blend", "local": 1, "translate": [1, 2, 3],
        "scale": 2, "rotate": {"axis": [0, 0, 1], "angle": 1}}})");
    expectDone(scene, R"({"pose": {"object": "blend", "locals": [1, 3], "by": {
        "translate": [1, 0, 0], "scale": 3, "rotate": {"axis": [0, 0, 2], "angle": 0.5}}}})");
    const Json one = poseOfLocal(scene, 1, 1);
    EXPECT_EQ(one["translate"], json("[2, 2, 3]"));
    EXPECT_EQ(one["scale"], 6.0);
    EXPECT_NEAR(one["rotate"]["angle"].get<double>(), 1.5, 1e-15);
    EXPECT_EQ(poseOfLocal(scene, 1, 3)["rotate"]["angle"], 0.5);
}

TEST(GroupPose, AboutAPointTurnsTheGroupAsAWhole) {
    Scene scene = open();
    const auto placeOf = [&](std::size_t j) {
        const auto& local = scene.state().objects[1]->body.as<BlendingCurve>()->locals()[j];
        return local.placement().point(local.origin());
    };
    const Vec3 first = placeOf(0);
    const Vec3 second = placeOf(2);
    const Vec3 about(0.5, 0, 0);
    expectDone(scene, R"({"pose": {"object": "blend", "locals": [0, 2], "by": {"scale": 2,
        "rotate": {"angle": 1.5707963267948966}, "about": [0.5, 0, 0]}}})");
    const auto turned = [&](const Vec3& p) {
        return about + 2.0 * Vec3(-(p.y - about.y), p.x - about.x, p.z);
    };
    EXPECT_LE(glm::length(placeOf(0) - turned(first)), 1e-14);
    EXPECT_LE(glm::length(placeOf(2) - turned(second)), 1e-14);
}

TEST(GroupPose, RefusalsNameTheirPlace) {
    Scene scene = open();
    const auto refused = [&](const char* pose, Code code, const char* path) {
        expectRefused(scene, R"({"pose": )" + std::string(pose) + "}", code, path);
    };
    refused(R"({"object": "spline", "local": 0})", Code::notSupported, "pose.object");
    refused(R"({"object": "blend", "local": 0, "locals": [1]})", Code::unknownField, "pose.locals");
    refused(R"({"object": "blend", "locals": [0, 1, 0]})", Code::outOfRange, "pose.locals[2]");
    refused(R"({"object": "blend", "locals": [0, "1"]})", Code::wrongType, "pose.locals[1]");
    refused(R"({"object": "tube", "local": 1})", Code::wrongType, "pose.local");
    refused(R"({"object": "tube", "locals": [[0, 0.5]]})", Code::notInteger, "pose.locals[0][1]");
    refused(R"({"object": "tube", "local": [5, 0]})", Code::outOfRange,
            "objects[2].poses[0].local[0]");
    refused(R"({"object": "blend", "local": 0, "by": {"scale": 0}})", Code::outOfRange,
            "pose.by.scale");
    refused(R"({"object": "blend", "local": 0, "scale": 2, "by": {}})", Code::unknownField,
            "pose.by");
    refused(R"({"object": "blend", "local": 0, "by": {"rotate": {"axis": [0,0,0], "angle": 1}}})",
            Code::outOfRange, "pose.by.rotate.axis");
    refused("3", Code::wrongType, "pose");
}

TEST(Turns, ComposeLikeTheirMatrices) {
    for (const double a : {0.0, 0.3, 2.5, std::acos(-1.0), 5.0, -1.0}) {
        for (const double b : {0.0, 0.7, std::acos(-1.0), -2.0}) {
            const Turn outer{{1, 2, 0.5}, a};
            const Turn inner{{-1, 0.3, 2}, b};
            const Turn both = compose(outer, inner);
            const Mat3 wanted = rotation(outer.axis, a) * rotation(inner.axis, b);
            const Mat3 made = rotation(both.axis, both.angle);
            for (int column = 0; column < 3; ++column) {
                EXPECT_LE(glm::length(made[column] - wanted[column]), 1e-14);
            }
        }
    }
}

// --- knots ---------------------------------------------------------------------------------------

TEST(KnotMove, MergesWithinASnapAndComesOffToEitherSide) {
    Scene scene = open();
    const auto knots = [&] { return object(scene, 0)["knots"]; };
    expectDone(scene, R"({"move": "objects[0].knots[3]", "to": 2.8, "snap": 0.1})");
    EXPECT_EQ(knots(), json("[0,0,0,2.8,3,4,4,4]"));
    expectDone(scene, R"({"move": "objects[0].knots[3]", "to": 2.95, "snap": 0.1})");
    EXPECT_EQ(knots(), json("[0,0,0,3,3,4,4,4]"));
    const auto off = scene.execute(json(R"({"move": "objects[0].knots[3]", "to": 3.5})"));
    ASSERT_TRUE(off.ok());
    EXPECT_EQ(off->path, "objects[0].knots[4]");
    EXPECT_EQ(knots(), json("[0,0,0,3,3.5,4,4,4]"));
    expectDone(scene, R"({"move": "objects[0].knots[4]", "to": 3})");
    const auto left = scene.execute(json(R"({"move": "objects[0].knots[4]", "to": 1})"));
    ASSERT_TRUE(left.ok());
    EXPECT_EQ(left->path, "objects[0].knots[3]");
    expectDone(scene, R"({"move": "objects[0].knots[0]", "by": 0.05, "snap": 0.1})");
    EXPECT_EQ(knots(), json("[0.05,0.05,0.05,1,3,4,4,4]"));
    expectRefused(scene, R"({"move": "objects[0].knots[3]", "to": 1, "snap": "x"})",
                  Code::wrongType, "snap");
    expectRefused(scene, R"({"move": "objects[0].knots[3]", "to": 1, "snap": -1})",
                  Code::outOfRange, "snap");
    expectRefused(scene, R"({"move": "objects[0].points[3]", "by": [1, 1], "snap": 1})",
                  Code::unknownField, "snap");
}

TEST(KnotMove, OfASurfaceIsThatOfACurve) {
    Scene scene = open();
    expectDone(scene, R"({"move": "objects[4].knots[1][3]", "to": 0.5})");
    EXPECT_EQ(object(scene, 4)["knots"][1], json("[0,0,0,0.5,2,2,2]"));
    expectDone(scene, R"({"move": "objects[4].knots[1][6]", "to": 3})");
    EXPECT_EQ(object(scene, 4)["knots"][1], json("[0,0,0,0.5,3,3,3]"));
    expectDone(scene, R"({"move": "objects[2].knots[1][1]", "by": 0.01})");
}

// --- selection -----------------------------------------------------------------------------------

TEST(Selection, ComesBackWithItsSteps) {
    Scene scene = open();
    ASSERT_TRUE(scene.select(json(R"(["objects[0].points[1]"])")).ok());
    expectDone(scene, R"({"insert": "objects[0].points[5]", "value": [7, 7],
                          "selection": ["objects[0].points[5]"]})");
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[5]"});
    expectDone(scene, R"({"set": "title", "value": "x"})");
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[5]"});
    ASSERT_TRUE(scene.select(json(R"(["objects[1]", "title", "objects[1].poses"])")).ok());
    scene.undo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[5]"});
    scene.undo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[1]"});
    scene.redo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[5]"});
    expectDone(scene, R"({"remove": "objects[0].points[5]"})");
    EXPECT_TRUE(scene.selection().empty());
    scene.undo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[5]"});
}

TEST(Selection, OfAGestureIsThatBeforeItsFirstCommand) {
    Scene scene = open();
    ASSERT_TRUE(scene.select(json(R"(["objects[0]"])")).ok());
    for (const char* to : {"[1,1]", "[2,2]"}) {
        expectDone(scene, R"({"gesture": "g", "move": "objects[0].points[0]", "to": )" +
                              std::string(to) + R"(, "selection": ["objects[0].points[0]"]})");
    }
    scene.undo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0]"});
    EXPECT_FALSE(scene.canUndo());
    scene.redo();
    EXPECT_EQ(scene.selection(), Selection{"objects[0].points[0]"});
}

TEST(Selection, IsAListOfPaths) {
    Scene scene = open();
    expectRefused(scene, R"({"set": "title", "value": "x", "selection": "title"})", Code::wrongType,
                  "selection");
    expectRefused(scene, R"({"set": "title", "value": "x", "selection": ["title", 3]})",
                  Code::wrongType, "selection[1]");
    expectRefused(scene, R"({"set": "title", "value": "x", "selection": ["a..b"]})", Code::syntax,
                  "selection[0]");
    EXPECT_FALSE(scene.canUndo());
    EXPECT_EQ(scene.select(json("{}")).error().code, Code::wrongType);
}

// --- history -------------------------------------------------------------------------------------

TEST(History, KeepsFiveHundredSteps) {
    Scene scene = open();
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(scene.execute({{"set", "title"}, {"value", std::to_string(i)}}).ok());
    }
    int steps = 0;
    while (scene.undo()) ++steps;
    EXPECT_EQ(steps, 499);
    EXPECT_EQ(scene.document()["title"], "100");
}

TEST(History, IsBoundedByTheMemoryOfItsObjectsEachCountedOnce) {
    Scene scene = Scene::open(json(R"({"knotwork": 1, "objects": [
        {"type": "subdivision-surface", "levels": 7, "mesh": {"solid": "cube"}}]})")).value();
    const std::size_t bytes = scene.state().objects[0]->bytes;
    EXPECT_GT(bytes, std::size_t{3} << 20U);
    for (int i = 0; i < 60; ++i) {  // these steps share the object
        ASSERT_TRUE(scene.execute({{"set", "title"}, {"value", std::to_string(i)}}).ok());
    }
    int shared = 0;
    while (scene.undo()) ++shared;
    EXPECT_EQ(shared, 60);
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(scene.execute({{"set", "objects[0].style.width"}, {"value", 1 + i % 9}}).ok());
    }
    int own = 0;
    while (scene.undo()) ++own;
    EXPECT_EQ(own, static_cast<int>((std::size_t{128} << 20U) / bytes) - 1);
}

}  // namespace
}  // namespace knotwork::scene
