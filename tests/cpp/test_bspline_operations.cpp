#include "geometry/bspline_operations.hpp"

#include "geometry/bezier_piece.hpp"
#include "geometry/factor_matrices.hpp"
#include "geometry/hodograph.hpp"
#include "support/gates.hpp"
#include "support/refinements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;
using test::SplineKind;

Vec3 rowOf(const BsplineCurve& curve, double t, Side side, std::size_t order) {
    std::array<Vec3, 8> rows;
    curve.derivatives(t, side, {rows.data(), order + 1});
    return rows[order];
}

/// The largest difference of derivative `orderA` of a to derivative `orderB` of b at the telltale
/// parameters of b's domain from both sides, relative to the largest of either.
double relativeDifference(const BsplineCurve& a, std::size_t orderA, const BsplineCurve& b,
                          std::size_t orderB, RandomSplines& random) {
    double largest = 0;
    double size = 1;
    const auto compare = [&](double t, Side side) {
        const Vec3 p = rowOf(a, t, side, orderA);
        const Vec3 q = rowOf(b, t, side, orderB);
        size = std::max({size, glm::length(p), glm::length(q)});
        largest = std::max(largest, glm::length(p - q));
    };
    const Interval domain = b.domain();
    for (const double t : test::telltaleParameters(b.knotVector(), random)) {
        if (t > domain.start || b.closed()) compare(t, Side::left);
        if (t < domain.end || b.closed()) compare(t, Side::right);
    }
    return largest / size;
}

// --- splitting --------------------------------------------------------------------------------

/// The knots of the domain and a parameter in each span, not so near to a knot that derivatives of
/// high order are all rounding.
std::vector<double> placesToSplit(const BsplineCurve& curve) {
    std::vector<double> places;
    for (const double t : curve.knotVector().extended()) {
        if (!curve.domain().contains(t)) continue;
        if (!places.empty() && t > places.back()) {
            places.push_back(places.back() + 0.4 * (t - places.back()));
        }
        if (places.empty() || t > places.back()) places.push_back(t);
    }
    return places;
}

TEST(Split, HalvesMeetAndAreTheCurveWithAllItsDerivatives) {
    RandomSplines random(91);
    for (int round = 0; round < 300; ++round) {
        const Form form = round % 2 == 0 ? Form::clamped : Form::open;
        const BsplineCurve curve = random.curve(form, SplineKind{.rational = round % 3 == 0});
        const auto ts = placesToSplit(curve);
        for (std::size_t i = 1; i + 1 < ts.size(); ++i) {
            const auto halves = split(curve, ts[i]);
            ASSERT_TRUE(halves.ok()) << halves.error().message;
            ASSERT_EQ(halves->size(), 2U);
            const BsplineCurve& before = (*halves)[0];
            const BsplineCurve& after = (*halves)[1];
            ASSERT_EQ(before.domain(), (Interval{curve.domain().start, ts[i]}));
            ASSERT_EQ(after.domain(), (Interval{ts[i], curve.domain().end}));
            for (const BsplineCurve* half : {&before, &after}) {
                ASSERT_EQ(half->knotVector().form(), form);
                ASSERT_LE(relativeDifference(curve, 0, *half, 0, random), test::gates::refinement);
                for (std::size_t order = 1; order <= 3; ++order) {
                    ASSERT_LE(relativeDifference(curve, order, *half, order, random),
                              test::gates::complexStep);
                }
            }
            if (curve.knotVector().multiplicity(ts[i]) <= curve.degree()) {
                ASSERT_LE(glm::length(before.points().back() - after.points().front()),
                          test::gates::refinement);
            }
        }
    }
}

TEST(Split, OpensAClosedCurveAtTheParameter) {
    RandomSplines random(92);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve =
            random.curve(Form::closed, SplineKind{.rational = round % 3 == 0});
        const Interval domain = curve.domain();
        auto ts = placesToSplit(curve);
        ts.push_back(domain.start - 0.25 * domain.length());
        for (const double t : ts) {
            const auto opened = split(curve, t);
            ASSERT_TRUE(opened.ok()) << opened.error().message;
            ASSERT_EQ(opened->size(), 1U);
            const BsplineCurve& whole = opened->front();
            ASSERT_EQ(whole.knotVector().form(), Form::clamped);
            ASSERT_EQ(whole.domain().start, curve.knotVector().wrap(t));
            ASSERT_NEAR(whole.domain().length(), domain.length(), 1e-13);
            ASSERT_LE(glm::length(whole.points().front() - rowOf(curve, t, Side::right, 0)), 1e-12);
            ASSERT_LE(glm::length(whole.points().back() - rowOf(curve, t, Side::left, 0)), 1e-12);
            // Knots are compared as knots: a turn away, they are equal to rounding only.
            for (const double knot : whole.knotVector().knots()) {
                double there = curve.knotVector().wrap(knot);
                for (const double one : ts) {
                    if (std::abs(curve.knotVector().wrap(one) - there) < 1e-9) there = one;
                }
                if (knot < whole.domain().end) {
                    ASSERT_LE(glm::length(rowOf(whole, knot, Side::right, 0) -
                                          rowOf(curve, there, Side::right, 0)), 1e-12);
                }
                if (knot > whole.domain().start) {
                    ASSERT_LE(glm::length(rowOf(whole, knot, Side::left, 0) -
                                          rowOf(curve, there, Side::left, 0)), 1e-12);
                }
            }
            for (std::size_t i = 0; i < 40; ++i) {
                const double s = random.real(whole.domain().start, whole.domain().end);
                for (std::size_t order = 0; order <= 2; ++order) {
                    const Vec3 expected = rowOf(curve, s, Side::right, order);
                    ASSERT_LE(glm::length(rowOf(whole, s, Side::right, order) - expected),
                              1e-12 * std::pow(1000.0, static_cast<double>(order)) *
                                  std::max(1.0, glm::length(expected)));
                }
            }
        }
    }
}

TEST(Split, RefusesTheEndsAndWhatLiesOutside) {
    RandomSplines random(93);
    const BsplineCurve curve = random.curve(Form::clamped);
    const Interval domain = curve.domain();
    for (const double t : {domain.start, domain.end, domain.start - 1, domain.end + 1}) {
        const auto made = split(curve, t);
        ASSERT_FALSE(made.ok());
        EXPECT_EQ(made.error().code, Code::outOfRange);
        EXPECT_EQ(made.error().path, "t");
    }
    EXPECT_EQ(split(curve, std::numeric_limits<double>::quiet_NaN()).error().code, Code::notFinite);
    EXPECT_EQ(split(curve, domain.start + 1e-9).error().path, "t");
}

// --- running backwards ------------------------------------------------------------------------

TEST(Reversal, RunsThroughTheSamePointsFromTheEnd) {
    RandomSplines random(94);
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const BsplineCurve back = reversed(curve).value();
        const Interval domain = curve.domain();
        ASSERT_EQ(back.domain(), domain);
        const auto there = curve.knotVector().knots();
        const auto again = back.knotVector().knots();
        for (std::size_t i = 0; i < there.size(); ++i) {
            // Both at the very same knot, from opposite sides.
            const double t = there[i];
            const double s = again[again.size() - 1 - i];
            ASSERT_NEAR(s, domain.start + domain.end - t, 1e-14 * 100);
            if (!domain.contains(t)) continue;
            ASSERT_LE(glm::length(rowOf(curve, t, Side::left, 0) - rowOf(back, s, Side::right, 0)),
                      1e-12);
            ASSERT_LE(glm::length(rowOf(curve, t, Side::right, 0) - rowOf(back, s, Side::left, 0)),
                      1e-12);
        }
        for (int k = 0; k < 10; ++k) {
            const double t = random.real(domain.start, domain.end);
            const double s = domain.start + (domain.end - t);
            const Vec3 forward = rowOf(curve, t, Side::right, 1);
            ASSERT_LE(glm::length(curve.point(t) - back.point(s)), 1e-12);
            ASSERT_LE(glm::length(forward + rowOf(back, s, Side::left, 1)),
                      1e-10 * std::max(1.0, glm::length(forward)));
        }
    }
}

TEST(Reversal, TwiceGivesTheCurve) {
    RandomSplines random(95);
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const BsplineCurve twice = reversed(reversed(curve).value()).value();
        ASSERT_TRUE(std::equal(curve.points().begin(), curve.points().end(), twice.points().begin()));
        ASSERT_TRUE(std::equal(curve.weights().begin(), curve.weights().end(),
                               twice.weights().begin()));
        for (std::size_t i = 0; i < curve.knotVector().knots().size(); ++i) {
            ASSERT_NEAR(twice.knotVector().knots()[i], curve.knotVector().knots()[i], 1e-13);
        }
    }
    const BsplineCurve uniform =
        BsplineCurve::make(KnotVector::uniform(3, 6, Form::closed).value(), std::vector<Vec3>(6), 2)
            .value();
    EXPECT_EQ(reversed(reversed(uniform).value()).value(), uniform);
}

// --- Bézier pieces ----------------------------------------------------------------------------

Homogeneous deCasteljau(std::vector<Homogeneous> points, double w) {
    for (std::size_t r = 1; r < points.size(); ++r) {
        for (std::size_t j = points.size() - 1; j >= r; --j) {
            points[j] = (1 - w) * points[j - 1] + w * points[j];
        }
    }
    return points.back();
}

TEST(BezierPieces, AreTheCurveSpanBySpan) {
    RandomSplines random(96);
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve =
            random.curve(random.form(), SplineKind{.rational = round % 3 == 0});
        const auto pieces = bezierPieces(curve);
        ASSERT_EQ(pieces.front().interval.start, curve.domain().start);
        ASSERT_EQ(pieces.back().interval.end, curve.domain().end);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const auto& [interval, points] = pieces[i];
            ASSERT_LT(interval.start, interval.end);
            if (i > 0) {
                ASSERT_EQ(pieces[i - 1].interval.end, interval.start);
            }
            for (const double w : {0.0, 0.3, 0.5, 1.0}) {
                const double t = w == 1 ? interval.end : interval.start + w * interval.length();
                const Vec3 expected = rowOf(curve, t, w == 1 ? Side::left : Side::right, 0);
                const Homogeneous found = deCasteljau(points, w);
                ASSERT_LE(glm::length(Vec3(found) / found.w - expected), test::gates::refinement);
            }
        }
    }
}

// --- the hodograph ----------------------------------------------------------------------------

TEST(Hodograph, OfAPolynomialCurveIsItsDerivativeFromBothSides) {
    RandomSplines random(97);
    for (int round = 0; round < 500; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const auto derivative = derivativeCurve(curve);
        ASSERT_TRUE(derivative.ok()) << derivative.error().message;
        ASSERT_EQ(derivative->degree(), std::max(1, curve.degree() - 1));
        ASSERT_EQ(derivative->domain(), curve.domain());
        ASSERT_EQ(derivative->knotVector().form(), curve.knotVector().form());
        ASSERT_LE(relativeDifference(curve, 1, *derivative, 0, random), 1e-13);
        ASSERT_LE(relativeDifference(curve, 2, *derivative, 1, random), 1e-12);
    }
}

TEST(Hodograph, OfARationalCurveIsItsDerivativeFromBothSides) {
    RandomSplines random(98);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve = random.curve(random.form(), SplineKind{.rational = true});
        const auto derivative = derivativeCurve(curve);
        ASSERT_TRUE(derivative.ok()) << derivative.error().message;
        ASSERT_EQ(derivative->degree(), 2 * curve.degree());
        ASSERT_EQ(derivative->domain(), curve.domain());
        ASSERT_LE(relativeDifference(curve, 1, *derivative, 0, random), 1e-12);
        ASSERT_LE(relativeDifference(curve, 2, *derivative, 1, random), 1e-10);
    }
}

TEST(Hodograph, OfAPolygonIsItsEdgesOneByOne) {
    const auto curve = BsplineCurve::make(KnotVector::uniform(1, 3, Form::clamped).value(),
                                          {{0, 0, 0}, {1, 2, 0}, {4, 2, 0}}, 2, {2, 2, 2});
    const auto derivative = derivativeCurve(*curve).value();
    EXPECT_EQ(derivative.degree(), 1);
    EXPECT_EQ(rowOf(derivative, 0.5, Side::right, 0), Vec3(1, 2, 0));
    EXPECT_EQ(rowOf(derivative, 1, Side::left, 0), Vec3(1, 2, 0));
    EXPECT_EQ(rowOf(derivative, 1, Side::right, 0), Vec3(3, 0, 0));
    EXPECT_EQ(rowOf(derivative, 1.7, Side::right, 1), Vec3(0));
}

TEST(Hodograph, OfARationalCurveOfDegreeThirteenIsNotSupported) {
    RandomSplines random(99);
    const auto curve =
        random.curve(Form::clamped, SplineKind{.minDegree = 13, .maxDegree = 13, .rational = true});
    const auto made = derivativeCurve(curve);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, Code::notSupported);
    EXPECT_EQ(made.error().path, "degree");
}

TEST(Hodograph, OfWeightsWhoseSquaresAreTooFarApartIsNotSupported) {
    const auto of = [](double least, double most) {
        return derivativeCurve(BsplineCurve::make(KnotVector::uniform(2, 3, Form::clamped).value(),
                                                  {{0, 0, 0}, {1, 2, 0}, {4, 2, 0}}, 2,
                                                  {least, 1, most})
                                   .value());
    };
    EXPECT_TRUE(of(1e-4, 1e4).ok());
    const auto made = of(1e-6, 1e6);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, Code::notSupported);
    EXPECT_EQ(made.error().path, "weights[0]");
}

// --- factor matrices --------------------------------------------------------------------------

/// rows × columns times columns.
std::vector<Vec3> times(const std::vector<double>& matrix, const std::vector<Vec3>& vector) {
    std::vector<Vec3> result(matrix.size() / vector.size(), Vec3(0));
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        result[i / vector.size()] += matrix[i] * vector[i % vector.size()];
    }
    return result;
}

std::vector<Vec3> activePoints(const BsplineCurve& curve, double t) {
    const KnotVector& knots = curve.knotVector();
    const std::size_t span = knots.findSpan(knots.wrap(t));
    std::vector<Vec3> active;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(curve.degree()); ++j) {
        active.push_back(curve.points()[knots.pointIndex(span, j)]);
    }
    return active;
}

TEST(FactorMatrices, MultiplyToThePointAndTheDerivatives) {
    RandomSplines random(100);
    for (int round = 0; round < 300; ++round) {
        const BsplineCurve curve = random.curve(random.form());
        const auto degree = static_cast<std::size_t>(curve.degree());
        for (const double t : test::telltaleParameters(curve.knotVector(), random, 5)) {
            const auto matrices = factorMatrices(curve.knotVector(), t);
            ASSERT_EQ(matrices.size(), degree);
            // T'_k from the differences of T_k at two parameters of the span: it is affine in t.
            const Interval whole = curve.domain();
            const KnotVector& knots = curve.knotVector();
            const std::size_t span = knots.findSpan(knots.wrap(t));
            const double u = knots.extended()[span];
            const double v = knots.extended()[span + 1];
            const double p = u + 0.25 * (v - u);
            const double q = u + 0.75 * (v - u);
            const auto low = factorMatrices(knots, p);
            const auto high = factorMatrices(knots, q);
            for (std::size_t order = 0; order <= std::min<std::size_t>(degree, 3); ++order) {
                std::vector<Vec3> product = activePoints(curve, t);
                double factor = 1;
                for (std::size_t k = degree; k >= 1; --k) {
                    ASSERT_EQ(matrices[k - 1].size(), k * (k + 1));
                    std::vector<double> matrix = matrices[k - 1];
                    if (k + order > degree) {
                        factor *= static_cast<double>(k);
                        for (std::size_t i = 0; i < matrix.size(); ++i) {
                            matrix[i] = (high[k - 1][i] - low[k - 1][i]) / (q - p);
                        }
                    }
                    product = times(matrix, product);
                }
                const Side side =
                    !curve.closed() && t == whole.end ? Side::left : Side::right;
                const Vec3 expected = rowOf(curve, t, side, order);
                ASSERT_LE(glm::length(factor * product[0] - expected),
                          1e-12 * std::pow(100.0, static_cast<double>(order)) *
                              std::max(1.0, glm::length(expected)));
            }
        }
    }
}

}  // namespace
}  // namespace knotwork
