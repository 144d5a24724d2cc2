#include "scene/surface_specs.hpp"
#include "support/traces.hpp"

#include <string>

namespace knotwork::scene {
namespace {

Json blendOf(const std::string& rest) {
    return parsed(R"({"type":"blending-surface","bFunction":[{"family":"expo-rational"},
        {"family":"polynomial"}],"model":{"type":"parametric-surface","name":"torus"},)" +
                  rest + "}");
}

TEST(TraceBlendSurface, EndsWithThePointOfTheSurface) {
    for (const char* rest :
         {R"("locals":[3,4])", R"("locals":[4,2],"kind":"plane")",
          R"("locals":[5,3],"kind":"bezier","poses":[{"local":[0,1],"translate":[1,2,3]}])",
          R"("locals":[2,3],"form":["open","closed"],"poses":[{"local":[1,0],"scale":2}])",
          R"("locals":[4,2],"form":["open","open"],"knots":[[0,1,1,6],[0,6]])"}) {
        const Json spec = blendOf(rest);
        const auto surface = makeSurface(spec);
        ASSERT_TRUE(surface.ok()) << surface.error().message;
        const auto* blend = surface->value.as<BlendingSurface>();
        const auto places = [](const std::vector<double>& knots) {
            std::vector<double> all(knots);
            for (std::size_t i = 1; i < knots.size(); ++i) {
                all.push_back(0.3 * knots[i - 1] + 0.7 * knots[i]);
            }
            return all;
        };
        for (const double u : places(blend->alongU().knots)) {
            for (const double v : places(blend->alongV().knots)) {
                const Trace trace = traced(
                    Json{{"algorithm", "blend"}, {"surface", spec}, {"u", u}, {"v", v}});
                ASSERT_EQ(trace.frames.size(), 5u);
                expectReadable(trace);
                const Vec3 point = pointAt(surface->value, *placeInDomain(surface->value, u, v));
                EXPECT_LE(distance(trace.frames.back().points.back(), point),
                          test::gates::exact * 16)
                    << rest << " at " << u << ", " << v;
                const auto& weights = trace.frames.back().weights;
                ASSERT_EQ(weights.size(), 4u);
                EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1,
                            test::gates::partitionOfUnity);
                EXPECT_EQ(trace.frames[2].matrix[1][0], weights[2]);
            }
        }
    }
}

TEST(TraceBlendSurface, SaysWhatItBlends) {
    const Trace trace = traced(R"({"algorithm":"blend","u":0.5,"v":0.25,"surface":{
        "type":"blending-surface","bFunction":{"family":"linear"},"locals":[2,3],
        "model":{"type":"parametric-surface","name":"plane"},
        "poses":[{"local":[1,0],"translate":[0,0,1]}]}})");
    EXPECT_EQ(trace.algorithm, "blend");
    EXPECT_EQ(trace.frames[0].text,
              "The parameter u = 0.5 lies between the knots 0 and 1, and v = 0.25 between 0 and "
              "0.5; there the local patches (0, 0), (0, 1), (1, 0) and (1, 1) are blended.");
    EXPECT_EQ(trace.frames[2].text,
              "Each patch counts the product of its weight along u, 0.5 or 0.5, and its weight "
              "along v, 0.5 or 0.5: 0.25, 0.25, 0.25 and 0.25, which together are 1.");
    EXPECT_EQ(trace.frames[4].text, "Blended with these weights they give the point of the surface "
                                    "at (0.5, 0.25), (0.5, 0.25, 0.25).");
    EXPECT_EQ(trace.frames[3].points[trace.frames[3].marked[2]], Vec3(0.5, 0.25, 1));
}

TEST(TraceBlendSurface, RefusesWhatItCannotTrace) {
    const std::string plane = R"({"type":"parametric-surface","name":"plane"})";
    const std::string blend = dumpJson(blendOf(R"("locals":[2,2],"form":["open","open"])"));
    const auto of = [](const std::string& surface, const std::string& rest) {
        return R"({"algorithm":"blend","surface":)" + surface + rest + "}";
    };
    expectRefused(of(plane, R"(,"u":0,"v":0)"), Code::notSupported, "surface.type");
    expectRefused(of(blend, R"(,"u":0)"), Code::wrongType, "v");
    expectRefused(of(blend, R"(,"u":7,"v":0)"), Code::outOfRange, "u");
    expectRefused(of(blend, R"(,"u":0,"v":-1)"), Code::outOfRange, "v");
    expectRefused(of(blend, R"(,"u":0,"v":0,"t":0)"), Code::unknownField, "t");
    expectRefused(of(blend, R"(,"u":0,"v":0,"curve":{})"), Code::unknownField, "curve");
    expectRefused(of(R"({"type":"blending-surface"})", R"(,"u":0,"v":0)"), Code::wrongType,
                  "surface.bFunction");
}

}  // namespace
}  // namespace knotwork::scene
