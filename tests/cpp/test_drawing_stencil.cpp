#include "support/drawings.hpp"
#include "support/scene_commands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace knotwork::drawing {
namespace {

using namespace test;

std::string flatNet(const std::string& rest) {
    return R"({"type": "subdivision-surface", "levels": 1, "mesh": {
        "vertices": [[0,0],[1,0],[2,0],[0,1],[1.25,1.5],[2,1],[0,2],[1,2],[2,2]],
        "faces": [[0,1,4,3],[1,2,5,4],[3,4,7,6],[4,5,8,7]]}, )" + rest + "}";
}

std::vector<std::string> labelsOf(const Drawing& drawing) {
    std::vector<std::string> texts;
    for (const Shape& shape : drawing.shapes) {
        if (shape.kind == Kind::label) texts.push_back(shape.text);
    }
    std::sort(texts.begin(), texts.end());
    return texts;
}

TEST(DrawnStencils, ShowTheNewPointAmongWhatMakesItWithTheWeightsAsFractions) {
    const Drawing drawing = drawn({flatNet(R"("stencil": {"of": "vertex", "index": 4})")});
    const auto shapes = withRole(drawing, Role::trace);
    ASSERT_EQ(shapes.size(), 3U + 10U);
    EXPECT_EQ(shapes[0]->indices.size(), 2 * 9U);
    EXPECT_EQ(shapes[1]->positions.size(), 3 * 9U);
    EXPECT_EQ(shapes[2]->index, 1);
    const Shape& wires = *withRole(drawing, Role::polygon).at(0);
    EXPECT_EQ(positionIn(*shapes[1], 4), positionIn(wires, 4));
    // 9/16 of itself, 3/32 of the sum of its neighbours (5.5, 4.5)…
    const Vec3 sum{9 * 1.25 / 16 + 3 * 4.0 / 32 + 4.0 / 64, 9 * 1.5 / 16 + 3 * 4.0 / 32 + 4.0 / 64, 0};
    EXPECT_LE(glm::length(positionIn(*shapes[2], 0) - sum), 1e-15);
    EXPECT_EQ(labelsOf(drawing), (std::vector<std::string>{"1/64", "1/64", "1/64", "1/64", "3/32",
                                                           "3/32", "3/32", "3/32", "9/16", "v′"}));
}

TEST(DrawnStencils, WriteWeightsThatAreNoFractionsWithThreeDigits) {
    const char* const pyramid = R"({"type": "subdivision-surface", "scheme": "loop",
        "mesh": {"vertices": [[0,0,1],[1,0],[0.3,1],[-0.8,0.6],[-0.8,-0.6],[0.3,-1]],
                 "faces": [[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,5,1]]}, "stencil": {"of": "vertex"}})";
    // β = (5/8 − (3/8 + cos 72°/4)²)/5
    EXPECT_EQ(labelsOf(drawn({pyramid})), (std::vector<std::string>{"0.0841", "0.0841", "0.0841",
                                                                   "0.0841", "0.0841", "0.58", "v′"}));
}

TEST(DrawnStencils, TakeTheLastElementBeyondTheEndAndNameTheirs) {
    const auto labels = labelsOf(drawn({flatNet(R"("stencil": {"of": "face", "index": 99})")}));
    EXPECT_EQ(labels, (std::vector<std::string>{"1/4", "1/4", "1/4", "1/4", "f"}));
    EXPECT_EQ(labelsOf(drawn({flatNet(R"("stencil": {"of": "edge", "index": 1})")})).back(), "e");
}

TEST(DrawnStencils, FollowASchemeThatMakesOtherPoints) {
    scene::Scene scene = sceneOf({flatNet(R"("stencil": {"of": "face", "index": 1})")});
    expectDone(scene, R"({"set": "objects[0].scheme", "value": "loop"})");
    EXPECT_EQ(scene.document()["objects"][0]["stencil"],
              scene::parseJson(R"({"of": "vertex", "index": 1})").value());
    expectDone(scene, R"({"set": "objects[0].scheme", "value": "doo-sabin"})");
    EXPECT_EQ(scene.document()["objects"][0]["stencil"]["of"], "corner");
    expectRefused(scene, R"({"set": "objects[0].stencil.of", "value": "edge"})", Code::notSupported,
                  "objects[0].stencil.of");
    expectRefused(scene, R"({"set": "objects[0].stencil.index", "value": -1})", Code::outOfRange,
                  "objects[0].stencil.index");
    expectDone(scene, R"({"remove": "objects[0].stencil"})");
    EXPECT_EQ(labelsOf(draw(scene.state(), {})).size(), 0U);
}

}  // namespace
}  // namespace knotwork::drawing
