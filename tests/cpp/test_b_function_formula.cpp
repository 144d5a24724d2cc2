// B-functions that a person types: what is found out about them, and what is refused.
#include "geometry/b_function.hpp"

#include "support/function_gates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

namespace gates = test::gates;

constexpr double infinity = std::numeric_limits<double>::infinity();
using Order = std::array<double, 2>;

BFunction typed(const char* expression) {
    const auto made = BFunction::makeFormula(expression);
    EXPECT_TRUE(made.ok()) << expression << ": " << (made.ok() ? "" : made.error().message);
    return made.ok() ? made.value() : BFunction();
}

struct Pair {
    const char* expression;
    BFunction builtIn;
};

std::vector<Pair> pairs() {
    return {
        {"t", BFunction()},
        {"sin(pi*t/2)^2", BFunction::makeTrigonometric(1).value()},
        {"1/2-cos(pi*t)/2", BFunction::makeTrigonometric(1).value()},
        {"t-sin(2*pi*t)/(2*pi)", BFunction::makeTrigonometric(2).value()},
        {"1/2-(9*cos(pi*t)-cos(3*pi*t))/16", BFunction::makeTrigonometric(3).value()},
        {"3*t^2-2*t^3", BFunction::makePolynomial(1, 1).value()},
        {"t^3*(10-15*t+6*t^2)", BFunction::makePolynomial(2, 2).value()},
        {"35*t^4-84*t^5+70*t^6-20*t^7", BFunction::makePolynomial(3, 3).value()},
        {"6*t^2-8*t^3+3*t^4", BFunction::makePolynomial(1, 2).value()},
        {"t^3", BFunction::makePolynomial(2, 0).value()},
        {"1-(1-t)^4", BFunction::makePolynomial(0, 3).value()},
        {"t^2/(t^2+(1-t)^2)", BFunction::makeRational(2, 1).value()},
        {"t^3/(t^3+4*(1-t)^3)", BFunction::makeRational(3, 4).value()},
        {"1/(1+(1/t-1)^2)", BFunction::makeRational(2, 1).value()},
        {"t^2.5/(t^2.5+0.7*(1-t)^2.5)", BFunction::makeRational(2.5, 0.7).value()},
        {"1/(1+exp(1/t-1/(1-t)))", BFunction::makeLogistic(1).value()},
        {"1/(1+exp(0.01*(1-2*t)/(t*(1-t))))", BFunction::makeLogistic(0.01).value()},
        {"1/(1+exp(1000*(1/t-1/(1-t))))", BFunction::makeLogistic(1000).value()},
        {"(1+tanh((1/(1-t)-1/t)/2))/2", BFunction::makeLogistic(1).value()},
    };
}

TEST(BFunctionFormula, IsTheBuiltInOneOfTheSameFormulaWithItsOrdersAndItsSymmetry) {
    for (const auto& [expression, builtIn] : pairs()) {
        const BFunction function = typed(expression);
        EXPECT_EQ(function.order(), builtIn.order()) << expression;
        EXPECT_EQ(function.powers(), builtIn.powers()) << expression;
        EXPECT_EQ(function.symmetric(), builtIn.symmetric()) << expression;
        EXPECT_EQ(function.smooth(), builtIn.smooth()) << expression;
        for (int i = 0; i <= 64; ++i) {
            const double t = i / 64.0;
            EXPECT_NEAR(function.value(t), builtIn.value(t), 2 * gates::bFunction) << expression;
        }
        EXPECT_EQ(function.value(0), 0) << expression;
        EXPECT_EQ(function.value(1), 1) << expression;
    }
}

TEST(BFunctionFormula, HasTheDerivativesOfTheBuiltInOneToTheFifth) {
    for (const auto& [expression, builtIn] : pairs()) {
        const BFunction function = typed(expression);
        for (const double t : {0.0, 0.03, 0.2, 0.5, 0.81, 0.97, 1.0}) {
            std::array<double, 6> rows{};
            std::array<double, 6> expected{};
            function.derivatives(t, rows);
            builtIn.derivatives(t, expected);
            double size = 1;  // of steep ones single rows vanish
            for (const double row : expected) size = std::max(size, std::abs(row));
            for (std::size_t k = 1; k < rows.size(); ++k) {
                // Where a formula has only a limit, the fourth is extrapolated to 3e-7.
                EXPECT_NEAR(rows[k], expected[k], (k < 4 ? 1e-9 : 1e-7) * size)
                    << expression << " at " << t << ", order " << k;
            }
        }
    }
}

TEST(BFunctionFormula, FindsOutOrdersOfFormulasThatHaveOnlyALimitAtAnEnd) {
    EXPECT_EQ(typed("exp(1-1/t)").order(), (Order{infinity, 0}));
    EXPECT_EQ(typed("exp(-1/t)/(exp(-1/t)+exp(-1/(1-t)))").order(), (Order{infinity, infinity}));
    EXPECT_EQ(typed("sqrt(t)").order(), (Order{0, 0}));
    EXPECT_EQ(typed("sqrt(t)").powers(), (Order{0.5, 1}));
    EXPECT_EQ(typed("t*sqrt(t)").powers(), (Order{1.5, 1}));
    EXPECT_EQ(typed("1-sqrt(1-t^3)").powers(), (Order{3, 0.5}));
    EXPECT_EQ(typed("1/(1-log(t))").order(), (Order{0, 0}));
    EXPECT_EQ(typed("t*(1-log(t))").order(), (Order{0, 1}));
    EXPECT_EQ(typed("t^25").order(), (Order{24, 0}));
    EXPECT_NE(typed("t*sqrt(t)").warning(), "");
    EXPECT_NE(typed("(t+abs(t-0.5)*(2*t-1)+0.5)/2").warning(), "");
}

TEST(BFunctionFormula, TakesPartInTheAlgebra) {
    const BFunction cubic = typed("t^3");
    EXPECT_DOUBLE_EQ(BFunction::makeDual(cubic).value().value(0.25), 1 - 0.75 * 0.75 * 0.75);
    EXPECT_EQ(BFunction::makeDual(cubic).value().order(), (Order{0, 2}));
    EXPECT_EQ(BFunction::makeComposed(cubic, cubic).value().order(), (Order{8, 0}));
    EXPECT_TRUE(BFunction::makeSymmetrised(cubic).value().symmetric());
    EXPECT_EQ(cubic.expression(), "t^3");
    EXPECT_EQ(cubic, typed("t^3"));
    EXPECT_NE(cubic, typed("t*t*t"));
    EXPECT_EQ(cubic.family(), BFamily::formula);
}

struct Refusal {
    const char* expression;
    Code code;
    const char* says;
};

TEST(BFunctionFormula, RefusesWhatIsNoBFunctionAndNamesTheAxiom) {
    const Refusal refusals[] = {
        {"sin(pi*t)^2", Code::outOfRange, "D3"},  // erratum E15
        {"1-t", Code::outOfRange, "D2"},
        {"cos(pi*t/2)^2", Code::outOfRange, "D2"},
        {"t/2", Code::outOfRange, "D3"},
        {"2*t", Code::outOfRange, "D3"},
        {"0.5", Code::outOfRange, "D2"},
        {"t+1e-9", Code::outOfRange, "D2"},
        {"t+sin(2*pi*t)/4", Code::outOfRange, "D4"},
        {"t-sin(2*pi*t)/6", Code::outOfRange, "D4"},
        {"sin(3.5*pi*t)*t^2*(-1)", Code::outOfRange, "D4"},
        {"t^3-0.001*t*(1-t)", Code::outOfRange, "D4"},
        {"t+sin(2*pi*t*1000)/6280", Code::outOfRange, "D4"},
        {"((t-1/3)^3+1/27)/((2/3)^3+1/27)-1e-5*t*(1-t)", Code::outOfRange, "D4"},
        {"t-(abs(t-1/pi)/(t-1/pi)+1-2*t)/100", Code::outOfRange, "D4"},  // falls at a jump only
        {"t-(abs(t-2.8/pi)/(t-2.8/pi)+1-2*t)/5", Code::outOfRange, "D1"},  // 1.24 before it falls
        {"1/t", Code::notFinite, "D2"},
        {"sqrt(t-0.5)", Code::notFinite, "D2"},
        {"t/(2-t)/(1-(t-0.5)*0)/((t-0.5)/(t-0.5))", Code::notFinite, "D1"},
        {"exp(1/(1-t))/(exp(1/t)+exp(1/(1-t)))", Code::notFinite, "D3"},
        {"t^", Code::syntax, "column 3"},
        {"s^2", Code::unknownName, "column 1"},
        {"", Code::syntax, "column 1"},
    };
    for (const Refusal& refusal : refusals) {
        const auto made = BFunction::makeFormula(refusal.expression);
        ASSERT_FALSE(made.ok()) << refusal.expression;
        EXPECT_EQ(codeName(made.error().code), codeName(refusal.code)) << made.error().message;
        EXPECT_EQ(made.error().path, "expression");
        EXPECT_NE(made.error().message.find(refusal.says), std::string::npos)
            << refusal.expression << ": " << made.error().message;
    }
    const auto article = BFunction::makeFormula("sin(pi*t)^2");
    EXPECT_NE(article.error().message.find("B(1)"), std::string::npos) << article.error().message;
}

}  // namespace
}  // namespace knotwork
