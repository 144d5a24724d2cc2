// What follows when one field of an object changes: forms, nets, patches, meshes, fits, types.
#include "scene/fields.hpp"
#include "scene/scene.hpp"
#include "support/curves.hpp"
#include "support/gates.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

Scene with(std::string_view object) {
    return Scene::open(json(R"({"knotwork": 1, "objects": [)" + std::string(object) + "]}")).value();
}

const Object& first(const Scene& scene) { return *scene.state().objects[0]; }
const Json& spec(const Scene& scene) { return first(scene).spec; }

// --- forms ---------------------------------------------------------------------------------------

constexpr const char* loop = R"({"type": "bspline-curve", "degree": 3, "form": "closed",
    "points": [[0,0],[3,-1],[4,2],[2,4],[-1,3]], "knots": [0,1,1.5,3,4,4.5],
    "weights": [1,2,1,0.5,1]})";

TEST(FormChange, OpeningAClosedCurveDoesNotMoveItAndClosingJoinsItAgain) {
    for (const char* form : {"open", "clamped"}) {
        Scene scene = with(loop);
        const Curve before = *first(scene).body.curve();
        const std::string open = R"({"set": "objects[0].form", "value": ")" + std::string(form) + "\"}";
        expectDone(scene, open);
        EXPECT_EQ(spec(scene)["points"].size(), 8U);
        EXPECT_FALSE(isClosed(*first(scene).body.curve()));
        EXPECT_LE(test::distanceBetween(before, *first(scene).body.curve()), 1e-13) << form;
        expectDone(scene, R"({"set": "objects[0].form", "value": "closed"})");
        EXPECT_EQ(spec(scene)["points"].size(), 5U);
        EXPECT_LE(test::distanceBetween(before, *first(scene).body.curve()), 1e-12) << form;
        EXPECT_EQ(spec(scene)["knots"], json("[0,1,1.5,3,4,4.5]"));
    }
}

TEST(FormChange, ClosingKeepsTheCurveWhereItDoesNotDependOnItsEnds) {
    Scene scene = with(R"({"type": "bspline-curve", "degree": 2, "form": "open",
        "points": [[0,0],[1,2],[3,3],[5,0],[6,2],[7,5],[8,3]], "knots": [0,1,2,3.5,4,5,6,7,8,9.5]})");
    const Curve before = *first(scene).body.curve();
    expectDone(scene, R"({"set": "objects[0].form", "value": "closed"})");
    EXPECT_EQ(spec(scene)["knots"], json("[2,3.5,4,5,6,7,8,9.5]"));
    EXPECT_EQ(spec(scene)["points"].size(), 7U);
    const Curve& after = *first(scene).body.curve();
    for (const double t : {3.5, 4.0, 4.7, 5.9, 7.0}) {
        EXPECT_LE(glm::length(pointAt(before, t) - pointAt(after, t)), 1e-14) << t;
    }
    EXPECT_GT(glm::length(pointAt(before, 2.2) - pointAt(after, 2.2)), 1e-3);
}

TEST(FormChange, OfASurfaceOpensItDirectionByDirection) {
    Scene scene = with(R"({"type": "bspline-surface", "degree": [2, 1], "form": ["closed", "clamped"],
        "points": [[[1,0,0],[1,0,1]],[[0,1,0],[0,1,1]],[[-1,0,0],[-1,0,2]],[[0,-1,0],[0,-2,1]]]})");
    const Surface before = *first(scene).body.surface();
    expectDone(scene, R"({"set": "objects[0].form", "value": ["clamped", "clamped"]})");
    EXPECT_EQ(spec(scene)["points"].size(), 6U);
    for (double u = 0; u <= 4; u += 0.37) {
        for (const double v : {0.0, 0.4, 1.0}) {
            const Surface& after = *first(scene).body.surface();
            EXPECT_LE(glm::length(pointAt(before, {u, v}) - pointAt(after, {u, v})), 1e-14);
        }
    }
    expectDone(scene, R"({"set": "objects[0].form[0]", "value": "closed"})");
    EXPECT_EQ(spec(scene)["points"].size(), 4U);
}

// --- nets ----------------------------------------------------------------------------------------

constexpr const char* net = R"({"type": "bspline-surface", "degree": [1, 2],
    "knots": [[0,0,1,3,3],[0,0,0,1,5,5,5]], "weights": [[1,2,3,4],[5,6,7,8],[9,10,11,12]],
    "points": [[[0,0,0],[0,1,1],[0,2,0],[0,3,0]],[[1,0,0],[1,1,1],[1,2,0],[1,3,0]],
               [[2,0,0],[2,1,1],[2,2,0],[2,3,0]]]})";

TEST(Nets, RowsAndColumnsComeAndGoWithAKnotAndTheirWeights) {
    Scene scene = with(net);
    expectDone(scene, R"({"insert": "objects[0].points[1]",
                          "value": [[0.5,0,0],[0.5,1,1],[0.5,2,0],[0.5,3,0]]})");
    EXPECT_EQ(spec(scene)["points"].size(), 4U);
    EXPECT_EQ(spec(scene)["knots"][0].size(), 6U);
    EXPECT_EQ(spec(scene)["knots"][1], json("[0,0,0,1,5,5,5]"));
    EXPECT_EQ(spec(scene)["weights"], json("[[1,2,3,4],[1,1,1,1],[5,6,7,8],[9,10,11,12]]"));
    expectDone(scene, R"({"remove": "objects[0].points[3][1]"})");
    EXPECT_EQ(spec(scene)["points"][2], json("[[1,0,0],[1,2,0],[1,3,0]]"));
    EXPECT_EQ(spec(scene)["knots"][1], json("[0,0,0,5,5,5]"));
    EXPECT_EQ(spec(scene)["weights"][0], json("[1,3,4]"));
    expectDone(scene, R"({"insert": "objects[0].points[0][3]",
                          "value": [[0,4,0],[0.5,4,0],[1,4,0],[2,4,0]]})");
    EXPECT_EQ(spec(scene)["points"][3], json("[[2,0,0],[2,2,0],[2,3,0],[2,4,0]]"));
    EXPECT_EQ(spec(scene)["weights"][3], json("[9,11,12,1]"));
    expectRefused(scene, R"({"insert": "objects[0].points[0][3]", "value": [[0,4,0]]})",
                  Code::wrongLength, "value");
    expectRefused(scene, R"({"remove": "objects[0].points[0][4]"})", Code::unknownField,
                  "objects[0].points[0][4]");
}

TEST(Nets, DegreesTakeTheKnotsOfTheirDirectionWithThem) {
    Scene scene = with(net);
    expectDone(scene, R"({"set": "objects[0].degree[0]", "value": 2})");
    EXPECT_EQ(spec(scene)["knots"], json("[[0,0,0,1,1,1],[0,0,0,1,5,5,5]]"));
    expectDone(scene, R"({"set": "objects[0].form[1]", "value": "closed"})");
    EXPECT_EQ(spec(scene)["knots"][1].size(), 5U);
    expectRefused(scene, R"({"set": "objects[0].degree[0]", "value": 3})", Code::wrongLength,
                  "objects[0].points");
}

TEST(Nets, APointMovesAndNothingElse) {
    Scene scene = with(net);
    Json wanted = spec(scene);
    wanted["points"][1][2] = json("[5, 6, 7]");
    expectDone(scene, R"({"move": "objects[0].points[1][2]", "to": [5, 6, 7]})");
    EXPECT_EQ(dumpJson(spec(scene)), dumpJson(wanted));
    expectDone(scene, R"({"set": "objects[0].points[1][2][0]", "value": 8})");
    EXPECT_EQ(first(scene).body.as<BsplineSurface>()->points()[6], Vec3(8, 6, 7));
    expectRefused(scene, R"({"move": "objects[0].points[1][2]", "to": [5]})", Code::wrongLength,
                  "objects[0].points[1][2]");
    expectRefused(scene, R"({"move": "objects[0].points[1][2]", "to": [1e13, 0]})",
                  Code::outOfRange, "objects[0].points[1][2]");
}

// --- patches -------------------------------------------------------------------------------------

TEST(Patches, TheirNumberKeepsTheSpacingAndDropsPosesThatAreGone) {
    Scene scene = with(R"({"id": "t", "type": "blending-surface", "bFunction": {"family": "linear"},
        "model": {"type": "parametric-surface", "name": "plane"}, "locals": [3, 5],
        "kind": "bezier", "knots": [[0,1,3],[0,1,2,3,6]],
        "poses": [{"local": [1, 1], "scale": 2}, {"local": [2, 4]}]})");
    expectDone(scene, R"({"set": "objects[0].locals[1]", "value": 3})");
    EXPECT_EQ(spec(scene)["knots"], json("[[0,1,3],[0,2,6]]"));
    ASSERT_EQ(spec(scene)["poses"].size(), 1U);
    EXPECT_EQ(spec(scene)["poses"][0]["scale"], 2.0);
    expectDone(scene, R"({"set": "objects[0].kind", "value": "plane"})");
    EXPECT_EQ(member(spec(scene), "degree"), nullptr);
    expectDone(scene, R"({"set": "objects[0].model.name", "value": "torus"})");
    EXPECT_EQ(spec(scene)["form"], json(R"(["closed", "closed"])"));
    expectDone(scene, R"({"set": "objects[0].model.type", "value": "bspline-surface"})");
    EXPECT_EQ(spec(scene)["model"]["degree"], json("[3, 3]"));
}

// --- meshes and clouds ---------------------------------------------------------------------------

TEST(Meshes, ASolidTurnsIntoVerticesAndFacesWhenItIsFirstEdited) {
    Scene scene = with(R"({"type": "subdivision-surface", "mesh": {"solid": "cube"}, "levels": 1})");
    const Vec3 before = first(scene).body.subdivision()->control.points()[3];
    expectDone(scene, R"({"move": "objects[0].mesh.vertices[3]", "by": [0, 0, 1]})");
    EXPECT_EQ(first(scene).body.subdivision()->control.points()[3], before + Vec3(0, 0, 1));
    EXPECT_EQ(spec(scene)["mesh"]["faces"].size(), 6U);
    EXPECT_EQ(first(scene).body.subdivision()->refined.faces().count(), 24U);
    expectDone(scene, R"({"remove": "objects[0].mesh.vertices[0]"})");
    EXPECT_EQ(spec(scene)["mesh"]["vertices"].size(), 7U);
    EXPECT_EQ(spec(scene)["mesh"]["faces"].size(), 3U);
    expectDone(scene, R"({"insert": "objects[0].mesh.vertices[2]", "value": [0, 0, 5]})");
    const auto faces = first(scene).body.subdivision()->control.faces();
    for (std::size_t f = 0; f < faces.count(); ++f) {
        EXPECT_EQ(std::count(faces[f].begin(), faces[f].end(), 2U), 0);
    }
    expectDone(scene, R"({"remove": "objects[0].mesh.faces[0]"})");
    expectDone(scene, R"({"set": "objects[0].scheme", "value": "loop"})");
    EXPECT_EQ(first(scene).body.subdivision()->control.faces().uniformSize, 3U);
}

TEST(Meshes, AnotherSolidHasItsOwnParameters) {
    Scene scene = with(R"({"type": "subdivision-surface",
                           "mesh": {"solid": "torus", "parameters": {"around": 5}}})");
    expectDone(scene, R"({"set": "objects[0].mesh.solid", "value": "cube"})");
    EXPECT_EQ(spec(scene)["mesh"]["solid"], "cube");
}

TEST(Clouds, TheFitFollowsThePoints) {
    Scene scene = with(R"({"type": "point-cloud", "points": [[0,0],[1,1],[2,0],[3,1],[4,0]],
                           "fit": {"degree": 3, "count": 5}})");
    const Vec3 before = pointAt(first(scene).body.cloud()->fit->curve, 0.5);
    expectDone(scene, R"({"move": "objects[0].points[2]", "by": [0, 3]})");
    EXPECT_GT(glm::length(pointAt(first(scene).body.cloud()->fit->curve, 0.5) - before), 0.1);
    expectDone(scene, R"({"remove": "objects[0].points[2]"})");
    EXPECT_EQ(spec(scene)["fit"]["count"], 4.0);
    expectDone(scene, R"({"remove": "objects[0].points[2]"})");
    EXPECT_EQ(spec(scene)["fit"]["degree"], 2.0);
    expectDone(scene, R"({"remove": "objects[0].fit"})");
    EXPECT_FALSE(first(scene).body.cloud()->fit.has_value());
}

// --- types ---------------------------------------------------------------------------------------

TEST(TypeChange, EveryTypeBecomesEveryOtherAndKeepsItsNameStyleAndShow) {
    for (const ObjectType& from : objectTypes()) {
        Scene scene = with(R"({"id": "it", "type": "parametric-curve", "name": "rose",
                               "style": {"colour": "#123456"}, "show": {"comb": true}})");
        ASSERT_TRUE(scene.execute({{"set", "objects[0].type"}, {"value", from.type}}).ok());
        for (const ObjectType& to : objectTypes()) {
            const auto done = scene.execute({{"set", "objects[0].type"}, {"value", to.type}});
            ASSERT_TRUE(done.ok()) << from.type << " to " << to.type << ": " << done.error().path
                                   << done.error().message;
            EXPECT_EQ(spec(scene)["type"], to.type);
            EXPECT_EQ(first(scene).id, "it");
            EXPECT_EQ(spec(scene)["style"]["colour"], "#123456");
            EXPECT_EQ(spec(scene)["show"]["comb"], true);
            scene.undo();
        }
    }
}

TEST(TypeChange, PointsStayPointsAndACurveBecomesAModel) {
    Scene scene = with(R"({"type": "bspline-curve", "degree": 2,
                           "points": [[0,0],[1,2],[3,3],[5,0]]})");
    expectDone(scene, R"({"set": "objects[0].type", "value": "bezier-curve"})");
    EXPECT_EQ(spec(scene)["points"], json("[[0,0],[1,2],[3,3],[5,0]]"));
    expectDone(scene, R"({"set": "objects[0].type", "value": "blending-curve"})");
    EXPECT_EQ(spec(scene)["model"]["type"], "bezier-curve");
    EXPECT_EQ(member(spec(scene)["model"], "id"), nullptr);
    expectDone(scene, R"({"set": "objects[0].model.type", "value": "subdivision-curve"})");
    EXPECT_EQ(spec(scene)["model"]["points"].size(), 4U);
    expectRefused(scene, R"({"set": "objects[0].type", "value": "teapot"})", Code::unknownName,
                  "objects[0].type");
}

}  // namespace
}  // namespace knotwork::scene
