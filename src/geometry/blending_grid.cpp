#include "geometry/blending_grid.hpp"

#include "geometry/blending_kernels.hpp"
#include "geometry/surface.hpp"
#include "geometry/triples.hpp"

#include <algorithm>

namespace knotwork {

namespace {

using simd::Double2;

// Below this part of the largest product of |Su| and |Sv| a normal is looked at closely.
constexpr double clearly = 1e-6;

}  // namespace

BlendTable::BlendTable(const BlendDirection& along, const GridLine& line)
    : values_(2 * line.count) {
    std::vector<double> ratios;
    spans_.reserve(line.count);
    ratios.reserve(line.count);
    for (std::size_t i = 0; i < line.count; ++i) {
        const GridLine::Place at = line.at(i);
        spans_.push_back(along.spanAt(at.parameter, at.side));
        ratios.push_back(spans_.back().ratio());
    }
    along.blend.sampleDerivatives(ratios, values_);
    for (std::size_t i = 0; i < line.count; ++i) values_[line.count + i] /= spans_[i].length;
}

double leastNormal(const BlendingSurface& surface) noexcept {
    constexpr SurfaceOrders orders{1, 1};
    std::array<Vec3, orders.size()> rows;
    double alongU = 0;
    double alongV = 0;
    for (std::size_t i = 0; i < surface.alongU().count; ++i) {
        for (std::size_t j = 0; j < surface.alongV().count; ++j) {
            const SurfacePlace at{surface.alongU().knots[i], surface.alongV().knots[j]};
            surface.patch(i, j, at, orders, rows);
            alongU = std::max(alongU, glm::length(rows[orders.at(1, 0)]));
            alongV = std::max(alongV, glm::length(rows[orders.at(0, 1)]));
        }
    }
    return clearly * alongU * alongV;
}

BlendedPolynomialGrid::BlendedPolynomialGrid(const BlendingSurface& surface, const GridLine& u,
                                             const GridLine& v)
    : surface_(surface),
      u_(surface.alongU(), u),
      v_(surface.alongV(), v),
      degree_(surface.cut().orders()),
      stride_((3 * degree_.columns() + 1) / 2 * 2),
      least_(leastNormal(surface)) {
    const std::size_t room = v.count + 1;
    for (std::vector<double>* numbers : {&local_, &weights_, &slopes_, &inverses_}) {
        numbers->resize(room);
    }
    for (std::size_t j = 0; j < v.count; ++j) {
        const BlendingSpan& span = v_.span(j);
        const bool fresh = cells_.empty() || span.start > cells_.back().start;
        const bool wrapped = !fresh && span.start < cells_.back().start;
        if (fresh) cells_.push_back(span);
        if (fresh || wrapped) runs_.push_back({j, 0, wrapped ? 0 : cells_.size() - 1});
        ++runs_.back().count;
        local_[j] = 2 * span.ratio() - 1;
        weights_[j] = v_.value(j);
        slopes_[j] = v_.slope(j) * span.length / 2;
    }
    addNet();
    row_.resize(cells_.size() * 12 * degree_.columns());
}

const double* BlendedPolynomialGrid::netAt(std::size_t patch, std::size_t cell,
                                           std::size_t b) const noexcept {
    const std::size_t lines = static_cast<std::size_t>(degree_.u) + 1;
    return &net_[((patch * cells_.size() + cell) * 2 + b) * lines * stride_];
}

/// Every patch as Σ (u − u_i)^a/a! Q_a(w), once for each of the two cells that it has in v.
void BlendedPolynomialGrid::addNet() {
    const std::size_t lines = static_cast<std::size_t>(degree_.u) + 1;
    const std::size_t rows = surface_.alongU().count;
    const std::vector<double>& knots = surface_.alongV().knots;
    net_.assign(rows * cells_.size() * 2 * lines * stride_, 0.0);
    std::vector<Vec3> matrix(degree_.size());
    std::vector<Vec3> moved(degree_.size());
    double* to = net_.data();
    for (std::size_t i = 0; i < rows; ++i) {
        for (const BlendingSpan& cell : cells_) {
            for (std::size_t b = 0; b < 2; ++b) {
                const std::size_t j = b == 0 ? cell.first : cell.second;
                const double centre = cell.start + cell.length / 2 - (b == 0 ? 0 : cell.shift);
                const auto own = surface_.matrix(i, j);
                std::copy(own.begin(), own.end(), matrix.begin());
                surface_.place(i, j).place(matrix);
                polynomialDerivatives(matrix, degree_, 0, centre - knots[j], degree_, moved);
                for (std::size_t line = 0; line < lines; ++line, to += stride_) {
                    double factor = 1;  // (h/2)^k / k!
                    for (std::size_t k = 0; k < degree_.columns(); ++k) {
                        if (k > 0) factor *= cell.length / 2 / static_cast<double>(k);
                        write(factor * moved[degree_.at(line, k)], to + 3 * k);
                    }
                }
            }
        }
    }
}

/// The factors of the lines of the patches before and after, for P and for Pu.
struct BlendedPolynomialGrid::LineFactors {
    std::array<double, 2 * (maxSurfaceOrder + 1)> values;
    std::array<double, 2 * (maxSurfaceOrder + 1)> slopes;
};

BlendedPolynomialGrid::LineFactors BlendedPolynomialGrid::factorsAt(
    std::size_t row) const noexcept {
    const std::size_t lines = static_cast<std::size_t>(degree_.u) + 1;
    const BlendingSpan& span = u_.span(row);
    LineFactors factors;
    for (std::size_t a = 0; a < 2; ++a) {
        const std::size_t i = a == 0 ? span.first : span.second;
        const double x = span.t - (a == 0 ? 0 : span.shift) - surface_.alongU().knots[i];
        const double weight = a == 0 ? 1 - u_.value(row) : u_.value(row);
        const double slope = a == 0 ? -u_.slope(row) : u_.slope(row);
        std::array<double, maxSurfaceOrder + 1> powers;
        taylorPowers(x, std::span<double>(powers).first(lines));
        for (std::size_t k = 0; k < lines; ++k) {
            factors.values[a * lines + k] = weight * powers[k];
            factors.slopes[a * lines + k] =
                slope * powers[k] + (k > 0 ? weight * powers[k - 1] : 0);
        }
    }
    return factors;
}

void BlendedPolynomialGrid::prepare(std::size_t row) noexcept {
    constexpr std::size_t longest = 3 * (maxSurfaceOrder + 1) + 1;
    const std::size_t lines = static_cast<std::size_t>(degree_.u) + 1;
    const LineFactors factors = factorsAt(row);
    double* to = row_.data();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        std::array<double, 2 * longest> points;  // of b = 0 and b = 1, each stride_ long
        std::array<double, 2 * longest> alongs;
        for (std::size_t b = 0; b < 2; ++b) {
            const double* first = netAt(u_.span(row).first, cell, b);
            const double* second = netAt(u_.span(row).second, cell, b);
            for (std::size_t n = 0; n < stride_; n += 2) {
                Double2 point = simd::splat(0);
                Double2 along = simd::splat(0);
                for (std::size_t k = 0; k < lines; ++k) {
                    const Double2 before = simd::load(first + k * stride_ + n);
                    const Double2 after = simd::load(second + k * stride_ + n);
                    point = point + simd::splat(factors.values[k]) * before +
                            simd::splat(factors.values[lines + k]) * after;
                    along = along + simd::splat(factors.slopes[k]) * before +
                            simd::splat(factors.slopes[lines + k]) * after;
                }
                simd::store(&points[b * stride_ + n], point);
                simd::store(&alongs[b * stride_ + n], along);
            }
        }
        for (std::size_t n = 0; n < 3 * degree_.columns(); n += 3, to += 12) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                to[axis] = points[n + axis];
                to[3 + axis] = alongs[n + axis];
                to[6 + axis] = points[stride_ + n + axis] - points[n + axis];
                to[9 + axis] = alongs[stride_ + n + axis] - alongs[n + axis];
            }
        }
    }
}

void BlendedPolynomialGrid::columns(std::size_t first, std::size_t count, double* positions,
                                    double* normals) noexcept {
    unclear_.clear();
    const auto degree = static_cast<std::size_t>(degree_.v);
    const std::size_t end = first + count;
    for (const BlendRun& run : runs_) {
        const std::size_t from = std::max(first, run.first);
        const std::size_t to = std::min(end, run.first + run.count);
        if (from >= to) continue;
        const double largest = kernels::blendedRow(
            {&row_[run.cell * 12 * (degree + 1)], degree},
            {&local_[from], &weights_[from], &slopes_[from]}, to - from,
            positions + 3 * (from - first), normals + 3 * (from - first), &inverses_[from]);
        const double most = 2 / cells_[run.cell].length / least_;  // dS/dw is Sv · length/2
        if (largest < most) continue;
        for (std::size_t j = from; j < to; ++j) {
            if (!(inverses_[j] < most)) unclear_.push_back(j);
        }
    }
}

}  // namespace knotwork
