// What the tests of traces share: making them from text, and what every frame has to be.
#pragma once

#include "scene/json_values.hpp"
#include "scene/specs.hpp"
#include "scene/trace.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace knotwork::scene {

using test::RandomSplines;
using test::SplineKind;

inline Json parsed(const std::string& text) {
    auto json = parseJson(text);
    EXPECT_TRUE(json.ok()) << text;
    return std::move(*json);
}

inline Trace traced(const Json& arguments) {
    auto trace = makeTrace(arguments);
    EXPECT_TRUE(trace.ok())
        << (trace.ok() ? "" : trace.error().path + ": " + trace.error().message);
    return trace.ok() ? std::move(*trace) : Trace{};
}

inline Trace traced(const std::string& text) { return traced(parsed(text)); }
inline Trace traced(const char* text) { return traced(parsed(text)); }

inline Json about(const char* algorithm, const BsplineCurve& curve, const char* name, Json value) {
    return {{"algorithm", algorithm}, {"curve", specOf(Curve(curve))}, {name, std::move(value)}};
}

inline void expectRefused(const std::string& arguments, Code code, const std::string& path) {
    const auto trace = makeTrace(parsed(arguments));
    ASSERT_FALSE(trace.ok()) << arguments;
    EXPECT_EQ(codeName(trace.error().code), codeName(code)) << arguments;
    EXPECT_EQ(trace.error().path, path) << arguments;
    EXPECT_GT(trace.error().message.size(), 20u);
}

inline double distance(const Vec3& a, const Vec3& b) { return glm::length(a - b); }

/// The names of elements that are open where the text ends, or what is wrong in it.
inline std::string unbalanced(const std::string& markup) {
    std::vector<std::string> open;
    for (std::size_t at = 0; at < markup.size(); ++at) {
        if (markup[at] == '&') {
            const std::string entity = markup.substr(at, markup.find(';', at) - at + 1);
            if (entity != "&lt;" && entity != "&gt;" && entity != "&amp;") return "bare &";
        }
        if (markup[at] == '>') return "bare >";
        if (markup[at] != '<') continue;
        const std::size_t end = markup.find('>', at);
        if (end == std::string::npos) return "no end of a tag";
        const std::string tag = markup.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find(' '));
        if (name[0] != '/') {
            open.push_back(name);
        } else {
            if (open.empty() || "/" + open.back() != name) return "stray " + name;
            open.pop_back();
        }
        at = end;
    }
    return open.empty() ? "" : "open " + open.back();
}

inline void expectReadable(const TraceFrame& frame) {
    EXPECT_FALSE(frame.title.empty());
    EXPECT_FALSE(frame.points.empty());
    ASSERT_GT(frame.text.size(), 20u);
    EXPECT_EQ(frame.text.back(), '.');
    for (const std::string& text : {frame.title, frame.text}) {
        EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << text;
        EXPECT_EQ(text.find("  "), std::string::npos) << text;
        for (const char* odd : {"nan", "inf", "NaN", "-0 ", "-0,", "-0)", " ,", "()"}) {
            EXPECT_EQ(text.find(odd), std::string::npos) << text;
        }
    }
    for (const auto& edge : frame.edges) {
        EXPECT_LT(edge[0], frame.points.size());
        EXPECT_LT(edge[1], frame.points.size());
        EXPECT_NE(edge[0], edge[1]);
    }
    for (const std::size_t i : frame.marked) EXPECT_LT(i, frame.points.size());
    for (const Vec3& point : frame.points) EXPECT_TRUE(isFinite(point)) << frame.text;
    for (const double weight : frame.weights) EXPECT_TRUE(std::isfinite(weight)) << frame.text;
    for (const auto& row : frame.matrix) {
        EXPECT_EQ(row.size(), frame.matrix.front().size());
        for (const double entry : row) EXPECT_TRUE(std::isfinite(entry));
    }
    if (frame.formula.empty()) return;
    EXPECT_EQ(unbalanced(frame.formula), "") << frame.formula;
    EXPECT_EQ(frame.formula.find("<math xmlns=\"http://www.w3.org/1998/Math/MathML\""), 0u);
    EXPECT_EQ(frame.formula.find("nan"), std::string::npos) << frame.formula;
}

inline void expectReadable(const Trace& trace) {
    for (const TraceFrame& frame : trace.frames) expectReadable(frame);
}

inline const char* const quadratic = R"({"type":"bspline-curve","degree":2,
    "points":[[0,0],[1,2],[3,3],[5,0],[6,2]],"knots":[0,0,0,1,3,4,4,4]})";

inline std::string onQuadratic(const std::string& algorithm, const std::string& rest) {
    return R"({"algorithm":")" + algorithm + R"(","curve":)" + quadratic + "," + rest + "}";
}

inline const char* const square = R"("points":[[0,0],[1,0],[1,1],[0,1]],"closed":true)";

inline std::string onSquare(const std::string& algorithm, const std::string& rest = "") {
    return R"({"algorithm":")" + algorithm + "\"," + square + rest + "}";
}

/// Calls act(curve, t) for random curves of all forms, at all knots, both ends and between.
template <class Act>
void eachParameter(unsigned seed, int curves, Act act) {
    RandomSplines random(seed);
    for (int i = 0; i < curves; ++i) {
        for (const Form form : test::allForms) {
            SplineKind kind{.maxDegree = 5, .dimension = 2 + i % 2, .rational = i % 3 == 0};
            const BsplineCurve curve = random.curve(form, kind);
            for (const double t : test::telltaleParameters(curve.knotVector(), random, 2)) {
                act(curve, t);
            }
        }
    }
}

}  // namespace knotwork::scene
