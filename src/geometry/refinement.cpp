#include "geometry/refinement.hpp"

#include "geometry/boehm.hpp"
#include "geometry/cubic_refinement.hpp"
#include "geometry/homogeneous.hpp"
#include "geometry/oslo.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

using MaybeError = std::optional<Error>;

Result<KnotVector> withKnot(const KnotVector& knots, double t) {
    std::vector<double> more(knots.knots().begin(), knots.knots().end());
    more.insert(std::upper_bound(more.begin(), more.end(), t), t);
    return KnotVector::make(std::move(more), knots.degree(), knots.pointCount() + 1, knots.form());
}

MaybeError checkInsertion(const KnotVector& knots, double t, int times) {
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, "t", formatNumber(t) + " is not a finite parameter");
    }
    const Interval domain = knots.domain();
    if (!knots.closed() && !domain.contains(t)) {
        return refuse(Code::outOfRange, "t",
                      formatNumber(t) + " lies outside the domain [" + formatNumber(domain.start) +
                          ", " + formatNumber(domain.end) + "]");
    }
    if (times < 1) {
        return refuse(Code::outOfRange, "times",
                      std::to_string(times) + " insertions asked for; at least 1 is needed");
    }
    if (times > maxPointCount - knots.pointCount()) {
        return refuse(Code::tooLarge, "times",
                      "the curve would have more than 100000 points; insert fewer knots");
    }
    const int present = knots.multiplicity(t);
    if (present + times > knots.degree()) {
        return refuse(Code::knotsMultiplicity, "t",
                      "the knot " + formatNumber(t) + " would stand " +
                          std::to_string(present + times) + " times (now " +
                          std::to_string(present) + "); insert it until it stands degree = " +
                          std::to_string(knots.degree()) + " times at most");
    }
    return {};
}

MaybeError checkRefinedCount(const KnotVector& knots, std::size_t given) {
    const std::size_t before = knots.knots().size();
    if (given < before) {
        return refuse(Code::knotsCount, "knots",
                      std::to_string(given) + " knots given; a refinement is the full vector and "
                          "has at least the " + std::to_string(before) + " knots of the curve");
    }
    const std::size_t most = KnotVector::knotCount(knots.degree(), maxPointCount, knots.form());
    if (given > most) {
        return refuse(Code::tooLarge, "knots",
                      std::to_string(given) + " knots given; the curve would have more than "
                          "100000 points");
    }
    return {};
}

Error refuseMissing(const KnotVector& knots, double knot, std::size_t place) {
    return refuse(Code::knotsMultiplicity, indexed("knots", place),
                  "the knot " + formatNumber(knot) + " of the curve is missing here: its "
                      "multiplicity is " + std::to_string(knots.multiplicity(knot)) +
                      ", and a refinement keeps it");
}

Error refuseOutside(const Interval& domain, double knot, std::size_t place) {
    return refuse(Code::outOfRange, indexed("knots", place),
                  formatNumber(knot) + " is new and lies outside the domain [" +
                      formatNumber(domain.start) + ", " + formatNumber(domain.end) +
                      "]; a refinement adds knots inside only");
}

/// A part of a refined vector, which is looked for the knots of a part of the old one.
struct Part {
    std::span<const double> knots;
    std::size_t place = 0;  ///< where it begins in the whole vector
};

// Both lists ascend: what stands in `after` besides `before` is new.
MaybeError checkContains(const KnotVector& knots, std::span<const double> before,
                         const Part& after) {
    const Interval domain = knots.domain();
    std::size_t found = 0;
    for (std::size_t i = 0; i < after.knots.size(); ++i) {
        const double knot = after.knots[i];
        if (found < before.size() && knot == before[found]) {
            ++found;
        } else if (found < before.size() && knot > before[found]) {
            return refuseMissing(knots, before[found], after.place + i);
        } else if (!domain.contains(knot)) {
            return refuseOutside(domain, knot, after.place + i);
        }
    }
    if (found == before.size()) return {};
    return refuseMissing(knots, before[found], after.place + after.knots.size() - 1);
}

Part withoutSeam(std::span<const double> period) {
    const auto first = std::upper_bound(period.begin(), period.end(), period.front());
    const auto last = std::lower_bound(first, period.end(), period.back());
    const auto place = static_cast<std::size_t>(first - period.begin());
    return {period.subspan(place, static_cast<std::size_t>(last - first)), place};
}

// A knot at the seam may be repeated at either end of a period; the ends themselves stay.
MaybeError checkContainsPeriod(const KnotVector& knots, std::span<const double> after,
                               int afterAtSeam) {
    const Interval domain = knots.domain();
    for (const std::size_t i : {std::size_t{0}, after.size() - 1}) {
        const double end = i == 0 ? domain.start : domain.end;
        if (after[i] == end) continue;
        return refuse(Code::outOfRange, indexed("knots", i),
                      formatNumber(after[i]) + " is not the end " + formatNumber(end) +
                          " of the period; a refinement begins and ends where the curve does");
    }
    const Part inner = withoutSeam(after);
    if (afterAtSeam < knots.multiplicity(domain.start)) {
        return refuseMissing(knots, domain.start, inner.place);
    }
    return checkContains(knots, withoutSeam(knots.knots()).knots, inner);
}

/// A vector of its own right, which need not have the knots of the old one yet.
Result<KnotVector> finerKnots(const KnotVector& knots, std::vector<double> refined) {
    if (auto error = checkRefinedCount(knots, refined.size())) return *std::move(error);
    const std::size_t more = refined.size() - knots.knots().size();
    return KnotVector::make(std::move(refined), knots.degree(),
                            knots.pointCount() + static_cast<int>(more), knots.form());
}

MaybeError checkRefines(const KnotVector& knots, const KnotVector& refined) {
    const auto after = refined.knots();
    if (!knots.closed()) return checkContains(knots, knots.knots(), {after});
    return checkContainsPeriod(knots, after, refined.multiplicity(after.front()));
}

bool isPlainCubic(const BsplineCurve& curve) noexcept {
    return curve.degree() == 3 && curve.knotVector().form() == Form::clamped &&
           curve.weights().empty();
}

Result<BsplineCurve> curveOver(KnotVector refined, std::span<const Homogeneous> points,
                               const BsplineCurve& curve) {
    return fromHomogeneous(std::move(refined), points, curve.dimension(),
                           !curve.weights().empty());
}

using Algorithm = std::vector<Homogeneous> (*)(const KnotVector&, const KnotVector&,
                                               std::span<const Homogeneous>);

Result<BsplineCurve> refineBy(Algorithm algorithm, const BsplineCurve& curve,
                              std::vector<double> knots) {
    auto refined = refinedKnots(curve.knotVector(), std::move(knots));
    if (!refined) return refined.error();
    const auto points = algorithm(curve.knotVector(), *refined, homogeneousPoints(curve));
    return curveOver(std::move(*refined), points, curve);
}

}  // namespace

Result<BsplineCurve> insertKnot(const BsplineCurve& curve, double t, int times) {
    KnotVector knots = curve.knotVector();
    if (auto error = checkInsertion(knots, t, times)) return *std::move(error);
    const double inside = knots.wrap(t);
    std::vector<Homogeneous> points = homogeneousPoints(curve);
    for (int i = 0; i < times; ++i) {
        points = boehmOnce(knots, points, inside);
        auto more = withKnot(knots, inside);
        if (!more.ok()) return refuse(more.error().code, "t", more.error().message);
        knots = std::move(more).value();
    }
    return curveOver(std::move(knots), points, curve);
}

Result<KnotVector> refinedKnots(const KnotVector& knots, std::vector<double> refined) {
    auto made = finerKnots(knots, std::move(refined));
    if (!made) return made;
    if (auto error = checkRefines(knots, *made)) return *std::move(error);
    return made;
}

Result<BsplineCurve> refineByOslo(const BsplineCurve& curve, std::vector<double> knots) {
    if (!isPlainCubic(curve)) return refineByOslo1(curve, std::move(knots));
    auto refined = finerKnots(curve.knotVector(), std::move(knots));
    if (!refined) return refined.error();
    auto points = refinedCubic(curve.knotVector(), curve.points(), *refined);
    if (!points) return *checkRefines(curve.knotVector(), *refined);  // which knot is missing
    return BsplineCurve::make(std::move(*refined), std::move(*points), curve.dimension());
}

Result<BsplineCurve> refineByOslo1(const BsplineCurve& curve, std::vector<double> knots) {
    if (!curve.weights().empty()) return refineBy(oslo1, curve, std::move(knots));
    auto refined = refinedKnots(curve.knotVector(), std::move(knots));
    if (!refined) return refined.error();
    auto points = oslo1(curve.knotVector(), *refined, curve.points());
    return BsplineCurve::make(std::move(*refined), std::move(points), curve.dimension());
}

Result<BsplineCurve> refineByOslo2(const BsplineCurve& curve, std::vector<double> knots) {
    return refineBy(oslo2, curve, std::move(knots));
}

Result<BsplineCurve> refineByBoehm(const BsplineCurve& curve, std::vector<double> knots) {
    return refineBy(boehm, curve, std::move(knots));
}

}  // namespace knotwork
