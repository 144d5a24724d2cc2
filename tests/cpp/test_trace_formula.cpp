// Formulae and numbers of traces.
#include "scene/trace_formula.hpp"

#include <gtest/gtest.h>

#include <string>

namespace knotwork::scene {
namespace {

/// The inside of the one row that a formula is.
std::string inside(const char* notation) {
    const std::string text = mathml(notation);
    const std::string open =
        "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow>";
    const std::string close = "</mrow></math>";
    EXPECT_EQ(text.substr(0, open.size()), open);
    EXPECT_EQ(text.substr(text.size() - close.size()), close);
    return text.substr(open.size(), text.size() - open.size() - close.size());
}

TEST(TraceFormula, LettersNumbersAndOperatorsAreTheirElements) {
    EXPECT_EQ(inside("2.5a=-1"),
              "<mn>2.5</mn><mi>a</mi><mo>=</mo><mo>\u2212</mo><mn>1</mn>");
}

TEST(TraceFormula, ScriptsAndFractionsNest) {
    EXPECT_EQ(inside("c_{2}^{(1)}"),
              "<msubsup><mi>c</mi><mrow><mn>2</mn></mrow><mrow><mo>(</mo><mn>1</mn><mo>)</mo></mrow>"
              "</msubsup>");
    EXPECT_EQ(inside("x_{i}y^{2}"),
              "<msub><mi>x</mi><mrow><mi>i</mi></mrow></msub><msup><mi>y</mi><mrow><mn>2</mn></mrow>"
              "</msup>");
    EXPECT_EQ(inside("\\frac{1}{\\frac{a}{b}}"),
              "<mfrac><mrow><mn>1</mn></mrow><mrow><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi>"
              "</mrow></mfrac></mrow></mfrac>");
}

TEST(TraceFormula, TablesHaveRowsAndCells) {
    EXPECT_EQ(inside("\\matrix{1&2\\\\3&4}"),
              "<mrow><mo>(</mo><mtable><mtr><mtd><mn>1</mn></mtd><mtd><mn>2</mn></mtd></mtr><mtr><mtd>"
              "<mn>3</mn></mtd><mtd><mn>4</mn></mtd></mtr></mtable><mo>)</mo></mrow>");
}

TEST(TraceFormula, WhateverIsWrittenComesOutEscapedAndClosed) {
    EXPECT_EQ(inside("a<b>c"), "<mi>a</mi><mo>&lt;</mo><mi>b</mi><mo>&gt;</mo><mi>c</mi>");
    EXPECT_EQ(inside("a}b&c"), "<mi>a</mi><mi>b</mi><mi>c</mi>");
    EXPECT_EQ(inside("\\frac{a"), "<mfrac><mrow><mi>a</mi></mrow><mrow></mrow></mfrac>");
    EXPECT_EQ(inside("\\table{a_"),
              "<mtable><mtr><mtd><msub><mi>a</mi><mrow></mrow></msub></mtd></mtr></mtable>");
}

TEST(TraceFormula, ALongTableLosesItsMiddle) {
    NotedRows rows;
    for (int i = 0; i < 30; ++i) rows.add("a_{" + std::to_string(i) + '}');
    EXPECT_EQ(rows.table(), "\\table{a_{0}\\\\a_{1}\\\\a_{2}\\\\a_{3}\\\\a_{4}\\\\a_{5}\\\\a_{6}\\\\"
                            "a_{7}\\\\a_{8}\\\\\\vdots\\\\a_{28}\\\\a_{29}}");
    NotedRows few;
    for (int i = 0; i < 12; ++i) few.add("b");
    EXPECT_EQ(few.table().find("vdots"), std::string::npos);
}

TEST(TraceNumbers, HaveFourDigitsOrAsManyAsAreNeeded) {
    EXPECT_EQ(readable(2.0 / 3), "0.6667");
    EXPECT_EQ(readable(0.5), "0.5");
    EXPECT_EQ(readable(-12.345678), "-12.35");
    EXPECT_EQ(readable(123456.7), "123457");
    EXPECT_EQ(readable(1e12), "1e+12");
    EXPECT_EQ(readable(1000.00012, {.size = 1000, .gap = 1e-5}), "1000.00012");
}

TEST(TraceNumbers, NoiseAndMinusZeroAreZero) {
    EXPECT_EQ(readable(-0.0), "0");
    EXPECT_EQ(readable(1e-17), "0");
    EXPECT_EQ(readable(-3e-14), "0");
    EXPECT_EQ(readable(0.0, {.size = 0}), "0");
    EXPECT_EQ(readable(2e-17, {.size = 1e-16}), "2e-17");
    EXPECT_EQ(readable(1e-3, {.size = 1e12}), "0");
}

TEST(TraceNumbers, SmallAndLargeOnesAreNotedAsPowersOfTen) {
    EXPECT_EQ(noted(1.5e-9), "1.5\\cdot 10^{-9}");
    EXPECT_EQ(noted(-2e20), "-2\\cdot 10^{20}");
    EXPECT_EQ(notedDifference(1, -2, {}), "1-(-2)");
    EXPECT_EQ(notedDifference(1, 2, {}), "1-2");
}

TEST(TraceNumbers, ListsAreSpokenAndLongOnesShortened) {
    EXPECT_EQ(spoken({"a"}), "a");
    EXPECT_EQ(spoken({"a", "b"}), "a and b");
    EXPECT_EQ(spoken({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(spoken(std::vector<std::string>(20, "x")), "x, x, x, x, x, x and 14 more");
    EXPECT_EQ(readable(Vec3(1, -0.0, 3), 2, {}), "(1, 0)");
    EXPECT_EQ(readable(Vec3(1, 2.5, 1.0 / 3), 3, {}), "(1, 2.5, 0.3333)");
}

}  // namespace
}  // namespace knotwork::scene
