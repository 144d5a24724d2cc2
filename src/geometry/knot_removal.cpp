#include "geometry/knot_removal.hpp"

#include "geometry/bezier_piece.hpp"
#include "geometry/bspline_indexing.hpp"
#include "geometry/homogeneous.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

using MaybeError = std::optional<Error>;

/// Where the knot stands: t_r is the last of `multiplicity` equal ones in the extended vector.
struct Place {
    double t = 0;
    std::ptrdiff_t last = 0;
    std::ptrdiff_t multiplicity = 0;
};

// --- may it go? -------------------------------------------------------------------------------

MaybeError checkEnd(const KnotVector& knots, const Place& place) {
    const Interval domain = knots.domain();
    if (place.t != domain.start && place.t != domain.end) return {};
    const auto degree = static_cast<std::ptrdiff_t>(knots.degree());
    const std::ptrdiff_t first = place.last - place.multiplicity + 1;
    const bool stays = knots.closed() ? place.multiplicity > 1
                       : place.t == domain.start ? place.last > degree
                                                 : first < knots.pointCount();
    if (stays) return {};
    return refuse(Code::outOfRange, "t",
                  "the knot " + formatNumber(place.t) + " ends the domain [" +
                      formatNumber(domain.start) + ", " + formatNumber(domain.end) +
                      "], which must stay; remove a knot inside");
}

MaybeError checkPlace(const KnotVector& knots, double t, const Place& place) {
    if (place.multiplicity == 0 || !knots.domain().contains(place.t)) {
        return refuse(Code::outOfRange, "t",
                      formatNumber(t) + " is no knot of the curve in its domain; take one of its "
                          "knots, exactly");
    }
    if (auto error = checkEnd(knots, place)) return error;
    if (knots.pointCount() > knots.degree() + 1) return {};
    return refuse(Code::knotsCount, "t",
                  "the curve has degree + 1 = " + std::to_string(knots.pointCount()) +
                      " points, the least for its degree; no knot of it can be removed");
}

Result<Place> placeOf(const KnotVector& knots, double t) {
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, "t", formatNumber(t) + " is not a finite parameter");
    }
    Place place{knots.wrap(t), 0, 0};
    const auto all = knots.extended();
    const auto [first, end] = std::equal_range(all.begin(), all.end(), place.t);
    place.multiplicity = end - first;
    place.last = end - all.begin() - 1;
    if (auto error = checkPlace(knots, t, place)) return *std::move(error);
    return place;
}

// --- the equations ----------------------------------------------------------------------------

/// Points N+2 of the curve around the knot, N = d-s+1: given[q+1] is to be
/// (1 - a[q]) found[q] + a[q] found[q+1], the first and the last are found as they are given.
struct Equations {
    std::ptrdiff_t first = 0;  ///< the index of given[0]
    std::vector<Homogeneous> given;
    std::vector<double> a;  ///< N of them, descending
    std::vector<Homogeneous> found;     ///< N+1
    std::vector<Homogeneous> residual;  ///< N+2: what inserting the knot again leaves over
};

Equations equationsAt(const KnotVector& knots, std::span<const Homogeneous> points,
                      const Place& place) {
    const auto degree = static_cast<std::ptrdiff_t>(knots.degree());
    const std::ptrdiff_t count = degree - place.multiplicity + 1;
    Equations equations;
    equations.first = place.last - degree - 1;
    for (std::ptrdiff_t q = 0; q < count + 2; ++q) {
        equations.given.push_back(points[cyclic(equations.first + q, points.size())]);
    }
    for (std::ptrdiff_t q = 0; q < count; ++q) {
        const std::ptrdiff_t i = place.last - degree + q;
        const double from = knotAt(knots, i);
        equations.a.push_back((place.t - from) / (knotAt(knots, i + degree + 1) - from));
    }
    return equations;
}

/// The numbers y with which the equations add up to one without unknowns, 1 at row `middle`.
std::vector<double> dependency(std::span<const double> a, std::size_t middle) {
    std::vector<double> y(a.size());
    y[middle] = 1;
    for (std::size_t q = middle; q + 1 < a.size(); ++q) y[q + 1] = -y[q] * a[q] / (1 - a[q + 1]);
    for (std::size_t q = middle; q > 0; --q) y[q - 1] = -y[q] * (1 - a[q]) / a[q - 1];
    return y;
}

/// The residual that all equations are to have, up to its sign.
Homogeneous evenResidual(const Equations& equations, std::span<const double> y) {
    const std::size_t last = y.size() - 1;
    Homogeneous sum = -y[0] * (1 - equations.a[0]) * equations.given.front() -
                      y[last] * equations.a[last] * equations.given.back();
    double size = 0;
    for (std::size_t q = 0; q <= last; ++q) {
        sum += y[q] * equations.given[q + 1];
        size += std::abs(y[q]);
    }
    return sum / size;
}

void solveInner(Equations& equations) {
    const std::span<const double> a = equations.a;
    const std::size_t count = a.size();
    const auto below = std::find_if(a.begin(), a.end(), [](double x) { return x < 0.5; });
    const std::size_t middle =
        std::min(static_cast<std::size_t>(below - a.begin()), count - 1);
    const std::vector<double> y = dependency(a, middle);
    const Homogeneous even = evenResidual(equations, y);
    const auto wanted = [&](std::size_t q) {
        const bool odd = (q + middle) % 2 == 1;
        return odd ? equations.given[q + 1] + even : equations.given[q + 1] - even;
    };
    auto& found = equations.found;
    found.assign(count + 1, Homogeneous(0));
    found.front() = equations.given.front();
    found.back() = equations.given.back();
    for (std::size_t q = 0; q < middle; ++q) {
        found[q + 1] = (wanted(q) - (1 - a[q]) * found[q]) / a[q];
    }
    for (std::size_t q = count - 1; q > middle; --q) {
        found[q] = (wanted(q) - a[q] * found[q + 1]) / (1 - a[q]);
    }
}

void solve(Equations& equations) {
    const auto& given = equations.given;
    const std::size_t count = equations.a.size();
    if (count == 0) {  // the two points of a gap become one
        equations.found = {0.5 * (given[0] + given[1])};
    } else {
        solveInner(equations);
    }
    equations.residual = {given.front() - equations.found.front()};
    for (std::size_t q = 0; q < count; ++q) {
        const double a = equations.a[q];
        equations.residual.push_back(given[q + 1] - (1 - a) * equations.found[q] -
                                     a * equations.found[q + 1]);
    }
    equations.residual.push_back(given.back() - equations.found.back());
}

// --- how far the curve moves ------------------------------------------------------------------

/// A part of one span: the curve, and what of it goes.
struct MovedPart {
    std::vector<Homogeneous> curve;
    std::vector<Homogeneous> lost;
};

/// How far the end of a part moves.
double moved(const Homogeneous& curve, const Homogeneous& lost) noexcept {
    const Vec3 change = Vec3(lost) - lost.w * (Vec3(curve) / curve.w);
    return glm::length(change) / std::abs(curve.w - lost.w);
}

// With C = P/w and what is left (P - dP)/(w - dw), the curve moves by (dP - C dw) / (w - dw); seen
// from a point near the part, C is short. Sums of Bézier points with positive weights are bounded
// by the longest of the points.
double boundOn(const MovedPart& part) noexcept {
    const Vec3 near = Vec3(part.curve.front()) / part.curve.front().w;
    double points = 0;
    double weights = 0;
    double reach = 0;
    double left = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < part.curve.size(); ++j) {
        const Homogeneous& at = part.curve[j];
        const Homogeneous& lost = part.lost[j];
        points = std::max(points, glm::length(Vec3(lost) - lost.w * near));
        weights = std::max(weights, std::abs(lost.w));
        reach = std::max(reach, glm::length(Vec3(at) / at.w - near));
        left = std::min(left, at.w - lost.w);
    }
    if (!(left > 0)) return std::numeric_limits<double>::infinity();
    return (points + reach * weights) / left;
}

std::pair<std::vector<Homogeneous>, std::vector<Homogeneous>> halves(
    std::vector<Homogeneous> points) {
    const std::size_t degree = points.size() - 1;
    std::vector<Homogeneous> right(points.size());
    right[degree] = points[degree];
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = degree; j >= r; --j) points[j] = 0.5 * (points[j - 1] + points[j]);
        right[degree - r] = points[degree];
    }
    return {std::move(points), std::move(right)};
}

constexpr double slack = 1.02;
constexpr int deepest = 12;  // bounds of halves approach the values like 4^-depth

/// Raises `least`, what some point moves, and answers a bound for all of the part.
double boundWithin(const MovedPart& part, double& least, int depth) {
    least = std::max({least, moved(part.curve.front(), part.lost.front()),
                      moved(part.curve.back(), part.lost.back())});
    const double bound = boundOn(part);
    if (bound <= slack * least || depth == deepest || bound == 0) return bound;
    auto [curveLeft, curveRight] = halves(part.curve);
    auto [lostLeft, lostRight] = halves(part.lost);
    const double left = boundWithin({std::move(curveLeft), std::move(lostLeft)}, least, depth + 1);
    const double right =
        boundWithin({std::move(curveRight), std::move(lostRight)}, least, depth + 1);
    return std::max(left, right);
}

/// The span of the curve that begins at knot `span`, and what of it goes.
MovedPart movedSpan(const KnotVector& knots, std::span<const Homogeneous> points,
                    const Equations& equations, std::ptrdiff_t span) {
    const auto degree = static_cast<std::ptrdiff_t>(knots.degree());
    const auto d = static_cast<std::size_t>(degree);
    std::array<double, 2 * maxDegree> around{};
    for (std::ptrdiff_t i = 0; i < 2 * degree; ++i) {
        around[static_cast<std::size_t>(i)] = knotAt(knots, span + 1 - degree + i);
    }
    const std::span<const double> local(around.data(), 2 * d);
    MovedPart part;
    std::array<double, maxDegree + 1> weights{};
    for (std::size_t j = 0; j <= d; ++j) {
        bezierWeights(local, d, d - 1, {local[d - 1], local[d]}, j, weights);
        Homogeneous curve(0);
        Homogeneous lost(0);
        for (std::size_t k = 0; k <= d; ++k) {
            const std::ptrdiff_t i = span - degree + static_cast<std::ptrdiff_t>(k);
            curve += weights[k] * points[cyclic(i, points.size())];
            const std::ptrdiff_t row = i - equations.first;
            if (row >= 0 && row < static_cast<std::ptrdiff_t>(equations.residual.size())) {
                lost += weights[k] * equations.residual[static_cast<std::size_t>(row)];
            }
        }
        part.curve.push_back(curve);
        part.lost.push_back(lost);
    }
    return part;
}

/// Nothing below this is worth a closer look.
double roundingOf(std::span<const Homogeneous> points) noexcept {
    double size = 0;
    for (const Homogeneous& point : points) size = std::max(size, glm::length(Vec3(point)) / point.w);
    return 1e-16 * size;
}

double deviationOf(const KnotVector& knots, std::span<const Homogeneous> points,
                   const Equations& equations) {
    const auto degree = static_cast<std::ptrdiff_t>(knots.degree());
    std::ptrdiff_t span = equations.first;
    std::ptrdiff_t end = span + static_cast<std::ptrdiff_t>(equations.residual.size()) + degree;
    if (!knots.closed()) {
        span = std::max(span, degree);
        end = std::min(end, static_cast<std::ptrdiff_t>(knots.pointCount()));
    }
    std::vector<MovedPart> parts;
    double least = roundingOf(points);
    for (; span < end; ++span) {
        if (knotAt(knots, span) == knotAt(knots, span + 1)) continue;
        parts.push_back(movedSpan(knots, points, equations, span));
        least = std::max({least, moved(parts.back().curve.front(), parts.back().lost.front()),
                          moved(parts.back().curve.back(), parts.back().lost.back())});
    }
    double bound = 0;
    for (const MovedPart& part : parts) bound = std::max(bound, boundWithin(part, least, 0));
    return bound;
}

// --- what is left -----------------------------------------------------------------------------

Result<KnotVector> withoutKnot(const KnotVector& knots, const Place& place) {
    std::vector<double> fewer(knots.knots().begin(), knots.knots().end());
    // Of the knots at a seam the first and the last stay.
    const auto last = std::upper_bound(fewer.begin(), fewer.end(), place.t);
    const bool atSeamOnce = knots.closed() && place.t == fewer[0] && fewer[1] != fewer[0];
    fewer.erase(atSeamOnce ? fewer.end() - 1 : last - 1);
    return KnotVector::make(std::move(fewer), knots.degree(), knots.pointCount() - 1,
                            knots.form());
}

std::vector<Homogeneous> pointsLeft(const KnotVector& knots, const Place& place,
                                    std::span<const Homogeneous> points,
                                    const Equations& equations) {
    const std::size_t count = points.size() - 1;
    std::vector<Homogeneous> left(count);
    const std::ptrdiff_t base = knots.closed() ? equations.first : 0;
    // Where the period ends in equal knots, the seam is the last of them and moves up by one.
    const bool repeatedAtEnd = knots.closed() && place.last == knots.degree();
    for (std::ptrdiff_t i = base; i < base + static_cast<std::ptrdiff_t>(count); ++i) {
        const std::ptrdiff_t q = i - equations.first;
        const bool solved = q >= 0 && q < static_cast<std::ptrdiff_t>(equations.found.size());
        left[cyclic(i + (repeatedAtEnd ? 1 : 0), count)] =
            solved ? equations.found[static_cast<std::size_t>(q)]
                   : points[cyclic(q < 0 ? i : i + 1, points.size())];
    }
    return left;
}

Result<KnotRemoval> removal(const BsplineCurve& curve, const Place& place) {
    const KnotVector& knots = curve.knotVector();
    const std::vector<Homogeneous> points = homogeneousPoints(curve);
    Equations equations = equationsAt(knots, points, place);
    solve(equations);
    auto fewer = withoutKnot(knots, place);
    if (!fewer) return refuse(fewer.error().code, "t", fewer.error().message);
    const auto left = pointsLeft(knots, place, points, equations);
    auto made = fromHomogeneous(std::move(*fewer), left, curve.dimension(),
                                !curve.weights().empty());
    if (!made) return KnotRemoval{curve, std::numeric_limits<double>::infinity(), false};
    return KnotRemoval{std::move(*made), deviationOf(knots, points, equations), true};
}

}  // namespace

Result<KnotRemoval> removeKnotAnyway(const BsplineCurve& curve, double t) {
    const auto place = placeOf(curve.knotVector(), t);
    return place ? removal(curve, *place) : Result<KnotRemoval>(place.error());
}

Result<KnotRemoval> removeKnot(const BsplineCurve& curve, double t, double tolerance) {
    if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
        return refuse(std::isfinite(tolerance) ? Code::outOfRange : Code::notFinite, "tolerance",
                      "the tolerance is " + formatNumber(tolerance) +
                          "; it is a distance and must be at least 0");
    }
    auto anyway = removeKnotAnyway(curve, t);
    if (!anyway || (anyway->removed && anyway->deviation <= tolerance)) return anyway;
    return KnotRemoval{curve, anyway->deviation, false};
}

}  // namespace knotwork
