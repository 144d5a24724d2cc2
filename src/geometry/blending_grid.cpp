#include "geometry/blending_grid.hpp"

#include "geometry/blending_kernels.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/surface.hpp"
#include "geometry/surface_differential.hpp"

#include <algorithm>

namespace knotwork {

namespace {

using simd::Double2;

// Below this part of the largest product of |Su| and |Sv| a normal is looked at closely.
constexpr double clearly = 1e-6;

void write(const Vec3& v, double* to) noexcept {
    for (int axis = 0; axis < 3; ++axis) to[axis] = v[axis];
}

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

// ---- Planes and Bézier patches -----------------------------------------------------------------

bool BlendedPolynomialGrid::suits(const BlendingSurface& surface) noexcept {
    return !surface.cutsModel() &&
           static_cast<std::size_t>(surface.cut().orders().v) <= maxPowerDegree;
}

BlendedPolynomialGrid::BlendedPolynomialGrid(const BlendingSurface& surface, const GridLine& u,
                                             const GridLine& v)
    : surface_(surface),
      u_(surface.alongU(), u),
      v_(surface.alongV(), v),
      degree_(surface.cut().orders()),
      stride_((3 * degree_.columns() + 1) / 2 * 2) {
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
    findLeast();
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

void BlendedPolynomialGrid::findLeast() {
    double alongU = 0;
    double alongV = 0;
    for (std::size_t i = 0; i < surface_.alongU().count; ++i) {
        for (std::size_t j = 0; j < surface_.alongV().count; ++j) {
            const Affine& placement = surface_.place(i, j).placement();
            const auto matrix = surface_.matrix(i, j);
            alongU = std::max(alongU, glm::length(placement.vector(matrix[degree_.at(1, 0)])));
            alongV = std::max(alongV, glm::length(placement.vector(matrix[degree_.at(0, 1)])));
        }
    }
    least_ = clearly * alongU * alongV;
}

void BlendedPolynomialGrid::prepare(std::size_t row) noexcept {
    constexpr std::size_t longest = 3 * (maxPowerDegree + 1) + 1;
    const std::size_t lines = static_cast<std::size_t>(degree_.u) + 1;
    const BlendingSpan& span = u_.span(row);
    // The factors of line k of the patches before and after, for P and for Pu.
    std::array<double, 2 * (maxSurfaceOrder + 1)> factors;
    std::array<double, 2 * (maxSurfaceOrder + 1)> slopes;
    for (std::size_t a = 0; a < 2; ++a) {
        const std::size_t i = a == 0 ? span.first : span.second;
        const double x = span.t - (a == 0 ? 0 : span.shift) - surface_.alongU().knots[i];
        const double weight = a == 0 ? 1 - u_.value(row) : u_.value(row);
        const double slope = a == 0 ? -u_.slope(row) : u_.slope(row);
        std::array<double, maxSurfaceOrder + 1> powers;
        taylorPowers(x, std::span<double>(powers).first(lines));
        for (std::size_t k = 0; k < lines; ++k) {
            factors[a * lines + k] = weight * powers[k];
            slopes[a * lines + k] = slope * powers[k] + (k > 0 ? weight * powers[k - 1] : 0);
        }
    }
    double* to = row_.data();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        std::array<double, 2 * longest> points;  // of b = 0 and b = 1, each stride_ long
        std::array<double, 2 * longest> alongs;
        for (std::size_t b = 0; b < 2; ++b) {
            const double* first = netAt(span.first, cell, b);
            const double* second = netAt(span.second, cell, b);
            for (std::size_t n = 0; n < stride_; n += 2) {
                Double2 point = simd::splat(0);
                Double2 along = simd::splat(0);
                for (std::size_t k = 0; k < lines; ++k) {
                    const Double2 before = simd::load(first + k * stride_ + n);
                    const Double2 after = simd::load(second + k * stride_ + n);
                    point = point + simd::splat(factors[k]) * before +
                            simd::splat(factors[lines + k]) * after;
                    along = along + simd::splat(slopes[k]) * before +
                            simd::splat(slopes[lines + k]) * after;
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

// ---- Sub-surfaces of a parametric model --------------------------------------------------------

namespace {

Affine plus(const Affine& a, double factor, const Affine& b) noexcept {
    return {a.linear + factor * b.linear, a.offset + factor * b.offset};
}

Affine minus(const Affine& a, const Affine& b) noexcept { return plus(a, -1, b); }

}  // namespace

bool BlendedModelGrid::suits(const BlendingSurface& surface) noexcept {
    const auto shifts = [](const BlendDirection& along, double shift) {
        return along.closed() && shift != 0;
    };
    const BlendingSpan lastU = surface.alongU().spanAt(surface.domain().u.end, Side::left);
    const BlendingSpan lastV = surface.alongV().spanAt(surface.domain().v.end, Side::left);
    return surface.cutsModel() && surface.model().as<ParametricSurface>() != nullptr &&
           !shifts(surface.alongU(), surface.shiftU(lastU)) &&
           !shifts(surface.alongV(), surface.shiftV(lastV));
}

BlendedModelGrid::BlendedModelGrid(const BlendingSurface& surface, const GridLine& u,
                                   const GridLine& v)
    : surface_(surface),
      model_(*surface.model().as<ParametricSurface>()),
      u_(surface.alongU(), u),
      v_(surface.alongV(), v),
      terms_(model_.axes().size()),
      lengthU_(u.domain.length()),
      lengthV_(v.domain.length()),
      alongU_(2 * terms_ * u.count),
      alongV_(2 * terms_ * v.count),
      maps_(surface.alongV().knots.size()) {
    for (std::size_t i = 0; i < u.count; ++i) {
        model_.factorsU(u_.span(i).t, 1, std::span(alongU_).subspan(2 * terms_ * i));
    }
    for (std::size_t j = 0; j < v.count; ++j) {
        model_.factorsV(v_.span(j).t, 1, std::span(alongV_).subspan(2 * terms_ * j));
    }
}

void BlendedModelGrid::prepare(std::size_t row) noexcept {
    row_ = row;
    const BlendingSpan& u = u_.span(row);
    const std::size_t columns = surface_.alongV().count;
    const bool closed = surface_.alongV().closed();
    for (std::size_t j = 0; j < (closed ? columns : columns - 1); ++j) {
        const std::size_t next = j + 1 == columns ? 0 : j + 1;
        const Affine& p00 = surface_.place(u.first, j).placement();
        const Affine& p10 = surface_.place(u.second, j).placement();
        const Affine& p01 = surface_.place(u.first, next).placement();
        const Affine& p11 = surface_.place(u.second, next).placement();
        Maps& maps = maps_[j];
        maps.alike = p00 == p10 && p00 == p01 && p00 == p11;
        maps.first = p00;
        if (maps.alike) continue;
        const Affine change = minus(p10, p00);
        const Affine nextChange = minus(p11, p01);
        maps.first = plus(p00, u_.value(row), change);
        maps.step = minus(plus(p01, u_.value(row), nextChange), maps.first);
        const Affine none{Mat3(0.0), Vec3(0)};
        maps.firstU = plus(none, u_.slope(row), change);
        maps.stepU = plus(none, u_.slope(row), minus(nextChange, change));
    }
}

void BlendedModelGrid::columns(std::size_t first, std::size_t count, double* positions,
                               double* normals) noexcept {
    unclear_.clear();
    const std::span<const std::uint8_t> axes = model_.axes();
    const double* f = &alongU_[2 * terms_ * row_];
    for (std::size_t j = first; j < first + count; ++j, positions += 3, normals += 3) {
        const double* g = &alongV_[2 * terms_ * j];
        Vec3 s(0);
        Vec3 su(0);
        Vec3 sv(0);
        for (std::size_t k = 0; k < terms_; ++k) {
            const std::uint8_t axis = axes[k];
            s[axis] += f[2 * k] * g[2 * k];
            su[axis] += f[2 * k + 1] * g[2 * k];
            sv[axis] += f[2 * k] * g[2 * k + 1];
        }
        const Maps& maps = maps_[v_.span(j).first];
        Affine map = maps.first;
        if (!maps.alike) {
            map = plus(maps.first, v_.value(j), maps.step);
            const Affine alongU = plus(maps.firstU, v_.value(j), maps.stepU);
            su = map.vector(su) + alongU.point(s);
            sv = map.vector(sv) + v_.slope(j) * maps.step.point(s);
        } else {
            su = map.vector(su);
            sv = map.vector(sv);
        }
        const Vec3 normal = plainNormal(su, sv, lengthU_, lengthV_);
        if (normal == Vec3(0)) unclear_.push_back(j);
        write(map.point(s), positions);
        write(normal, normals);
    }
}

// ---- Any other ---------------------------------------------------------------------------------

void BlendedPointGrid::columns(std::size_t first, std::size_t count, double* positions,
                               double* normals) noexcept {
    unclear_.clear();
    constexpr SurfaceOrders orders{1, 1};
    const GridLine::Place u = u_.at(row_);
    std::array<Vec3, orders.size()> rows;
    for (std::size_t j = first; j < first + count; ++j, positions += 3, normals += 3) {
        const GridLine::Place v = v_.at(j);
        surface_.derivatives({u.parameter, v.parameter, u.side, v.side}, orders, rows);
        const Vec3 normal = plainNormal(rows[orders.at(1, 0)], rows[orders.at(0, 1)],
                                        u_.domain.length(), v_.domain.length());
        if (normal == Vec3(0)) unclear_.push_back(j);
        write(rows[0], positions);
        write(normal, normals);
    }
}

}  // namespace knotwork
