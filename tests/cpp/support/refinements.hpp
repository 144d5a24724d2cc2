// Random refinements, and the distance of curves that should be the same.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "support/splines.hpp"

#include <algorithm>
#include <vector>

namespace knotwork::test {

/// How often a knot at t can be added: to d+1 equal ones, but to none at a clamped end.
inline int roomAt(const KnotVector& knots, double t) {
    return knots.degree() + 1 - knots.multiplicity(t);
}

/// The full vector of a refinement with about `more` new knots: between knots, at knots, and at the
/// ends of the domain.
inline std::vector<double> randomRefinement(const KnotVector& knots, RandomSplines& random,
                                            int more) {
    std::vector<double> refined(knots.knots().begin(), knots.knots().end());
    const Interval domain = knots.domain();
    std::vector<double> telltale = telltaleParameters(knots, random, more);
    for (int i = 0; i < more; ++i) {
        const auto at = static_cast<std::size_t>(
            random.integer(0, static_cast<int>(telltale.size()) - 1));
        // The seam of a closed vector is one knot with two ends.
        const bool seam = knots.closed() && (telltale[at] == domain.start || telltale[at] == domain.end);
        double t = seam && random.integer(0, 1) == 0 ? domain.start : telltale[at];
        int present = 0;
        for (const double knot : refined) {
            present += seam ? knot == domain.start || knot == domain.end : knot == t;
        }
        if (seam) --present;
        if (present > knots.degree()) continue;
        refined.insert(std::upper_bound(refined.begin(), refined.end(), t), t);
    }
    return refined;
}

/// The largest distance at the ends, at all knots of both curves from both sides, and between.
inline double farthest(const BsplineCurve& a, const BsplineCurve& b, RandomSplines& random) {
    double largest = 0;
    for (const KnotVector* knots : {&a.knotVector(), &b.knotVector()}) {
        for (const double t : telltaleParameters(*knots, random)) {
            for (const Side side : bothSides) {
                const Vec3 apart = pointOf(a, t, side) - pointOf(b, t, side);
                largest = std::max(largest, glm::length(apart));
            }
        }
    }
    return largest;
}

}  // namespace knotwork::test
