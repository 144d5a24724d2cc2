#include "geometry/refinement.hpp"

#include "geometry/bspline_kernels.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

using Homogeneous = glm::dvec4;  // (w x, w y, w z, w); w = 1 without weights

std::vector<Homogeneous> homogeneousPoints(const BsplineCurve& curve) {
    std::vector<Homogeneous> points;
    points.reserve(curve.points().size());
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
        const double weight = curve.weights().empty() ? 1 : curve.weights()[i];
        points.emplace_back(weight * curve.points()[i], weight);
    }
    return points;
}

Homogeneous blend(const Homogeneous& from, const Homogeneous& to, double a) noexcept {
    return (1 - a) * from + a * to;
}

// b_i is c_i up to s-d, c_{i-1} from the first knot equal to t on (there a_i = 0, and c_i may lie
// past the last point), and a blend between.
std::vector<Homogeneous> insertedPoints(std::span<const double> knots, std::size_t degree,
                                        std::size_t span, std::span<const Homogeneous> points,
                                        double t) {
    std::vector<Homogeneous> refined(points.size() + 1);
    for (std::size_t i = 0; i < refined.size(); ++i) {
        if (i + degree <= span) {
            refined[i] = points[i];
        } else if (knots[i] >= t) {
            refined[i] = points[i - 1];
        } else {
            refined[i] = blend(points[i - 1], points[i], kernels::weight(knots, degree, i, t));
        }
    }
    return refined;
}

// The d blended points s-d+1 … s and the n+1-d that follow them are one period of the refined
// polygon; indices of either polygon wrap.
std::vector<Homogeneous> insertedPeriod(std::span<const double> knots, std::size_t degree,
                                        std::size_t span, std::span<const Homogeneous> points,
                                        double t) {
    const std::size_t n = points.size();
    std::vector<Homogeneous> refined(n + 1);
    const std::size_t first = span - degree + 1;
    for (std::size_t i = first; i <= first + n; ++i) {
        const Homogeneous& before = points[(i - 1) % n];
        refined[i % (n + 1)] =
            i > span ? before : blend(before, points[i % n], kernels::weight(knots, degree, i, t));
    }
    return refined;
}

std::vector<Homogeneous> insertedOnce(const KnotVector& knots, std::span<const Homogeneous> points,
                                      double t) {
    const auto all = knots.extended();
    const auto degree = static_cast<std::size_t>(knots.degree());
    const auto after = std::upper_bound(all.begin(), all.end(), t) - all.begin();
    const std::size_t span = static_cast<std::size_t>(after) - 1;
    return knots.closed() ? insertedPeriod(all, degree, span, points, t)
                          : insertedPoints(all, degree, span, points, t);
}

Result<KnotVector> withKnot(const KnotVector& knots, double t) {
    std::vector<double> more(knots.knots().begin(), knots.knots().end());
    more.insert(std::upper_bound(more.begin(), more.end(), t), t);
    return KnotVector::make(std::move(more), knots.degree(), knots.pointCount() + 1, knots.form());
}

std::optional<Error> checkInsertion(const KnotVector& knots, double t, int times) {
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

Result<BsplineCurve> curveOf(KnotVector knots, std::span<const Homogeneous> refined,
                             const BsplineCurve& original) {
    std::vector<Vec3> points;
    std::vector<double> weights;
    points.reserve(refined.size());
    for (const Homogeneous& point : refined) {
        if (original.weights().empty()) {
            points.emplace_back(point);
        } else {
            points.push_back(Vec3(point) / point.w);
            weights.push_back(point.w);
        }
    }
    return BsplineCurve::make(std::move(knots), std::move(points), original.dimension(),
                              std::move(weights));
}

}  // namespace

Result<BsplineCurve> insertKnot(const BsplineCurve& curve, double t, int times) {
    KnotVector knots = curve.knotVector();
    if (auto error = checkInsertion(knots, t, times)) return *std::move(error);
    const double inside = knots.wrap(t);
    std::vector<Homogeneous> points = homogeneousPoints(curve);
    for (int i = 0; i < times; ++i) {
        points = insertedOnce(knots, points, inside);
        auto more = withKnot(knots, inside);
        if (!more.ok()) return refuse(more.error().code, "t", more.error().message);
        knots = std::move(more).value();
    }
    return curveOf(std::move(knots), points, curve);
}

}  // namespace knotwork
