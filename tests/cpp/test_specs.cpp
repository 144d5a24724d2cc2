#include "scene/specs.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

namespace knotwork::scene {
namespace {

using test::json;

struct Refusal {
    const char* text;
    Code code;
    const char* path;
};

template <class Make>
void expectRefusals(std::span<const Refusal> refusals, Make make) {
    for (const Refusal& refusal : refusals) {
        const auto made = make(json(refusal.text));
        ASSERT_FALSE(made.ok()) << refusal.text;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << refusal.text;
        EXPECT_EQ(made.error().path, refusal.path) << refusal.text;
        EXPECT_GT(made.error().message.size(), 20U) << refusal.text;
    }
}

TEST(Json, ReadsNumbersAsDoublesAndKeepsTheOrderOfKeys) {
    const Json read = json(R"({"b": 1, "a": [2.5, -3e2], "c": "x"})");
    EXPECT_EQ(dumpJson(read), R"({"b":1.0,"a":[2.5,-300.0],"c":"x"})");
}

TEST(Json, RefusesBrokenTextDeepNestingAndHugeInput) {
    EXPECT_EQ(parseJson("{\"a\": ").error().code, Code::syntax);
    EXPECT_EQ(parseJson("").error().code, Code::syntax);
    EXPECT_EQ(parseJson("{} {}").error().code, Code::syntax);
    EXPECT_EQ(parseJson("1e999").error().code, Code::syntax);
    EXPECT_EQ(parseJson(std::string(33, '[') + std::string(33, ']')).error().code, Code::tooLarge);
    EXPECT_TRUE(parseJson(std::string(32, '[') + std::string(32, ']')).ok());
    EXPECT_EQ(parseJson(std::string(maximumDocumentBytes + 1, ' ')).error().code, Code::tooLarge);
}

TEST(Json, CborCarriesNumbersThatJsonCannotAndByteStringsAsDoubles) {
    std::vector<std::uint8_t> bytes{0x82, 0xfb};
    const auto append = [&](double number) {
        std::array<std::uint8_t, 8> raw{};
        std::memcpy(raw.data(), &number, 8);
        bytes.insert(bytes.end(), raw.begin(), raw.end());
    };
    // A big-endian NaN, then a byte string of two little-endian doubles.
    bytes.insert(bytes.end(), {0x7f, 0xf8, 0, 0, 0, 0, 0, 0});
    bytes.push_back(0x50);
    append(1.5);
    append(-2);
    const auto read = parseCbor(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_TRUE(std::isnan((*read)[0].get<double>()));
    EXPECT_EQ((*read)[1], Json::array({1.5, -2.0}));
    bytes.pop_back();
    EXPECT_EQ(parseCbor(bytes).error().code, Code::syntax);
}

TEST(BFunctionSpec, IsCompletedWithDefaultsInTheOrderOfTheTables) {
    const auto made = makeBFunction(json(R"({"gamma": 2, "family": "expo-rational"})"));
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(dumpJson(made->spec),
              R"({"family":"expo-rational","alpha":1.0,"beta":1.0,"gamma":2.0,"lambda":0.5})");
}

TEST(BFunctionSpec, FamiliesMadeOfOthersNest) {
    const auto made = makeBFunction(json(
        R"({"family": "mixed", "of": [{"family": "linear"}, {"family": "dual",
            "of": {"family": "polynomial", "p": 1, "q": 3}}], "weight": 0.25})"));
    ASSERT_TRUE(made.ok()) << made.error().message;
    const auto beta = BFunction::makePolynomial(1, 3).value();
    EXPECT_NEAR(made->value.value(0.3), 0.25 * 0.3 + 0.75 * (1 - beta.value(0.7)), 1e-15);
}

TEST(BFunctionSpec, BadOnesAreRefusedWithTheirPlace) {
    const std::array refusals{
        Refusal{R"({})", Code::wrongType, "family"},
        Refusal{R"({"family": "erb"})", Code::unknownName, "family"},
        Refusal{R"({"family": "linear", "alpha": 1})", Code::unknownField, "alpha"},
        Refusal{R"({"family": "rational", "m": "2"})", Code::wrongType, "m"},
        Refusal{R"({"family": "rational", "m": null})", Code::wrongType, "m"},
        Refusal{R"({"family": "rational", "m": 51})", Code::outOfRange, "m"},
        Refusal{R"({"family": "expo-rational", "lambda": 1})", Code::outOfRange, "lambda"},
        Refusal{R"({"family": "trigonometric", "order": 1.5})", Code::notInteger, "order"},
        Refusal{R"({"family": "composed", "outer": {"family": "linear"},
                    "inner": {"family": "logistic", "c": 0}})", Code::outOfRange, "inner.c"},
        Refusal{R"({"family": "mixed", "of": [{"family": "linear"}]})", Code::wrongLength, "of"},
        Refusal{R"({"family": "tabulated", "values": [0, 0.6, 0.5, 1]})", Code::outOfRange,
                "values[2]"},
        Refusal{R"([])", Code::wrongType, ""},
    };
    expectRefusals(refusals, makeBFunction);
}

TEST(CurveSpec, ASplineGetsItsFormAndKnots) {
    const auto made = makeCurve(json(
        R"({"type": "bspline-curve", "points": [[0, 0], [1, 2], [3, 0]], "degree": 2})"));
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(dumpJson(made->spec),
              R"({"type":"bspline-curve","degree":2.0,"form":"clamped",)"
              R"("points":[[0.0,0.0],[1.0,2.0],[3.0,0.0]],"knots":[0.0,0.0,0.0,1.0,1.0,1.0]})");
    EXPECT_EQ(dimension(made->value), 2);
}

TEST(CurveSpec, FlatPointsAreTriples) {
    const auto made = makeCurve(json(
        R"({"type": "bspline-curve", "degree": 1, "points": [0, 0, 0, 1, 2, 3]})"));
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->spec["points"], json("[[0,0,0],[1,2,3]]"));
    EXPECT_EQ(dimension(made->value), 3);
}

TEST(CurveSpec, TheCanonicalFormIsItsOwnCanonicalForm) {
    for (const char* text :
         {R"({"type": "parametric-curve", "name": "rose", "parameters": {"k": 1.5}})",
          R"({"type": "bspline-curve", "degree": 2, "form": "closed", "weights": [1, 2, 1, 2],
              "points": [[0,0],[1,0],[1,1],[0,1]]})",
          R"({"type": "blending-curve", "bFunction": {"family": "rational"},
              "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 4},
              "poses": [{"local": 2, "scale": [2, 1]}]})",
          R"({"type": "blending-curve", "bFunction": {"family": "linear"}, "fit": "affine",
              "locals": [{"type": "parametric-curve", "name": "circle"},
                         {"type": "parametric-curve", "name": "heart"}]})"}) {
        const auto once = makeCurve(json(text));
        ASSERT_TRUE(once.ok()) << once.error().path << once.error().message;
        const auto twice = makeCurve(once->spec);
        ASSERT_TRUE(twice.ok()) << twice.error().message;
        EXPECT_EQ(dumpJson(once->spec), dumpJson(twice->spec));
        EXPECT_EQ(pointAt(once->value, 0.4), pointAt(twice->value, 0.4));
    }
}

TEST(CurveSpec, ABlendOfAClosedModelIsClosedUnlessToldOtherwise) {
    const char* text = R"({"type": "blending-curve", "bFunction": {"family": "linear"},
        "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 4}})";
    auto spec = json(text);
    const auto closed = makeCurve(spec);
    EXPECT_EQ(closed->spec["form"], "closed");
    EXPECT_EQ(closed->spec["knots"].size(), 5U);
    spec["form"] = "open";
    EXPECT_EQ(makeCurve(spec)->spec["knots"].size(), 4U);
}

TEST(CurveSpec, BadOnesAreRefusedWithTheirPlace) {
    const std::array refusals{
        Refusal{R"({})", Code::wrongType, "type"},
        Refusal{R"({"type": "spline"})", Code::unknownName, "type"},
        Refusal{R"({"type": "bspline-curve", "degree": 2})", Code::wrongType, "points"},
        Refusal{R"({"type": "bspline-curve", "degree": 26, "points": [[0,0]]})", Code::tooLarge,
                "degree"},
        Refusal{R"({"type": "bspline-curve", "degree": 0, "points": [[0,0],[1,1]]})",
                Code::outOfRange, "degree"},
        Refusal{R"({"type": "bspline-curve", "degree": 2.5, "points": [[0,0],[1,1]]})",
                Code::notInteger, "degree"},
        Refusal{R"({"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,1]]})",
                Code::wrongLength, "points"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1]]})",
                Code::wrongLength, "points[1]"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,"1"]]})",
                Code::wrongType, "points[1][1]"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [0,0,0,1]})", Code::wrongLength,
                "points"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,1]],
                    "knots": [0,0,2,1]})", Code::knotsDecreasing, "knots[3]"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,1]],
                    "knots": [0,0,1]})", Code::knotsCount, "knots"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,1]],
                    "weights": [1,-1]})", Code::outOfRange, "weights[1]"},
        Refusal{R"({"type": "bspline-curve", "degree": 1, "points": [[0,0],[1,1]], "form": "x"})",
                Code::unknownName, "form"},
        Refusal{R"({"type": "parametric-curve", "name": "rosa"})", Code::unknownName, "name"},
        Refusal{R"({"type": "parametric-curve", "name": "rose", "parameters": {"q": 1}})",
                Code::unknownField, "parameters.q"},
        Refusal{R"({"type": "parametric-curve", "name": "rose", "parameters": {"k": 0.31830988618}})",
                Code::outOfRange, "parameters.k"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "linear"},
                    "locals": {"count": 4}})", Code::wrongType, "model"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "linear"},
                    "locals": {"count": 1}, "model": {"type": "parametric-curve", "name": "circle"}})",
                Code::outOfRange, "locals.count"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "rational", "c": -1},
                    "locals": {"count": 3}, "model": {"type": "parametric-curve", "name": "circle"}})",
                Code::outOfRange, "bFunction.c"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "linear"},
                    "locals": {"count": 3}, "model": {"type": "parametric-curve", "name": "circle"},
                    "poses": [{"local": 1}, {"local": 1}]})", Code::outOfRange, "poses[1].local"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "linear"},
                    "locals": {"count": 3}, "model": {"type": "parametric-curve", "name": "circle"},
                    "poses": [{"local": 1, "scale": 0}]})", Code::outOfRange, "poses[0].scale"},
        Refusal{R"({"type": "blending-curve", "bFunction": {"family": "linear"},
                    "locals": {"count": 3, "kind": "sub-curve"},
                    "model": {"type": "bspline-curve", "degree": 3, "points": [[0,0]]}})",
                Code::wrongLength, "model.points"},
    };
    expectRefusals(refusals, makeCurve);
}

TEST(CurveSpec, AComputedSplineIsSpelledAsItWouldBeGiven) {
    const auto made = makeCurve(json(
        R"({"type": "bspline-curve", "degree": 2, "form": "closed", "weights": [1, 2, 1, 2],
            "points": [[0,0],[1,0],[1,1],[0,1]]})"));
    EXPECT_EQ(dumpJson(specOf(*made->value.as<BsplineCurve>())), dumpJson(made->spec));
}

}  // namespace
}  // namespace knotwork::scene
