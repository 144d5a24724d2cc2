#include "geometry/patch_surface.hpp"
#include "scene/surface_specs.hpp"
#include "support/blending_gates.hpp"
#include "support/blending_surfaces.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace knotwork::scene {
namespace {

namespace gates = test::gates;
using test::json;
using test::matrixAt;

const std::string cylinder =
    R"({"type":"parametric-surface","name":"cylinder","parameters":{"height":3}})";

/// A blending surface of a cylinder with these fields besides, or instead.
Json blend(const std::string& fields) {
    Json spec = json(R"({"type":"blending-surface","bFunction":{"family":"linear"},"model":)" +
                     cylinder + R"(,"locals":[4,3]})");
    const Json given = json("{" + fields + "}");
    for (const auto& item : given.items()) spec[item.key()] = item.value();
    return spec;
}

TEST(BlendingSurfaceSpec, ComesBackCompleteWithTheFormsAndKnotsOfTheModel) {
    const auto made = makeSurface(blend(R"("poses":[{"local":[1,2],"translate":[0,1]}])"));
    ASSERT_TRUE(made.ok()) << made.error().message;
    Json spec = made->spec;
    EXPECT_EQ(spec["form"], json(R"(["closed","open"])"));
    EXPECT_EQ(spec["knots"][0].size(), 5u);
    EXPECT_EQ(spec["knots"][1], json("[0,1.5,3]"));
    EXPECT_EQ(spec["kind"], "sub-surface");
    EXPECT_EQ(spec["model"]["parameters"]["radius"], 1.0);
    EXPECT_EQ(dumpJson(spec["poses"]),
              R"([{"local":[1.0,2.0],"translate":[0.0,1.0],"rotate":{"axis":[0.0,0.0,1.0],"angle":0.0},"scale":1.0}])");
    std::vector<std::string> keys;
    for (const auto& item : spec.items()) keys.push_back(item.key());
    EXPECT_EQ(keys, (std::vector<std::string>{"type", "bFunction", "model", "locals", "kind",
                                              "form", "knots", "poses"}));
    const auto again = makeSurface(spec);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->spec, spec);
    EXPECT_EQ(matrixAt(again->value, {1, 2}, {2, 2}), matrixAt(made->value, {1, 2}, {2, 2}));
}

TEST(BlendingSurfaceSpec, BezierPatchesHaveDegreesAndTheOthersNone) {
    EXPECT_EQ(makeSurface(blend(R"("kind":"bezier")"))->spec["degree"], json("[3,3]"));
    EXPECT_EQ(makeSurface(blend(R"("kind":"bezier","degree":[2,5])"))->spec["degree"],
              json("[2,5]"));
    EXPECT_FALSE(makeSurface(blend(R"("kind":"plane")"))->spec.contains("degree"));
    const auto made = makeSurface(blend(R"("kind":"plane","degree":[2,2])"));
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, Code::notSupported);
    EXPECT_EQ(made.error().path, "degree");
}

TEST(BlendingSurfaceSpec, OneBFunctionServesBothDirectionsOrEachHasItsOwn) {
    const auto one = makeSurface(blend(R"("bFunction":{"family":"logistic"})"));
    const auto* same = one->value.as<BlendingSurface>();
    EXPECT_EQ(same->alongU().blend, same->alongV().blend);
    EXPECT_TRUE(one->spec["bFunction"].is_object());
    const auto two =
        makeSurface(blend(R"("bFunction":[{"family":"linear"},{"family":"logistic","c":2}])"));
    const auto* different = two->value.as<BlendingSurface>();
    EXPECT_EQ(different->alongU().blend.family(), BFamily::linear);
    EXPECT_EQ(different->alongV().blend.parameters()[0], 2);
    EXPECT_EQ(two->spec["bFunction"][1]["c"], 2.0);
}

TEST(BlendingSurfaceSpec, WhatIsComputedHasASpecificationThatMakesItAgain) {
    const auto composed =
        BFunction::makeComposed(BFunction::makePolynomial(2, 1).value(),
                                BFunction::makeTabulated(std::vector{0.0, 0.25, 1.0}).value())
            .value();
    const auto mixed =
        BFunction::makeMixed(BFunction::makeFormula("3 * t^2 - 2 * t^3").value(),
                             BFunction::makeDual(BFunction::makeExpoRational().value()).value(),
                             0.25)
            .value();
    for (const auto& [name, surface] : test::blendingSpecimens(composed, mixed)) {
        const Json spec = specOf(Surface(surface));
        const auto again = makeSurface(spec);
        ASSERT_TRUE(again.ok()) << name << ": " << again.error().path << again.error().message;
        EXPECT_EQ(again->spec, spec) << name;
        const SurfacePlace at{surface.domain().u.start + 0.7, surface.domain().v.start + 0.4};
        EXPECT_EQ(matrixAt(again->value, at, {2, 2}), matrixAt(surface, at, {2, 2})) << name;
    }
}

struct Refusal {
    const char* fields;
    Code code;
    const char* path;
};

TEST(BlendingSurfaceSpec, RefusalsNameThePlaceOfTheFault) {
    const std::vector<Refusal> refusals{
        {R"("bFunction":{"family":"expo-rational","alpha":-1})", Code::outOfRange,
         "bFunction.alpha"},
        {R"("bFunction":[{"family":"linear"},{"family":"expo-rational","alpha":9}])",
         Code::outOfRange, "bFunction[1].alpha"},
        {R"("bFunction":[{"family":"linear"}])", Code::wrongLength, "bFunction"},
        {R"("bFunction":"linear")", Code::wrongType, "bFunction"},
        {R"("bFunction":[{"family":"tabulated","values":[0,2,1]},{"family":"linear"}])",
         Code::outOfRange, "bFunction[0].values[2]"},
        {R"("model":{"type":"parametric-surface","name":"egg"})", Code::unknownName, "model.name"},
        {R"("model":{"type":"circle"})", Code::unknownName, "model.type"},
        {R"("model":3)", Code::wrongType, "model"},
        {R"("locals":4)", Code::wrongType, "locals"},
        {R"("locals":[4])", Code::wrongLength, "locals"},
        {R"("locals":[4,1])", Code::outOfRange, "locals[1]"},
        {R"("locals":[4.5,3])", Code::notInteger, "locals[0]"},
        {R"("locals":[4,10001])", Code::tooLarge, "locals[1]"},
        {R"("locals":[200,200])", Code::tooLarge, "locals"},
        {R"("locals":["4",3])", Code::wrongType, "locals[0]"},
        {R"("kind":"sphere")", Code::unknownName, "kind"},
        {R"("kind":"bezier","degree":[3,26])", Code::tooLarge, "degree[1]"},
        {R"("kind":"bezier","degree":[0,3])", Code::outOfRange, "degree[0]"},
        {R"("form":["closed","clamped"])", Code::unknownName, "form[1]"},
        {R"("form":"closed")", Code::wrongType, "form"},
        {R"("knots":[[0,1,2,3],[0,1,2]])", Code::knotsCount, "knots[0]"},
        {R"("knots":[[0,1,2,1.5,4],[0,1,2]])", Code::knotsDecreasing, "knots[0][3]"},
        {R"("knots":[[0,1,2,3,4],[0,0,0]])", Code::knotsMultiplicity, "knots[1][2]"},
        {R"("knots":[[0,1,2,3,4],[0,1,null]])", Code::wrongType, "knots[1][2]"},
        {R"("poses":[{"local":[0,0]},{"local":[4,0]}])", Code::outOfRange, "poses[1].local[0]"},
        {R"("poses":[{"local":[0,3]}])", Code::outOfRange, "poses[0].local[1]"},
        {R"("poses":[{"local":[0,-1]}])", Code::outOfRange, "poses[0].local[1]"},
        {R"("poses":[{"local":[1,1]},{"local":[1,1]}])", Code::outOfRange, "poses[1].local"},
        {R"("poses":[{"local":1}])", Code::wrongType, "poses[0].local"},
        {R"("poses":[{"scale":2}])", Code::wrongType, "poses[0].local"},
        {R"("poses":[{"local":[0,0],"scale":0}])", Code::outOfRange, "poses[0].scale"},
        {R"("poses":[{"local":[0,0],"rotate":{"axis":[0,0,0],"angle":1}}])", Code::outOfRange,
         "poses[0].rotate.axis"},
        {R"("poses":[{"local":[0,0],"turn":1}])", Code::unknownField, "poses[0].turn"},
        {R"("spacing":"length")", Code::unknownField, "spacing"}};
    for (const Refusal& refusal : refusals) {
        const auto made = makeSurface(blend(refusal.fields));
        ASSERT_FALSE(made.ok()) << refusal.fields;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << refusal.fields;
        EXPECT_EQ(made.error().path, refusal.path) << refusal.fields;
        EXPECT_GT(made.error().message.size(), 20U) << refusal.fields;
    }
}

TEST(BlendingSurfaceSpec, APatchByItselfIsThePatchWhereItTakesPart) {
    const auto erb = BFunction::makeExpoRational().value();
    for (const auto& [name, surface] : test::blendingSpecimens(erb, {})) {
        for (std::size_t i = 0; i < surface.alongU().count; ++i) {
            for (std::size_t j = 0; j < surface.alongV().count; ++j) {
                const auto patch = patchSurface(surface, i, j);
                ASSERT_TRUE(patch.ok()) << name << ": " << patch.error().message;
                const Rectangle over{surface.alongU().support(i), surface.alongV().support(j)};
                EXPECT_EQ(domain(*patch), over) << name;
                for (const double share : {0.0, 0.3, 0.5, 1.0}) {
                    const SurfacePlace at{over.u.start + share * over.u.length(),
                                          over.v.end - share * over.v.length()};
                    std::array<Vec3, 9> expected;
                    surface.patch(i, j, at, {2, 2}, expected);
                    const auto got = matrixAt(*patch, at, {2, 2});
                    double size = 1;
                    for (const Vec3& row : expected) size = std::max(size, glm::length(row));
                    for (std::size_t k = 0; k < got.size(); ++k) {
                        test::expectNear(got[k], expected[k], gates::patchAlone * size, name);
                    }
                }
                const auto again = makeSurface(specOf(*patch));
                ASSERT_TRUE(again.ok()) << name << ": " << again.error().message;
            }
        }
    }
}

}  // namespace
}  // namespace knotwork::scene
