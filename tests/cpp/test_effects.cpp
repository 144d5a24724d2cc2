// Effects: every kind at rest, half way and on its way, and what is refused of them.
#include "scene/effects.hpp"

#include "scene/document.hpp"
#include "support/json_text.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <array>
#include <tuple>

namespace knotwork::scene {
namespace {

using test::expectDone;
using test::json;
using test::twoScene;

constexpr const char* everyEffect = R"({
    "knotwork": 1,
    "objects": [
        {"id": "line", "type": "line-curve", "from": [1, 0], "to": [3, 0]},
        {"id": "blend", "type": "blending-curve", "bFunction": {"family": "expo-rational"},
         "model": {"type": "parametric-curve", "name": "butterfly"}, "locals": {"count": 12}},
        {"id": "tube", "type": "blending-surface", "bFunction": {"family": "expo-rational"},
         "model": {"type": "parametric-surface", "name": "cylinder"}, "locals": [5, 3]}],
    "effects": [
        {"target": "line", "kind": "scale", "factor": 3, "center": [2, 0]},
        {"target": "line", "kind": "rotate", "angle": 1.5707963267948966, "center": [2, 0]},
        {"target": "blend", "kind": "scale", "factor": [2, 4], "local": 3},
        {"target": "blend", "kind": "translate", "by": [0, 0, 1], "local": 4},
        {"target": "blend", "kind": "morph", "to": {"type": "parametric-curve", "name": "rose"}},
        {"target": "tube", "kind": "rotate", "angle": 1, "local": [2, 1]},
        {"target": "tube", "kind": "simulate", "rotate": {"angle": 1}}]})";

Moment atPhase(double phase) { return {.phase = phase, .time = {}}; }

TEST(Effects, AtPhaseZeroAndOneEverythingStandsWhereItBeganToTheBit) {
    const Scene scene = twoScene();
    const auto rest = place(scene.state(), {});
    for (const double phase : {0.0, 1.0}) {
        const auto placed = place(scene.state(), {.phase = phase, .time = {}});
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_EQ(placed[i].placement, Affine{});
            EXPECT_EQ(placed[i].colour, rest[i].colour);
            for (double t = 0; t < 4; t += 0.3) {
                EXPECT_EQ(pointAt(*placed[i].body.curve(), t), pointAt(*rest[i].body.curve(), t));
            }
        }
    }
    const auto half = place(scene.state(), {.phase = 0.5, .time = {}});
    const Vec3 there = pointAt(*half[1].body.curve(), 0);
    EXPECT_GT(glm::length(there - pointAt(*rest[1].body.curve(), 0)), 1e-3);
    EXPECT_NEAR(half[0].colour.red, 1, 1e-12);
}

TEST(Effects, ADayOfTimeLeavesNoDrift) {
    const Scene scene = twoScene();
    const auto now = place(scene.state(), {.phase = {}, .time = 1.25});
    const auto later = place(scene.state(), {.phase = {}, .time = 1.25 + 86'400});
    const Vec3 then = pointAt(*later[1].body.curve(), 1);
    EXPECT_LE(glm::length(pointAt(*now[1].body.curve(), 1) - then), 1e-9);
    EXPECT_EQ(phaseAt(-1e-30, 10), 0);
    EXPECT_NEAR(phaseAt(-2.5, 10), 0.75, 1e-15);
}

TEST(Effects, GoThereAndComeBackTheSameWay) {
    const auto easing = BFunction::makeTrigonometric().value();
    EXPECT_EQ(effectWeight(easing, 0), 0);
    EXPECT_EQ(effectWeight(easing, 0.5), 1);
    EXPECT_EQ(effectWeight(easing, 1), 0);
    EXPECT_NEAR(effectWeight(easing, 0.2), effectWeight(easing, 0.8), 1e-15);
}

TEST(Effects, SimulatingTurnsAPosedLocalFurther) {
    // Two turns about different axes become one: compare with the product of the rotations.
    Scene scene = twoScene();
    expectDone(scene, R"({"set": "effects[0].rotate", "value": {"axis": [1, 2, 0], "angle": 1.5}})");
    expectDone(scene, R"({"pose": {"object": "blend", "local": 0,
                          "rotate": {"axis": [0, 1, 1], "angle": 0.7}}})");
    const auto rest = place(scene.state(), {});
    const auto half = place(scene.state(), {.phase = 0.5, .time = {}});
    const auto& before = rest[1].body.as<BlendingCurve>()->locals()[0];
    const auto& after = half[1].body.as<BlendingCurve>()->locals()[0];
    const Mat3 extra = after.placement().linear * glm::inverse(before.placement().linear);
    const Vec3 axis = glm::normalize(Vec3(1, 2, 0));
    EXPECT_LE(glm::length(extra * axis - axis), 1e-14);
    EXPECT_GT(glm::length(extra * Vec3(0, 0, 1) - Vec3(0, 0, 1)), 1e-3);
}

TEST(Effects, TurningATurnedLocalIsNowhereWorse) {
    // About one axis the angles add up; where they make half a turn the product of their matrices is
    // symmetric and hides the axis.
    constexpr double half = 3.141592653589793;
    const Vec3 axis(1, 2, -2);
    for (const double past : {-1e-3, -1e-7, -1e-12, 0.0, 1e-10, 1e-5}) {
        Scene scene = twoScene();
        Json turn = json(R"({"set": "effects[0].rotate", "value": {"axis": [1, 2, -2]}})");
        const double share = place(scene.state(), atPhase(0.5))[1]
                                 .body.as<BlendingCurve>()->locals()[0].pose().angle;
        Json pose = json(R"({"pose": {"object": "blend", "local": 0, "rotate": {"axis": [1, 2, -2]}}})");
        pose["pose"]["rotate"]["angle"] = half + past - share;
        turn["value"]["angle"] = 1;
        ASSERT_TRUE(scene.execute(turn).ok());
        ASSERT_TRUE(scene.execute(pose).ok());
        const auto placed = place(scene.state(), atPhase(0.5))[1].body;
        const Pose& found = placed.as<BlendingCurve>()->locals()[0].pose();
        const Mat3 difference = rotation(found.axis, found.angle) - rotation(axis, half + past);
        for (int k = 0; k < 3; ++k) EXPECT_LE(glm::length(difference[k]), 2e-15) << past;
    }
}

TEST(Effects, EveryKindIsGoneAtPhaseZeroAndOne) {
    const Scene scene = Scene::open(json(everyEffect)).value();
    const auto rest = place(scene.state(), {});
    for (const double phase : {0.0, 1.0}) {
        const auto placed = place(scene.state(), atPhase(phase));
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_EQ(placed[i].placement, Affine{});
        }
        for (double t = 0; t < 30; t += 0.7) {
            EXPECT_EQ(pointAt(*placed[1].body.curve(), t), pointAt(*rest[1].body.curve(), t));
            const auto at = placeInDomain(*rest[2].body.surface(), t, 0.4).value();
            EXPECT_EQ(pointAt(*placed[2].body.surface(), at), pointAt(*rest[2].body.surface(), at));
        }
    }
}

TEST(Effects, WholeObjectsAreScaledAndTurnedAboutTheirCentre) {
    const Scene scene = Scene::open(json(everyEffect)).value();
    const Placed line = place(scene.state(), atPhase(0.5))[0];
    // [1, 3] on the x-axis, about 2 three times as long, then upright.
    EXPECT_LE(glm::length(line.placement.point({1, 0, 0}) - Vec3(2, -3, 0)), 1e-15);
    EXPECT_LE(glm::length(line.placement.point({3, 0, 0}) - Vec3(2, 3, 0)), 1e-15);
    EXPECT_EQ(line.placement.point({2, 0, 0}), Vec3(2, 0, 0));
}

TEST(Effects, OneLocalMovesByItself) {
    Json document = json(everyEffect);
    document["effects"].erase(4);  // without the morph
    const Scene scene = Scene::open(document).value();
    const auto rest = place(scene.state(), {})[1].body;
    const auto half = place(scene.state(), atPhase(0.5))[1].body;
    const auto& before = *rest.as<BlendingCurve>();
    const auto& after = *half.as<BlendingCurve>();
    for (std::size_t j = 0; j < before.locals().size(); ++j) {
        Pose expected;
        if (j == 3) expected.scale = {2, 4, 1};
        if (j == 4) expected.translate = {0, 0, 1};
        EXPECT_EQ(after.locals()[j].pose(), expected) << j;
    }
}

TEST(Effects, PatchesOfASurfaceMoveToo) {
    const Scene scene = Scene::open(json(everyEffect)).value();
    const auto half = place(scene.state(), atPhase(0.5))[2].body;
    const auto& tube = *half.as<BlendingSurface>();
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_FALSE(tube.place(i, j).pose().isIdentity()) << i << ' ' << j;
        }
    }
    // The one that is turned besides is turned by more than the others may be.
    EXPECT_NE(tube.place(2, 1).pose(), tube.place(2, 2).pose());
}

TEST(Effects, AMorphPassesThroughBothCurves) {
    Json document = json(everyEffect);
    for (const int other : {3, 2}) document["effects"].erase(static_cast<std::size_t>(other));
    const Scene scene = Scene::open(document).value();
    const auto rest = place(scene.state(), {})[1].body;
    const auto half = place(scene.state(), atPhase(0.5))[1].body;
    const Curve rose(ParametricCurve::make("rose").value());
    const double ratio = domain(rose).length() / domain(*rest.curve()).length();
    for (double t = 0; t < 37; t += 0.31) {
        EXPECT_LE(glm::length(pointAt(*half.curve(), t) - pointAt(rose, ratio * t)), 1e-13);
    }
    const double weight = effectWeight(scene.state().effects[2]->easing, 0.2);
    const auto some = place(scene.state(), atPhase(0.2))[1].body;
    for (double t = 0; t < 37; t += 0.31) {
        const Vec3 mixed =
            (1 - weight) * pointAt(*rest.curve(), t) + weight * pointAt(rose, ratio * t);
        EXPECT_LE(glm::length(pointAt(*some.curve(), t) - mixed), 1e-12);
    }
}

TEST(Effects, RefusalsNameTheirPlace) {
    const std::array<std::tuple<const char*, Code, const char*>, 9> refusals{{
        {R"({"target": "line", "kind": "scale", "factor": 0})", Code::outOfRange, "factor"},
        {R"({"target": "line", "kind": "scale", "factor": [1, -1]})", Code::outOfRange,
         "factor[1]"},
        {R"({"target": "line", "kind": "scale", "local": 0})", Code::notSupported, "local"},
        {R"({"target": "blend", "kind": "scale", "local": 12})", Code::outOfRange, "local"},
        {R"({"target": "blend", "kind": "scale", "local": [1, 1]})", Code::notSupported, "local"},
        {R"({"target": "tube", "kind": "rotate", "local": [1, 3]})", Code::outOfRange, "local[1]"},
        {R"({"target": "tube", "kind": "morph"})", Code::notSupported, "kind"},
        {R"({"target": "line", "kind": "simulate"})", Code::notSupported, "kind"},
        {R"({"target": "blend", "kind": "morph", "to": {"type": "bspline-curve", "degree": 3,
            "points": [[0, 0]]}})", Code::wrongLength, "to.points"},
    }};
    const Scene scene = Scene::open(json(everyEffect)).value();
    for (const auto& [spec, code, path] : refusals) {
        const auto effect = readEffect(json(spec), scene.state().objects);
        ASSERT_FALSE(effect.ok()) << spec;
        EXPECT_EQ(effect.error().code, code) << spec << effect.error().message;
        EXPECT_EQ(effect.error().path, path) << spec << effect.error().message;
    }
}

TEST(Effects, EveryKindHasDefaultsForAllButItsTarget) {
    const Scene scene = Scene::open(json(everyEffect)).value();
    for (const char* kind : {"translate", "rotate", "scale", "simulate", "morph", "colour"}) {
        const auto effect =
            readEffect({{"target", "blend"}, {"kind", kind}}, scene.state().objects);
        ASSERT_TRUE(effect.ok()) << kind << effect.error().message;
        EXPECT_EQ((*effect)->period, 10);
        const auto again = readEffect((*effect)->spec, scene.state().objects);
        EXPECT_EQ(dumpJson((*again)->spec), dumpJson((*effect)->spec)) << kind;
    }
}

}  // namespace
}  // namespace knotwork::scene
