// What B-functions refuse, and what their description table promises.
#include "geometry/b_function.hpp"

#include "support/function_specimens.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knotwork {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expectRefusal(const Result<BFunction>& result, Code code, const std::string& path) {
    ASSERT_FALSE(result.ok()) << path;
    EXPECT_EQ(codeName(result.error().code), codeName(code)) << path;
    EXPECT_EQ(result.error().path, path);
    EXPECT_FALSE(result.error().message.empty()) << path;
}

TEST(BFunctionRefusals, ParametersOutOfRangeAreNamed) {
    const Code outside = Code::outOfRange;
    expectRefusal(BFunction::makeExpoRational(0), outside, "alpha");
    expectRefusal(BFunction::makeExpoRational(4.001), outside, "alpha");
    expectRefusal(BFunction::makeExpoRational(1, -1), outside, "beta");
    expectRefusal(BFunction::makeExpoRational(1, 101), outside, "beta");
    expectRefusal(BFunction::makeExpoRational(1, 1, 0), outside, "gamma");
    expectRefusal(BFunction::makeExpoRational(1, 1, 1, 0), outside, "lambda");
    expectRefusal(BFunction::makeExpoRational(1, 1, 1, 1), outside, "lambda");
    expectRefusal(BFunction::makeTrigonometric(0), outside, "order");
    expectRefusal(BFunction::makeTrigonometric(21), outside, "order");
    expectRefusal(BFunction::makePolynomial(-1, 1), outside, "p");
    expectRefusal(BFunction::makePolynomial(1, 21), outside, "q");
    expectRefusal(BFunction::makeRational(0.99), outside, "m");
    expectRefusal(BFunction::makeRational(2, 0), outside, "c");
    expectRefusal(BFunction::makeLogistic(1000.5), outside, "c");
    expectRefusal(BFunction::makeMixed(BFunction(), BFunction(), 1.01), outside, "weight");
}

TEST(BFunctionRefusals, WhatIsNoFiniteNumberOrNoIntegerIsNamed) {
    expectRefusal(BFunction::makeExpoRational(std::nan("")), Code::notFinite, "alpha");
    expectRefusal(BFunction::makeExpoRational(1, infinity), Code::notFinite, "beta");
    expectRefusal(BFunction::makeTrigonometric(1.5), Code::notInteger, "order");
    expectRefusal(BFunction::makePolynomial(1, 0.5), Code::notInteger, "q");
    expectRefusal(BFunction::makeMixed(BFunction(), BFunction(), std::nan("")), Code::notFinite,
                  "weight");
}

TEST(BFunctionRefusals, TheEndsOfTheRangesAreAllowed) {
    EXPECT_TRUE(BFunction::makeExpoRational(4, 100, 4, 0.5).ok());
    EXPECT_TRUE(BFunction::makeTrigonometric(20).ok());
    EXPECT_TRUE(BFunction::makePolynomial(0, 20).ok());
    EXPECT_TRUE(BFunction::makeRational(50, 1000).ok());
    EXPECT_TRUE(BFunction::makeLogistic(1000).ok());
    EXPECT_TRUE(BFunction::makeMixed(BFunction(), BFunction(), 0).ok());
}

TEST(BFunctionRefusals, ATableThatIsNoBFunctionNamesItsFirstWrongValue) {
    const auto table = [](std::vector<double> values) { return BFunction::makeTabulated(values); };
    expectRefusal(table({0.1, 0.5, 1}), Code::outOfRange, "values[0]");
    expectRefusal(table({0, 0.5, 0.4, 1}), Code::outOfRange, "values[2]");
    expectRefusal(table({0, 0.5, 0.9}), Code::outOfRange, "values[2]");
    expectRefusal(table({0, 1.5, 1}), Code::outOfRange, "values[2]");
    expectRefusal(table({0, std::nan(""), 1}), Code::notFinite, "values[1]");
    expectRefusal(table({0}), Code::wrongLength, "values");
    expectRefusal(table({}), Code::wrongLength, "values");
    std::vector<double> many(100'001, 0.5);
    many.front() = 0;
    many.back() = 1;
    expectRefusal(table(many), Code::tooLarge, "values");
    many.resize(100'000);
    many.back() = 1;
    EXPECT_TRUE(table(many).ok());
}

TEST(BFunctionRefusals, UnknownNamesAreRefusedWhereTheyStand) {
    const std::vector<NamedValue> none;
    expectRefusal(BFunction::make("cubic", none), Code::unknownName, "family");
    expectRefusal(BFunction::make("dual", none), Code::unknownName, "family");
    const std::vector<NamedValue> misspelt{{"alhpa", 1.0}};
    expectRefusal(BFunction::make("expo-rational", misspelt), Code::unknownField, "alhpa");
    expectRefusal(BFunction::make("linear", misspelt), Code::unknownField, "alhpa");
    const std::vector<NamedValue> outside{{"beta", 2.0}, {"lambda", 1.0}};
    expectRefusal(BFunction::make("expo-rational", outside), Code::outOfRange, "lambda");
}

TEST(BFunctionRefusals, NestingThatWouldCostTooMuchIsRefused) {
    BFunction doubled;
    int levels = 0;
    for (;; ++levels) {
        const auto next = BFunction::makeSymmetrised(doubled);
        if (!next.ok()) {
            expectRefusal(next, Code::tooLarge, "");
            break;
        }
        doubled = next.value();
        ASSERT_LT(levels, 40);
    }
    EXPECT_EQ(levels, 10);  // 1024 evaluations

    BFunction deep;
    for (int i = 1; i < 32; ++i) deep = BFunction::makeDual(deep).value();
    EXPECT_DOUBLE_EQ(deep.value(0.3), 0.3);
    expectRefusal(BFunction::makeDual(deep), Code::tooLarge, "");
}

TEST(BFunctionDescriptions, EveryFamilyIsListedInTheOrderOfItsEnumerator) {
    std::size_t i = 0;
    for (const BFamilyDescription& family : bFunctionFamilies()) {
        EXPECT_EQ(static_cast<std::size_t>(family.family), i++) << family.name;
        EXPECT_EQ(findBFamily(family.name), &family);
        EXPECT_FALSE(family.label.empty()) << family.name;
    }
    EXPECT_EQ(i, static_cast<std::size_t>(BFamily::mixed) + 1);
}

TEST(BFunctionDescriptions, AFamilyMadeByNameHasTheDefaultsOfItsDescription) {
    for (const BFamilyDescription& family : bFunctionFamilies()) {
        if (family.tabulated || family.expression || !family.operands.empty()) continue;
        const auto made = BFunction::make(family.name, {});
        ASSERT_TRUE(made.ok()) << family.name;
        EXPECT_EQ(made.value().family(), family.family);
        ASSERT_EQ(made.value().parameters().size(), family.parameters.size());
        for (std::size_t i = 0; i < family.parameters.size(); ++i) {
            const ParameterDescription& parameter = family.parameters[i];
            EXPECT_EQ(made.value().parameters()[i], parameter.defaultValue) << parameter.name;
            EXPECT_LE(parameter.min, parameter.low) << parameter.name;
            EXPECT_LT(parameter.low, parameter.high) << parameter.name;
            EXPECT_LE(parameter.high, parameter.max) << parameter.name;
            EXPECT_FALSE(parameter.help.empty()) << parameter.name;
        }
    }
    EXPECT_EQ(BFunction::make("rational", {}).value(), BFunction::makeRational().value());
    EXPECT_EQ(BFunction::make("expo-rational", {}).value(), BFunction::makeExpoRational().value());
    EXPECT_EQ(BFunction::make("polynomial", {}).value(), BFunction::makePolynomial().value());
}

}  // namespace
}  // namespace knotwork
