// Blending curves by specification: kinds of local curves, spacing, local(j) and other knots.
#include "scene/blending_specs.hpp"
#include "support/blends.hpp"
#include "support/json_text.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace knotwork::scene {
namespace {

using test::expectNear;
using test::json;
using test::rowsOf;

constexpr double rowGate = 1e-12;

Made<Curve> make(const Json& spec) {
    auto made = makeCurve(spec);
    EXPECT_TRUE(made.ok()) << dumpJson(spec) << (made.ok() ? "" : made.error().message);
    return made.ok() ? std::move(*made) : *makeCurve(json(R"({"type":"line-curve","from":[0,0],"to":[1,0]})"));
}

const BlendingCurve& blendOf(const Made<Curve>& made) { return *made.value.as<BlendingCurve>(); }

Json withKind(const char* kind) {
    Json spec = json(R"({"type": "blending-curve", "bFunction": {"family": "expo-rational"},
        "model": {"type": "parametric-curve", "name": "trefoil"}, "locals": {"count": 6},
        "poses": [{"local": 0, "translate": [1, 0, 0.5]},
                  {"local": 2, "rotate": {"axis": [1, 2, 3], "angle": 1}, "scale": [1, 2, 0.5]},
                  {"local": 5, "translate": [0, 1], "scale": 1.5}]})");
    spec["locals"]["kind"] = kind;
    return spec;
}

/// Blending curves of every sort, as someone would write them.
std::vector<std::pair<std::string, Json>> sorts() {
    std::vector<std::pair<std::string, Json>> all;
    for (const char* kind : {"sub-curve", "line", "arc", "bezier", "bspline"}) {
        all.emplace_back(kind, withKind(kind));
    }
    all.emplace_back("open, by length", withKind("arc"));
    all.back().second["form"] = "open";
    all.back().second["spacing"] = "length";
    all.emplace_back("breaks", withKind("bezier"));
    all.back().second["form"] = "open";
    all.back().second["knots"] = json("[0, 0, 1, 2, 2, 3]");
    Json given = json(R"({"type": "blending-curve", "bFunction": {"family": "linear"}, "locals": [
        {"type": "bspline-curve", "degree": 2, "form": "closed", "points": [[0,0],[2,1],[1,3]]},
        {"type": "bezier-curve", "points": [[0,0,1],[2,1,0],[1,3,0]], "weights": [1,2,1]},
        {"type": "line-curve", "from": [0,1], "to": [2,2], "domain": [0,2]},
        {"type": "parametric-curve", "name": "heart", "parameters": {"scale": 0.1}}],
        "poses": [{"local": 1, "rotate": {"angle": 1}}, {"local": 3, "translate": [1,2,3], "scale": 2}]})");
    all.emplace_back("given", given);
    given["form"] = "closed";
    all.emplace_back("given and closed", given);
    given["fit"] = "affine";
    all.emplace_back("fitted", given);
    Json nested = withKind("line");
    nested["model"] = withKind("bezier");
    nested["form"] = "open";
    all.emplace_back("nested", nested);
    return all;
}

void expectSame(const Curve& a, const Curve& b, const Interval& over, const std::string& name) {
    for (int i = 0; i <= 20; ++i) {
        const double t = uniformParameter(over, static_cast<std::size_t>(i), 21);
        const Side side = i == 20 ? Side::left : Side::right;
        const auto got = rowsOf<4>(a, t, side);
        const auto expected = rowsOf<4>(b, t, side);
        for (std::size_t k = 0; k < 4; ++k) {
            expectNear(got[k], expected[k], rowGate * (1 + glm::length(expected[k])) * std::pow(10.0, k),
                       name + " at " + std::to_string(t) + ", row " + std::to_string(k));
        }
    }
}

TEST(BlendingSpec, ReadsBackAsTheSameCurve) {
    for (const auto& [name, spec] : sorts()) {
        const auto made = make(spec);
        const auto again = make(made.spec);
        EXPECT_EQ(again.spec, made.spec) << name;
        expectSame(again.value, made.value, domain(made.value), name);
    }
}

TEST(BlendingSpec, ALocalCurveIsWhereItTakesPartAndIsMadeAgainByItsSpecification) {
    for (const auto& [name, spec] : sorts()) {
        const auto made = make(spec);
        const BlendingCurve& curve = blendOf(made);
        for (std::size_t j = 0; j < curve.locals().size(); ++j) {
            const auto local = localCurve(made.spec, curve, j);
            ASSERT_TRUE(local.ok()) << name << local.error().message;
            const Interval over = domain(local->value);
            EXPECT_EQ(over, curve.locals()[j].domain()) << name;
            EXPECT_FALSE(isClosed(local->value)) << name;
            const auto again = make(local->spec);
            EXPECT_EQ(again.spec, local->spec) << name;
            EXPECT_EQ(domain(again.value), over) << name;
            EXPECT_EQ(dimension(again.value), dimension(local->value)) << name;
            expectSame(again.value, local->value, over, name + " local " + std::to_string(j));
            // And it is what the curve has at its knot.
            const bool seen = curve.support(j).length() > 0;
            const Side side = blendingSide(curve.knots(), j);
            if (seen) {
                expectNear(rowsOf<1>(made.value, curve.knots()[j], side)[0],
                           rowsOf<1>(local->value, curve.knots()[j], side)[0], rowGate, name);
            }
        }
        EXPECT_EQ(localCurve(made.spec, curve, curve.locals().size()).error().path, "j");
    }
}

TEST(BlendingSpec, ALocalCurveThatIsNotPosedIsOfItsOwnKind) {
    const auto typeOf = [](const char* kind) {
        const auto made = make(withKind(kind));
        return stringOr(localCurve(made.spec, blendOf(made), 1)->spec, "type", "");
    };
    EXPECT_EQ(typeOf("line"), "line-curve");
    EXPECT_EQ(typeOf("arc"), "arc-curve");
    EXPECT_EQ(typeOf("bezier"), "bezier-curve");
    EXPECT_EQ(typeOf("bspline"), "bspline-curve");
    EXPECT_EQ(typeOf("sub-curve"), "blending-curve");
}

TEST(BlendingSpec, KnotsMoveWithOrWithoutCuttingAnew) {
    for (const auto& [name, spec] : sorts()) {
        const auto made = make(spec);
        const BlendingCurve& curve = blendOf(made);
        std::vector<double> knots = curve.knots();
        knots[1] += 0.1 * (knots[2] - knots[1] + knots[1] - knots[0]);
        if (knots[1] > knots[2]) knots[1] = knots[2];
        const auto kept = withKnots(made.spec, curve, knots, false);
        ASSERT_TRUE(kept.ok()) << name;
        const auto still = make(*kept);
        EXPECT_EQ(blendOf(still).knots(), knots) << name;
        for (std::size_t j = 0; j < curve.locals().size(); ++j) {
            for (const double share : {0.0, 0.3, 1.0}) {
                const Interval over = curve.locals()[j].domain();
                const double t = over.start + share * over.length();
                const Vec3 before = curve.locals()[j].point(t);
                expectNear(blendOf(still).locals()[j].point(t), before,
                           rowGate * (1 + glm::length(before)), name);
            }
        }
        const auto recut = withKnots(made.spec, curve, knots, true);
        ASSERT_TRUE(recut.ok()) << name;
        EXPECT_EQ((*recut)["poses"], made.spec["poses"]) << name;
        EXPECT_EQ((*recut)["locals"], made.spec["locals"]) << name;
        EXPECT_EQ(blendOf(make(*recut)).knots(), knots) << name;
    }
    // Cut anew, a line is the tangent at its new knot; kept, it is the one of the old knot.
    Json lines = withKind("line");
    lines.erase("poses");
    const auto made = make(lines);
    std::vector<double> knots = blendOf(made).knots();
    knots[2] += 0.3;
    const Curve model = make(lines["model"]).value;
    const auto at = [&](bool recut) {
        return rowsOf<2>(make(*withKnots(made.spec, blendOf(made), knots, recut)).value, knots[2]);
    };
    expectNear(at(true)[1], rowsOf<2>(model, knots[2])[1], rowGate, "recut");
    expectNear(at(false)[1], rowsOf<2>(model, blendOf(made).knots()[2])[1], rowGate, "kept");
}

TEST(BlendingSpec, OtherKnotsAreRefusedAsKnotsAre) {
    const auto made = make(withKind("line"));
    const BlendingCurve& curve = blendOf(made);
    for (const bool recut : {false, true}) {
        EXPECT_EQ(withKnots(made.spec, curve, {0, 1, 2}, recut).error().code, Code::knotsCount);
        const auto falling = withKnots(made.spec, curve, {0, 2, 1, 3, 4, 5, 6}, recut);
        EXPECT_EQ(falling.error().code, Code::knotsDecreasing);
        EXPECT_EQ(falling.error().path, "knots[2]");
        EXPECT_EQ(withKnots(made.spec, curve, {0, 1, 1, 1, 4, 5, 6}, recut).error().code,
                  Code::knotsMultiplicity);
    }
}

TEST(BlendingSpec, KnotsAtEqualLengthsDivideTheModelEvenly) {
    Json spec = json(R"({"type": "blending-curve", "bFunction": {"family": "linear"},
        "model": {"type": "parametric-curve", "name": "ellipse", "parameters": {"a": 5, "b": 1}},
        "locals": {"count": 8}, "spacing": "length"})");
    const auto made = make(spec);
    const Curve model = make(spec["model"]).value;
    const std::vector<double>& knots = blendOf(made).knots();
    ASSERT_EQ(knots.size(), 9U);
    std::vector<double> lengths;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        double length = 0;
        constexpr int steps = 20'000;
        Vec3 last = pointAt(model, knots[i - 1]);
        for (int s = 1; s <= steps; ++s) {
            const Vec3 next = pointAt(model, knots[i - 1] + (knots[i] - knots[i - 1]) * s / steps);
            length += glm::length(next - last);
            last = next;
        }
        lengths.push_back(length);
    }
    for (const double length : lengths) EXPECT_NEAR(length, lengths[0], 1e-7);
    EXPECT_GT(knots[1] - knots[0], 1.5 * (knots[2] - knots[1]));  // not evenly in the parameter
    EXPECT_EQ(made.spec["spacing"], "length");
    spec["form"] = "open";
    EXPECT_EQ(blendOf(make(spec)).knots().size(), 8U);
}

TEST(BlendingSpec, BadOnesAreRefusedWithTheirPlace) {
    struct Refusal {
        const char* fields;
        Code code;
        const char* path;
    };
    const std::array refusals{
        Refusal{R"({"locals": {"count": 4, "kind": "bezier", "degree": 26}})", Code::tooLarge,
                "locals.degree"},
        Refusal{R"({"locals": {"count": 4, "kind": "bezier", "degree": 0}})", Code::outOfRange,
                "locals.degree"},
        Refusal{R"({"locals": {"count": 4, "kind": "bezier", "degree": 2.5}})", Code::notInteger,
                "locals.degree"},
        Refusal{R"({"locals": {"count": 4, "kind": "bspline", "degree": 8}})", Code::outOfRange,
                "locals.degree"},
        Refusal{R"({"locals": {"count": 4, "kind": "line", "degree": 1}})", Code::notSupported,
                "locals.degree"},
        Refusal{R"({"locals": {"count": 4, "kind": "plane"}})", Code::unknownName, "locals.kind"},
        Refusal{R"({"spacing": "length", "knots": [0, 1, 2, 3, 4]})", Code::notSupported, "spacing"},
        Refusal{R"({"spacing": "chord"})", Code::unknownName, "spacing"},
        Refusal{R"({"spacing": true})", Code::wrongType, "spacing"},
        Refusal{R"({"model": {"type": "line-curve", "from": [1, 1], "to": [1, 1]}, "spacing": "length"})",
                Code::notSupported, "spacing"},
        Refusal{R"({"model": null})", Code::wrongType, "model"},
    };
    for (const Refusal& refusal : refusals) {
        Json spec = json(R"({"type": "blending-curve", "bFunction": {"family": "linear"},
            "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 4}})");
        spec.update(json(refusal.fields));
        const auto made = makeCurve(spec);
        ASSERT_FALSE(made.ok()) << refusal.fields;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << refusal.fields;
        EXPECT_EQ(made.error().path, refusal.path) << refusal.fields;
    }
    const auto given = makeCurve(json(R"({"type": "blending-curve", "bFunction": {"family": "linear"},
        "spacing": "length", "locals": [{"type": "line-curve", "from": [0, 0], "to": [1, 1]},
                                        {"type": "line-curve", "from": [0, 0], "to": [1, 1]}]})"));
    EXPECT_EQ(given.error().path, "spacing");
}

TEST(BlendingSpec, LocalsByDefaultAreOfDegreeThree) {
    const auto made = make(withKind("bezier"));
    EXPECT_EQ(numberOr(made.spec["locals"], "degree", 0), 3);
    EXPECT_EQ(blendOf(made).locals()[0].source().as<BezierCurve>()->degree(), 3U);
    EXPECT_EQ(member(make(withKind("line")).spec["locals"], "degree"), nullptr);
}

}  // namespace
}  // namespace knotwork::scene
