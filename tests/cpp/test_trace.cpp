// Traces of any algorithm: what is refused, and the public form.
#include "support/traces.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

TEST(Trace, RefusesWhatItDoesNotKnow) {
    expectRefused("[]", Code::wrongType, "");
    expectRefused("{}", Code::wrongType, "algorithm");
    expectRefused(R"({"algorithm":7})", Code::wrongType, "algorithm");
    expectRefused(R"({"algorithm":"doo-sabin","mesh":{},"levels":1})", Code::unknownName,
                  "algorithm");
    expectRefused(R"({"algorithm":"de-boor"})", Code::wrongType, "curve");
    expectRefused(onQuadratic("de-boor", "\"knot\":1"), Code::unknownField, "knot");
    expectRefused(onQuadratic("boehm", "\"t\":1"), Code::unknownField, "t");
    expectRefused(onSquare("four-point", ",\"degree\":3"), Code::unknownField, "degree");
    expectRefused(onSquare("lane-riesenfeld", ",\"tension\":0"), Code::unknownField, "tension");
    const auto refused = makeTrace(parsed(R"({"algorithm":"casteljau"})"));
    EXPECT_NE(refused.error().message.find("de-boor, cox-de-boor, factor-matrices, boehm, oslo, "
                                           "lane-riesenfeld, four-point, blend"),
              std::string::npos);
}

TEST(Trace, RefusesArgumentsWhereTheyStand) {
    expectRefused(onQuadratic("de-boor", "\"t\":\"1\""), Code::wrongType, "t");
    expectRefused(onQuadratic("de-boor", "\"t\":4.5"), Code::outOfRange, "t");
    expectRefused(onQuadratic("cox-de-boor", "\"t\":-1"), Code::outOfRange, "t");
    expectRefused(onQuadratic("boehm", "\"knot\":5"), Code::outOfRange, "knot");
    expectRefused(onQuadratic("boehm", "\"knot\":4"), Code::knotsMultiplicity, "knot");
    expectRefused(onQuadratic("oslo", "\"knots\":[0,0,0,1]"), Code::knotsCount, "knots");
    expectRefused(onQuadratic("oslo", "\"knots\":[0,0,0,2,3,4,4,4]"), Code::knotsMultiplicity,
                  "knots[3]");
    expectRefused(onQuadratic("oslo", "\"knots\":[0,0,0,1,3,2,4,4,4]"), Code::knotsDecreasing,
                  "knots[5]");
    expectRefused(R"({"algorithm":"oslo","curve":{"type":"bspline-curve","degree":2,"form":"open",
        "points":[[0,0],[1,1],[2,0]]},"knots":[0,1,1.5,2,3,4,5]})", Code::outOfRange, "knots[2]");
    expectRefused(R"({"algorithm":"de-boor","t":0,"curve":{"type":"bspline-curve","degree":2,
        "points":[[0,0],[1,1],[2]]}})", Code::wrongLength, "curve.points[2]");
    expectRefused(R"({"algorithm":"de-boor","t":0,"curve":{"type":"bspline-curve","degree":3,
        "points":[[0,0],[1,1],[2,0]]}})", Code::wrongLength, "curve.points");
    expectRefused(R"({"algorithm":"de-boor","t":0,"curve":{"type":"nurbs"}})", Code::unknownName,
                  "curve.type");
    expectRefused(R"({"algorithm":"oslo","knots":[],"curve":{"type":"parametric-curve",
        "name":"circle"}})", Code::notSupported, "curve.type");
    expectRefused(onQuadratic("blend", "\"t\":1"), Code::notSupported, "curve.type");
}

TEST(Trace, RefusesPolygonsThatCannotBeSubdivided) {
    expectRefused(onSquare("lane-riesenfeld", ",\"degree\":0"), Code::outOfRange, "degree");
    expectRefused(onSquare("lane-riesenfeld", ",\"degree\":26"), Code::tooLarge, "degree");
    expectRefused(onSquare("lane-riesenfeld", ",\"levels\":1.5"), Code::notInteger, "levels");
    expectRefused(onSquare("lane-riesenfeld", ",\"levels\":-1"), Code::outOfRange, "levels");
    expectRefused(onSquare("four-point", ",\"tension\":1.5"), Code::outOfRange, "tension");
    expectRefused(R"({"algorithm":"lane-riesenfeld","points":[[0,0],[1,1],[2,2]]})",
                  Code::wrongLength, "points");
    expectRefused(R"({"algorithm":"four-point","points":[[0,0],[1,1]],"closed":true})",
                  Code::wrongLength, "points");
    expectRefused(R"({"algorithm":"four-point","points":[[0,0],[1,"1"]]})", Code::wrongType,
                  "points[1][1]");
    expectRefused(R"({"algorithm":"four-point","points":[[0,0],[1,1e300]]})", Code::outOfRange,
                  "points[1]");
}

TEST(Trace, RefusesWhatNobodyCanLookAt) {
    expectRefused(onSquare("lane-riesenfeld", ",\"levels\":22"), Code::tooLarge, "levels");
    expectRefused(onSquare("four-point", ",\"levels\":22"), Code::tooLarge, "levels");
    Json curve = parsed(quadratic);
    curve.erase("knots");
    for (int i = 0; i < 21'000; ++i) curve["points"].push_back(Json::array({i, i}));
    const auto refused = makeTrace({{"algorithm", "de-boor"}, {"curve", curve}, {"t", 1.5}});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(codeName(refused.error().code), "TOO_LARGE");
    EXPECT_EQ(refused.error().path, "curve.points");
}

TEST(Trace, NoLevelsIsThePolygonItself) {
    const Trace trace = traced(onSquare("four-point", ",\"levels\":0"));
    ASSERT_EQ(trace.frames.size(), 1u);
    EXPECT_EQ(trace.frames[0].points.size(), 4u);
    EXPECT_EQ(trace.frames[0].edges.size(), 4u);
}

TEST(Trace, IsTheSameEveryTime) {
    for (const char* algorithm : {"de-boor", "cox-de-boor", "factor-matrices"}) {
        const std::string arguments = onQuadratic(algorithm, "\"t\":1.7");
        EXPECT_EQ(dumpJson(traceJson(traced(arguments))), dumpJson(traceJson(traced(arguments))));
    }
}

TEST(Trace, HasItsPublicForm) {
    const Json json = traceJson(traced(onQuadratic("factor-matrices", "\"t\":2")));
    EXPECT_EQ(json["algorithm"], "factor-matrices");
    const Json& frame = json["frames"][2];
    std::set<std::string> names;
    for (const auto& item : frame.items()) names.insert(item.key());
    EXPECT_EQ(names, (std::set<std::string>{"edges", "formula", "key", "marked", "matrix", "points",
                                            "text", "title", "values", "weights"}));
    EXPECT_EQ(frame["points"][0], Json::array({1.0, 2.0, 0.0}));
    EXPECT_EQ(frame["key"], "factor-matrices.factor");
    EXPECT_EQ(frame["values"]["k"], "2");
    EXPECT_EQ(frame["matrix"].size(), 2u);
}

}  // namespace
}  // namespace knotwork::scene
