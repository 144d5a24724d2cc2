#include "geometry/bspline_operations.hpp"

#include "geometry/bspline_indexing.hpp"
#include "geometry/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace knotwork {

namespace {

Error atT(const Error& error) { return refuse(error.code, "t", error.message); }

/// The knots with t in them d+1 times.
std::vector<double> knotsWithGap(const KnotVector& knots, double t) {
    std::vector<double> more(knots.knots().begin(), knots.knots().end());
    const int missing = knots.degree() + 1 - knots.multiplicity(t);
    more.insert(std::upper_bound(more.begin(), more.end(), t), static_cast<std::size_t>(missing),
                t);
    return more;
}

/// Knots first … of the extended vector and points from the same index, `points` of them.
Result<BsplineCurve> partOf(const BsplineCurve& curve, std::size_t first, std::size_t count,
                            Form form) {
    const KnotVector& knots = curve.knotVector();
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    std::vector<double> cut;
    for (auto i = begin; i <= end + knots.degree(); ++i) cut.push_back(knotAt(knots, i));
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (auto i = begin; i < end; ++i) {
        const std::size_t point = cyclic(i, curve.points().size());
        points.push_back(curve.points()[point]);
        if (!curve.weights().empty()) weights.push_back(curve.weights()[point]);
    }
    auto made = KnotVector::make(std::move(cut), knots.degree(), static_cast<int>(count), form);
    if (!made) return atT(made.error());
    return BsplineCurve::make(std::move(*made), std::move(points), curve.dimension(),
                              std::move(weights));
}

Result<Done> checkSplit(const BsplineCurve& curve, double t) {
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, "t", formatNumber(t) + " is not a finite parameter");
    }
    const Interval domain = curve.domain();
    if (curve.closed() || (domain.start < t && t < domain.end)) return Done{};
    return refuse(Code::outOfRange, "t",
                  formatNumber(t) + " does not lie inside the domain [" +
                      formatNumber(domain.start) + ", " + formatNumber(domain.end) +
                      "]; a curve is split between its ends");
}

}  // namespace

Result<std::vector<BsplineCurve>> split(const BsplineCurve& curve, double t) {
    if (const auto checked = checkSplit(curve, t); !checked) return checked.error();
    const double at = curve.knotVector().wrap(t);
    const auto gapped = refineByOslo1(curve, knotsWithGap(curve.knotVector(), at));
    if (!gapped) return atT(gapped.error());
    const KnotVector& knots = gapped->knotVector();
    const auto all = knots.extended();
    const auto place = std::lower_bound(all.begin(), all.end(), at) - all.begin();
    const auto first = static_cast<std::size_t>(place);
    const auto count = static_cast<std::size_t>(knots.pointCount());
    if (curve.closed()) {
        auto whole = partOf(*gapped, first, count, Form::clamped);
        if (!whole) return whole.error();
        return std::vector<BsplineCurve>{std::move(*whole)};
    }
    auto before = partOf(*gapped, 0, first, knots.form());
    if (!before) return before.error();
    auto after = partOf(*gapped, first, count - first, knots.form());
    if (!after) return after.error();
    return std::vector<BsplineCurve>{std::move(*before), std::move(*after)};
}

Result<BsplineCurve> reversed(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const Interval domain = knots.domain();
    const double middle = domain.start + domain.length() / 2;
    // Each half from its own end: ends and equal knots stay what they are.
    const auto mirrored = [&](double knot) {
        return knot <= middle ? domain.end - (knot - domain.start)
                              : domain.start + (domain.end - knot);
    };
    std::vector<double> turned(knots.knots().size());
    std::transform(knots.knots().rbegin(), knots.knots().rend(), turned.begin(), mirrored);
    auto made = KnotVector::make(std::move(turned), knots.degree(), knots.pointCount(),
                                 knots.form());
    if (!made) return refuse(Code::outOfRange, "knots", made.error().message);
    const std::size_t count = curve.points().size();
    const std::ptrdiff_t last =
        knots.closed() ? knots.degree() - 1 : static_cast<std::ptrdiff_t>(count) - 1;
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (std::size_t j = 0; j < count; ++j) {
        const std::size_t i = cyclic(last - static_cast<std::ptrdiff_t>(j), count);
        points.push_back(curve.points()[i]);
        if (!curve.weights().empty()) weights.push_back(curve.weights()[i]);
    }
    return BsplineCurve::make(std::move(*made), std::move(points), curve.dimension(),
                              std::move(weights));
}

}  // namespace knotwork
