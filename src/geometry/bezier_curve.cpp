#include "geometry/bezier_curve.hpp"

#include "geometry/bspline_kernels.hpp"
#include "geometry/checks.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

constexpr std::size_t mostPoints = maxDegree + 1;
using Homogeneous = glm::dvec4;  // (w x, w y, w z, w)

std::optional<Error> checkCount(std::size_t count) {
    if (count >= 2 && count <= mostPoints) return {};
    return refuse(count < 2 ? Code::wrongLength : Code::tooLarge, "points",
                  std::to_string(count) +
                      " points; a Bézier curve has 2 to 26, one more than its degree");
}

/// Δ^k b_0 = Σ (−1)^(k−i) binomial(k, i) b_i.
template <class Point>
Point difference(std::span<const Point> points, std::size_t k) noexcept {
    Point sum(0.0);
    double factor = k % 2 == 0 ? 1 : -1;
    for (std::size_t i = 0; i <= k; ++i) {
        sum += factor * points[i];
        factor *= -static_cast<double>(k - i) / static_cast<double>(i + 1);
    }
    return sum;
}

/// rows[k] = d!/(d−k)! h^(−k) Δ^k of the points that are left after d − k steps of de Casteljau's
/// algorithm at u, for as many rows as there are. The points are overwritten.
template <class Point>
void bernsteinRows(std::span<Point> points, double u, double length,
                   std::span<Point> rows) noexcept {
    const std::size_t degree = points.size() - 1;
    std::fill(rows.begin(), rows.end(), Point(0.0));
    for (std::size_t left = degree;; --left) {
        if (left < rows.size()) {
            double factor = 1;
            for (std::size_t i = 0; i < left; ++i) factor *= static_cast<double>(degree - i) / length;
            rows[left] = factor * difference<Point>(points, left);
        }
        if (left == 0) return;
        for (std::size_t j = 0; j < left; ++j) {
            points[j] = (1 - u) * points[j] + u * points[j + 1];
        }
    }
}

/// Rows of (w C, w) become rows of C.
void project(std::span<const Homogeneous> lifted, std::span<Vec3> rows) noexcept {
    std::array<double, mostPoints> weights{};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k] = Vec3(lifted[k]);
        weights[k] = lifted[k].w;
    }
    kernels::quotientRule(rows.size(), std::span<const double>(weights).first(rows.size()),
                          [&](std::size_t k) -> Vec3& { return rows[k]; });
}

/// The k-th elementary symmetric mean of d − j numbers `low` and j numbers `high`: the blossom of
/// t^k. A mean of products, so nothing larger than max(|low|, |high|)^k stands in it.
double blossomOfPower(std::size_t d, std::size_t j, std::size_t k, double low,
                      double high) noexcept {
    // Of k numbers drawn from the d, i are `high`: hypergeometric probabilities.
    double sum = 0;
    for (std::size_t i = 0; i <= k; ++i) {
        if (i > j || k - i > d - j) continue;
        double probability = 1;
        for (std::size_t drawn = 0; drawn < k; ++drawn) {
            const bool isHigh = drawn < i;
            const std::size_t remaining = isHigh ? j - drawn : d - j - (drawn - i);
            probability *= static_cast<double>(remaining) / static_cast<double>(d - drawn) *
                           (isHigh ? high : low);
        }
        double choices = 1;  // in which order they come
        for (std::size_t c = 0; c < i; ++c) {
            choices *= static_cast<double>(k - c) / static_cast<double>(c + 1);
        }
        sum += choices * probability;
    }
    return sum;
}

}  // namespace

BezierCurve::BezierCurve(std::vector<Vec3> points, std::vector<double> weights,
                         const Interval& domain)
    : points_(std::move(points)), weights_(std::move(weights)), domain_(domain),
      dimension_(std::all_of(points_.begin(), points_.end(),
                             [](const Vec3& point) { return point.z == 0; })
                     ? 2
                     : 3),
      rational_(std::any_of(weights_.begin(), weights_.end(),
                            [&](double weight) { return weight != weights_.front(); })) {}

Result<BezierCurve> BezierCurve::make(std::vector<Vec3> points, std::vector<double> weights,
                                      const Interval& domain) {
    if (auto error = checkCount(points.size())) return *std::move(error);
    // One span of a B-spline refuses points and weights as every B-spline does.
    const int degree = static_cast<int>(points.size()) - 1;
    auto span = BsplineCurve::make(*KnotVector::uniform(degree, degree + 1, Form::clamped), points,
                                   3, weights);
    if (!span) return span.error();
    if (auto error = checkDomain(domain)) return *std::move(error);
    return BezierCurve(std::move(points), std::move(weights), domain);
}

BezierCurve BezierCurve::fromTaylor(std::span<const Vec3> taylor, double t0,
                                    const Interval& domain) {
    const std::size_t degree = taylor.size() - 1;
    std::vector<Vec3> points(taylor.size(), Vec3(0.0));
    for (std::size_t j = 0; j <= degree; ++j) {
        for (std::size_t k = taylor.size(); k-- > 0;) {
            points[j] += blossomOfPower(degree, j, k, domain.start - t0, domain.end - t0) * taylor[k];
        }
    }
    return {std::move(points), {}, domain};
}

void BezierCurve::evaluate(double t, Side, std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    const double u = (t - domain_.start) / domain_.length();
    const std::size_t count = points_.size();
    if (!rational_) {
        std::array<Vec3, mostPoints> work;
        std::copy(points_.begin(), points_.end(), work.begin());
        bernsteinRows<Vec3>({work.data(), count}, u, domain_.length(), rows);
        return;
    }
    std::array<Homogeneous, mostPoints> work;
    for (std::size_t j = 0; j < count; ++j) {
        work[j] = {weights_[j] * points_[j], weights_[j]};
    }
    std::array<Homogeneous, mostPoints> lifted;
    bernsteinRows<Homogeneous>({work.data(), count}, u, domain_.length(),
                               {lifted.data(), rows.size()});
    project(lifted, rows);
    // w p / w may be next to p.
    if (t == domain_.start) rows[0] = points_.front();
    if (t == domain_.end) rows[0] = points_.back();
}

std::optional<BsplineCurve> asBspline(const BezierCurve& curve) {
    const std::size_t order = curve.degree() + 1;
    std::vector<double> knots(order, curve.domain().start);
    knots.insert(knots.end(), order, curve.domain().end);
    const int count = static_cast<int>(order);
    auto vector = KnotVector::make(std::move(knots), count - 1, count, Form::clamped);
    if (!vector) return std::nullopt;
    const auto points = curve.points();
    const auto weights = curve.weights();
    auto made = BsplineCurve::make(std::move(*vector), {points.begin(), points.end()},
                                   curve.dimension(), {weights.begin(), weights.end()});
    return made ? std::optional(std::move(*made)) : std::nullopt;
}

}  // namespace knotwork
