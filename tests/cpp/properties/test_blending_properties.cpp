// The theorems of blending curves (formulas in blending_curve.hpp) on random models, knots,
// poses and B-functions.
#include "properties/generators.hpp"
#include "properties/property.hpp"

#include "geometry/quadrature.hpp"
#include "support/blending_gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace knotwork {
namespace {

using test::BlendingCase;
namespace gates = test::gates;

constexpr std::size_t rowCount = 5;
using Rows = std::array<Vec3, rowCount>;

Rows rowsAt(const BlendingCurve& curve, double t, Side side) {
    Rows rows;
    curve.evaluate(t, side, rows);
    return rows;
}

Rows rowsAt(const LocalCurve& local, double t, Side side) {
    Rows rows;
    local.evaluate(t, side, rows);
    return rows;
}

std::vector<double> parametersOf(const BlendingCurve& curve) {
    return *test::parametersOf(curve.domain(), curve.knots());
}

/// The local centred at knot i, and the parameter at which it is evaluated there.
struct Centre {
    const LocalCurve* local;
    double t;
};

Centre centreOf(const BlendingCurve& curve, std::size_t i) {
    const bool wraps = i == curve.locals().size();  // the end of a closed curve's period
    return {&curve.locals()[wraps ? 0 : i], wraps ? curve.domain().start : curve.knots()[i]};
}

/// The span beside knot i, or 0 where there is none on that side.
double spanBeside(const BlendingCurve& curve, std::size_t i, Side side) {
    const auto& knots = curve.knots();
    if (side == Side::right) return i + 1 < knots.size() ? knots[i + 1] - knots[i] : 0;
    return i > 0 ? knots[i] - knots[i - 1] : 0;
}

double hermiteOrder(const BFunction& blend, Side side) {
    return blend.order()[side == Side::right ? 0 : 1];
}

/// Derivatives up to the order-th are of this size here: what is compared is compared with that.
double sizeOf(const BlendingCurve& curve, double t, Side side, std::size_t order, double span) {
    double size = 1;
    const Rows rows = rowsAt(curve, t, side);
    for (std::size_t k = 0; k <= order; ++k) size = std::max(size, glm::length(rows[k]));
    return size * std::max(1.0, std::pow(span, -static_cast<double>(order)));
}

// (a) of MATH 3.3.
TEST(BlendingProperty, AtAKnotTheCurveHasTheDerivativesOfItsLocalUpToTheHermiteOrder) {
    test::holds(500, [] {
        const BlendingCurve curve = BlendingCase(*test::anyBlending()).curve();
        for (std::size_t i = 0; i < curve.knots().size(); ++i) {
            for (const Side side : test::bothSides) {
                const double span = spanBeside(curve, i, side);
                if (span == 0) continue;
                const double t = curve.knots()[i];
                const Centre centre = centreOf(curve, i);
                const Rows found = rowsAt(curve, t, side);
                const Rows expected = rowsAt(*centre.local, centre.t, side);
                for (std::size_t k = 0; k < rowCount; ++k) {
                    if (static_cast<double>(k) > hermiteOrder(curve.blend(), side)) break;
                    RC_ASSERT(glm::length(found[k] - expected[k]) <=
                              gates::hermite * sizeOf(curve, t, side, k, span));
                }
            }
        }
    });
}

// (b) and (f): the first derivative that jumps does so by B^(s+1)(0) g_R/h_R^(s+1) on the right
// less B^(s+1)(1) g_L/h_L^(s+1) on the left; here each side against the local alone.
TEST(BlendingProperty, TheFirstDerivativeBeyondTheHermiteOrderLeavesTheLocalByTheFormula) {
    test::holds(500, [] {
        const BlendingCurve curve = BlendingCase(*test::anyBlending()).curve();
        for (std::size_t i = 0; i < curve.knots().size(); ++i) {
            for (const Side side : test::bothSides) {
                const double span = spanBeside(curve, i, side);
                const double order = hermiteOrder(curve.blend(), side);
                if (span == 0 || order + 1 >= rowCount || !curve.blend().smooth()) continue;
                const auto k = static_cast<std::size_t>(order) + 1;
                const double t = curve.knots()[i];
                const Centre here = centreOf(curve, i);
                const Centre other = centreOf(curve, side == Side::right ? i + 1 : i - 1);
                // The neighbour is seen here a span away from its own centre.
                const double there = other.t + (side == Side::right ? -span : span);
                std::array<double, rowCount> blend{};
                curve.blend().derivatives(side == Side::right ? 0 : 1, blend);
                const Vec3 gap =
                    rowsAt(*other.local, there, side)[0] - rowsAt(*here.local, here.t, side)[0];
                const double sign = side == Side::right ? 1 : -1;
                const Vec3 expected = rowsAt(*here.local, here.t, side)[k] +
                                      sign * blend[k] * gap / std::pow(span, k);
                RC_ASSERT(glm::length(rowsAt(curve, t, side)[k] - expected) <=
                          gates::hermite * sizeOf(curve, t, side, k, span));
            }
        }
    });
}

// (c)
TEST(BlendingProperty, LocalsThatAreAllOneCurveReproduceItWhateverTheBFunction) {
    test::holds(300, [] {
        BlendingCase blending = *test::anyBlending();
        blending.poses.assign(blending.count, Pose{});
        const bool periodic = isClosed(blending.model);
        if (!periodic) blending.form = BlendForm::open;
        if (!periodic && blending.knots.size() > blending.count) blending.knots.pop_back();
        const BlendingCurve curve = blending.curve();
        for (const double t : parametersOf(curve)) {
            for (const Side side : test::bothSides) {
                Rows expected;
                evaluate(blending.model, t, side, expected);
                const Rows found = rowsAt(curve, t, side);
                // A derivative of B without bounds multiplies the rounding of c_i − c_{i−1}.
                const std::size_t orders = curve.blend().smooth() ? 3 : 1;
                for (std::size_t k = 0; k < orders; ++k) {
                    const double size = 1 + glm::length(expected[k]);
                    RC_ASSERT(glm::length(found[k] - expected[k]) <= gates::reproduction * size);
                }
            }
        }
    });
}

/// The same blend of locals that are given one by one.
BlendingCurve ofLocals(const BlendingCase& blending, std::vector<Curve> locals) {
    return BlendingCurve::fromLocals(std::move(locals), blending.form, blending.blend.function,
                                     blending.knots, false, {})
        .value();
}

/// A straight or bent spline: what a map of its points does to it is known.
std::vector<Vec3> anyPoints() {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back(*test::spacePoint(1, 3));
    return points;
}

Curve cubic(std::vector<Vec3> points, const Interval& over) {
    std::vector<double> knots(4, over.start);
    knots.insert(knots.end(), 4, over.end);
    auto vector = KnotVector::make(std::move(knots), 3, 4, Form::clamped).value();
    return Curve(BsplineCurve::make(std::move(vector), std::move(points), 3).value());
}

// (d)
TEST(BlendingProperty, AnAffineMapOfTheLocalsIsOneOfTheCurve) {
    test::holds(200, [] {
        const BlendingCase blending = *test::anyBlending();
        const Mat3 linear(*test::spacePoint(1, 3), *test::spacePoint(1, 3),
                          *test::spacePoint(1, 3));
        const Vec3 offset = *test::spacePoint(1, 3);
        const Interval over{blending.knots.front(), blending.knots.back()};
        std::vector<Curve> locals;
        std::vector<Curve> mapped;
        for (std::size_t j = 0; j < blending.count; ++j) {
            std::vector<Vec3> points = anyPoints();
            locals.push_back(cubic(points, over));
            for (Vec3& point : points) point = linear * point + offset;
            mapped.push_back(cubic(points, over));
        }
        const BlendingCurve before = ofLocals(blending, std::move(locals));
        const BlendingCurve after = ofLocals(blending, std::move(mapped));
        for (const double t : parametersOf(before)) {
            for (const Side side : test::bothSides) {
                const Vec3 expected = linear * rowsAt(before, t, side)[0] + offset;
                const double size = 1 + glm::length(expected);
                RC_ASSERT(glm::length(rowsAt(after, t, side)[0] - expected) <=
                          gates::reproduction * size);
            }
        }
    });
}

// (e)
TEST(BlendingProperty, APoseChangesTheCurveOnlyOnTheSupportOfItsLocal) {
    test::holds(300, [] {
        BlendingCase blending = *test::anyBlending();
        const BlendingCurve before = blending.curve();
        const auto moved =
            static_cast<std::size_t>(*test::whole(0, static_cast<int>(blending.count) - 1));
        blending.poses[moved].translate += Vec3(1, 2, 0);
        const BlendingCurve after = before.withPoses(blending.poses);
        const std::vector<double> ts = parametersOf(before);
        for (const double t : ts) {
            const double weight = before.blendBasis(t)[moved];
            Vec3 change = pointAt(Curve(after), t) - pointAt(Curve(before), t);
            if (weight == 0) RC_ASSERT(change == Vec3(0));
            const double size = 1 + glm::length(pointAt(Curve(before), t));
            RC_ASSERT(glm::length(change - weight * Vec3(1, 2, 0)) <= gates::reproduction * size);
        }
    });
}

TEST(BlendingProperty, WeightsAreNotNegativeAndSumToOneAndAtAKnotItsLocalHasItAll) {
    test::holds(300, [] {
        const BlendingCurve curve = BlendingCase(*test::anyBlending()).curve();
        for (const double t : parametersOf(curve)) {
            double sum = 0;
            int active = 0;
            for (const double weight : curve.blendBasis(t)) {
                RC_ASSERT(weight >= 0);
                sum += weight;
                active += weight > 0 ? 1 : 0;
            }
            RC_ASSERT(std::abs(sum - 1) <= gates::weights);
            RC_ASSERT(active <= 2);
        }
        for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i) {
            if (spanBeside(curve, i, Side::right) > 0) {
                RC_ASSERT(curve.blendBasis(curve.knots()[i])[i] == 1);
            }
        }
    });
}

TEST(BlendingProperty, AClosedCurveRepeatsItselfWithItsPeriodAndMeetsItsBeginning) {
    test::holds(300, [] {
        const BlendingCase blending = *test::anyBlending();
        RC_PRE(blending.form == BlendForm::closed);
        const BlendingCurve curve = blending.curve();
        const Interval domain = curve.domain();
        const Vec3 start = rowsAt(curve, domain.start, Side::right)[0];
        RC_ASSERT(rowsAt(curve, domain.end, Side::right)[0] == start);
        if (spanBeside(curve, curve.locals().size(), Side::left) > 0 &&
            spanBeside(curve, 0, Side::right) > 0) {
            const Vec3 end = rowsAt(curve, domain.end, Side::left)[0];
            RC_ASSERT(glm::length(end - start) <= gates::reproduction * (1 + glm::length(start)));
        }
        for (int k = 0; k < 5; ++k) {
            const double t = domain.start + domain.length() * std::abs(*test::real(1));
            const Rows here = rowsAt(curve, t, Side::right);
            const Rows turns = rowsAt(curve, t + 2 * domain.length(), Side::right);
            const double size = 1 + glm::length(here[0]) + glm::length(here[1]);
            RC_ASSERT(glm::length(here[0] - turns[0]) <= gates::wrapped * size);
        }
    });
}

TEST(BlendingProperty, DifferencesWithinASpanAreIntegralsOfTheDerivatives) {
    test::holds(200, [] {
        const BlendingCurve curve = BlendingCase(*test::anyBlending()).curve();
        RC_PRE(curve.blend().smooth());
        for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i) {
            const double h = spanBeside(curve, i, Side::right);
            if (h == 0) continue;
            const double from = curve.knots()[i] + (0.05 + 0.8 * std::abs(*test::real(1))) * h;
            const double to = from + 0.05 * h;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto next = [&](double t) { return rowsAt(curve, t, Side::right)[k + 1].x; };
                const auto size = [&](double t) { return std::abs(next(t)); };
                const double change =
                    rowsAt(curve, to, Side::right)[k].x - rowsAt(curve, from, Side::right)[k].x;
                const double scale = 1 + integrateGauss<16>(size, from, to);
                RC_ASSERT(std::abs(change - integrateGauss<16>(next, from, to)) <=
                          gates::blendIntegrals * scale);
            }
        }
    });
}

}  // namespace
}  // namespace knotwork
