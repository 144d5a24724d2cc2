#include "geometry/bspline_surface.hpp"

#include "geometry/bspline_kernels.hpp"
#include "geometry/checks.hpp"
#include "geometry/homogeneous.hpp"
#include "geometry/oslo.hpp"
#include "geometry/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace knotwork {

namespace {

constexpr double smallestWeight = 1e-9;  // as of curves
constexpr double largestWeight = 1e9;

using MaybeError = std::optional<Error>;

std::string at(const char* list, std::size_t place, std::size_t columns) {
    return indexed(indexed(list, place / columns), place % columns);
}

MaybeError checkWeights(std::span<const double> weights, std::size_t columns) {
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double weight = weights[k];
        if (weight >= smallestWeight && weight <= largestWeight) continue;
        return refuse(std::isfinite(weight) ? Code::outOfRange : Code::notFinite,
                      at("weights", k, columns),
                      formatNumber(weight) +
                          " is no allowed weight; weights are positive, from 1e-9 to 1e9");
    }
    return {};
}

MaybeError checkLength(std::size_t given, std::size_t needed, const char* path) {
    if (given == needed) return {};
    return refuse(Code::wrongLength, path,
                  std::to_string(given) + ' ' + path + " given, " + std::to_string(needed) +
                      " needed");
}

MaybeError checkNet(std::size_t needed, std::size_t columns, std::span<const Vec3> points,
                    std::span<const double> weights) {
    if (needed > static_cast<std::size_t>(maxPointCount)) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(needed) + " points; a surface has at most 100000");
    }
    if (auto error = checkLength(points.size(), needed, "points")) return error;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!allowedCoordinates(points[k])) {
            return checkCoordinates(points[k], at("points", k, columns));
        }
    }
    if (weights.empty()) return {};
    if (auto error = checkLength(weights.size(), needed, "weights")) return error;
    return checkWeights(weights, columns);
}

/// The rows of derivatives of the d+1 functions that live where t lies.
struct Active {
    std::size_t span = 0;
    std::size_t degree = 0;
    std::array<double, (maxSurfaceOrder + 1) * (maxDegree + 1)> rows;

    Active(const KnotVector& knots, double t, Side side, int order) noexcept
        : degree(static_cast<std::size_t>(knots.degree())) {
        const double inside = knots.wrap(t, side);
        span = knots.findSpan(inside, side);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            kernels::basisDerivative(
                knots.extended(), degree, span, k, inside,
                std::span<double>(rows).subspan(k * (degree + 1), degree + 1));
        }
    }
    [[nodiscard]] double at(std::size_t order, std::size_t j) const noexcept {
        return rows[order * (degree + 1) + j];
    }
};

/// The quotient rule in two variables, in place: rows hold the derivatives of w S, `weights` those
/// of w: w S^(a,b) = (w S)^(a,b) − Σ binomial(a, i) binomial(b, j) w^(i,j) S^(a−i,b−j).
void divideByWeight(const SurfaceOrders& orders, std::span<const double> weights,
                    std::span<Vec3> rows) noexcept {
    const std::size_t rowCount = static_cast<std::size_t>(orders.u) + 1;
    for (std::size_t a = 0; a < rowCount; ++a) {
        for (std::size_t b = 0; b < orders.columns(); ++b) {
            Vec3 sum = rows[orders.at(a, b)];
            double outer = 1;  // binomial(a, i)
            for (std::size_t i = 0; i <= a; ++i) {
                double inner = outer;  // times binomial(b, j)
                for (std::size_t j = 0; j <= b; ++j) {
                    if (i + j > 0) {
                        sum -= inner * weights[orders.at(i, j)] * rows[orders.at(a - i, b - j)];
                    }
                    inner *= static_cast<double>(b - j) / static_cast<double>(j + 1);
                }
                outer *= static_cast<double>(a - i) / static_cast<double>(i + 1);
            }
            rows[orders.at(a, b)] = sum / weights[0];
        }
    }
}

/// All rows and columns of the net, each a curve's points, become those over finer knots.
template <class Point>
std::vector<Point> refineNet(const BsplineSurface& surface, const KnotVector& finerU,
                             const KnotVector& finerV, std::span<const Point> net) {
    const std::size_t columns = surface.columnCount();
    const auto finerRows = static_cast<std::size_t>(finerU.pointCount());
    const auto finerColumns = static_cast<std::size_t>(finerV.pointCount());
    std::vector<Point> between(finerRows * columns);
    std::vector<Point> column(surface.rowCount());
    for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < column.size(); ++i) column[i] = net[i * columns + j];
        const auto finer = oslo1(surface.knotsU(), finerU, std::span<const Point>(column));
        for (std::size_t i = 0; i < finerRows; ++i) between[i * columns + j] = finer[i];
    }
    std::vector<Point> refined;
    refined.reserve(finerRows * finerColumns);
    for (std::size_t i = 0; i < finerRows; ++i) {
        const auto row = std::span<const Point>(between).subspan(i * columns, columns);
        const auto finer = oslo1(surface.knotsV(), finerV, row);
        refined.insert(refined.end(), finer.begin(), finer.end());
    }
    return refined;
}

Result<BsplineSurface> refineWeighted(const BsplineSurface& surface, KnotVector finerU,
                                      KnotVector finerV) {
    std::vector<Homogeneous> net;
    net.reserve(surface.points().size());
    for (std::size_t k = 0; k < surface.points().size(); ++k) {
        const double weight = surface.weights()[k];
        net.emplace_back(weight * surface.points()[k], weight);
    }
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (const Homogeneous& point :
         refineNet(surface, finerU, finerV, std::span<const Homogeneous>(net))) {
        points.push_back(Vec3(point) / point.w);
        weights.push_back(point.w);
    }
    return BsplineSurface::make(std::move(finerU), std::move(finerV), std::move(points),
                                std::move(weights));
}

}  // namespace

Error ofDirection(Error error, std::size_t direction) {
    for (const std::string_view list : {"knots", "degree"}) {
        if (!error.path.starts_with(list)) continue;
        error.path.insert(list.size(), "[" + std::to_string(direction) + "]");
        return error;
    }
    if (direction == 1 && error.path == "points") error.path = "points[0]";
    return error;
}

BsplineSurface::BsplineSurface(KnotVector knotsU, KnotVector knotsV, std::vector<Vec3> points,
                               std::vector<double> weights)
    : knotsU_(std::move(knotsU)),
      knotsV_(std::move(knotsV)),
      points_(std::move(points)),
      weights_(std::move(weights)),
      rational_(std::any_of(weights_.begin(), weights_.end(),
                            [&](double weight) { return weight != weights_.front(); })) {}

Result<BsplineSurface> BsplineSurface::make(KnotVector knotsU, KnotVector knotsV,
                                            std::vector<Vec3> points,
                                            std::vector<double> weights) {
    const auto columns = static_cast<std::size_t>(knotsV.pointCount());
    const std::size_t needed = static_cast<std::size_t>(knotsU.pointCount()) * columns;
    if (auto error = checkNet(needed, columns, points, weights)) return *std::move(error);
    return BsplineSurface(std::move(knotsU), std::move(knotsV), std::move(points),
                          std::move(weights));
}

void BsplineSurface::derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                                 std::span<Vec3> rows) const noexcept {
    const Active u(knotsU_, at.u, at.sideU, orders.u);
    const Active v(knotsV_, at.v, at.sideV, orders.v);
    const std::size_t rowCount = static_cast<std::size_t>(orders.u) + 1;
    std::array<double, (maxSurfaceOrder + 1) * (maxSurfaceOrder + 1)> weightRows;
    std::array<Homogeneous, maxDegree + 1> collapsed;
    for (std::size_t a = 0; a < rowCount; ++a) {
        for (std::size_t j = 0; j <= v.degree; ++j) {
            Homogeneous sum(0);
            for (std::size_t i = 0; i <= u.degree; ++i) {
                const std::size_t k = knotsU_.pointIndex(u.span, i) * columnCount() +
                                      knotsV_.pointIndex(v.span, j);
                const double factor = rational_ ? u.at(a, i) * weights_[k] : u.at(a, i);
                sum += Homogeneous(factor * points_[k], factor);
            }
            collapsed[j] = sum;
        }
        for (std::size_t b = 0; b < orders.columns(); ++b) {
            Homogeneous sum(0);
            for (std::size_t j = 0; j <= v.degree; ++j) sum += v.at(b, j) * collapsed[j];
            rows[orders.at(a, b)] = Vec3(sum);
            weightRows[orders.at(a, b)] = sum.w;
        }
    }
    if (rational_) divideByWeight(orders, weightRows, rows);
}

Result<BsplineSurface> refine(const BsplineSurface& surface, std::vector<double> refinedU,
                              std::vector<double> refinedV) {
    auto finerU = refinedKnots(surface.knotsU(), std::move(refinedU));
    if (!finerU) return ofDirection(finerU.error(), 0);
    auto finerV = refinedKnots(surface.knotsV(), std::move(refinedV));
    if (!finerV) return ofDirection(finerV.error(), 1);
    const auto count = static_cast<std::size_t>(finerU->pointCount()) *
                       static_cast<std::size_t>(finerV->pointCount());
    if (count > static_cast<std::size_t>(maxPointCount)) {
        return refuse(Code::tooLarge, "knots",
                      "the surface would have " + std::to_string(count) +
                          " points; at most 100000 are supported");
    }
    if (!surface.weights().empty()) {
        return refineWeighted(surface, std::move(*finerU), std::move(*finerV));
    }
    auto points = refineNet(surface, *finerU, *finerV, surface.points());
    return BsplineSurface::make(std::move(*finerU), std::move(*finerV), std::move(points));
}

}  // namespace knotwork
