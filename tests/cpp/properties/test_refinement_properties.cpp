// Other knots, the same curve: the identities of refinement on random splines of every form.
#include "properties/generators.hpp"
#include "properties/property.hpp"

#include "geometry/refinement.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace knotwork {
namespace {

using test::parametersOf;
using test::pointOf;
using test::SplineCase;
namespace gates = test::gates;

/// Both are the same curve, looked at where either has knots.
void expectSameCurve(const BsplineCurve& a, const BsplineCurve& b) {
    RC_ASSERT(a.domain() == b.domain());
    for (const BsplineCurve* knots : {&a, &b}) {
        for (const double t : parametersOf(knots->knotVector())) {
            for (const Side side : test::bothSides) {
                const double distance = glm::length(pointOf(a, t, side) - pointOf(b, t, side));
                RC_ASSERT(distance <= gates::refinement);
            }
        }
    }
}

/// A parameter at which a knot may be put `times` more, a knot of the curve or another one.
std::pair<double, int> anyInsertion(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const Interval domain = knots.domain();
    double t = domain.start + domain.length() * std::abs(*test::real(1));
    if (*test::whole(0, 1) == 0) {
        const auto all = knots.knots();
        t = all[static_cast<std::size_t>(*test::whole(0, static_cast<int>(all.size()) - 1))];
    }
    const int missing = knots.degree() - knots.multiplicity(t);
    RC_PRE(missing > 0 && domain.contains(t));
    return {t, *test::whole(1, missing)};
}

TEST(RefinementProperty, InsertingAKnotDoesNotMoveTheCurve) {
    test::holds(1000, [] {
        const BsplineCurve curve = test::SplineCase(*test::anySpline()).curve();
        const auto [t, times] = anyInsertion(curve);
        const auto refined = insertKnot(curve, t, times);
        if (!refined.ok()) {  // too near to a knot
            RC_ASSERT(codeName(refined.error().code) == codeName(Code::outOfRange));
            return;
        }
        RC_ASSERT(refined->knotVector().multiplicity(t) ==
                  curve.knotVector().multiplicity(t) + times);
        expectSameCurve(curve, *refined);
    });
}

TEST(RefinementProperty, TheOrderInWhichKnotsAreInsertedDoesNotMatter) {
    test::holds(500, [] {
        const BsplineCurve curve = test::SplineCase(*test::anySpline()).curve();
        const auto [s, often] = anyInsertion(curve);
        const auto [t, times] = anyInsertion(curve);
        RC_PRE(s != t);
        const auto first = insertKnot(curve, s, often);
        const auto second = insertKnot(curve, t, times);
        RC_PRE(first.ok() && second.ok());
        const auto one = insertKnot(*first, t, times);
        const auto other = insertKnot(*second, s, often);
        RC_PRE(one.ok() && other.ok());
        RC_ASSERT(one->knotVector() == other->knotVector());
        for (std::size_t i = 0; i < one->points().size(); ++i) {
            const Vec3 apart = one->points()[i] - other->points()[i];
            RC_ASSERT(glm::length(apart) <= gates::refinement);
        }
    });
}

TEST(RefinementProperty, NewPointsLieInTheHullOfTheOldAndWeightsStayPositive) {
    test::holds(500, [] {
        const BsplineCurve curve = test::SplineCase(*test::anySpline()).curve();
        const auto [t, times] = anyInsertion(curve);
        const auto refined = insertKnot(curve, t, times);
        RC_PRE(refined.ok());
        for (const Vec3& point : refined->points()) {
            for (int axis = 0; axis < 3; ++axis) {
                RC_ASSERT(std::abs(point[axis]) <= 1 + gates::exact);
            }
        }
        for (const double weight : refined->weights()) RC_ASSERT(weight > 0);
    });
}

}  // namespace
}  // namespace knotwork
