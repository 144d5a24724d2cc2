// Traces that evaluate a curve end with its point, and show the numbers on the way there.
#include "support/traces.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/factor_matrices.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

TEST(TraceDeBoor, HasAFrameForEachLevelAndEndsWithThePointOfTheCurve) {
    eachParameter(701, 12, [](const BsplineCurve& curve, double t) {
        const Trace trace = traced(about("de-boor", curve, "t", t));
        ASSERT_EQ(trace.frames.size(), static_cast<std::size_t>(curve.degree()) + 1);
        expectReadable(trace);
        EXPECT_LE(distance(trace.frames.back().points.back(), pointAt(Curve(curve), t)),
                  test::gates::exact * 4)
            << "at " << t;
        EXPECT_EQ(trace.frames.front().points.size(), curve.points().size());
    });
}

TEST(TraceDeBoor, MarksTheActivePointsAndTheNewPointsOfEachLevel) {
    const Trace trace = traced(onQuadratic("de-boor", "\"t\":2"));
    ASSERT_EQ(trace.frames.size(), 3u);
    EXPECT_EQ(trace.frames[0].marked, (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(trace.frames[1].marked, (std::vector<std::size_t>{3, 4}));
    EXPECT_EQ(trace.frames[2].marked, (std::vector<std::size_t>{5}));
    ASSERT_EQ(trace.frames[1].weights.size(), 2u);
    EXPECT_NEAR(trace.frames[1].weights[0], 2.0 / 3, test::gates::exact);
    EXPECT_NEAR(trace.frames[1].weights[1], 1.0 / 3, test::gates::exact);
    EXPECT_NEAR(trace.frames[2].weights[0], 0.5, test::gates::exact);
    EXPECT_LE(distance(trace.frames[1].points[3], {7.0 / 3, 8.0 / 3, 0}), test::gates::exact);
    EXPECT_LE(distance(trace.frames[2].points[5], {3, 7.0 / 3, 0}), test::gates::exact);
}

TEST(TraceDeBoor, SaysTheNumbersOfItsSteps) {
    const Trace trace = traced(onQuadratic("de-boor", "\"t\":2"));
    EXPECT_EQ(trace.frames[0].text,
              "The parameter 2 lies between the knots 1 and 3; because the degree is 2, only 3 "
              "of the 5 control points act there, number 1 to number 3.");
    EXPECT_EQ(trace.frames[1].text,
              "Level 1 of 2 mixes each two neighbours, the second by the part of its knots that "
              "2 has passed, 0.6667 and 0.3333, and leaves 2 points, (2.333, 2.667) and (3.667, "
              "2).");
    EXPECT_EQ(trace.frames[2].text,
              "The last mix, with 0.5 of the second point, gives the point of the curve at 2, "
              "(3, 2.333).");
    EXPECT_EQ(trace.frames[1].key, "de-boor.level");
}

TEST(TraceDeBoor, ShowsTheRatioWithSymbolsAndNumbers) {
    const std::string formula = traced(onQuadratic("de-boor", "\"t\":2")).frames[2].formula;
    const auto has = [&](const char* part) { return formula.find(part) != std::string::npos; };
    EXPECT_TRUE(has("<mfrac><mrow><mi>t</mi><mo>\u2212</mo><msub><mi>t</mi><mrow><mn>3</mn></mrow></msub>"
                    "</mrow>"))
        << formula;
    EXPECT_TRUE(has("<mfrac><mrow><mn>2</mn><mo>\u2212</mo><mn>1</mn></mrow><mrow><mn>3</mn><mo>\u2212"
                    "</mo><mn>1</mn></mrow></mfrac><mo>=</mo><mn>0.5</mn>"))
        << formula;
}

TEST(TraceCoxDeBoor, EndsWithAllBasisFunctionsAndThePoint) {
    eachParameter(702, 12, [](const BsplineCurve& curve, double t) {
        const Trace trace = traced(about("cox-de-boor", curve, "t", t));
        ASSERT_EQ(trace.frames.size(), static_cast<std::size_t>(curve.degree()) + 1);
        expectReadable(trace);
        const KnotVector& knots = curve.knotVector();
        std::vector<double> basis(curve.points().size());
        const Side side = t == curve.domain().end ? Side::left : Side::right;
        basisRows(knots, t, side, 0, basis);
        ASSERT_EQ(trace.frames.back().weights.size(), basis.size());
        for (std::size_t i = 0; i < basis.size(); ++i) {
            EXPECT_NEAR(trace.frames.back().weights[i], basis[i], test::gates::exact);
        }
        EXPECT_LE(distance(trace.frames.back().points.back(), pointAt(Curve(curve), t)),
                  test::gates::basisAgainstDeBoor * 4);
        for (const TraceFrame& frame : trace.frames) {
            double sum = 0;
            for (const double weight : frame.weights) sum += weight;
            EXPECT_NEAR(sum, 1, test::gates::partitionOfUnity);
        }
    });
}

TEST(TraceCoxDeBoor, HasTheValuesOfTheTruth) {
    const auto& truth = test::truth("bspline_basis");
    Json arguments = parsed(R"({"algorithm":"cox-de-boor","t":1.25,"curve":{"type":"bspline-curve",
        "degree":3,"points":[[0,0],[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0]]}})");
    arguments["curve"]["knots"] = listOf(test::doubles(test::rationals(truth["knots"])));
    const Trace trace = traced(arguments);
    const auto expected = test::doubles(test::rationals(truth["N(5/4)"]));
    ASSERT_EQ(trace.frames.back().weights.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(trace.frames.back().weights[i], expected[i], test::gates::exact);
    }
    EXPECT_NE(trace.frames.back().text.find("numbers 2, 3, 4 and 5 are 0.04167, 0.8576, 0.09722 and "
                                            "0.003472"),
              std::string::npos)
        << trace.frames.back().text;
}

TEST(TraceFactorMatrices, MultiplyToTheRowOfTheBasisAndToThePoint) {
    eachParameter(703, 10, [](const BsplineCurve& curve, double t) {
        const Trace trace = traced(about("factor-matrices", curve, "t", t));
        const auto degree = static_cast<std::size_t>(curve.degree());
        ASSERT_EQ(trace.frames.size(), degree + 2);
        expectReadable(trace);
        std::vector<double> product{1};
        const auto factors = factorMatrices(curve.knotVector(), t);
        for (std::size_t k = 1; k <= degree; ++k) {
            const auto& matrix = trace.frames[k].matrix;
            ASSERT_EQ(matrix.size(), k);
            ASSERT_EQ(matrix.front().size(), k + 1);
            for (std::size_t i = 0; i < k * (k + 1); ++i) {
                // the library goes round at the end of a closed curve, where the trace stays left
                if (curve.closed() && t == curve.domain().end) break;
                EXPECT_NEAR(matrix[i / (k + 1)][i % (k + 1)], factors[k - 1][i],
                            test::gates::exact);
            }
            std::vector<double> next(k + 1, 0.0);
            for (std::size_t r = 0; r < k; ++r) {
                EXPECT_NEAR(matrix[r][r] + matrix[r][r + 1], 1, test::gates::exact);
                for (std::size_t c = 0; c <= k; ++c) next[c] += product[r] * matrix[r][c];
            }
            product = next;
        }
        const Side side = t == curve.domain().end ? Side::left : Side::right;
        const KnotVector& knots = curve.knotVector();
        std::vector<double> basis(degree + 1);
        const double inside = knots.wrap(t, side);
        basisFunctions(knots, knots.findSpan(inside, side), inside, basis);
        for (std::size_t j = 0; j <= degree; ++j) {
            EXPECT_NEAR(product[j], basis[j], test::gates::exact);
            EXPECT_NEAR(trace.frames.back().weights[j], basis[j], test::gates::exact);
        }
        EXPECT_LE(distance(trace.frames.back().points.back(), pointAt(Curve(curve), t)),
                  test::gates::basisAgainstDeBoor * 4);
    });
}

TEST(TraceDeBoor, WrapsAroundAClosedCurve) {
    const auto& truth = test::truth("closed_cubic_uniform");
    for (const auto& [t, point] : truth["pts"].items()) {
        Json arguments = parsed(R"({"algorithm":"de-boor","curve":{"type":"bspline-curve","degree":3,
            "form":"closed","points":[[0,0],[4,0],[5,3],[2,5],[-1,3]]}})");
        arguments["t"] = test::Rational::parse(t).value() + 5;
        const auto expected = test::doubles(test::rationals(point));
        const Trace trace = traced(arguments);
        EXPECT_LE(distance(trace.frames.back().points.back(), {expected[0], expected[1], 0}),
                  test::gates::exact);
    }
}

TEST(TraceBlend, EndsWithThePointOfTheCurve) {
    for (const char* rest :
         {R"("form":"closed","locals":{"count":4})", R"("form":"open","locals":{"count":3})",
          R"("locals":{"count":4},"poses":[{"local":0,"translate":[1,2,3]},{"local":2,"scale":2}])",
          R"("form":"open","locals":{"count":4},"knots":[0,1,1,6])",
          R"("form":"open","locals":{"count":4},"knots":[0,0,3,6])",
          R"("form":"open","locals":{"count":4},"knots":[0,3,6,6])"}) {
        const Json spec = parsed(std::string(R"({"type":"blending-curve","bFunction":
            {"family":"expo-rational"},"model":{"type":"parametric-curve","name":"butterfly"},)") +
                                 rest + "}");
        const auto curve = makeCurve(spec);
        ASSERT_TRUE(curve.ok()) << curve.error().message;
        const auto* blending = curve->value.as<BlendingCurve>();
        const std::vector<double>& knots = blending->knots();
        std::vector<double> ts(knots);
        for (std::size_t i = 1; i < knots.size(); ++i) {
            ts.push_back(0.3 * knots[i - 1] + 0.7 * knots[i]);
        }
        for (const double t : ts) {
            const Trace trace = traced(Json{{"algorithm", "blend"}, {"curve", spec}, {"t", t}});
            ASSERT_EQ(trace.frames.size(), 4u);
            expectReadable(trace);
            EXPECT_LE(distance(trace.frames.back().points.back(), pointAt(curve->value, t)),
                      test::gates::exact * 8)
                << rest << " at " << t;
            const auto& weights = trace.frames.back().weights;
            ASSERT_EQ(weights.size(), 2u);
            EXPECT_EQ(weights[0], 1 - weights[1]);
        }
    }
}

TEST(TraceBlend, SaysWhatItBlends) {
    const Trace trace = traced(R"({"algorithm":"blend","t":0.5,"curve":{"type":"blending-curve",
        "bFunction":{"family":"polynomial"},"locals":[
        {"type":"bspline-curve","degree":1,"points":[[0,0],[2,0]]},
        {"type":"bspline-curve","degree":1,"points":[[0,4],[2,4]]}],"knots":[0,1]}})");
    EXPECT_EQ(trace.frames[1].text, "The part of the span that 0.5 has passed is w = 0.5, and the "
                                    "polynomial B-function takes it to 0.5.");
    EXPECT_EQ(trace.frames[2].text,
              "At 0.5 local curve 0 is at (1, 0) and counts 0.5, and local curve 1 is at (1, 4) "
              "and counts 0.5.");
    EXPECT_LE(distance(trace.frames[3].points.back(), {1, 2, 0}), test::gates::exact);
}

}  // namespace
}  // namespace knotwork::scene
