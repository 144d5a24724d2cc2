// The checklist of the axioms: what each of these breaks, and where.
#include "geometry/b_function_axioms.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace knotwork {
namespace {

AxiomBreaches breachesOf(const char* expression) {
    return axiomBreaches(Formula::make(expression, "expression").value());
}

/// The names of the broken axioms.
std::string broken(const AxiomBreaches& breaches) {
    std::string names;
    for (std::size_t k = 0; k < breaches.size(); ++k) {
        if (breaches[k]) names += axiomNames[k];
    }
    return names;
}

TEST(Axioms, EachOfTheseBreaksWhatItBreaks) {
    const std::array<std::pair<const char*, const char*>, 11> cases{{
        {"t", ""},
        {"3*t^2 - 2*t^3", ""},
        {"sin(pi*t/2)^2", ""},
        {"t^2", "D5"},
        {"sin(pi*t)^2", "D3D4D5"},
        {"t + 0.1", "D1D2D3D5"},
        {"t/2", "D3D5"},
        {"1 - t", "D2D3D4"},
        {"t + sin(2*pi*t)/3", "D4"},
        {"2*t^2 - t^4 + 0.4*sin(3*pi*t)*t", "D1D4D5"},
        {"1/(t - 0.5)", "D1D2D3D4D5"},
    }};
    for (const auto& [expression, axioms] : cases) {
        EXPECT_EQ(broken(breachesOf(expression)), axioms) << expression;
    }
}

TEST(Axioms, TheArticlesExampleFallsAfterTheMiddleAndEndsAtZero) {
    const AxiomBreaches breaches = breachesOf("sin(pi*t)^2");
    EXPECT_NEAR(breaches[2]->found, 0, 1e-15);
    EXPECT_EQ(breaches[2]->t, 1);
    EXPECT_GT(breaches[3]->t, 0.5);
    EXPECT_LT(breaches[3]->t, 0.501);
    EXPECT_LT(breaches[3]->found, 0);
    // B(t) + B(1−t) = 2 sin²(πt).
    const double t = breaches[4]->t;
    EXPECT_NEAR(breaches[4]->found, 2 * std::pow(std::sin(3.141592653589793 * t), 2), 1e-15);
}

TEST(Axioms, AValueThatIsTakenForAWhileIsTakenTwice) {
    // Rises to 1/2 on [0, 1/3], rests, and rises again.
    const AxiomBreaches smooth = breachesOf("0.5 + 4*(t - 0.5)^3");
    EXPECT_EQ(broken(smooth), "");  // flat in one point only
    const AxiomBreaches flat =
        breachesOf("(3*t - abs(3*t - 1) + 1)/4 + (3*t - 2 + abs(3*t - 2))/4");
    ASSERT_TRUE(flat[0].has_value());
    EXPECT_NEAR(flat[0]->t, 1.0 / 3, 1e-3);
    EXPECT_NEAR(flat[0]->found, 0.5, 1e-12);
    EXPECT_FALSE(flat[3].has_value());
}

TEST(Axioms, TheFirstHoldsOnlyWhereTheNextThreeDo) {
    using Holds = std::array<bool, 5>;
    EXPECT_EQ(axiomsThatHold(breachesOf("t")), (Holds{true, true, true, true, true}));
    EXPECT_EQ(axiomsThatHold(breachesOf("t^2")), (Holds{true, true, true, true, false}));
    EXPECT_EQ(axiomsThatHold(breachesOf("(1 + t)/2")), (Holds{false, false, true, true, false}));
    EXPECT_EQ(axiomsThatHold(breachesOf("t/2")), (Holds{false, true, false, true, false}));
    EXPECT_EQ(axiomsThatHold(breachesOf("t - sin(2*pi*t)/4")),
              (Holds{false, true, true, false, true}));
}

TEST(Axioms, ANarrowDipBetweenTheSamplesIsSeen) {
    // Slope 1 − 1.2/cosh²((t − 0.33337)·12000) is negative within a fifth of a step of the grid.
    const auto dip = breachesOf("t - 1e-4*tanh((t - 0.33337)*12000)")[3];
    ASSERT_TRUE(dip.has_value());
    EXPECT_NEAR(dip->t, 0.33337, 1e-4);
}

TEST(Axioms, BFunctionsBreakAtMostTheLast) {
    EXPECT_EQ(broken(axiomBreaches(BFunction::makeExpoRational().value())), "");
    const AxiomBreaches leaning = axiomBreaches(BFunction::makePolynomial(1, 3).value());
    EXPECT_EQ(broken(leaning), "D5");
    EXPECT_GT(std::abs(leaning[4]->found - 1), 0.1);
}

}  // namespace
}  // namespace knotwork
