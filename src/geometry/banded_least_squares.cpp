#include "geometry/banded_least_squares.hpp"

#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

// Rounding leaves up to 1e-15 of a column that depends on others; degree 25 has 1e-9 of real ones.
constexpr double independence = 1e-13;

/// Several rows, one after the other.
struct AnyRows {
    double* first;
    std::size_t count;
    std::size_t size;

    [[nodiscard]] double* row(std::size_t i) const noexcept { return first + i * size; }
};

/// As many as the compiler knows of, so that loops unroll.
template <std::size_t Count, std::size_t Size>
struct FixedRows {
    static constexpr std::size_t count = Count;
    static constexpr std::size_t size = Size;
    double* first;

    [[nodiscard]] double* row(std::size_t i) const noexcept { return first + i * size; }
};

/// A reflection of the space of one row of R and the rows below: x - v (v · x) / scale, where v is
/// `head` for the row of R and what stands at `place` of the others.
struct Reflection {
    double head;
    double scale;
    std::size_t place;
};

using simd::Double2;

/// Reflects `count` columns from `upper` of the row of R on, and from place `at` of the others on.
template <class Rows>
inline void reflect(const Reflection& by, double* upper, const Rows& rows, std::size_t at,
                    std::size_t count) noexcept {
    std::size_t k = 0;
    const Double2 head = simd::splat(by.head);
    const Double2 scale = simd::splat(1 / by.scale);
    for (; k + 2 <= count; k += 2) {
        const Double2 above = simd::load(upper + k);
        Double2 share = head * above;
        for (std::size_t i = 0; i < rows.count; ++i) {
            const double* const row = rows.row(i);
            share = share + simd::loadSplat(row + by.place) * simd::load(row + at + k);
        }
        share = share * scale;
        simd::store(upper + k, above - head * share);
        for (std::size_t i = 0; i < rows.count; ++i) {
            double* const row = rows.row(i);
            simd::store(row + at + k, simd::load(row + at + k) -
                                          simd::loadSplat(row + by.place) * share);
        }
    }
    if (k == count) return;
    double share = by.head * upper[k];
    for (std::size_t i = 0; i < rows.count; ++i) {
        share += rows.row(i)[by.place] * rows.row(i)[at + k];
    }
    share *= 1 / by.scale;
    upper[k] -= by.head * share;
    for (std::size_t i = 0; i < rows.count; ++i) {
        rows.row(i)[at + k] -= rows.row(i)[by.place] * share;
    }
}

/// What makes the column at `place` zero in all rows; R's own element is put in its place. A scale
/// of zero where there is nothing to do.
template <class Rows>
inline Reflection eliminate(double& element, const Rows& rows, std::size_t place) noexcept {
    double below = 0;
    for (std::size_t i = 0; i < rows.count; ++i) {
        below += rows.row(i)[place] * rows.row(i)[place];
    }
    if (!(below > 0)) return {0, 0, place};
    const double length = std::sqrt(element * element + below);
    // Away from zero, so that nothing cancels.
    const double reflected = element > 0 ? -length : length;
    const double head = element - reflected;
    element = reflected;
    return {head, -reflected * head, place};
}

}  // namespace

BandedLeastSquares::BandedLeastSquares(std::size_t columns, std::size_t band, std::size_t border)
    : columns_(columns),
      core_(columns - border),
      band_(band),
      border_(border),
      r_(columns * (band + border + 3), 0.0),
      squares_(columns, 0.0) {}

void BandedLeastSquares::add(std::size_t first, std::span<double> rows) noexcept {
    const bool four = border_ == 0 && band_ == 4 && rows.size() == 4 * rowSize();
    if (four && first + 4 <= core_) return addFour(first, rows.data());
    const AnyRows below{rows.data(), rows.size() / rowSize(), rowSize()};
    const std::size_t width = first < core_ ? std::min(band_, core_ - first) : 0;
    for (std::size_t i = 0; i < below.count; ++i) {
        const double* const row = below.row(i);
        for (std::size_t k = 0; k < width; ++k) squares_[first + k] += row[k] * row[k];
        for (std::size_t k = 0; k < border_; ++k) {
            squares_[core_ + k] += row[band_ + k] * row[band_ + k];
        }
    }
    for (std::size_t place = 0; place < width; ++place) {
        double* const upper = rowOf(first + place);
        const Reflection by = eliminate(upper[0], below, place);
        if (by.scale == 0) continue;
        reflect(by, upper + 1, below, place + 1, width - place - 1);
        reflect(by, upper + band_, below, band_, border_ + 3);
    }
    for (std::size_t k = 0; k < border_; ++k) {
        double* const upper = rowOf(core_ + k) + band_ + k;
        const Reflection by = eliminate(upper[0], below, band_ + k);
        if (by.scale == 0) continue;
        reflect(by, upper + 1, below, band_ + k + 1, border_ - k + 2);
    }
}

void BandedLeastSquares::addFour(std::size_t first, double* rows) noexcept {
    constexpr std::size_t four = 4;
    constexpr std::size_t size = four + 3;
    const FixedRows<four, size> below{rows};
    for (std::size_t i = 0; i < four; ++i) {
        const double* const row = below.row(i);
        for (std::size_t k = 0; k < four; ++k) squares_[first + k] += row[k] * row[k];
    }
    for (std::size_t place = 0; place < four; ++place) {
        double* const upper = &r_[(first + place) * size];
        const Reflection by = eliminate(upper[0], below, place);
        if (by.scale == 0) continue;
        reflect(by, upper + 1, below, place + 1, four - 1 - place);
        reflect(by, upper + four, below, four, 3);
    }
}

std::optional<std::size_t> BandedLeastSquares::dependentColumn() const noexcept {
    for (std::size_t i = 0; i < columns_; ++i) {
        const double least = independence * std::sqrt(squares_[i]);
        if (!(std::abs(at(i, i)) > least)) return i;
    }
    return std::nullopt;
}

double BandedLeastSquares::at(std::size_t i, std::size_t j) const noexcept {
    return rowOf(i)[j < core_ ? j - i : band_ + (j - core_)];
}

std::size_t BandedLeastSquares::bandEnd(std::size_t i) const noexcept {
    return std::min(i + band_, core_);
}

// R x = x, in place.
template <class Value>
void BandedLeastSquares::solveUpper(std::span<Value> x) const noexcept {
    for (std::size_t i = columns_; i-- > 0;) {
        Value sum = x[i];
        for (std::size_t j = i + 1; j < bandEnd(i); ++j) sum -= at(i, j) * x[j];
        for (std::size_t j = std::max(core_, i + 1); j < columns_; ++j) sum -= at(i, j) * x[j];
        x[i] = sum / at(i, i);
    }
}

// Rᵀ x = x, in place.
void BandedLeastSquares::solveLower(std::span<double> x) const noexcept {
    for (std::size_t i = 0; i < columns_; ++i) {
        x[i] /= at(i, i);
        for (std::size_t j = i + 1; j < bandEnd(i); ++j) x[j] -= at(i, j) * x[i];
        for (std::size_t j = std::max(core_, i + 1); j < columns_; ++j) x[j] -= at(i, j) * x[i];
    }
}

std::vector<Vec3> BandedLeastSquares::solve() const {
    std::vector<Vec3> x(columns_);
    for (std::size_t i = 0; i < columns_; ++i) {
        const double* const right = rowOf(i) + band_ + border_;
        x[i] = Vec3(right[0], right[1], right[2]);
    }
    solveUpper(std::span<Vec3>(x));
    return x;
}

namespace {

double dot(std::span<const double> a, std::span<const double> b) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Vec3 applied(std::span<const double> row, std::span<const Vec3> x) noexcept {
    Vec3 sum(0);
    for (std::size_t i = 0; i < x.size(); ++i) sum += row[i] * x[i];
    return sum;
}

}  // namespace

// x + R⁻¹ Y s with Y = R⁻ᵀ Cᵀ, where s makes it meet the constraints C: Yᵀ Y s = value - C x.
std::vector<Vec3> BandedLeastSquares::solve(std::span<const Constraint> constraints) const {
    std::vector<Vec3> x = solve();
    std::array<std::vector<double>, 2> y;
    std::array<Vec3, 2> missing{};
    for (std::size_t i = 0; i < constraints.size(); ++i) {
        y[i] = constraints[i].row;
        solveLower(y[i]);
        missing[i] = constraints[i].value - applied(constraints[i].row, x);
    }
    const double a = dot(y[0], y[0]);
    Vec3 first = missing[0] / a;
    Vec3 second(0);
    if (constraints.size() == 2) {
        const double b = dot(y[0], y[1]);
        const double rest = dot(y[1], y[1]) - b * b / a;
        second = (missing[1] - b * first) / rest;
        first -= b / a * second;
    }
    for (std::size_t i = 0; i < constraints.size(); ++i) {
        solveUpper(std::span<double>(y[i]));
        const Vec3& step = i == 0 ? first : second;
        for (std::size_t j = 0; j < x.size(); ++j) x[j] += y[i][j] * step;
    }
    return x;
}

}  // namespace knotwork
