// What local curves that are cut from a model keep of it.
#include "geometry/local_cuts.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/bspline_basis.hpp"
#include "support/blends.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork {
namespace {

using test::expectNear;
using test::rowsOf;

constexpr double pi = std::numbers::pi;

Curve cutOne(const Curve& model, const LocalCut& cut, double knot, const Interval& over,
             Side side = Side::right) {
    return LocalCutter(model, cut).at(knot, side, over).value();
}

TEST(LocalCut, ALineIsTheTangent) {
    const Curve model(test::make("heart"));
    const Curve line = cutOne(model, {LocalKind::line, 1}, 1.2, {0.7, 1.5});
    const auto expected = rowsOf<2>(model, 1.2);
    const auto got = rowsOf<3>(line, 1.2);
    EXPECT_EQ(got[0], expected[0]);
    EXPECT_EQ(got[1], expected[1]);
    EXPECT_EQ(got[2], Vec3(0));
    EXPECT_EQ(domain(line), (Interval{0.7, 1.5}));
}

TEST(LocalCut, AnArcKeepsTheCurvatureAndItsPlane) {
    const Curve model(test::make("torus-knot"));
    for (const double t : {0.1, 1.0, 2.5}) {
        const Curve arc = cutOne(model, {LocalKind::arc, 1}, t, {t - 0.3, t + 0.2});
        const auto expected = rowsOf<3>(model, t);
        const auto got = rowsOf<3>(arc, t);
        EXPECT_EQ(got[0], expected[0]);
        expectNear(got[1], expected[1], 1e-14, "first");
        // The curvature binormal C′ × C″ / |C′|³ is kept, the tangential acceleration is not.
        expectNear(glm::cross(got[1], got[2]), glm::cross(expected[1], expected[2]), 1e-11, "bend");
        EXPECT_NEAR(glm::dot(got[1], got[2]), 0, 1e-11);
    }
}

TEST(LocalCut, ABezierCurveIsTheTaylorPolynomial) {
    const Curve model(test::make("trefoil"));
    for (const std::size_t degree : {1U, 2U, 3U, 5U, 8U, 25U}) {
        const Interval over{0.5, 1.4};
        const Curve curve = cutOne(model, {LocalKind::bezier, degree}, 0.9, over);
        const auto expected = rowsOf<26>(model, 0.9);
        const auto got = rowsOf<26>(curve, 0.9);
        for (std::size_t k = 0; k <= std::min<std::size_t>(degree, 4); ++k) {
            const double scale = std::pow(4.0 * static_cast<double>(degree) / over.length(), double(k));
            expectNear(got[k], expected[k], 2e-14 * scale, std::to_string(degree));
        }
        EXPECT_EQ(curve.as<BezierCurve>()->degree(), degree);
        EXPECT_EQ(domain(curve), over);
    }
    // Of degree 25 it is the model, to rounding: the remainder is 0.5^26/26! of a 26th derivative.
    const Curve close = cutOne(model, {LocalKind::bezier, 25}, 0.9, {0.5, 1.4});
    for (const double t : {0.5, 0.6, 1.1, 1.4}) {
        expectNear(rowsOf<1>(close, t)[0], pointAt(model, t), 1e-13, "degree 25");
    }
}

/// ∫ (model − spline) N_i for every i, relative to the length of the interval.
double largestMoment(const Curve& model, const Curve& local) {
    const auto& spline = *local.as<BsplineCurve>();
    const auto& knots = spline.knotVector();
    const auto count = static_cast<std::size_t>(knots.pointCount());
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto integrand = [&](double t) {
                std::vector<double> values(count);
                basisRows(knots, t, Side::right, 0, values);
                return values[i] * (pointAt(model, t)[axis] - spline.point(t)[axis]);
            };
            double sum = 0;
            const auto all = knots.knots();
            for (std::size_t k = 1; k < all.size(); ++k) {
                for (int part = 0; part < 4 && all[k] > all[k - 1]; ++part) {
                    const double step = (all[k] - all[k - 1]) / 4;
                    sum += integrateGauss<16>(integrand, all[k - 1] + part * step,
                                              all[k - 1] + (part + 1) * step);
                }
            }
            largest = std::max(largest, std::abs(sum) / knots.domain().length());
        }
    }
    return largest;
}

TEST(LocalCut, ABsplineIsNextToTheModelInTheMeanSquare) {
    const Curve model(test::make("trefoil"));
    for (const std::size_t degree : {1U, 2U, 3U, 5U, 7U}) {
        const Curve local = cutOne(model, {LocalKind::bspline, degree}, 1, {0.2, 2.1});
        EXPECT_EQ(local.as<BsplineCurve>()->points().size(), 8U);
        EXPECT_EQ(local.as<BsplineCurve>()->degree(), static_cast<int>(degree));
        EXPECT_EQ(domain(local), (Interval{0.2, 2.1}));
        // The error is at right angles to the whole space of splines.
        EXPECT_LT(largestMoment(model, local), 1e-14) << degree;
        EXPECT_GT(glm::length(rowsOf<1>(local, 1)[0] - pointAt(model, 1)), 1e-9);
    }
}

TEST(LocalCut, ABsplineReproducesWhatItsSpaceHolds) {
    const Curve cubic(BezierCurve::make({{0, 0, 0}, {1, 3, 1}, {2, -1, 0}, {4, 1, 2}}, {}, {0, 3})
                          .value());
    for (const std::size_t degree : {3U, 4U, 7U}) {
        const Curve local = cutOne(cubic, {LocalKind::bspline, degree}, 1, {-0.5, 2});
        for (const double t : {-0.5, 0.1, 1.3, 2.0}) {
            expectNear(rowsOf<1>(local, t)[0], rowsOf<1>(cubic, t)[0], 2e-14, "cubic");
        }
    }
}

TEST(LocalCut, WhereTheModelStandsStillLinesAndArcsRest) {
    for (const char* name : {"astroid", "nephroid"}) {
        const Curve model(test::make(name));
        for (const LocalKind kind : {LocalKind::line, LocalKind::arc}) {
            for (const double knot : {0.0, pi / 2, pi, 3 * pi / 2}) {
                const auto rows = rowsOf<3>(model, knot);
                const Curve local = cutOne(model, {kind, 1}, knot, {knot - 0.5, knot + 0.5});
                if (glm::length(rows[1]) > 1e-6) continue;  // the nephroid has two cusps, not four
                for (const double t : {knot - 0.5, knot + 0.3}) {
                    expectNear(rowsOf<1>(local, t)[0], rows[0], 1e-14, name);
                }
            }
            const auto curve = BlendingCurve::fromModel(model, 8, BlendForm::closed,
                                                        BFunction::makeExpoRational().value(), {},
                                                        {}, {kind, 1});
            ASSERT_TRUE(curve.ok()) << name;
            for (int i = 0; i <= 100; ++i) {
                const Vec3 p = rowsOf<1>(Curve(*curve), 2 * pi * i / 100)[0];
                EXPECT_LT(glm::length(p), 10) << name;
            }
        }
    }
}

TEST(LocalCut, WhereTheModelHasNoDerivativesThereAreNoTangentsButSubCurves) {
    const Curve root(FormulaCurve::make({.x = "t", .y = "sqrt(t)", .domain = {0, 2}}).value());
    const auto cut = [&](LocalKind kind, std::vector<double> knots) {
        return BlendingCurve::fromModel(root, 3, BlendForm::open, BFunction(), std::move(knots), {},
                                        {kind, 3});
    };
    for (const LocalKind kind : {LocalKind::line, LocalKind::arc, LocalKind::bezier}) {
        const auto made = cut(kind, {0, 1, 2});
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.error().code, Code::notFinite);
        EXPECT_EQ(made.error().path, "model");
        EXPECT_TRUE(cut(kind, {0.5, 1, 2}).ok());
    }
    EXPECT_TRUE(cut(LocalKind::subCurve, {0, 1, 2}).ok());
    EXPECT_TRUE(cut(LocalKind::bspline, {0, 1, 2}).ok());
}

TEST(LocalCut, AtACornerTheSideThatIsSeenCounts) {
    // A polygon with a corner at every whole parameter.
    const Curve polygon = test::spline(1, Form::clamped, {}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {3, 1, 0}});
    const auto blend = BFunction::makePolynomial(1, 1).value();
    const auto curve = BlendingCurve::fromModel(polygon, 5, BlendForm::open, blend, {0, 1, 2, 2, 3},
                                                {}, {LocalKind::line, 1})
                           .value();
    const auto direction = [&](std::size_t j) {
        return curve.locals()[j].source().as<LineCurve>()->direction();
    };
    EXPECT_EQ(direction(0), Vec3(1, 0, 0));
    EXPECT_EQ(direction(1), Vec3(0, 1, 0));  // seen from both sides: what comes
    EXPECT_EQ(direction(2), Vec3(0, 1, 0));  // the first of a break is seen from the left only
    EXPECT_EQ(direction(3), Vec3(2, 0, 0));
    EXPECT_EQ(direction(4), Vec3(2, 0, 0));  // and the last one
}

TEST(LocalCut, AClosedSplineIsContinuedByItsPeriodAndAnotherByItsEndPiece) {
    std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    const Curve closed = test::spline(3, Form::closed, {}, points);
    const auto first = BlendingCurve::fromModel(closed, 5, BlendForm::closed, BFunction(), {}, {},
                                                {LocalKind::bspline, 3})
                           .value();
    // The first local curve reaches one span before the seam.
    const LocalCurve& local = first.locals()[0];
    EXPECT_EQ(local.domain(), (Interval{-1, 1}));
    expectNear(local.point(-0.5), rowsOf<1>(closed, 4.5)[0], 0.02, "wrapped");
    const Curve open = test::spline(3, Form::clamped, {}, points);
    const auto bent = BlendingCurve::fromModel(open, 3, BlendForm::closed, BFunction(), {}, {}).value();
    const Interval whole = domain(open);
    const double before = whole.start - 0.1;
    expectNear(bent.locals()[0].point(before), rowsOf<1>(open, before)[0], 0, "continued");
    // A polynomial: the fourth difference over the end is 0.
    Vec3 difference(0);
    const std::array<double, 5> binomials{1, -4, 6, -4, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        difference += binomials[i] * rowsOf<1>(open, -0.3 + 0.15 * double(i))[0];
    }
    expectNear(difference, Vec3(0), 1e-13, "end piece");
}

TEST(LocalCut, DoubledEndKnotsGiveLocalsThatAreNeverSeen) {
    const Curve model(test::make("trefoil"));
    for (const auto& [name, cut] : test::allCuts()) {
        const auto curve = BlendingCurve::fromModel(model, 6, BlendForm::open, BFunction(),
                                                    {0, 0, 1, 1, 2, 2}, {}, cut);
        ASSERT_TRUE(curve.ok()) << name;
        EXPECT_EQ(curve->locals()[0].domain(), (Interval{0, 1}));
        EXPECT_EQ(curve->locals()[5].domain(), (Interval{1, 2}));
        EXPECT_EQ(curve->support(0).length(), 0);
        expectNear(rowsOf<1>(Curve(*curve), 0)[0], curve->locals()[1].point(0), 0, name);
        expectNear(rowsOf<1>(Curve(*curve), 2, Side::left)[0], curve->locals()[4].point(2), 0, name);
    }
}

TEST(LocalCut, TheBreaksOfABlendAreItsKnotsAndThoseOfItsLocals) {
    const Curve model = test::spline(2, Form::clamped, {0, 0, 0, 1, 2, 3, 3, 3},
                                     {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 2, 0}, {4, 0, 0}});
    const auto cut = BlendingCurve::fromModel(model, 3, BlendForm::open, BFunction(), {0, 1.5, 3}, {});
    const auto breaks = cut->breaks();
    EXPECT_EQ(std::vector<double>(breaks.begin(), breaks.end()),
              (std::vector<double>{0, 1, 1.5, 2, 3}));
    // Fitted onto [0, 2] and [0, 2] at three times the rate: 1/3 and 2/3 of each support.
    const auto fitted = BlendingCurve::fromLocals({model, Curve(test::make("circle"))},
                                                  BlendForm::closed, BFunction(), {0, 1.5, 3}, true,
                                                  {});
    const auto mapped = fitted->breaks();
    // The first one lives on [−1.5, 1.5], and, wrapped, on [1.5, 4.5]: knots at −0.5, 0.5, 2.5, 3.5.
    ASSERT_EQ(mapped.size(), 5U);
    EXPECT_NEAR(mapped[1], 0.5, 1e-15);
    EXPECT_NEAR(mapped[3], 2.5, 1e-15);
}

}  // namespace
}  // namespace knotwork
