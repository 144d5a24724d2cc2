#include "geometry/bspline_grid.hpp"

#include "geometry/bspline_curve.hpp"
#include "geometry/bspline_kernels.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/surface_kernels.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork {

namespace {

using simd::Double2;

// Below this part of the largest product of |Su| and |Sv| a normal is looked at closely; above it
// plainNormal() takes it.
constexpr double clearly = 1e-6;

/// The largest first derivative in one direction, bounded by the control points of the hodograph.
template <class PointAt>
double largestSlope(const KnotVector& knots, std::size_t lines, PointAt pointAt) noexcept {
    const auto t = knots.extended();
    const auto degree = static_cast<std::size_t>(knots.degree());
    const auto count = static_cast<std::size_t>(knots.pointCount());
    const std::size_t last = knots.closed() ? count + degree : count;
    double largest = 0;
    for (std::size_t i = 1; i < last; ++i) {
        const double width = t[i + degree] - t[i];
        if (!(width > 0)) continue;
        for (std::size_t line = 0; line < lines; ++line) {
            const Vec3 step = pointAt(i % count, line) - pointAt((i - 1) % count, line);
            largest = std::max(largest, glm::length(step) / width);
        }
    }
    return largest * static_cast<double>(degree);
}

double leastNormal(const BsplineSurface& surface) noexcept {
    const auto net = surface.points();
    const std::size_t columns = surface.columnCount();
    const double alongU =
        largestSlope(surface.knotsU(), columns,
                     [&](std::size_t i, std::size_t j) { return net[i * columns + j]; });
    const double alongV =
        largestSlope(surface.knotsV(), surface.rowCount(),
                     [&](std::size_t j, std::size_t i) { return net[i * columns + j]; });
    return clearly * alongU * alongV;
}

}  // namespace

BasisTable::BasisTable(const KnotVector& knots, const GridLine& line)
    : terms_(static_cast<std::size_t>(knots.degree()) + 1),
      values_(2 * terms_ * line.count),
      spans_(line.count) {
    for (std::size_t i = 0; i < line.count; ++i) {
        const GridLine::Place at = line.at(i);
        spans_[i] = knots.findSpan(at.parameter, at.side);
        const std::span<double> rows = std::span(values_).subspan(2 * terms_ * i, 2 * terms_);
        for (std::size_t order = 0; order < 2; ++order) {
            kernels::basisDerivative(knots.extended(), terms_ - 1, spans_[i], order, at.parameter,
                                     rows.subspan(order * terms_, terms_));
        }
    }
}

// ---- Polynomial surfaces -----------------------------------------------------------------------

PolynomialGrid::PolynomialGrid(const BsplineSurface& surface, const GridLine& u, const GridLine& v)
    : knotsU_(surface.knotsU()),
      basisU_(surface.knotsU(), u),
      degree_(static_cast<std::size_t>(surface.knotsV().degree())) {
    addRuns(surface.knotsV(), v);
    addNet(surface);
    row_.resize(2 * rowSize_);
    inverses_.resize(v.count + 1);
    least_ = leastNormal(surface);
}

void PolynomialGrid::addRuns(const KnotVector& knots, const GridLine& v) {
    const auto t = knots.extended();
    local_.resize(v.count + 1);
    for (std::size_t j = 0; j < v.count; ++j) {
        const GridLine::Place at = v.at(j);
        const std::size_t span = knots.findSpan(at.parameter, at.side);
        const bool wrapped = !spans_.empty() && span < spans_.back();
        const bool fresh = spans_.empty() || span > spans_.back();
        if (fresh) {
            spans_.push_back(span);
            scales_.push_back(2 / (t[span + 1] - t[span]));
        }
        const std::size_t piece = wrapped ? 0 : spans_.size() - 1;
        if (fresh || wrapped) runs_.push_back({j, 0, piece});
        ++runs_.back().count;
        const double centre = t[span] + (t[span + 1] - t[span]) / 2;
        local_[j] = (at.parameter - centre) * scales_[piece];
    }
    rowSize_ = 3 * (degree_ + 1) * spans_.size();
}

void PolynomialGrid::addNet(const BsplineSurface& surface) {
    const std::size_t columns = surface.columnCount();
    net_.resize(surface.rowCount() * rowSize_);
    double* to = net_.data();
    for (std::size_t i = 0; i < surface.rowCount(); ++i) {
        const auto points = surface.points().subspan(i * columns, columns);
        const auto curve = BsplineCurve::make(surface.knotsV(), {points.begin(), points.end()}, 3);
        for (const std::size_t span : spans_) {
            Coefficients c;
            powerCoefficients(*curve, span, 3, c);
            to = std::copy_n(c.begin(), 3 * (degree_ + 1), to);
        }
    }
}

void PolynomialGrid::prepare(std::size_t row) noexcept {
    const std::size_t terms = basisU_.terms();
    const double* values = basisU_.at(row);
    const std::size_t span = basisU_.span(row);
    std::fill(row_.begin(), row_.end(), 0.0);
    for (std::size_t i = 0; i < terms; ++i) {
        const double* from = &net_[knotsU_.pointIndex(span, i) * rowSize_];
        const double value = values[i];
        const double slope = values[terms + i];
        double* to = row_.data();
        for (std::size_t k = 0; k < rowSize_; k += 3, to += 6) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                to[axis] += value * from[k + axis];
                to[3 + axis] += slope * from[k + axis];
            }
        }
    }
}

void PolynomialGrid::columns(std::size_t first, std::size_t count, double* positions,
                             double* normals) noexcept {
    unclear_.clear();
    const std::size_t end = first + count;
    for (const Run& run : runs_) {
        const std::size_t from = std::max(first, run.first);
        const std::size_t to = std::min(end, run.first + run.count);
        if (from >= to) continue;
        const double* terms = &row_[run.piece * 6 * (degree_ + 1)];
        const double largest = kernels::surfaceRow({terms, degree_}, &local_[from], to - from,
                                                   positions + 3 * (from - first),
                                                   normals + 3 * (from - first), &inverses_[from]);
        const double most = scales_[run.piece] / least_;  // dS/dw is Sv over the scale
        if (largest < most) continue;
        for (std::size_t j = from; j < to; ++j) {
            if (!(inverses_[j] < most)) unclear_.push_back(j);
        }
    }
}

// ---- Any B-spline surface ----------------------------------------------------------------------

TensorGrid::TensorGrid(const BsplineSurface& surface, const GridLine& u, const GridLine& v)
    : surface_(surface),
      basisU_(surface.knotsU(), u),
      components_(surface.rational() ? 4 : 3),
      columns_(v.count, static_cast<std::size_t>(surface.knotsV().degree()) + 1, components_,
               leastNormal(surface)) {
    const BasisTable basisV(surface.knotsV(), v);
    const std::size_t degree = basisV.terms() - 1;
    for (std::size_t j = 0; j < v.count; ++j) {
        const double* values = basisV.at(j);
        columns_.add(j, basisV.span(j) - degree, values, values + basisV.terms(), 1);
    }
    for (std::size_t k = 0; k < surface.points().size(); ++k) {
        const double weight = surface.rational() ? surface.weights()[k] : 1;
        const Vec3 point = weight * surface.points()[k];
        net_.insert(net_.end(), {point.x, point.y, point.z});
        if (surface.rational()) net_.push_back(weight);
    }
    row_.resize(2 * components_ * (surface.columnCount() + degree));
}

void TensorGrid::prepare(std::size_t row) noexcept {
    const std::size_t terms = basisU_.terms();
    const std::size_t rowSize = components_ * surface_.columnCount();
    const double* values = basisU_.at(row);
    std::fill(row_.begin(), row_.end(), 0.0);
    for (std::size_t i = 0; i < terms; ++i) {
        const std::size_t line = surface_.knotsU().pointIndex(basisU_.span(row), i);
        const double* from = &net_[line * rowSize];
        double* to = row_.data();
        for (std::size_t k = 0; k < rowSize; k += components_, to += 2 * components_) {
            for (std::size_t c = 0; c < components_; ++c) {
                to[c] += values[i] * from[k + c];
                to[components_ + c] += values[terms + i] * from[k + c];
            }
        }
    }
    if (!surface_.knotsV().closed()) return;
    const auto beyond = row_.begin() + static_cast<std::ptrdiff_t>(2 * rowSize);
    std::copy_n(row_.begin(), row_.end() - beyond, beyond);
}

}  // namespace knotwork
