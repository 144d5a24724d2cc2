#include "geometry/b_function_cells.hpp"

#include <limits>

namespace knotwork::b_function {

namespace {

constexpr std::size_t terms = CellPolynomial::terms;
using Matrix = std::array<std::array<double, terms>, terms>;

/// Row i: what the value at node i adds to the coefficients, Π (u - x_j) / (x_i - x_j).
constexpr Matrix lagrangePowers() noexcept {
    Matrix matrix{};
    for (std::size_t i = 0; i < terms; ++i) {
        auto& row = matrix[i];
        row[0] = 1;
        for (std::size_t j = 0; j < terms; ++j) {
            if (j == i) continue;
            const double scale = 1 / (cellNodes[i] - cellNodes[j]);
            for (std::size_t k = terms; k-- > 0;) {
                row[k] = ((k > 0 ? row[k - 1] : 0) - cellNodes[j] * row[k]) * scale;
            }
        }
    }
    return matrix;
}

constexpr Matrix toPowers = lagrangePowers();

}  // namespace

CellPolynomial interpolateCell(const std::array<double, terms>& values) noexcept {
    CellPolynomial cell{};
    // What they have in common would only be rounded.
    const double base = values[0];
    for (std::size_t i = 1; i < terms; ++i) {
        for (std::size_t k = 0; k < terms; ++k) {
            cell.coefficients[k] += toPowers[i][k] * (values[i] - base);
        }
    }
    cell.coefficients[0] += base;
    return cell;
}

std::size_t Cells::run(std::uint32_t cell, std::span<const double> ts,
                       std::span<double> values) const noexcept {
    using simd::Double2;
    const auto& c = cells_[cell].coefficients;
    if (std::isnan(c[0])) return 0;
    const Double2 scale = cell < perSide_ ? perLeft_ : perRight_;
    const Double2 number = simd::splat(cell);
    // Strictly inside, so that no neighbour is as near.
    const Double2 limit = simd::splat(0.25);
    std::size_t done = 0;
    for (; done + 4 <= ts.size(); done += 4) {
        const Double2 u0 = (simd::load(&ts[done]) - split_) * scale + middle_ - number;
        const Double2 u1 = (simd::load(&ts[done + 2]) - split_) * scale + middle_ - number;
        if (!simd::areBelow(u0 * u0, u1 * u1, limit)) break;
        Double2 sum0 = simd::splat(c[terms - 1]);
        Double2 sum1 = sum0;
        for (std::size_t k = terms - 1; k-- > 0;) {
            const Double2 term = simd::splat(c[k]);
            sum0 = sum0 * u0 + term;
            sum1 = sum1 * u1 + term;
        }
        simd::store(&values[done], sum0);
        simd::store(&values[done + 2], sum1);
    }
    return done;
}

std::size_t Cells::mirrorLeft() {
    std::size_t good = 0;
    for (std::size_t j = 0; j < perSide_; ++j) {
        const auto& left = cells_[j].coefficients;
        auto& right = cells_[2 * perSide_ - 1 - j].coefficients;
        if (!(left[0] > 1 - largest)) continue;
        right[0] = 1 - left[0];
        for (std::size_t k = 1; k < terms; ++k) right[k] = k % 2 == 0 ? -left[k] : left[k];
        ++good;
    }
    return good;
}

Cells::Cells(double split, std::size_t perSide)
    : perSide_(perSide),
      leftWidth_(split / static_cast<double>(perSide)),
      rightWidth_((1 - split) / static_cast<double>(perSide)),
      split_(simd::splat(split)),
      perLeft_(simd::splat(1 / leftWidth_)),
      perRight_(simd::splat(1 / rightWidth_)),
      middle_(simd::splat(static_cast<double>(perSide) - 0.5)),
      last_(simd::splat(static_cast<double>(2 * perSide - 1))),
      cells_(2 * perSide) {
    for (CellPolynomial& cell : cells_) {
        cell.coefficients.fill(std::numeric_limits<double>::quiet_NaN());
    }
}

}  // namespace knotwork::b_function
