// The formula language: what formulas mean, their derivatives, and what is said about wrong ones.
#include "geometry/formula.hpp"
#include "geometry/formula_program.hpp"

#include "support/calculus.hpp"
#include "support/function_gates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace knotwork {
namespace {

namespace gates = test::gates;

constexpr double pi = std::numbers::pi;

Formula read(std::string_view text, const std::vector<NamedValue>& parameters = {}) {
    auto made = Formula::make(text, "x", parameters);
    EXPECT_TRUE(made.ok()) << text << ": " << (made.ok() ? "" : made.error().message);
    return made.ok() ? *std::move(made) : Formula::make("0", "x").value();
}

// --- what formulas mean --------------------------------------------------------------------------

struct Meaning {
    const char* text;
    double expected;  // at t = 3
};

TEST(Formula, BindsAsItIsTaughtInSchool) {
    const Meaning meanings[] = {
        {"-t^2", -9},         {"(-t)^2", 9},        {"2^-1", 0.5},      {"2^3^2", 512},
        {"(2^3)^2", 64},      {"-2^2", -4},         {"2^-t^2", 0x1p-9}, {"2*-t", -6},
        {"2^-1*8", 4},        {"10-4-3", 3},        {"10-(4-3)", 9},    {"16/4/2", 2},
        {"16/(4/2)", 8},      {"2+3*4", 14},        {"(2+3)*4", 20},    {"2*t^2", 18},
        {"(2*t)^2", 36},      {"1-2+3", 2},         {"8/4*2", 4},       {"--t", 3},
        {"-+-+t", 3},         {"2--t", 5},          {"t- -t", 6},       {"-t*-t", 9},
        {"+t", 3},            {"-t^-1", -1.0 / 3},  {"2^t", 8},         {"t^t", 27},
        {"-t^t^1", -27},      {"t^0", 1},           {"(t-3)^0", 1},     {"0^0", 1},
        {"(t-3)^(t-3)", 1},   {"1e-3", 0.001},      {".5", 0.5},        {"5.", 5},
        {"1.5E+2", 150},      {"2*e", 2 * std::numbers::e}, {"e^0", 1}, {"pi", pi},
        {"sqrt(t+1)", 2},     {"abs(-t)", 3},       {"abs(2-t)", 1},    {"sin(pi/2)^2", 1},
        {"-sin(pi/2)^2", -1}, {" 1 +\t2\n* t\r", 7}, {"((((t))))", 3},  {"t^-2", 1.0 / 9},
        {"7-t", 4},           {"t-7", -4},          {"12/t", 4},        {"t/12", 0.25},
        {"(1+1)^(1+t)", 16},  {"t^0.5^2", std::pow(3, 0.25)},           {"(-8)^(t/3)", -8},
    };
    for (const Meaning& meaning : meanings) {
        EXPECT_DOUBLE_EQ(read(meaning.text).value(3), meaning.expected) << meaning.text;
        EXPECT_DOUBLE_EQ(read(meaning.text).jet(Jet::variable(3, 4)).value(), meaning.expected)
            << meaning.text;
    }
}

TEST(Formula, EveryFunctionIsTheOneOfItsName) {
    const double t = 0.3;
    const Meaning meanings[] = {
        {"sin(t)", std::sin(t)},   {"cos(t)", std::cos(t)},   {"tan(t)", std::tan(t)},
        {"asin(t)", std::asin(t)}, {"acos(t)", std::acos(t)}, {"atan(t)", std::atan(t)},
        {"sinh(t)", std::sinh(t)}, {"cosh(t)", std::cosh(t)}, {"tanh(t)", std::tanh(t)},
        {"exp(t)", std::exp(t)},   {"log(t)", std::log(t)},   {"sqrt(t)", std::sqrt(t)},
        {"abs(-t)", t},            {"e^t", std::exp(t)},      {"2.5^t", std::pow(2.5, t)},
        {"t^1.7", std::pow(t, 1.7)},
    };
    for (const Meaning& meaning : meanings) {
        EXPECT_EQ(read(meaning.text).value(t), meaning.expected) << meaning.text;
    }
}

TEST(Formula, ParametersStandForTheirValues) {
    const Formula formula = read("a*cos(t)+b_2^a", {{"a", 2}, {"b_2", -3}});
    EXPECT_DOUBLE_EQ(formula.value(0.4), 2 * std::cos(0.4) + 9);
    EXPECT_EQ(formula.text(), "a*cos(t)+b_2^a");
    EXPECT_EQ(read("a-b", {{"a", 2}, {"b", 2}}).constant(), 0);
}

TEST(Formula, WhatDoesNotDependOnTIsComputedAtOnce) {
    EXPECT_EQ(read("2*(3+sin(pi/2))^2-1").constant(), 31);
    EXPECT_EQ(read("-(1+1)^-2").constant(), -0.25);
    EXPECT_FALSE(read("0*t").constant());
    EXPECT_EQ(read("t^(1+1)+2*3").program().size(), 3U);
    EXPECT_EQ(read("(1+2)*t").program().size(), 2U);
    EXPECT_EQ(read("2^(t*3)").program().size(), 3U);
}

// --- derivatives ---------------------------------------------------------------------------------

TEST(Formula, DerivativesOfEveryOperationAgreeWithTheComplexStepAndWithCauchysIntegral) {
    const char* texts[] = {
        "t+t*t", "2-t", "t-2", "3*t", "t/3", "3/t", "t/(1+t^2)", "t^5", "t^-3", "t^2.5", "2.5^t",
        "e^(-t)", "t^(1+t)", "-t^2", "sin(2*t)", "cos(t)", "tan(t)", "asin(t/2)", "acos(t/2)",
        "atan(2*t)", "sinh(t)", "cosh(t)", "tanh(2*t)", "exp(-t^2)", "log(1+t)", "sqrt(1+t)",
        "abs(t-2)*t", "exp(sin(t))-2*cos(4*t)+sin(t/12)^5", "(t+1)^1025/2^1025"};
    constexpr int top = 10;
    for (const char* text : texts) {
        const Formula formula = read(text);
        const auto function = [&](const test::Complex& z) {
            return formula::run<Formula::deepest>(formula.program(), z);
        };
        for (const double t : {0.45, 0.6}) {
            const Jet jet = formula.jet(Jet::variable(t, top));
            EXPECT_NEAR(jet.value(), formula.value(t), 1e-15 * (1 + std::abs(jet.value()))) << text;
            EXPECT_EQ(jet.order(), top);
            const double slope = test::complexStepDerivative(function, t);
            EXPECT_NEAR(jet.derivative(1), slope,
                        gates::complexStepSlope * std::max(1.0, std::abs(slope))) << text;
            if (std::string_view(text).find("1025") != std::string_view::npos) continue;
            constexpr double radius = 0.35;
            for (int k = 2; k <= top; ++k) {
                const double expected = test::cauchyDerivative(function, t, k, radius);
                // A rounding of the values on the circle comes out multiplied by k!/radius^k.
                const double noise = 1e-13 * std::tgamma(k + 1.0) / std::pow(radius, k);
                EXPECT_NEAR(jet.derivative(k), expected,
                            gates::cauchy * std::abs(expected) + noise) << text << ", order " << k;
            }
        }
    }
}

TEST(Formula, PolynomialsOfIntegersAreExact) {
    const Jet jet = read("t^2*(1-2*t)^3").jet(Jet::variable(2, 6));
    const double expected[] = {-108, -324, -774, -1380, -1632, -960, 0};
    for (int k = 0; k <= 6; ++k) EXPECT_EQ(jet.derivative(k), expected[k]) << "order " << k;
    const Jet power = read("t^5").jet(Jet::variable(0, 8));
    for (int k = 0; k <= 8; ++k) EXPECT_EQ(power.derivative(k), k == 5 ? 120 : 0) << "order " << k;
}

TEST(Formula, AtAKinkTheSideDecides) {
    const Formula kink = read("2*abs(t-1)+sqrt((t-1)^2)");
    EXPECT_EQ(kink.jet(Jet::variable(1, 3), Side::right)[1], 3);
    EXPECT_EQ(kink.jet(Jet::variable(1, 3), Side::left)[1], -3);
}

// --- wrong formulas ------------------------------------------------------------------------------

struct Wrong {
    const char* text;
    Code code;
    const char* place;
    const char* says;
};

TEST(FormulaErrors, NameTheFieldTheColumnWhatWasFoundAndWhatWasExpected) {
    const Wrong wrong[] = {
        {"", Code::syntax, "column 1", "the end of the formula"},
        {"   ", Code::syntax, "column 4", "a number, a name"},
        {"2*", Code::syntax, "column 3", "the end of the formula"},
        {"*2", Code::syntax, "column 1", "\"*\""},
        {"2**3", Code::syntax, "column 3", "write ^"},
        {"2 3", Code::syntax, "column 3", "the number 3"},
        {"2t", Code::syntax, "column 2", "write * for a product"},
        {"t(2)", Code::syntax, "column 2", "\"(\""},
        {"(t)(t)", Code::syntax, "column 4", "write * for a product"},
        {"(t+1", Code::syntax, "column 5", "\")\" for the \"(\" of column 1"},
        {"sin(cos(t)", Code::syntax, "column 11", "column 4"},
        {"t+1)", Code::syntax, "column 4", "\")\""},
        {"()", Code::syntax, "column 2", "\")\""},
        {"sin()", Code::syntax, "column 5", "\")\""},
        {"sin t", Code::syntax, "column 5", "\"(\" after sin"},
        {"sin", Code::syntax, "column 4", "\"(\" after sin"},
        {"sin+1", Code::syntax, "column 4", "\"(\" after sin"},
        {"sin(t, 2)", Code::syntax, "column 6", "one number"},
        {"1,5", Code::syntax, "column 2", "decimals have a point"},
        {"1.2.3", Code::syntax, "column 4", "the number .3"},
        {"1e", Code::syntax, "column 2", "\"e\""},
        {".", Code::syntax, "column 1", "\".\""},
        {"t ^ ^ 2", Code::syntax, "column 5", "\"^\""},
        {"t +* 2", Code::syntax, "column 4", "\"*\""},
        {"t = 2", Code::syntax, "column 3", "\"=\""},
        {"t²", Code::syntax, "column 2", "write ^2"},
        {"π·t", Code::syntax, "column 1", "write pi"},
        {"2·t", Code::syntax, "column 2", "write *"},
        {"2 − t", Code::syntax, "column 3", "write -"},
        {"[t]", Code::syntax, "column 1", "write ("},
        {"|t|", Code::syntax, "column 1", "abs"},
        {"ééé", Code::syntax, "column 1", "\"é\""},
        {"(t)é", Code::syntax, "column 4", "\"é\""},
        {"\x07", Code::syntax, "column 1", "U+0007"},
        {"t\xc2\xa0+1", Code::syntax, "column 2", "U+00A0"},
        {"t+\xff", Code::syntax, "column 3", "no text"},
        {"t;alert(1)", Code::syntax, "column 2", "\";\""},
        {"x", Code::unknownName, "column 1", "t, pi, e"},
        {"t+a*2", Code::unknownName, "column 3", "\"a\""},
        {"ln(t)", Code::unknownName, "column 1", "Did you mean log?"},
        {"Sin(t)", Code::unknownName, "column 1", "Did you mean sin?"},
        {"T", Code::unknownName, "column 1", "Did you mean t?"},
        {"eval(t)", Code::unknownName, "column 1", "sin cos tan"},
        {"1+1e999", Code::notFinite, "column 3", "1e999"},
    };
    for (const Wrong& one : wrong) {
        const auto made = Formula::make(one.text, "model.x");
        ASSERT_FALSE(made.ok()) << one.text;
        const std::string& message = made.error().message;
        EXPECT_EQ(codeName(made.error().code), codeName(one.code)) << one.text;
        EXPECT_EQ(made.error().path, "model.x") << one.text;
        // `column 1` must not be found in `column 11`.
        const auto place = message.find(one.place);
        ASSERT_NE(place, std::string::npos) << one.text << ": " << message;
        const char after = message[place + std::string_view(one.place).size()];
        EXPECT_FALSE('0' <= after && after <= '9') << one.text << ": " << message;
        EXPECT_NE(message.find(one.says), std::string::npos) << one.text << ": " << message;
    }
}

TEST(FormulaErrors, ColumnsCountCharactersAndNotBytes) {
    EXPECT_NE(Formula::make("t+\u00e9", "x").error().message.find("column 3"), std::string::npos);
    const auto second = Formula::make("2*(t) \U0001D70B", "x");
    EXPECT_NE(second.error().message.find("column 7"), std::string::npos);
    EXPECT_NE(second.error().message.find("\U0001D70B"), std::string::npos);
}

std::string repeated(std::string_view part, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += part;
    return text;
}

TEST(FormulaErrors, HostileFormulasAreReadOrRefusedAndNothingElse) {
    const auto codeOf = [](const std::string& text) {
        const auto made = Formula::make(text, "x");
        return made.ok() ? std::string("ok") : std::string(codeName(made.error().code));
    };
    EXPECT_EQ(codeOf(std::string(100'000, '(') + "t" + std::string(100'000, ')')), "TOO_LARGE");
    EXPECT_EQ(codeOf(std::string(4999, '(') + "t" + std::string(4999, ')')), "ok");
    EXPECT_EQ(codeOf(std::string(9999, '(')), "SYNTAX");
    EXPECT_EQ(codeOf(std::string(10'000, ')')), "SYNTAX");
    EXPECT_EQ(codeOf(std::string(9'999, '-') + "t"), "ok");
    EXPECT_EQ(codeOf("t" + repeated("^t", 4'999)), "TOO_LARGE");
    EXPECT_EQ(codeOf("t" + repeated("^t", 63)), "ok");
    EXPECT_EQ(codeOf("t" + repeated("^t", 64)), "TOO_LARGE");
    EXPECT_EQ(codeOf("2" + repeated("^2", 4'999)), "ok");  // infinite, but a formula
    EXPECT_EQ(codeOf("t" + repeated("+t", 4'999)), "ok");
    EXPECT_EQ(codeOf(repeated("1+(", 2'500) + "t" + std::string(2'499, ')')), "SYNTAX");
    EXPECT_EQ(codeOf(repeated("1+(", 2'000) + "t" + std::string(2'000, ')')), "ok");
    EXPECT_EQ(codeOf(repeated("t+(", 2'000) + "t" + std::string(2'000, ')')), "TOO_LARGE");
    EXPECT_EQ(codeOf(repeated("sin(", 1'999) + "t" + std::string(1'999, ')')), "ok");
    EXPECT_EQ(codeOf(std::string(10'000, '9')), "NOT_FINITE");
    EXPECT_EQ(codeOf("0." + std::string(9'990, '0') + "1"), "ok");
    EXPECT_EQ(codeOf(std::string(10'000, 'a')), "UNKNOWN_NAME");
    EXPECT_EQ(codeOf("1e99999999999999999999"), "NOT_FINITE");
    EXPECT_EQ(codeOf("1e-99999999999999999999"), "ok");
    EXPECT_EQ(codeOf(std::string("t\0+1", 4)), "SYNTAX");
    EXPECT_EQ(codeOf(std::string(1, '\0')), "SYNTAX");
    EXPECT_LT(Formula::make(std::string(10'000, 'a'), "x").error().message.size(), 300U);
    for (int byte = 0; byte < 256; ++byte) {
        (void)codeOf(std::string(1, static_cast<char>(byte)));
        (void)codeOf("t+" + std::string(3, static_cast<char>(byte)));
    }
}

TEST(Formula, IsTotalWhereItHasNoValue) {
    for (const char* text : {"1/t", "log(t-1)", "sqrt(t-1)", "t^(1/t)", "0^(t-1)", "asin(2+t)",
                             "(t-1)^t", "exp(1/t^2)*t", "tan(1/t)", "t^1e300", "t^-1e300",
                             "(t*0)^(1/t)", "abs(log(t))", "t^(0/t)"}) {
        const Formula formula = read(text);
        for (const double t : {0.0, -0.0, 1.0, -1.0, 1e300, -1e300}) {
            (void)formula.value(t);
            (void)formula.jet(Jet::variable(t, 5), Side::left);
            (void)formula.jet(Jet::variable(t, 25), Side::right);
        }
    }
    EXPECT_TRUE(std::isinf(read("1/t").value(0)));
    EXPECT_TRUE(std::isnan(read("(-1)^t").value(0.5)));
}

TEST(FormulaErrors, AnUnknownNameIsAnsweredWithTheFirstTwentyParameters) {
    std::vector<NamedValue> parameters;
    const auto listed = [&] { return Formula::make("c*t", "x", parameters).error().message; };
    parameters.assign({{"a", 1}, {"b_2", 2}});
    EXPECT_NE(listed().find("t, pi, e, a, b_2 and the functions"), std::string::npos) << listed();
    parameters.clear();
    for (int i = 0; i < 21; ++i) parameters.emplace_back("p" + std::to_string(i), i);
    EXPECT_NE(listed().find("p18, p19, … and the functions"), std::string::npos) << listed();
}

TEST(FormulaErrors, ParametersHaveNamesThatFormulasCanUse) {
    const auto codeOf = [](const std::vector<NamedValue>& parameters) {
        const auto error = checkFormulaParameters(parameters, "parameters");
        return error ? std::string(codeName(error->code)) + " " + error->path : std::string("ok");
    };
    EXPECT_EQ(codeOf({{"a", 1}, {"_b2", -1e300}, {"T", 0}, {"sine", 2}}), "ok");
    EXPECT_EQ(codeOf({{"a", 1}, {"t", 1}}), "OUT_OF_RANGE parameters.t");
    EXPECT_EQ(codeOf({{"pi", 1}}), "OUT_OF_RANGE parameters.pi");
    EXPECT_EQ(codeOf({{"e", 1}}), "OUT_OF_RANGE parameters.e");
    EXPECT_EQ(codeOf({{"sqrt", 1}}), "OUT_OF_RANGE parameters.sqrt");
    EXPECT_EQ(codeOf({{"2a", 1}}), "SYNTAX parameters.2a");
    EXPECT_EQ(codeOf({{"a b", 1}}), "SYNTAX parameters.a b");
    EXPECT_EQ(codeOf({{" a", 1}}), "SYNTAX parameters. a");
    EXPECT_EQ(codeOf({{"", 1}}), "SYNTAX parameters");
    EXPECT_EQ(codeOf({{"a", std::nan("")}}), "NOT_FINITE parameters.a");
    EXPECT_EQ(codeOf(std::vector<NamedValue>(1001, {"a", 1})), "TOO_LARGE parameters");
}

}  // namespace
}  // namespace knotwork
