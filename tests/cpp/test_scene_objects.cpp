// Objects of every type in a document: curves are test_scene.cpp's, these are the others.
#include "scene/fields.hpp"
#include "scene/object_builders.hpp"
#include "scene/scene.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <tuple>

namespace knotwork::scene {
namespace {

using test::json;

constexpr const char* everything = R"({
    "knotwork": 1, "view": {"mode": "3d", "camera": {"azimuth": 0.5, "elevation": 0.4}},
    "objects": [
        {"id": "net", "type": "bspline-surface", "degree": [1, 2],
         "points": [[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],[1,1,1],[1,2,0]]]},
        {"id": "ring", "type": "parametric-surface", "name": "torus"},
        {"id": "tube", "type": "blending-surface", "bFunction": {"family": "expo-rational"},
         "model": {"type": "parametric-surface", "name": "cylinder"}, "locals": [5, 3],
         "poses": [{"local": [1, 1], "translate": [0, 0, 1]}]},
        {"id": "ball", "type": "subdivision-surface", "levels": 2, "mesh": {"solid": "cube"}},
        {"id": "data", "type": "point-cloud", "points": [[0,0],[1,1],[2,0],[3,1],[4,0]],
         "fit": {"degree": 2, "count": 4}},
        {"id": "article", "type": "b-function", "at": [1, 2], "size": 3,
         "bFunction": {"family": "formula", "expression": "sin(pi*t)^2"}}]})";

TEST(SceneObjects, EveryTypeIsMadeAndWrittenBack) {
    const Scene scene = Scene::open(json(everything)).value();
    const auto& objects = scene.state().objects;
    EXPECT_NE(objects[0]->body.as<BsplineSurface>(), nullptr);
    EXPECT_NE(objects[1]->body.as<ParametricSurface>(), nullptr);
    const auto* tube = objects[2]->body.as<BlendingSurface>();
    ASSERT_NE(tube, nullptr);
    EXPECT_EQ(tube->place(1, 1).pose().translate.z, 1);
    ASSERT_NE(objects[3]->body.subdivision(), nullptr);
    EXPECT_EQ(objects[3]->body.subdivision()->refined.faces().count(), 96U);
    ASSERT_NE(objects[4]->body.cloud(), nullptr);
    EXPECT_EQ(objects[4]->body.cloud()->fit->curve.points().size(), 4U);
    EXPECT_EQ(objects[4]->body.curve(), nullptr);
    ASSERT_NE(objects[5]->body.graph(), nullptr);
    EXPECT_EQ(objects[5]->body.graph()->candidate.value(0.5), 1);
    EXPECT_EQ(objects[5]->body.graph()->at, Vec3(1, 2, 0));
    const Json document = scene.document();
    EXPECT_EQ(dumpJson(Scene::open(document)->document()), dumpJson(document));
}

TEST(SceneObjects, CanonicalKeysStandInTheOrderOfTheTables) {
    const Scene scene = Scene::open(json(everything)).value();
    for (const auto& object : scene.state().objects) {
        std::vector<std::string> keys;
        for (const auto& item : object->spec.items()) keys.push_back(item.key());
        EXPECT_EQ(keys.front(), "id");
        EXPECT_EQ(keys[1], "type");
        EXPECT_EQ(keys.back(), "show") << object->id;
    }
}

TEST(SceneObjects, RefusalsNameTheirPlace) {
    const std::array<std::tuple<const char*, Code, const char*>, 8> refusals{{
        {R"({"type": "subdivision-surface"})", Code::wrongType, "mesh"},
        {R"({"type": "subdivision-surface", "mesh": 3})", Code::wrongType, "mesh"},
        {R"({"type": "subdivision-surface", "mesh": {"solid": "cub"}})", Code::unknownName,
         "mesh.solid"},
        {R"({"type": "subdivision-surface", "mesh": {"solid": "cube"}, "scheme": "loop"})",
         Code::notSupported, "mesh.faces[0]"},
        {R"({"type": "subdivision-surface", "mesh": {"solid": "cube"}, "levels": 20})",
         Code::tooLarge, "levels"},
        {R"({"type": "point-cloud", "points": [[0,0],[1,0]], "fit": {"degree": 3, "count": 2}})",
         Code::outOfRange, "fit.count"},
        {R"({"type": "b-function", "bFunction": {"family": "formula", "expression": "t+"}})",
         Code::syntax, "bFunction.expression"},
        {R"({"type": "point-cloud", "points": [], "sho": 1})", Code::unknownField, "sho"},
    }};
    for (const auto& [spec, code, path] : refusals) {
        const auto made = makeObject(json(spec));
        ASSERT_FALSE(made.ok()) << spec;
        EXPECT_EQ(made.error().code, code) << spec << made.error().message;
        EXPECT_EQ(made.error().path, path) << spec << made.error().message;
    }
}

TEST(SceneObjects, PanelsShowWhatASurfaceIsMadeOfAndOnlyFlagsThatDoSomething) {
    const Scene scene = Scene::open(json(everything)).value();
    const auto pathsOf = [&](std::size_t i) {
        std::set<std::string> paths;
        for (const PanelField& field : panelFields(scene.state().objects[i]->spec)) {
            paths.insert(field.path);
        }
        return paths;
    };
    const auto net = pathsOf(0);
    for (const char* path : {"degree[0]", "degree[1]", "form[1]", "points[1]", "knots[0]"}) {
        EXPECT_TRUE(net.contains(path)) << path;
    }
    EXPECT_TRUE(net.contains("show.isolines"));
    EXPECT_FALSE(net.contains("show.comb"));
    const auto tube = pathsOf(2);
    for (const char* path : {"bFunction.alpha", "model.name", "model.parameters.radius",
                             "locals[0]", "show.handles"}) {
        EXPECT_TRUE(tube.contains(path)) << path;
    }
    EXPECT_TRUE(pathsOf(4).contains("fit.count"));
}

}  // namespace
}  // namespace knotwork::scene
