#include "scene/fields.hpp"
#include "scene/surface_specs.hpp"
#include "support/blending_triangles.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace knotwork::scene {
namespace {

using test::json;
using test::matrixAt;

const std::string plane = R"({"type":"parametric-surface","name":"plane"})";
const std::string torus = R"({"type":"parametric-surface","name":"torus","parameters":{"R":3}})";

/// A blending triangle with these fields besides, or instead.
Json triangle(const std::string& fields = "") {
    Json spec = json(R"({"type":"blending-triangle","locals":[)" + torus + "," + plane + "," +
                     torus + "]}");
    const Json given = json("{" + fields + "}");
    for (const auto& item : given.items()) spec[item.key()] = item.value();
    return spec;
}

std::vector<std::string> keysOf(const Json& spec) {
    std::vector<std::string> keys;
    for (const auto& item : spec.items()) keys.push_back(item.key());
    return keys;
}

TEST(BlendingTriangleSpec, ComesBackCompleteWithAnOrderOrABFunction) {
    const auto made = makeSurface(triangle());
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(keysOf(made->spec), (std::vector<std::string>{"type", "locals", "order"}));
    EXPECT_EQ(made->spec["order"], 1.0);
    EXPECT_EQ(made->spec["locals"][0]["parameters"]["r"], 1.0);
    EXPECT_EQ(made->value.as<BlendingTriangle>()->blend().order, 1);
    EXPECT_EQ(makeSurface(triangle(R"("order":2)"))->value.as<BlendingTriangle>()->blend().order, 2);
    const auto other = makeSurface(triangle(R"("bFunction":{"family":"logistic"})"));
    ASSERT_TRUE(other.ok()) << other.error().message;
    EXPECT_EQ(keysOf(other->spec), (std::vector<std::string>{"type", "locals", "bFunction"}));
    EXPECT_EQ(other->spec["bFunction"]["c"], 1.0);
    for (const auto& one : {made, other}) {
        const auto again = makeSurface(one->spec);
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(again->spec, one->spec);
        EXPECT_EQ(matrixAt(again->value, {0.3, 0.4}, {2, 2}),
                  matrixAt(one->value, {0.3, 0.4}, {2, 2}));
    }
}

TEST(BlendingTriangleSpec, WhatIsComputedHasASpecificationThatMakesItAgain) {
    const Surface inner = test::triangleOf(test::threePatches());
    for (const auto& [name, blend] : test::triangleBlends()) {
        const Surface surface =
            test::triangleOf({inner, test::model("helicoid"), test::threePatches()[1]}, blend);
        const Json spec = specOf(surface);
        const auto again = makeSurface(spec);
        ASSERT_TRUE(again.ok()) << name << ": " << again.error().path << again.error().message;
        EXPECT_EQ(again->spec, spec) << name;
        EXPECT_EQ(matrixAt(again->value, {0.6, 0.3}, {2, 2}), matrixAt(surface, {0.6, 0.3}, {2, 2}));
    }
}

/// A triangle of triangles so deep.
std::string nested(int depth) {
    if (depth == 0) return plane;
    const std::string inner = nested(depth - 1);
    return R"({"type":"blending-triangle","locals":[)" + inner + "," + inner + "," + inner + "]}";
}

struct Refusal {
    std::string fields;
    Code code;
    const char* path;
};

TEST(BlendingTriangleSpec, RefusalsNameThePlaceOfTheFault) {
    const auto locals = [](const std::string& list) { return R"("locals":[)" + list + "]"; };
    const std::vector<Refusal> refusals{
        {locals(plane + "," + plane), Code::wrongLength, "locals"},
        {locals(plane + "," + plane + "," + plane + "," + plane), Code::wrongLength, "locals"},
        {locals(""), Code::wrongLength, "locals"},
        {R"("locals":3)", Code::wrongType, "locals"},
        {R"("locals":{"0":1})", Code::wrongType, "locals"},
        {locals(plane + ",3," + plane), Code::wrongType, "locals[1]"},
        {locals(plane + "," + plane + R"(,{"type":"circle"})"), Code::unknownName,
         "locals[2].type"},
        {locals(R"({"type":"line-curve","from":[0,0],"to":[1,1]},)" + plane + "," + plane),
         Code::unknownName, "locals[0].type"},
        {locals(plane + R"(,{"type":"parametric-surface","name":"egg"},)" + plane),
         Code::unknownName, "locals[1].name"},
        {locals(plane + R"(,{"type":"bspline-surface","degree":[1,1],"points":[[[0,0]],[[1,1]]]},)" +
                plane),
         Code::wrongLength, "locals[1].points[0]"},
        {R"("order":0)", Code::outOfRange, "order"},
        {R"("order":3)", Code::outOfRange, "order"},
        {R"("order":1.5)", Code::notInteger, "order"},
        {R"("order":"1")", Code::wrongType, "order"},
        {R"("order":null)", Code::wrongType, "order"},
        {R"("bFunction":{"family":"sine"})", Code::unknownName, "bFunction.family"},
        {R"("bFunction":[{"family":"linear"},{"family":"linear"}])", Code::wrongType, "bFunction"},
        {R"("bFunction":{"family":"logistic","c":1000})", Code::outOfRange, "bFunction"},
        {R"("order":1,"bFunction":{"family":"linear"})", Code::notSupported, "order"},
        {R"("degree":[1,1])", Code::unknownField, "degree"},
        {R"("model":{})", Code::unknownField, "model"},
        {locals(nested(6) + "," + nested(6) + "," + nested(6)), Code::tooLarge, "locals"},
        {locals(plane + "," + nested(7) + "," + plane), Code::tooLarge, "locals[1].locals"}};
    for (const Refusal& refusal : refusals) {
        const auto made = makeSurface(triangle(refusal.fields));
        ASSERT_FALSE(made.ok()) << refusal.fields;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << refusal.fields;
        EXPECT_EQ(made.error().path, refusal.path) << refusal.fields;
        EXPECT_GT(made.error().message.size(), 20U) << refusal.fields;
    }
    Json without = triangle();
    without.erase("locals");
    EXPECT_EQ(makeSurface(without).error().path, "locals");
}

TEST(BlendingTriangleSpec, ItsTableSaysThatThereAreThreePatches) {
    const SurfaceType* type = findSurfaceType("blending-triangle");
    ASSERT_NE(type, nullptr);
    EXPECT_EQ(type->fields.front().name, "locals");
    EXPECT_EQ(type->fields.front().min, 3);
    EXPECT_EQ(type->fields.front().max, 3);
}

TEST(BlendingTriangleSpec, PanelsShowTheFieldsOfEachPatch) {
    std::vector<std::string> paths;
    for (const PanelField& field : panelFields(makeSurface(triangle())->spec)) {
        paths.push_back(field.path);
    }
    for (const char* path : {"locals[0].parameters.R", "locals[1].parameters.width", "order"}) {
        EXPECT_NE(std::find(paths.begin(), paths.end(), path), paths.end()) << path;
    }
}

}  // namespace
}  // namespace knotwork::scene
