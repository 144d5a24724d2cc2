// The identities of B-splines on random ones, from both sides of every knot.
#include "properties/generators.hpp"
#include "properties/property.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/bspline_kernels.hpp"
#include "geometry/piecewise_polynomial.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace knotwork {
namespace {

using test::parametersOf;
using test::SplineCase;
using Complex = std::complex<double>;
namespace gates = test::gates;

std::vector<Vec3> rowsAt(const BsplineCurve& curve, double t, Side side, std::size_t count) {
    std::vector<Vec3> rows(count);
    curve.derivatives(t, side, rows);
    return rows;
}

std::vector<double> basisAt(const KnotVector& knots, double t, Side side, int derivatives) {
    std::vector<double> rows(static_cast<std::size_t>(knots.pointCount() * (derivatives + 1)));
    basisRows(knots, t, side, derivatives, rows);
    return rows;
}

/// De Boor's algorithm on the span of one side, in homogeneous coordinates x, y, z, w of any kind.
template <class Scalar>
std::array<Scalar, 4> deBoor(const SplineCase& spline, const KnotVector& knots, std::size_t span,
                             const Scalar& t) {
    const auto degree = static_cast<std::size_t>(knots.degree());
    std::array<Scalar, 4> point;
    for (int axis = 0; axis < 4; ++axis) {
        std::vector<Scalar> active;
        for (std::size_t j = 0; j <= degree; ++j) {
            const std::size_t i = knots.pointIndex(span, j);
            const double weight = spline.weights.empty() ? 1 : spline.weights[i];
            active.emplace_back(axis == 3 ? weight : weight * spline.points[i][axis]);
        }
        point[static_cast<std::size_t>(axis)] =
            kernels::deBoor(knots.extended(), degree, span, t, std::span<Scalar>(active));
    }
    return point;
}

/// How large the order-th derivative could be here: the basis' derivatives, all of one sign.
double derivativeSize(const KnotVector& knots, double t, Side side, int order) {
    const auto n = static_cast<std::size_t>(knots.pointCount());
    const std::vector<double> rows = basisAt(knots, t, side, order);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
        sum += std::abs(rows[static_cast<std::size_t>(order) * n + i]);
    return sum;
}

template <class Values>
double largestOf(const Values& values) {
    double largest = 0;
    for (const auto& value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

/// What a complex step through values of size 1 loses on a short span: it sees their rounding
/// errors, divided by the span. The derivatives under test have no such error.
double stepNoise(const KnotVector& knots, std::size_t span) {
    const auto t = knots.extended();
    return 100 * std::numeric_limits<double>::epsilon() / (t[span + 1] - t[span]);
}

TEST(SplineProperty, TheBasisIsAPartitionOfUnityAndNotNegative) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline();
        const KnotVector knots = spline.knotVector();
        for (const double t : parametersOf(knots)) {
            for (const Side side : test::bothSides) {
                const std::vector<double> row = basisAt(knots, t, side, 0);
                double sum = 0;
                for (const double value : row) {
                    RC_ASSERT(value >= 0);
                    sum += value;
                }
                RC_ASSERT(std::abs(sum - 1) <= gates::partitionOfUnity);
            }
        }
    });
}

TEST(SplineProperty, TheBasisFormAgreesWithDeBoorsAlgorithmFromBothSides) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline();
        const BsplineCurve curve = spline.curve();
        const KnotVector& knots = curve.knotVector();
        for (const double t : parametersOf(knots)) {
            for (const Side side : test::bothSides) {
                const double inside = knots.wrap(t, side);
                const auto [x, y, z, w] =
                    deBoor<double>(spline, knots, knots.findSpan(inside, side), inside);
                const Vec3 expected = Vec3(x, y, z) / w;
                const Vec3 found = rowsAt(curve, t, side, 1)[0];
                RC_ASSERT(glm::length(found - expected) <= gates::basisAgainstDeBoor);
                const std::vector<double> basis = basisAt(knots, t, side, 0);
                Vec3 sum(0);
                double weights = 0;
                for (std::size_t i = 0; i < basis.size(); ++i) {
                    const double weight = spline.weights.empty() ? 1 : spline.weights[i];
                    sum += basis[i] * weight * spline.points[i];
                    weights += basis[i] * weight;
                }
                RC_ASSERT(glm::length(sum / weights - expected) <= gates::basisAgainstDeBoor);
            }
        }
    });
}

TEST(SplineProperty, FirstDerivativesAgreeWithTheComplexStepThroughDeBoorsAlgorithm) {
    constexpr double step = 1e-40;
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline();
        const BsplineCurve curve = spline.curve();
        const KnotVector& knots = curve.knotVector();
        for (const double t : parametersOf(knots)) {
            for (const Side side : test::bothSides) {
                const double inside = knots.wrap(t, side);
                const std::size_t span = knots.findSpan(inside, side);
                const auto [x, y, z, w] =
                    deBoor<Complex>(spline, knots, span, Complex(inside, step));
                const Vec3 expected((x / w).imag() / step, (y / w).imag() / step,
                                    (z / w).imag() / step);
                const Vec3 found = rowsAt(curve, t, side, 2)[1];
                const double size = derivativeSize(knots, t, side, 1);
                RC_ASSERT(glm::length(found - expected) <=
                          gates::complexStep * size + stepNoise(knots, span));
            }
        }
    });
}

TEST(SplineProperty, EveryDerivativeOfTheBasisIsTheComplexStepOfTheOneBelow) {
    constexpr double step = 1e-40;
    test::holds(300, [] {
        const SplineCase spline = *test::anySpline({.nearlyEqualKnots = false});
        const KnotVector knots = spline.knotVector();
        const auto degree = static_cast<std::size_t>(knots.degree());
        std::vector<double> rows((degree + 2) * (degree + 1));
        std::vector<Complex> lower(degree + 1);
        for (const double t : parametersOf(knots)) {
            for (const Side side : test::bothSides) {
                const double inside = knots.wrap(t, side);
                const std::size_t span = knots.findSpan(inside, side);
                basisDerivatives(knots, span, inside, knots.degree() + 1, rows);
                for (std::size_t order = 1; order <= degree + 1; ++order) {
                    kernels::basisDerivative(knots.extended(), degree, span, order - 1,
                                             Complex(inside, step), std::span(lower));
                    const auto row = std::span(rows).subspan(order * (degree + 1), degree + 1);
                    for (std::size_t j = 0; j <= degree; ++j) {
                        const double expected = lower[j].imag() / step;
                        RC_ASSERT(std::abs(row[j] - expected) <=
                                  gates::complexStep * largestOf(row));
                    }
                }
            }
        }
    });
}

TEST(SplineProperty, AtAKnotOfMultiplicityMTheFirstDegreeMinusMDerivativesAreContinuous) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline({.nearlyEqualKnots = false});
        const BsplineCurve curve = spline.curve();
        const KnotVector& knots = curve.knotVector();
        const Interval domain = knots.domain();
        for (const double t : knots.knots()) {
            const bool inner = domain.start < t && t < domain.end;
            if (!inner && !(curve.closed() && t == domain.start)) continue;
            const int smooth = knots.degree() - knots.multiplicity(t);
            if (smooth < 0) continue;
            const auto count = static_cast<std::size_t>(smooth) + 1;
            const auto left = rowsAt(curve, t, Side::left, count);
            const auto right = rowsAt(curve, t, Side::right, count);
            for (std::size_t k = 0; k < count; ++k) {
                const int order = static_cast<int>(k);
                const double size = derivativeSize(knots, t, Side::left, order) +
                                    derivativeSize(knots, t, Side::right, order);
                // The quotient rule of a rational one multiplies by the derivatives of the weight.
                const double gate = curve.rational() ? gates::rationalJumps : gates::refinement;
                RC_ASSERT(glm::length(left[k] - right[k]) <= gate * (1 + size));
            }
        }
    });
}

TEST(SplineProperty, APointMovesTheCurveOnlyOnTheSupportOfItsFunction) {
    test::holds(1000, [] {
        SplineCase spline = *test::anySpline();
        const BsplineCurve before = spline.curve();
        const KnotVector& knots = before.knotVector();
        const std::vector<double> ts = parametersOf(knots);
        const int moved = *test::whole(0, static_cast<int>(spline.points.size()) - 1);
        spline.points[static_cast<std::size_t>(moved)].x += 1;
        const BsplineCurve after = spline.curve();
        for (const double t : ts) {
            for (const Side side : test::bothSides) {
                const double weight = basisAt(knots, t, side, 0)[static_cast<std::size_t>(moved)];
                const Vec3 change = rowsAt(after, t, side, 1)[0] - rowsAt(before, t, side, 1)[0];
                if (weight == 0) RC_ASSERT(change == Vec3(0));
                if (spline.weights.empty()) {
                    RC_ASSERT(std::abs(change.x - weight) <= gates::basisAgainstDeBoor);
                }
            }
        }
    });
}

TEST(SplineProperty, TheCurveLiesBetweenTheActivePointsInEveryCoordinate) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline();
        const BsplineCurve curve = spline.curve();
        const KnotVector& knots = curve.knotVector();
        for (const double t : parametersOf(knots)) {
            const double inside = knots.wrap(t);
            const std::size_t span = knots.findSpan(inside);
            const Vec3 point = curve.point(t);
            for (int axis = 0; axis < 3; ++axis) {
                double least = 2;
                double most = -2;
                for (std::size_t j = 0; j <= static_cast<std::size_t>(knots.degree()); ++j) {
                    const double value = spline.points[knots.pointIndex(span, j)][axis];
                    least = std::min(least, value);
                    most = std::max(most, value);
                }
                RC_ASSERT(point[axis] >= least - gates::exact);
                RC_ASSERT(point[axis] <= most + gates::exact);
            }
        }
    });
}

TEST(SplineProperty, AnAffineMapOfThePointsIsOneOfTheCurve) {
    test::holds(1000, [] {
        SplineCase spline = *test::anySpline();
        spline.dimension = 3;
        const BsplineCurve before = spline.curve();
        const std::vector<double> ts = parametersOf(before.knotVector());
        const Mat3 linear(*test::spacePoint(1, 3), *test::spacePoint(1, 3),
                          *test::spacePoint(1, 3));
        const Vec3 offset = *test::spacePoint(1, 3);
        for (Vec3& point : spline.points) point = linear * point + offset;
        const BsplineCurve after = spline.curve();
        for (const double t : ts) {
            for (const Side side : test::bothSides) {
                const auto from = rowsAt(before, t, side, 2);
                const auto to = rowsAt(after, t, side, 2);
                RC_ASSERT(glm::length(linear * from[0] + offset - to[0]) <= gates::refinement);
                const double size = 1 + derivativeSize(before.knotVector(), t, side, 1);
                RC_ASSERT(glm::length(linear * from[1] - to[1]) <= gates::refinement * 4 * size);
            }
        }
    });
}

TEST(SplineProperty, ClampedCurvesBeginAndEndInTheirEndPointsExactly) {
    test::holds(1000, [] {
        SplineCase spline = *test::anySpline();
        RC_PRE(spline.form == Form::clamped);
        const BsplineCurve curve = spline.curve();
        const Interval domain = curve.domain();
        const double gate = curve.rational() ? gates::exact : 0;
        for (const Side side : test::bothSides) {
            const Vec3 start = rowsAt(curve, domain.start, side, 1)[0];
            const Vec3 end = rowsAt(curve, domain.end, side, 1)[0];
            RC_ASSERT(glm::length(start - spline.points.front()) <= gate);
            RC_ASSERT(glm::length(end - spline.points.back()) <= gate);
        }
    });
}

TEST(SplineProperty, AClosedCurveRepeatsItselfWithItsPeriod) {
    test::holds(1000, [] {
        SplineCase spline = *test::anySpline();
        RC_PRE(spline.form == Form::closed);
        const BsplineCurve curve = spline.curve();
        const KnotVector& knots = curve.knotVector();
        const Interval domain = knots.domain();
        RC_ASSERT(curve.point(domain.end) == curve.point(domain.start));
        for (const double t : parametersOf(knots)) {
            for (const Side side : test::bothSides) {
                const double inside = knots.wrap(t + 3 * knots.period(), side);
                // Where rounding took the parameter across a knot there is nothing to compare.
                if (knots.findSpan(inside, side) != knots.findSpan(knots.wrap(t, side), side))
                    continue;
                const double slope = std::max(derivativeSize(knots, t, side, 1),
                                              derivativeSize(knots, inside, side, 1));
                const Vec3 found = rowsAt(curve, t + 3 * knots.period(), side, 1)[0];
                const double shift = std::abs(inside - knots.wrap(t, side));
                RC_ASSERT(shift <= 1e-13 * (1 + std::abs(t) + 3 * knots.period()));
                RC_ASSERT(glm::length(found - rowsAt(curve, t, side, 1)[0]) <=
                          gates::refinement + 12 * slope * shift);
            }
        }
    });
}

TEST(SplineProperty, SamplesAgreeWithTheCurveAtKnotsEndsAndTheirNeighbours) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline({.size = 20});
        const BsplineCurve curve = spline.curve();
        const std::vector<double> ts = parametersOf(curve.knotVector());
        std::vector<double> xyz(3 * ts.size());
        const BsplineSampler sampler(curve);
        sampler.at(ts, 0, xyz);
        const double gate = gates::unevenSpans * (curve.rational()      ? gates::rationalSamples
                                                  : curve.degree() <= 3 ? gates::cubicSamples
                                                                        : gates::powerSamples);
        for (std::size_t i = 0; i < ts.size(); ++i) {
            const Vec3 expected = curve.point(ts[i]);
            for (int axis = 0; axis < 3; ++axis) {
                const double found = xyz[3 * i + static_cast<std::size_t>(axis)];
                RC_ASSERT(std::abs(found - expected[axis]) <= gate);
            }
        }
        constexpr std::size_t total = 17;
        std::vector<double> uniform(3 * total);
        sampler.uniform(0, total, total, uniform);
        for (std::size_t i = 0; i < total; ++i) {
            const Vec3 expected = curve.point(uniformParameter(curve.domain(), i, total));
            RC_ASSERT(std::abs(uniform[3 * i] - expected.x) <= gate);
        }
    });
}

TEST(SplineProperty, GrevilleAbscissaeReproduceTheParameter) {
    test::holds(1000, [] {
        const SplineCase spline = *test::anySpline();
        RC_PRE(spline.form != Form::closed);
        const KnotVector knots = spline.knotVector();
        const std::vector<double> greville = knots.grevilles();
        for (const double t : parametersOf(knots)) {
            const std::vector<double> row = basisAt(knots, t, Side::right, 0);
            double sum = 0;
            for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * greville[i];
            RC_ASSERT(std::abs(sum - t) <= 50 * gates::partitionOfUnity);
        }
    });
}

}  // namespace
}  // namespace knotwork
