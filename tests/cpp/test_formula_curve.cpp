// Curves given by formulas: against the models of the same formulas, and what they refuse.
#include "geometry/curve.hpp"
#include "scene/specs.hpp"

#include "support/function_gates.hpp"
#include "support/json_text.hpp"
#include "support/model_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace knotwork {
namespace {

constexpr double pi = std::numbers::pi;

Result<FormulaCurve> planar(const char* x, const char* y, Interval domain = {0, 1}) {
    return FormulaCurve::make({.x = x, .y = y, .domain = domain});
}

struct Model {
    const char* name;
    const char* x;
    const char* y;
    const char* z;  // null for a planar one
};

/// The formulas of the interface, with the names of the models' own parameters.
constexpr Model models[] = {
    {"circle", "radius*cos(t)", "radius*sin(t)", nullptr},
    {"ellipse", "a*cos(t)", "b*sin(t)", nullptr},
    {"lissajous", "a*cos(kx*t)", "b*sin(ky*t)", nullptr},
    {"rose", "a*cos(k*t)*cos(t)", "a*cos(k*t)*sin(t)", nullptr},
    {"butterfly", "scale*sin(t)*(e^cos(t)-2*cos(4*t)-sin(t/12)^5)",
     "scale*cos(t)*(e^cos(t)-2*cos(4*t)-sin(t/12)^5)", nullptr},
    {"hypotrochoid", "(R-r)*cos(t)+d*cos((R-r)*t/r)", "(R-r)*sin(t)-d*sin((R-r)*t/r)", nullptr},
    {"epitrochoid", "(R+r)*cos(t)-d*cos((R+r)*t/r)", "(R+r)*sin(t)-d*sin((R+r)*t/r)", nullptr},
    {"astroid", "a*cos(t)^3", "a*sin(t)^3", nullptr},
    {"cardioid", "a*(2*cos(t)-cos(2*t))", "a*(2*sin(t)-sin(2*t))", nullptr},
    {"nephroid", "a*(3*cos(t)-cos(3*t))", "a*(3*sin(t)-sin(3*t))", nullptr},
    {"heart", "16*scale*sin(t)^3", "scale*(13*cos(t)-5*cos(2*t)-2*cos(3*t)-cos(4*t))", nullptr},
    {"lemniscate", "a*cos(t)/(1+sin(t)^2)", "a*sin(t)*cos(t)/(1+sin(t)^2)", nullptr},
    {"spiral", "(a+b*t)*cos(t)", "(a+b*t)*sin(t)", nullptr},
    {"helix", "radius*cos(t)", "radius*sin(t)", "pitch*t/(2*pi)"},
    {"viviani", "a*(1+cos(t))", "a*sin(t)", "2*a*sin(t/2)"},
    {"trefoil", "scale*(sin(t)+2*sin(2*t))", "scale*(cos(t)-2*cos(2*t))", "-scale*sin(3*t)"},
    {"torus-knot", "(R+r*cos(q*t))*cos(p*t)", "(R+r*cos(q*t))*sin(p*t)", "r*sin(q*t)"},
};

TEST(FormulaCurve, OfEveryModelIsTheModelWithItsDerivatives) {
    EXPECT_EQ(std::size(models), parametricCurveModels().size());
    for (const Model& model : models) {
        const ParametricCurve expected = test::make(model.name);
        FormulaCurveParts parts{.x = model.x, .y = model.y, .domain = expected.domain(),
                                .closed = expected.closed()};
        if (model.z != nullptr) parts.z = model.z;
        const auto described = expected.description().parameters;
        for (std::size_t i = 0; i < described.size(); ++i) {
            parts.parameters.emplace_back(described[i].name, expected.parameters()[i]);
        }
        const auto curve = FormulaCurve::make(parts);
        ASSERT_TRUE(curve.ok()) << model.name << ": " << curve.error().message;
        EXPECT_EQ(curve->closed(), expected.closed()) << model.name;
        EXPECT_EQ(curve->dimension(), expected.dimension()) << model.name;
        for (const double t : {-1.0, 0.0, 0.4, 2.5, 6.2, 8.0}) {
            std::vector<Vec3> rows(6);
            curve->evaluate(t, Side::right, rows);
            const auto wanted = test::rowsOf(expected, t, 6);
            for (std::size_t k = 0; k < rows.size(); ++k) {
                EXPECT_LE(glm::length(rows[k] - wanted[k]),
                          1e-12 * std::max(1.0, glm::length(wanted[k])))
                    << model.name << " at " << t << ", order " << k;
            }
        }
    }
}

TEST(FormulaCurve, IsPlanarWithoutZAndWithTheNumberZero) {
    const auto dimensionOf = [](const char* z) {
        return FormulaCurve::make({.x = "t", .y = "t^2", .z = z, .domain = {0, 1}})->dimension();
    };
    EXPECT_EQ(planar("t", "t^2")->dimension(), 2);
    EXPECT_EQ(dimensionOf("0"), 2);
    EXPECT_EQ(dimensionOf("sin(0)*2"), 2);
    EXPECT_EQ(dimensionOf("1"), 3);
    EXPECT_EQ(dimensionOf("t"), 3);
}

TEST(FormulaCurve, HasTheDerivativesOfTheSideAtAKinkAndHonestOnesAtARoot) {
    const auto kink = planar("t", "abs(t)", {-1, 1});
    std::vector<Vec3> rows(2);
    kink->evaluate(0, Side::right, rows);
    EXPECT_EQ(rows[1], Vec3(1, 1, 0));
    kink->evaluate(0, Side::left, rows);
    EXPECT_EQ(rows[1], Vec3(1, -1, 0));
    planar("t", "abs(t)")->evaluate(0, Side::left, rows);  // where nothing is on that side
    EXPECT_EQ(rows[1], Vec3(1, 1, 0));
    planar("t", "abs(t)", {-1, 0})->evaluate(0, Side::right, rows);
    EXPECT_EQ(rows[1], Vec3(1, -1, 0));
    planar("sqrt(t)", "t")->evaluate(0, Side::right, rows);
    EXPECT_EQ(rows[0], Vec3(0, 0, 0));
    EXPECT_EQ(rows[1].x, std::numeric_limits<double>::infinity());
}

TEST(FormulaCurve, IsSampledAndWrappedLikeAnyCurve) {
    const auto made = FormulaCurve::make(
        {.x = "cos(t)", .y = "sin(t)", .domain = {0, 2 * pi}, .closed = true});
    ASSERT_TRUE(made.ok());
    const Curve curve(*made);
    EXPECT_NEAR(parameterInDomain(curve, 7).value(), 7 - 2 * pi, 1e-15);
    std::vector<double> xyz(15);
    CurveSampler(curve).uniform(0, 5, 5, xyz);
    const double expected[] = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, 0};
    for (std::size_t i = 0; i < 15; ++i) EXPECT_NEAR(xyz[i], expected[i], 1e-15) << i;
}

struct Refusal {
    const char* spec;
    Code code;
    const char* path;
    const char* says;
};

TEST(FormulaCurve, RefusalsNameTheFieldAndWhatIsWrong) {
    const Refusal refusals[] = {
        {R"j({"type":"formula-curve","x":"2*","y":"t","domain":[0,1]})j", Code::syntax, "x",
         "column 3"},
        {R"j({"type":"formula-curve","x":"t","y":"a*t","domain":[0,1]})j", Code::unknownName, "y",
         "column 1"},
        {R"j({"type":"formula-curve","x":"t","y":"t","z":"sin","domain":[0,1]})j", Code::syntax, "z",
         "column 4"},
        {R"j({"type":"formula-curve","x":"1/t","y":"t","domain":[0,1]})j", Code::notFinite, "x",
         "t = 0;"},
        {R"j({"type":"formula-curve","x":"t","y":"1/(t-0.3)","domain":[0,1]})j", Code::notFinite, "y",
         "t = 0.3"},
        {R"j({"type":"formula-curve","x":"t","y":"1/(3*t-1)^2","domain":[0,1]})j", Code::notFinite,
         "y", "t = 0.333"},
        {R"j({"type":"formula-curve","x":"t","y":"tan(t)","domain":[0,3]})j", Code::notFinite, "y",
         "t = 1.57"},
        {R"j({"type":"formula-curve","x":"t","y":"log(t)","domain":[-1,1]})j", Code::notFinite, "y",
         "t = -1"},
        {R"j({"type":"formula-curve","x":"t","y":"1e13*t","domain":[0,1]})j", Code::outOfRange, "y",
         "1e12"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[0,1],"closed":true})j",
         Code::outOfRange, "closed", "1.414"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[1,0]})j", Code::outOfRange, "domain",
         "ascending"},
        {R"j({"type":"formula-curve","x":"t","y":"t"})j", Code::wrongType, "domain", "missing"},
        {R"j({"type":"formula-curve","x":1,"y":"t","domain":[0,1]})j", Code::wrongType, "x", "text"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[0,1],"parameters":{"t":1}})j",
         Code::outOfRange, "parameters.t", "another name"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[0,1],"parameters":{"a":"1"}})j",
         Code::wrongType, "parameters.a", "number"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[0,1],"parameters":[1]})j",
         Code::wrongType, "parameters", "object"},
        {R"j({"type":"formula-curve","x":"t","y":"t","domain":[0,1],"closed":1})j", Code::wrongType,
         "closed", "true or false"},
    };
    for (const Refusal& refusal : refusals) {
        const auto made = scene::makeCurve(test::json(refusal.spec));
        ASSERT_FALSE(made.ok()) << refusal.spec;
        const Error& error = made.error();
        EXPECT_EQ(codeName(error.code), codeName(refusal.code)) << refusal.spec << error.message;
        EXPECT_EQ(error.path, refusal.path) << refusal.spec;
        EXPECT_NE(error.message.find(refusal.says), std::string::npos)
            << refusal.spec << ": " << error.message;
    }
}

TEST(FormulaCurve, SpecificationsAreCompletedAndMakeTheCurveAgain) {
    const auto made = scene::makeCurve(test::json(
        R"j({"x":"a*t","type":"formula-curve","domain":[-1,1],"y":"t^2","parameters":{"a":2}})j"));
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(scene::dumpJson(made->spec),
              R"j({"type":"formula-curve","x":"a*t","y":"t^2","parameters":{"a":2.0},)j"
              R"j("domain":[-1.0,1.0],"closed":false})j");
    const auto blend = scene::makeCurve(test::json(
        R"j({"type":"blending-curve","bFunction":{"family":"formula","expression":"t^2*(3-2*t)"},
            "model":{"type":"formula-curve","x":"cos(t)","y":"sin(t)","closed":true,
                     "domain":[0,6.283185307179586]},"locals":{"count":4}})j"));
    ASSERT_TRUE(blend.ok()) << blend.error().path << blend.error().message;
    EXPECT_TRUE(isClosed(blend->value));
    EXPECT_NEAR(pointAt(blend->value, 1).x, std::cos(1.0), 1e-15);
    const auto wrong = scene::makeCurve(test::json(
        R"j({"type":"blending-curve","bFunction":{"family":"formula","expression":"sin(pi*t)^2"},
            "model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4}})j"));
    ASSERT_FALSE(wrong.ok());
    EXPECT_EQ(wrong.error().path, "bFunction.expression");
}

}  // namespace
}  // namespace knotwork
