#include "geometry/bspline_curve.hpp"

#include "geometry/bspline_kernels.hpp"
#include "geometry/checks.hpp"
#include "geometry/simd.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

constexpr double smallestWeight = 1e-9;  // with largestWeight: no product comes near overflow
constexpr double largestWeight = 1e9;

using MaybeError = std::optional<Error>;
using Homogeneous = glm::dvec4;  // (w x, w y, w z, w)

MaybeError checkLength(std::size_t given, int needed, const char* path) {
    if (given == static_cast<std::size_t>(needed)) return {};
    return refuse(
        Code::wrongLength, path,
        std::to_string(given) + ' ' + path + " given, " + std::to_string(needed) + " needed");
}

/// Whether there is nothing to refuse; a NaN is never less than anything.
bool isPlain(const Vec3& point, int dimension) noexcept {
    return std::abs(point.x) <= largestCoordinate && std::abs(point.y) <= largestCoordinate &&
           std::abs(point.z) <= (dimension == 2 ? 0 : largestCoordinate);
}

/// How many points from the first one on are seen to be plain, two at a look.
std::size_t plainPoints(std::span<const Vec3> points, int dimension) noexcept {
    const double z = dimension == 2 ? 0 : largestCoordinate;
    const std::array<double, 6> most{largestCoordinate, largestCoordinate, z,
                                     largestCoordinate, largestCoordinate, z};
    const auto within = [&](const double* numbers, std::size_t at) {
        const simd::Double2 pair = simd::load(numbers + at);
        const simd::Double2 limit = simd::load(&most[at]);
        return (limit >= pair) & (pair >= simd::splat(0) - limit);
    };
    std::size_t i = 0;
    for (; i + 2 <= points.size(); i += 2) {
        const double* numbers = &points[i].x;
        if (!simd::inBoth(within(numbers, 0) & within(numbers, 2) & within(numbers, 4))) break;
    }
    return i;
}

/// What is wrong with a point that is not plain.
MaybeError refusePoint(const Vec3& point, std::size_t index) {
    if (!allowedCoordinates(point)) return checkCoordinates(point, indexed("points", index));
    return refuse(Code::outOfRange, indexed("points", index),
                  "z is " + formatNumber(point.z) + "; it must be 0 in two dimensions");
}

MaybeError checkWeight(double weight, std::size_t index) {
    if (!std::isfinite(weight)) {
        return refuse(Code::notFinite, indexed("weights", index),
                      formatNumber(weight) + " is not a finite weight");
    }
    if (weight < smallestWeight || weight > largestWeight) {
        return refuse(
            Code::outOfRange, indexed("weights", index),
            formatNumber(weight) + " is out of range; weights are positive, from 1e-9 to 1e9");
    }
    return {};
}

MaybeError checkCurve(int pointCount, std::span<const Vec3> points, int dimension,
                      std::span<const double> weights) {
    if (dimension != 2 && dimension != 3) {
        return refuse(Code::outOfRange, "dimension",
                      "dimension is " + std::to_string(dimension) + "; it must be 2 or 3");
    }
    if (auto error = checkLength(points.size(), pointCount, "points")) return error;
    for (std::size_t i = plainPoints(points, dimension); i < points.size(); ++i) {
        if (!isPlain(points[i], dimension)) return refusePoint(points[i], i);
    }
    if (weights.empty()) return {};
    if (auto error = checkLength(weights.size(), pointCount, "weights")) return error;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (auto error = checkWeight(weights[i], i)) return error;
    }
    return {};
}

}  // namespace

BsplineCurve::BsplineCurve(KnotVector knots, std::vector<Vec3> points, int dimension,
                           std::vector<double> weights)
    : knots_(std::move(knots)),
      points_(std::move(points)),
      weights_(std::move(weights)),
      dimension_(dimension),
      rational_(std::any_of(weights_.begin(), weights_.end(),
                            [&](double weight) { return weight != weights_.front(); })) {}

Result<BsplineCurve> BsplineCurve::make(KnotVector knots, std::vector<Vec3> points, int dimension,
                                        std::vector<double> weights) {
    if (auto error = checkCurve(knots.pointCount(), points, dimension, weights)) {
        return *std::move(error);
    }
    return BsplineCurve(std::move(knots), std::move(points), dimension, std::move(weights));
}

Vec3 BsplineCurve::point(double t) const noexcept {
    const double inside = knots_.wrap(t);
    const std::size_t span = knots_.findSpan(inside);
    const auto degree = static_cast<std::size_t>(knots_.degree());
    if (!rational_) {
        std::array<Vec3, maxDegree + 1> active;
        for (std::size_t j = 0; j <= degree; ++j) active[j] = points_[knots_.pointIndex(span, j)];
        return kernels::deBoor(knots_.extended(), degree, span, inside, std::span<Vec3>(active));
    }
    std::array<Homogeneous, maxDegree + 1> active;
    for (std::size_t j = 0; j <= degree; ++j) {
        const std::size_t i = knots_.pointIndex(span, j);
        active[j] = Homogeneous(weights_[i] * points_[i], weights_[i]);
    }
    const Homogeneous lifted =
        kernels::deBoor(knots_.extended(), degree, span, inside, std::span<Homogeneous>(active));
    return Vec3(lifted) / lifted.w;
}

void BsplineCurve::derivatives(double t, Side side, std::span<Vec3> rows) const noexcept {
    const double inside = knots_.wrap(t, side);
    const std::size_t span = knots_.findSpan(inside, side);
    const auto degree = static_cast<std::size_t>(knots_.degree());
    std::array<double, maxDegree + 1> values{};
    std::array<double, maxDegree + 1> weightRows{};
    for (std::size_t order = 0; order < rows.size(); ++order) {
        rows[order] = Vec3(0);
        if (order > degree) continue;
        kernels::basisDerivative(knots_.extended(), degree, span, order, inside,
                                 std::span<double>(values));
        for (std::size_t j = 0; j <= degree; ++j) {
            const std::size_t i = knots_.pointIndex(span, j);
            const double factor = rational_ ? values[j] * weights_[i] : values[j];
            rows[order] += factor * points_[i];
            weightRows[order] += factor;
        }
    }
    if (rational_) {
        kernels::quotientRule(rows.size(), std::span(weightRows).first(degree + 1),
                              [&](std::size_t k) -> Vec3& { return rows[k]; });
    }
}

}  // namespace knotwork
