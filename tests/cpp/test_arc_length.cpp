#include "geometry/arc_length.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/smooth_pieces.hpp"
#include "support/measure_gates.hpp"
#include "support/truth.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork::test {
namespace {

constexpr double pi = std::numbers::pi;

double lengthOf(const Curve& curve) { return ArcLength(curve).total(); }

void expectLength(const Curve& curve, double truth, const std::string& name) {
    EXPECT_NEAR(lengthOf(curve) / truth, 1, gates::length) << name;
}

TEST(ArcLength, OfModelsWithClosedForms) {
    expectLength(Curve(make("circle", {{"radius", 2.5}})), 5 * pi, "circle");
    expectLength(Curve(make("astroid", {{"a", 3.0}})), 18, "astroid");
    expectLength(Curve(make("cardioid", {{"a", 2.0}})), 32, "cardioid");
    expectLength(Curve(make("nephroid")), 24, "nephroid");
    expectLength(Curve(make("helix", {{"radius", 2.0}, {"pitch", 3.0}, {"turns", 4.0}})),
                 4 * std::hypot(4 * pi, 3), "helix");
    // r = bt: b/2 (t √(1+t²) + asinh t).
    const double t = 6 * pi;
    expectLength(Curve(make("spiral", {{"a", 0.0}, {"b", 0.5}})),
                 0.25 * (t * std::sqrt(1 + t * t) + std::asinh(t)), "spiral");
}

TEST(ArcLength, OfTheButterflyIsThePublishedOne) {
    const auto& cases = truth("butterfly");
    const auto number = [&](const char* name) {
        return std::stod(cases.at(name).get<std::string>());
    };
    expectLength(Curve(make("butterfly")), number("length_0_12pi"), "12π");
    expectLength(Curve(make("butterfly", {}, Interval{0, 2 * pi})), number("length_0_2pi"), "2π");
    EXPECT_NEAR(ArcLength(Curve(make("butterfly"))).between(0, 2 * pi) / number("length_0_2pi"), 1,
                gates::length);
}

TEST(ArcLength, OfAParabolaAndOfARationalCircle) {
    // y = x² from 0 to 1.
    const Curve parabola = spline(2, Form::clamped, {}, {{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
    expectLength(parabola, std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, "parabola");
    expectLength(rationalCircle(), 2 * pi, "rational circle");
}

TEST(ArcLength, OfACubicCuspInTheMiddleOfItsSpan) {
    // (t², t³) from −1 to 2, and its speed |t| √(4 + 9t²).
    const auto primitive = [](double t) { return std::pow(4 + 9 * t * t, 1.5) / 27; };
    const double truth = (primitive(1) - primitive(0)) + (primitive(2) - primitive(0));
    // Its blossom: x[a,b,c] = (ab+bc+ca)/3, y = abc.
    const auto blossom = [](double a, double b, double c) {
        return Vec3((a * b + b * c + c * a) / 3, a * b * c, 0);
    };
    const Curve cusp = spline(3, Form::clamped, {-1, -1, -1, -1, 2, 2, 2, 2},
                              {blossom(-1, -1, -1), blossom(-1, -1, 2), blossom(-1, 2, 2),
                               blossom(2, 2, 2)});
    expectLength(cusp, truth, "cusp");
}

TEST(ArcLength, OfFormulasWithCornersAndVerticalTangents) {
    for (const Animal& animal : formulas()) {
        const double length = lengthOf(animal.curve);
        if (animal.name == "corner of abs") {
            EXPECT_NEAR(length, 2 * std::sqrt(2.0), 1e-14);
        }
        if (animal.name == "root") {
            EXPECT_NEAR(length, std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 2e-14);
        }
        // Parameters beside 1 are 1e-16 apart, and the points there √(2·1e-16) = 1.5e-8.
        if (animal.name == "half circle of roots") {
            EXPECT_NEAR(length, pi, 3e-8);
        }
        EXPECT_GT(length, 0) << animal.name;
    }
}

TEST(ArcLength, OfStraightLinesThatTurnBackCountsBothWays) {
    // x = t(6 − 5t) √2 along the diagonal, back from t = 3/5.
    const Curve line = spline(2, Form::clamped, {}, {{0, 0, 0}, {3, 3, 0}, {1, 1, 0}});
    expectLength(line, std::sqrt(2.0) * (1.8 + 0.8), "line");
    expectLength(spline(1, Form::closed, {}, {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}), 12, "triangle");
}

TEST(ArcLength, OfACurveThatStandsStillIsZero) {
    const Curve still = spline(3, Form::clamped, {}, std::vector<Vec3>(5, Vec3(2, -1, 3)));
    const ArcLength lengths(still);
    EXPECT_EQ(lengths.total(), 0);
    EXPECT_EQ(parameterAtLength(lengths, 0).value(), 0);
}

TEST(ArcLength, JumpsHaveNoLength) {
    const Curve jump = spline(1, Form::clamped, {0, 0, 1, 1, 2, 2},
                              {{0, 0, 0}, {1, 0, 0}, {1, 5, 0}, {3, 5, 0}});
    expectLength(jump, 3, "jump");
}

/// Many Gauss panels between the knots, without looking at what comes out.
double bruteForce(const Curve& curve, double a, double b) {
    double sum = 0;
    constexpr int panels = 400;
    for (int i = 0; i < panels; ++i) {
        sum += integrateGauss<16>(
            [&](double t) {
                std::array<Vec3, 2> rows;
                evaluate(curve, t, Side::right, rows);
                return glm::length(rows[1]);
            },
            a + (b - a) * i / panels, a + (b - a) * (i + 1) / panels);
    }
    return sum;
}

TEST(ArcLength, OfEveryKindAgreesWithManyPanels) {
    for (const Animal& animal : zoo()) {
        double truth = 0;
        for (const Interval& piece : smoothPieces(animal.curve)) {
            truth += bruteForce(animal.curve, piece.start, piece.end);
        }
        // At a cusp inside a panel the many panels are the worse ones: (1/400)² of a piece.
        EXPECT_NEAR(lengthOf(animal.curve), truth, 1e-7 * truth + 1e-15) << animal.name;
    }
    for (const Animal& animal : blends()) {
        double truth = 0;
        for (const Interval& piece : smoothPieces(animal.curve)) {
            truth += bruteForce(animal.curve, piece.start, piece.end);
        }
        EXPECT_NEAR(lengthOf(animal.curve) / truth, 1, gates::length) << animal.name;
    }
}

TEST(ArcLength, IsAdditive) {
    RandomSplines random(17);
    for (const Animal& animal : zoo()) {
        const ArcLength lengths(animal.curve);
        const Interval whole = domain(animal.curve);
        for (int i = 0; i < 10; ++i) {
            double a = random.real(whole.start, whole.end);
            double b = random.real(whole.start, whole.end);
            if (a > b) std::swap(a, b);
            const double sum = lengths.between(whole.start, a) + lengths.between(a, b) +
                               lengths.between(b, whole.end);
            EXPECT_NEAR(sum, lengths.total(), gates::length * lengths.total()) << animal.name;
        }
    }
}

TEST(ArcLength, AndItsInverseGoBackAndForth) {
    for (const Animal& animal : zoo()) {
        const ArcLength lengths(animal.curve);
        const Interval whole = domain(animal.curve);
        double before = whole.start;
        for (int i = 0; i <= 37; ++i) {
            const double s = lengths.total() * (i / 37.0);
            const double t = parameterAtLength(lengths, s).value();
            EXPECT_GE(t, before) << animal.name;
            EXPECT_NEAR(lengths.between(whole.start, t), s, gates::lengthInverse * lengths.total())
                << animal.name << " at " << s;
            before = t;
        }
        if (lengths.total() > 0) {
            EXPECT_EQ(before, whole.end) << animal.name;
        }
    }
}

TEST(ArcLength, InverseIsTheParameterOfACircle) {
    const ArcLength lengths{Curve(make("circle", {{"radius", 2.0}}))};
    for (const double t : {0.0, 0.1, 1.0, 3.0, 6.0, 2 * pi}) {
        EXPECT_NEAR(lengths.parameterAt(2 * t), t, 1e-14);
    }
}

TEST(ArcLength, OfAClosedCurveGoesThroughTheSeamAndRoundAgain) {
    const ArcLength circle{Curve(make("circle"))};
    const auto between = [&](double a, double b) { return lengthBetween(circle, a, b).value(); };
    EXPECT_NEAR(between(5, 7), 2, 1e-14);
    EXPECT_NEAR(between(-1, 1), 2, 1e-14);
    EXPECT_NEAR(between(5, 1), 2 * pi - 4, 1e-14);
    EXPECT_NEAR(between(0.1, 0.1 + 6 * pi), 6 * pi, 1e-13);
    EXPECT_NEAR(between(0.1, 0.1 + 2 * pi), 2 * pi, 1e-14);
    EXPECT_EQ(between(1, 1), 0);
    EXPECT_NEAR(parameterAtLength(circle, 2 * pi + 1).value(), 1, 1e-14);
    EXPECT_NEAR(parameterAtLength(circle, -1).value(), 2 * pi - 1, 1e-14);
    EXPECT_NEAR(parameterAtLength(circle, circle.total()).value(), 2 * pi, 1e-14);
}

TEST(ArcLength, RefusesWhatLiesOutsideAnOpenCurve) {
    const ArcLength line{spline(1, Form::clamped, {}, {{0, 0, 0}, {2, 0, 0}})};
    const auto refusal = [](const Result<double>& answer) {
        return answer ? std::string("none")
                      : std::string(codeName(answer.error().code)) + " " + answer.error().path;
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(lengthBetween(line, -0.1, 1)), "OUT_OF_RANGE a");
    EXPECT_EQ(refusal(lengthBetween(line, 0, 1.1)), "OUT_OF_RANGE b");
    EXPECT_EQ(refusal(lengthBetween(line, 0.7, 0.2)), "OUT_OF_RANGE b");
    EXPECT_EQ(refusal(lengthBetween(line, infinite, 1)), "NOT_FINITE a");
    EXPECT_EQ(refusal(lengthBetween(line, {}, std::nan(""))), "NOT_FINITE b");
    EXPECT_EQ(refusal(parameterAtLength(line, -0.1)), "OUT_OF_RANGE s");
    EXPECT_EQ(refusal(parameterAtLength(line, 2.1)), "OUT_OF_RANGE s");
    EXPECT_EQ(refusal(parameterAtLength(line, std::nan(""))), "NOT_FINITE s");
    EXPECT_NEAR(lengthBetween(line, 0.25, {}).value(), 1.5, 1e-15);
}

TEST(SmoothPieces, BeginAndEndAtTheKnotsOfTheLocalsToo) {
    const Curve model = spline(2, Form::clamped, {0, 0, 0, 0.3, 1, 1, 1},
                               {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}});
    const Curve blend(BlendingCurve::fromModel(model, 3, BlendForm::open, BFunction(), {}, {}).value());
    const std::vector<Interval> pieces = smoothPieces(blend, {0, 1});
    const auto ends = [&](double t) {
        return std::count_if(pieces.begin(), pieces.end(),
                             [&](const Interval& piece) { return piece.end == t; });
    };
    EXPECT_EQ(ends(0.3), 1);
    EXPECT_EQ(ends(0.5), 1);
    EXPECT_EQ(pieces.front().start, 0);
    EXPECT_EQ(pieces.back().end, 1);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].start, pieces[i - 1].end);
        EXPECT_LT(pieces[i].start, pieces[i].end);
    }
}

/// B-functions with places in (0, 1) where a derivative jumps.
struct Kinked {
    const char* name;
    BFunction blend;
    std::vector<double> kinks;
};

std::vector<Kinked> kinkedBlends() {
    const auto table = BFunction::makeTabulated(std::vector{0.0, 0.1, 0.15, 0.8, 1.0}).value();
    const auto steep = BFunction::makeExpoRational(1, 1, 0.3, 0.4).value();  // λ = 0.4
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    // 3x² − 2x³ = 1/4.
    const double quarter = 0.5 - std::sin(pi / 18);
    return {
        {"tabulated", table, {0.25, 0.5, 0.75}},
        {"expo-rational", steep, {0.4}},
        {"dual", BFunction::makeDual(steep).value(), {0.6}},
        {"symmetrised", BFunction::makeSymmetrised(steep).value(), {0.4, 0.6}},
        {"mixed", BFunction::makeMixed(table, steep, 0.3).value(), {0.25, 0.4, 0.5, 0.75}},
        {"kinks outside", BFunction::makeComposed(table, cubic).value(), {quarter, 0.5, 1 - quarter}},
        {"kinks inside", BFunction::makeComposed(cubic, steep).value(), {0.4}},
    };
}

TEST(SmoothPieces, EndWhereTheBFunctionOfABlendIsNotSmooth) {
    const std::vector<double> knots{0, 1, 3.1};
    for (const auto& [name, blend, kinks] : kinkedBlends()) {
        const Curve curve(BlendingCurve::fromModel(Curve(make("circle")), 3, BlendForm::open, blend,
                                                   knots, {})
                              .value());
        const std::vector<Interval> pieces = smoothPieces(curve);
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            for (const double x : kinks) {
                const double t = knots[i] + x * (knots[i + 1] - knots[i]);
                EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [&](const Interval& piece) {
                    return std::abs(piece.end - t) < 1e-14;
                })) << name << " at " << t;
            }
        }
    }
}

}  // namespace
}  // namespace knotwork::test
