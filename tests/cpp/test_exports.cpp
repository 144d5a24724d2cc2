#include "drawing/exports.hpp"

#include "scene/builtin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace knotwork::drawing {
namespace {

using scene::Json;
using scene::Scene;

constexpr std::array formats{ExportFormat::svg, ExportFormat::json, ExportFormat::js,
                             ExportFormat::csv, ExportFormat::obj,  ExportFormat::stl,
                             ExportFormat::gltf, ExportFormat::glb};

Scene opened(const std::string& objects) {
    const std::string text = R"({ "knotwork": 1, "title": "uri\": \"data:", "objects": [)" + objects + "] }";
    auto scene = Scene::open(scene::parseJson(text).value());
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().path + scene.error().message);
    return *std::move(scene);
}

std::string subdivided(int levels) {
    return R"({ "id": "m", "type": "subdivision-surface", "scheme": "catmull-clark", "levels": )" +
           std::to_string(levels) + R"(, "mesh": { "solid": "cube" }, "show": { "wireframe": true } })";
}

/// One of every kind of thing that is written in a way of its own: turned over as a whole, falling
/// apart, with a fit, coloured by curvature, with labels.
Scene zoo() {
    return opened(subdivided(3) + R"(,
        { "id": "s", "type": "parametric-surface", "name": "torus", "style": { "colourBy": "gaussian" } },
        { "id": "c", "type": "bspline-curve", "degree": 3, "points": [[0,0],[1,2],[3,1],[4,4],[6,0]],
          "show": { "comb": true, "labels": true, "hull": true } },
        { "id": "p", "type": "point-cloud", "points": [[0,0],[1,1],[2,0],[3,1],[4,0],[5,2]],
          "fit": { "degree": 2, "count": 4 } },
        { "id": "f", "type": "b-function", "bFunction": { "family": "formula", "expression": "sin(pi*t)^2" } },
        { "id": "b", "type": "blending-curve", "bFunction": { "family": "expo-rational" },
          "model": { "type": "parametric-curve", "name": "circle" }, "locals": { "count": 4, "kind": "arc" } })");
}

/// In slices of this weight, what has been written taken away after each.
Result<std::string> sliced(const scene::State& state, ExportFormat format, double weight) {
    SceneExport work(state, format, {});
    std::string text;
    for (;;) {
        const auto more = work.advance(weight);
        if (!more) return more.error();
        text += work.take();
        if (!*more) return text;
    }
}

TEST(Exports, InSlicesOfAnySizeAreTheSameToTheByte) {
    const Scene scene = zoo();
    for (const ExportFormat format : formats) {
        const auto whole = exportScene(scene.state(), format, {});
        ASSERT_TRUE(whole.ok());
        for (const double weight : {0.0, 7.3, 100.0, 4000.0, 1e6}) {
            const auto pieces = sliced(scene.state(), format, weight);
            ASSERT_TRUE(pieces.ok());
            EXPECT_TRUE(*pieces == *whole)
                << exportFormatNames[static_cast<std::size_t>(format)] << " by " << weight;
        }
    }
}

TEST(Exports, OfEveryBuiltInSceneAreTheSameInSlices) {
    for (const scene::BuiltinScene& builtin : scene::builtinScenes()) {
        const Scene scene = Scene::open(scene::parseJson(builtin.document).value()).value();
        for (const ExportFormat format : {ExportFormat::svg, ExportFormat::glb, ExportFormat::csv}) {
            const auto whole = exportScene(scene.state(), format, {});
            ASSERT_TRUE(whole.ok());
            EXPECT_TRUE(sliced(scene.state(), format, 50).value() == *whole) << builtin.id;
        }
    }
}

TEST(Exports, OfALargeMeshHaveManySlicesAndAFractionThatGrows) {
    const Scene scene = opened(subdivided(5));
    for (const ExportFormat format :
         {ExportFormat::svg, ExportFormat::csv, ExportFormat::obj, ExportFormat::stl,
          ExportFormat::gltf, ExportFormat::glb}) {
        SceneExport work(scene.state(), format, {});
        double former = work.fraction();
        EXPECT_EQ(former, 0);
        double longest = 0;
        int slices = 1;
        for (; work.advance(1000).value(); ++slices) {
            EXPECT_GE(work.fraction(), former);
            longest = std::max(longest, work.fraction() - former);
            former = work.fraction();
        }
        const auto name = exportFormatNames[static_cast<std::size_t>(format)];
        EXPECT_GE(slices, 12) << name;
        EXPECT_LT(longest, 0.2) << name;
        EXPECT_NEAR(work.fraction(), 1, 1e-9) << name;
    }
}

TEST(Exports, HaveTheSceneAsItWasWhenTheyBegan) {
    Scene scene = opened(subdivided(3));
    const std::string whole = exportScene(scene.state(), ExportFormat::obj, {}).value();
    SceneExport work(scene.state(), ExportFormat::obj, {});
    ASSERT_TRUE(work.advance(100).value());
    ASSERT_TRUE(scene.execute(scene::parseJson(R"({ "set": "objects[0].levels", "value": 1 })").value()).ok());
    EXPECT_TRUE(work.finish().value() == whole);
}

TEST(Exports, ThatAreDroppedHalfWayKeepNothing) {
    for (const ExportFormat format : formats) {
        auto scene = std::make_unique<Scene>(zoo());
        const std::weak_ptr<const scene::Object> object = scene->state().objects.front();
        auto work = std::make_unique<SceneExport>(scene->state(), format, ExportOptions{});
        while (work->fraction() < 0.5 && work->advance(100).value()) {
        }
        scene.reset();
        EXPECT_FALSE(object.expired());
        work.reset();
        EXPECT_TRUE(object.expired()) << exportFormatNames[static_cast<std::size_t>(format)];
    }
}

TEST(Exports, ThatAreRefusedSayWhyInASliceToo) {
    const Scene curve = opened(R"({ "id": "c", "type": "line-curve", "from": [0,0], "to": [1,1] })");
    EXPECT_EQ(sliced(curve.state(), ExportFormat::stl, 10).error().code, Code::notSupported);
    SceneExport fine(zoo().state(), ExportFormat::obj, {.moment = {}, .tolerance = 1e-13});
    auto more = fine.advance(10);
    while (more.ok() && *more) more = fine.advance(10);
    ASSERT_FALSE(more.ok());
    EXPECT_EQ(more.error().code, Code::tooLarge);
    EXPECT_EQ(more.error().path, "tolerance");
    EXPECT_FALSE(fine.advance(10).ok());
}

}  // namespace
}  // namespace knotwork::drawing
