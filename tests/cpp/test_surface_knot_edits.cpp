#include "geometry/bspline_surface_knots.hpp"
#include "scene/scene.hpp"
#include "support/gates.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::expectRefused;
using test::json;

constexpr const char* surfaces = R"({
    "knotwork": 1,
    "objects": [
        {"id": "net", "type": "bspline-surface", "degree": [2, 1], "form": ["clamped", "open"],
         "points": [[[0,0,0],[0,1,1],[0,2,0]],[[1,0,1],[1,1,2],[1,2,1]],[[2,0,0],[2,1,-1],[2,2,2]],
                    [[3,0,1],[3,1,0],[3,2,1]]],
         "knots": [[0,0,0,1,3,3,3],[0,1,2,3.5,4]],
         "weights": [[1,2,1],[1,1,3],[2,1,1],[1,1,2]], "style": {"colour": "#123456"}},
        {"id": "tube", "type": "bspline-surface", "degree": [3, 2], "form": ["closed", "clamped"],
         "points": [[[1,0,0],[1,0,1],[1,0,2]],[[0,1,0],[0,1,1],[0,2,2]],[[-1,0,0],[-2,0,1],[-1,0,2]],
                    [[0,-1,0],[0,-1,1],[0,-1,2]],[[1,-1,0],[1,-1,1],[1,-1,2]]]},
        {"id": "blend", "type": "blending-surface", "bFunction": {"family": "linear"},
         "model": {"type": "parametric-surface", "name": "cylinder"}, "locals": [4, 3],
         "poses": [{"local": [1, 0], "translate": [0, 0, 1]}, {"local": [3, 2]}]},
        {"id": "torus", "type": "parametric-surface", "name": "torus"}]})";

Scene open() { return Scene::open(json(surfaces)).value(); }

const Json& object(const Scene& scene, std::size_t i) { return scene.state().objects[i]->spec; }
const Surface& surfaceOf(const Scene& scene, std::size_t i) {
    return *scene.state().objects[i]->body.surface();
}

Vec3 at(const Surface& surface, double u, double v) {
    return pointAt(surface, {u, v, Side::right, Side::right});
}

double moved(const Surface& a, const Surface& b) {
    const Rectangle whole = domain(a);
    double largest = 0;
    for (std::size_t i = 0; i <= 24; ++i) {
        for (std::size_t j = 0; j <= 24; ++j) {
            const double u = uniformParameter(whole.u, i, 25);
            const double v = uniformParameter(whole.v, j, 25);
            largest = std::max(largest, glm::length(at(a, u, v) - at(b, u, v)));
        }
    }
    return largest;
}

struct Insertion {
    std::size_t object;
    const char* command;
    std::size_t direction;
    const char* path;  ///< that the change names
};

constexpr Insertion insertions[] = {
    {0, R"({"insertKnot": {"object": "net", "at": 1.5, "along": "u"}})", 0, "objects[0].knots[0]"},
    {0, R"({"insertKnot": {"object": "net", "at": 1, "along": "u"}})", 0, "objects[0].knots[0]"},
    {0, R"({"insertKnot": {"object": "net", "at": 1.5, "along": "v"}})", 1, "objects[0].knots[1]"},
    {0, R"({"insert": "objects[0].knots[1]", "value": 2.75})", 1, "objects[0].knots[1]"},
    {1, R"({"insertKnot": {"object": "tube", "at": 7.25, "along": "u"}})", 0, "objects[1].knots[0]"},
    {1, R"({"insertKnot": {"object": "tube", "at": 0, "along": "u"}})", 0, "objects[1].knots[0]"},
    {1, R"({"insert": "objects[1].knots[1][2]", "value": 0.25})", 1, "objects[1].knots[1][2]"},
};

TEST(SurfaceKnotEdits, InsertingAKnotAddsALineOfPointsAndDoesNotMoveTheSurface) {
    for (const auto& [index, command, direction, path] : insertions) {
        SCOPED_TRACE(command);
        Scene scene = open();
        const Surface before = surfaceOf(scene, index);
        const Json was = object(scene, index);
        const auto done = scene.execute(json(command));
        ASSERT_TRUE(done.ok()) << done.error().path << done.error().message;
        EXPECT_EQ(done->path, path);
        EXPECT_LE(moved(before, surfaceOf(scene, index)), 5 * test::gates::refinement);
        const Json& is = object(scene, index);
        EXPECT_EQ(is["knots"][direction].size(), was["knots"][direction].size() + 1);
        EXPECT_EQ(is["points"].size(), was["points"].size() + (direction == 0 ? 1 : 0));
        EXPECT_EQ(is["points"][0].size(), was["points"][0].size() + (direction == 1 ? 1 : 0));
        EXPECT_EQ(is["style"], was["style"]);
        const Json after = is;
        EXPECT_TRUE(scene.undo());
        EXPECT_EQ(object(scene, index), was);
        EXPECT_TRUE(scene.redo());
        EXPECT_EQ(object(scene, index), after);
    }
}

TEST(SurfaceKnotEdits, RemovingAnInsertedKnotGivesTheSurfaceBack) {
    constexpr const char* removals[] = {"objects[0].knots[0][4]", "objects[0].knots[0][3]",
                                        "objects[0].knots[1][2]", "objects[0].knots[1][3]",
                                        "objects[1].knots[0][3]", "objects[1].knots[0][0]",
                                        "objects[1].knots[1][3]"};
    for (std::size_t k = 0; k < std::size(insertions); ++k) {
        SCOPED_TRACE(insertions[k].command);
        Scene scene = open();
        const std::size_t index = insertions[k].object;
        const Surface before = surfaceOf(scene, index);
        expectDone(scene, insertions[k].command);
        expectDone(scene, R"({"remove": ")" + std::string(removals[k]) + R"("})");
        EXPECT_LE(moved(before, surfaceOf(scene, index)), 1e-12);
        EXPECT_EQ(object(scene, index)["knots"], object(open(), index)["knots"]);
    }
}

TEST(SurfaceKnotEdits, ARemovedKnotTakesALineOfPointsWithItWhereverItWas) {
    Scene scene = open();
    const Surface before = surfaceOf(scene, 0);
    expectDone(scene, R"({"remove": "objects[0].knots[0][3]"})");
    EXPECT_EQ(object(scene, 0)["points"].size(), 3U);
    EXPECT_EQ(object(scene, 0)["knots"][0], json("[0,0,0,3,3,3]"));
    // What is left is near, and at the clamped ends where it was.
    EXPECT_LE(moved(before, surfaceOf(scene, 0)), 2);
    for (const double v : {1.0, 2.5, 3.5}) {
        EXPECT_LE(glm::length(at(before, 0, v) - at(surfaceOf(scene, 0), 0, v)), 1e-12);
        EXPECT_LE(glm::length(at(before, 3, v) - at(surfaceOf(scene, 0), 3, v)), 1e-12);
    }
}

TEST(SurfaceKnotEdits, KnotsOfABlendTakeALineOfPatchesWithThem) {
    Scene scene = open();
    const Json was = object(scene, 2);
    expectDone(scene, R"({"insertKnot": {"object": "blend", "at": 0.75, "along": "v"}})");
    EXPECT_EQ(object(scene, 2)["locals"], json("[4, 4]"));
    EXPECT_EQ(object(scene, 2)["poses"][0]["local"], json("[1, 0]"));
    EXPECT_EQ(object(scene, 2)["poses"][1]["local"], json("[3, 3]"));
    expectDone(scene, R"({"insertKnot": {"object": "blend", "at": 0.5, "along": "u"}})");
    EXPECT_EQ(object(scene, 2)["poses"][0]["local"], json("[2, 0]"));
    expectDone(scene, R"({"remove": "objects[2].knots[0][1]"})");
    expectDone(scene, R"({"remove": "objects[2].knots[1][2]"})");
    EXPECT_EQ(object(scene, 2), was);
    expectDone(scene, R"({"remove": "objects[2].knots[0][3]"})");
    EXPECT_EQ(object(scene, 2)["poses"].size(), 1U);
}

TEST(SurfaceKnotEdits, EqualKnotsMoveAsThoseOfCurvesDo) {
    Scene scene = open();
    const auto knots = [&] { return object(scene, 0)["knots"][0]; };
    expectDone(scene, R"({"insertKnot": {"object": "net", "at": 1, "along": "u"}})");
    const auto pulled = scene.execute(json(R"({"move": "objects[0].knots[0][3]", "to": 2})"));
    ASSERT_TRUE(pulled.ok());
    EXPECT_EQ(pulled->path, "objects[0].knots[0][4]");
    EXPECT_EQ(knots(), json("[0,0,0,1,2,3,3,3]"));
    expectDone(scene, R"({"move": "objects[0].knots[0][4]", "to": 1.02, "snap": 0.05})");
    EXPECT_EQ(knots(), json("[0,0,0,1,1,3,3,3]"));
    expectDone(scene, R"({"move": "objects[0].knots[0][0]", "to": -1})");
    EXPECT_EQ(knots(), json("[-1,-1,-1,1,1,3,3,3]"));
}

TEST(SurfaceKnotEdits, RefusalsNameThePlace) {
    Scene scene = open();
    const auto insert = [&](const char* arguments, Code code, const char* path) {
        expectRefused(scene, R"({"insertKnot": )" + std::string(arguments) + "}", code, path);
    };
    insert(R"({"object": "net", "at": 4, "along": "u"})", Code::outOfRange, "insertKnot.at");
    insert(R"({"object": "net", "at": 1, "along": "w"})", Code::unknownName, "insertKnot.along");
    insert(R"({"object": "net", "at": 1, "along": 0})", Code::wrongType, "insertKnot.along");
    insert(R"({"object": "net", "at": 1})", Code::wrongType, "insertKnot.along");
    insert(R"({"object": "net", "at": 1, "along": "u", "times": 2})", Code::unknownField,
           "insertKnot.times");
    insert(R"({"object": "torus", "at": 1, "along": "u"})", Code::notSupported, "insertKnot.along");
    insert(R"({"object": "torus", "at": 1})", Code::notSupported, "insertKnot.object");
    insert(R"({"object": "blend", "at": 9, "along": "v"})", Code::outOfRange, "insertKnot.at");
    insert(R"({"object": "net", "at": 2, "along": "v"})", Code::knotsMultiplicity, "insertKnot.at");
    expectRefused(scene, R"({"insert": "objects[0].knots[0]", "value": "1"})", Code::wrongType,
                  "objects[0].knots[0]");
    expectRefused(scene, R"({"remove": "objects[0].knots[0][0]"})", Code::outOfRange,
                  "objects[0].knots[0][0]");
    expectRefused(scene, R"({"remove": "objects[0].knots[0][12]"})", Code::unknownField,
                  "objects[0].knots[0][12]");
    expectRefused(scene, R"({"remove": "objects[2].knots[0][0]"})", Code::outOfRange,
                  "objects[2].knots[0][0]");
}

TEST(SurfaceKnots, OneWithoutWhichAWeightWouldNotBePositiveIsRefused) {
    // The weights 4, 1, 1, 4 come of a middle one of 2 · 1 − 4 alone.
    const auto knots = KnotVector::make({0, 0, 0, 0.5, 1, 1, 1}, 2, 4, Form::clamped).value();
    const auto across = KnotVector::uniform(1, 2, Form::clamped).value();
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 2; ++j) points.emplace_back(i, j, 0);
    }
    const auto made = BsplineSurface::make(knots, across, points, {4, 4, 1, 1, 1, 1, 4, 4});
    const auto without = removeKnot(made.value(), 0, 0.5);
    ASSERT_FALSE(without.ok());
    EXPECT_EQ(without.error().code, Code::outOfRange);
    EXPECT_EQ(without.error().path, "t");
    EXPECT_TRUE(removeKnot(BsplineSurface::make(knots, across, points).value(), 0, 0.5).ok());
}

}  // namespace
}  // namespace knotwork::scene
