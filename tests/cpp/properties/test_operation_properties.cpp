// Operations on random B-spline curves: what they promise to keep, from both sides of every knot
// and at both ends.
#include "properties/generators.hpp"
#include "properties/property.hpp"

#include "geometry/bezier_piece.hpp"
#include "geometry/bspline_operations.hpp"
#include "geometry/degree_elevation.hpp"
#include "geometry/factor_matrices.hpp"
#include "geometry/hodograph.hpp"
#include "geometry/knot_removal.hpp"
#include "geometry/oslo.hpp"
#include "geometry/refinement.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace knotwork {
namespace {

using test::parametersOf;
using test::pointOf;
using test::SplineCase;
namespace gates = test::gates;

double apart(const BsplineCurve& a, double s, const BsplineCurve& b, double t, Side side) {
    return glm::length(pointOf(a, s, side) - pointOf(b, t, side));
}

/// Both are the same curve, looked at where either has knots.
void expectSameCurve(const BsplineCurve& a, const BsplineCurve& b, double gate) {
    RC_ASSERT(a.domain() == b.domain());
    for (const BsplineCurve* curve : {&a, &b}) {
        for (const double t : parametersOf(curve->knotVector())) {
            for (const Side side : test::bothSides) RC_ASSERT(apart(a, t, b, t, side) <= gate);
        }
    }
}

BsplineCurve anyCurve(const test::SplineOptions& options = {}) {
    return SplineCase(*test::anySpline(options)).curve();
}

/// The knots with up to eight more, some of them where there are knots already.
std::vector<double> anyRefinement(const KnotVector& knots) {
    std::vector<double> refined(knots.knots().begin(), knots.knots().end());
    const Interval domain = knots.domain();
    for (int i = *test::whole(1, 8); i > 0; --i) {
        double t = domain.start + domain.length() * (0.001 + 0.998 * std::abs(*test::real(1)));
        const double old = refined[static_cast<std::size_t>(
            *test::whole(0, static_cast<int>(refined.size()) - 1))];
        if (*test::whole(0, 2) == 0 && domain.start < old && old < domain.end) t = old;
        refined.insert(std::upper_bound(refined.begin(), refined.end(), t), t);
    }
    return refined;
}

TEST(OperationProperty, AllRefinementsAgreeAndKeepTheCurve) {
    test::holds(600, [] {
        const BsplineCurve curve = anyCurve();
        const std::vector<double> refined = anyRefinement(curve.knotVector());
        const auto quick = refineByOslo(curve, refined);
        const auto one = refineByOslo1(curve, refined);
        const auto two = refineByOslo2(curve, refined);
        const auto boehm = refineByBoehm(curve, refined);
        RC_ASSERT(one.ok() == quick.ok());
        RC_ASSERT(one.ok() == two.ok());
        RC_ASSERT(one.ok() == boehm.ok());
        RC_PRE(one.ok());  // not too near to a knot, nor too often
        for (std::size_t j = 0; j < one->points().size(); ++j) {
            RC_ASSERT(glm::length(one->points()[j] - quick->points()[j]) <=
                      gates::osloAgainstBoehm);
            RC_ASSERT(glm::length(one->points()[j] - two->points()[j]) <= gates::osloAgainstBoehm);
            RC_ASSERT(glm::length(one->points()[j] - boehm->points()[j]) <=
                      gates::osloAgainstBoehm);
        }
        expectSameCurve(curve, *one, gates::refinement);
    });
}

TEST(OperationProperty, RowsOfTheOsloMatrixAreNotNegativeAndSumToOneWithDegreePlusOneNumbers) {
    test::holds(300, [] {
        const KnotVector knots = SplineCase(*test::anySpline()).knotVector();
        const auto refined = refinedKnots(knots, anyRefinement(knots));
        RC_PRE(refined.ok());
        const std::vector<double> matrix = osloMatrix(knots, *refined);
        const auto n = static_cast<std::size_t>(knots.pointCount());
        for (std::size_t j = 0; j * n < matrix.size(); ++j) {
            double sum = 0;
            int present = 0;
            for (std::size_t i = 0; i < n; ++i) {
                RC_ASSERT(matrix[j * n + i] >= 0);
                sum += matrix[j * n + i];
                present += matrix[j * n + i] > 0 ? 1 : 0;
            }
            RC_ASSERT(std::abs(sum - 1) <= gates::partitionOfUnity);
            RC_ASSERT(present <= knots.degree() + 1);
        }
    });
}

TEST(OperationProperty, AKnotThatWasInsertedCanBeRemovedAndOneThatIsNeededCannot) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.nearlyEqualKnots = false});
        const Interval domain = curve.domain();
        const double t = domain.start + domain.length() * (0.05 + 0.9 * std::abs(*test::real(1)));
        const auto refined = insertKnot(curve, t, 1);
        RC_PRE(refined.ok());
        const auto removed = removeKnot(*refined, t, 1e-9);
        RC_ASSERT(removed.ok());
        RC_ASSERT(removed->removed);
        RC_ASSERT(removed->deviation <= 1e-9);
        expectSameCurve(curve, removed->curve, 1e-9);
    });
}

TEST(OperationProperty, TheDeviationOfARemovalBoundsTheDistance) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.nearlyEqualKnots = false});
        const auto knots = curve.knotVector().knots();
        const double t =
            knots[static_cast<std::size_t>(*test::whole(0, static_cast<int>(knots.size()) - 1))];
        RC_PRE(curve.domain().start < t && t < curve.domain().end);
        const auto removed = removeKnotAnyway(curve, t);
        RC_PRE(removed.ok());
        RC_PRE(removed->removed);
        for (const double at : parametersOf(curve.knotVector())) {
            for (const Side side : test::bothSides) {
                RC_ASSERT(apart(curve, at, removed->curve, at, side) <=
                          removed->deviation * (1 + 1e-9) + gates::refinement);
            }
        }
    });
}

TEST(OperationProperty, ElevatingTheDegreeKeepsTheCurveAndItsDomain) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.maxDegree = 5});
        const int by = *test::whole(1, 3);
        const auto elevated = elevateDegree(curve, by);
        RC_ASSERT(elevated.ok());
        RC_ASSERT(elevated->degree() == curve.degree() + by);
        expectSameCurve(curve, *elevated, gates::refinement);
    });
}

TEST(OperationProperty, ThePartsOfASplitAreTheCurve) {
    test::holds(400, [] {
        const BsplineCurve curve = anyCurve();
        const Interval domain = curve.domain();
        const double t = domain.start + domain.length() * std::abs(*test::real(1));
        const auto parts = split(curve, t);
        RC_PRE(parts.ok());
        RC_ASSERT(parts->size() == (curve.closed() ? 1u : 2u));
        for (const BsplineCurve& part : *parts) {
            const Interval own = part.domain();
            for (const double at : parametersOf(part.knotVector())) {
                for (const Side side : test::bothSides) {
                    if (curve.closed() && at > domain.end) continue;  // a period on: rounded
                    if ((at == own.start && side == Side::left) ||
                        (at == own.end && side == Side::right)) {
                        continue;  // the other side belongs to the other part
                    }
                    RC_ASSERT(apart(part, at, curve, at, side) <= gates::refinement);
                }
            }
        }
    });
}

TEST(OperationProperty, ReversedTwiceACurveIsItselfAndOnceItRunsBackwards) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.nearlyEqualKnots = false});
        const auto backwards = reversed(curve);
        RC_ASSERT(backwards.ok());
        const Interval domain = curve.domain();
        for (const double t : {domain.start, domain.start + 0.3 * domain.length(), domain.end}) {
            const double mirrored = domain.start + (domain.end - t);
            const Vec3 there = pointOf(*backwards, mirrored, Side::left);
            RC_ASSERT(glm::length(there - pointOf(curve, t, Side::right)) <= 1e-12);
        }
        const auto again = reversed(*backwards);
        RC_ASSERT(again.ok());
        for (std::size_t i = 0; i < curve.points().size(); ++i) {
            RC_ASSERT(again->points()[i] == curve.points()[i]);
        }
    });
}

TEST(OperationProperty, TheHodographIsTheDerivativeFromBothSides) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.maxDegree = 5, .nearlyEqualKnots = false});
        const auto hodograph = derivativeCurve(curve);
        RC_ASSERT(hodograph.ok());
        for (const double t : parametersOf(curve.knotVector())) {
            for (const Side side : test::bothSides) {
                std::array<Vec3, 2> rows;
                curve.derivatives(t, side, rows);
                const double size = 1 + glm::length(rows[1]);
                RC_ASSERT(glm::length(pointOf(*hodograph, t, side) - rows[1]) <= 1e-10 * size);
            }
        }
    });
}

TEST(OperationProperty, BezierPiecesBeginAndEndOnTheCurve) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve();
        for (const BezierPiece& piece : bezierPieces(curve)) {
            const Homogeneous& first = piece.points.front();
            const Homogeneous& last = piece.points.back();
            const Vec3 start = pointOf(curve, piece.interval.start, Side::right);
            const Vec3 end = pointOf(curve, piece.interval.end, Side::left);
            RC_ASSERT(glm::length(Vec3(first) / first.w - start) <= gates::refinement);
            RC_ASSERT(glm::length(Vec3(last) / last.w - end) <= gates::refinement);
        }
    });
}

TEST(OperationProperty, RowsOfTheFactorMatricesSumToOneAndTheirProductIsTheBasis) {
    test::holds(300, [] {
        const BsplineCurve curve = anyCurve({.rational = false});
        const KnotVector& knots = curve.knotVector();
        for (const double t : parametersOf(knots)) {
            const auto matrices = factorMatrices(knots, t);
            std::vector<double> row{1};
            for (const std::vector<double>& matrix : matrices) {
                std::vector<double> next(row.size() + 1);
                for (std::size_t r = 0; r < row.size(); ++r) {
                    double sum = 0;
                    for (std::size_t c = 0; c < next.size(); ++c) {
                        sum += matrix[r * next.size() + c];
                        next[c] += row[r] * matrix[r * next.size() + c];
                    }
                    RC_ASSERT(std::abs(sum - 1) <= gates::partitionOfUnity);
                }
                row = next;
            }
            const std::size_t span = knots.findSpan(knots.wrap(t));
            Vec3 made(0);
            for (std::size_t j = 0; j < row.size(); ++j) {
                made += row[j] * curve.points()[knots.pointIndex(span, j)];
            }
            RC_ASSERT(glm::length(made - curve.point(t)) <= gates::basisAgainstDeBoor);
        }
    });
}

}  // namespace
}  // namespace knotwork
