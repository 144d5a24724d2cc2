// Values of a B-function from equal cells on each side of a split, two at a time.
//
// On [0, split] and on [split, 1] stand as many cells, each with a polynomial in u from -1/2 to 1/2
// centred in it, so that two values cost two rows of coefficients and one pass of Horner's rule. A
// cell whose polynomial is not good enough has NaN in place of coefficients, and so have the
// outermost ones, where all that lies beyond [0, 1] and NaN itself are looked up: whoever asks gets
// a NaN there and takes a slower way.
#pragma once

#include "geometry/simd.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork::b_function {

/// A polynomial of degree 7 by powers of u.
struct CellPolynomial {
    static constexpr std::size_t terms = 8;
    std::array<double, terms> coefficients;

    [[nodiscard]] double at(double u) const noexcept {
        double sum = coefficients[terms - 1];
        for (std::size_t k = terms - 1; k-- > 0;) sum = sum * u + coefficients[k];
        return sum;
    }
};

/// Where a cell is interpolated: half the Chebyshev–Lobatto points −cos(iπ/7). The outermost are
/// its ends, which neighbours share.
inline constexpr std::array<double, CellPolynomial::terms> cellNodes{
    -0.5,
    -0.45048443395120956,
    -0.31174490092936677,
    -0.11126046697815720,
    0.11126046697815720,
    0.31174490092936677,
    0.45048443395120956,
    0.5};

/// The polynomial with these values at the nodes.
[[nodiscard]] CellPolynomial interpolateCell(
    const std::array<double, CellPolynomial::terms>& values) noexcept;

class Cells {
public:
    /// No value at all.
    Cells() : Cells(0.5, 1) {}

    /// Those of a B-function f that is smooth but at the split, 0 < split < 1. Costs some 2000
    /// calls of f, three times as many where few cells do not do.
    template <class F>
    static Cells of(double split, const F& f);
    /// Those of an f with f(t) + f(1 - t) = 1, split at 1/2, for half of that.
    template <class F>
    static Cells ofSymmetric(const F& f);

    /// Where two parameters fall.
    struct Place {
        std::uint32_t first;
        std::uint32_t second;
        simd::Double2 u;
    };
    [[nodiscard]] Place find(simd::Double2 t) const noexcept {
        using simd::Double2;
        const Double2 distance = t - split_;
        const Double2 scale = simd::fromOn(distance, simd::splat(0), perRight_, perLeft_);
        const Double2 position =
            simd::smaller(last_, simd::larger(simd::splat(0), distance * scale + middle_));
        const simd::Wholes2 cell = simd::nearestWholes(position);
        return {cell.first, cell.second, position - cell.numbers};
    }

    /// Within 1e-15 and a relative 2e-11 of f, or NaN.
    [[nodiscard]] simd::Double2 at(const Place& place) const noexcept {
        const double* const a = cells_[place.first].coefficients.data();
        const double* const b = cells_[place.second].coefficients.data();
        simd::Double2 sum = simd::secondSecond(simd::load(a + 6), simd::load(b + 6));
        sum = sum * place.u + simd::firstFirst(simd::load(a + 6), simd::load(b + 6));
        for (const std::size_t k : {4U, 2U, 0U}) {
            const simd::Double2 ofA = simd::load(a + k);
            const simd::Double2 ofB = simd::load(b + k);
            sum = sum * place.u + simd::secondSecond(ofA, ofB);
            sum = sum * place.u + simd::firstFirst(ofA, ofB);
        }
        return sum;
    }

    /// The same values as long as parameters stay in one cell, where they cost a third. Answers how
    /// many it wrote, none in a cell of NaN. The values may take the parameters' places.
    std::size_t run(std::uint32_t cell, std::span<const double> ts,
                    std::span<double> values) const noexcept;

private:
    // On a side. Twice as many do for the steepest ones that are no steps.
    static constexpr std::size_t few = 128;
    static constexpr std::size_t many = 256;
    // Beyond these there is no need for a fast way, and what is larger may round to more than 1.
    static constexpr double smallest = 1e-15;
    static constexpr double largest = 1 - 1e-12;

    /// Of NaN only.
    Cells(double split, std::size_t perSide);
    /// As few cells as leave most of [0, 1] to a good one.
    template <class Fill>
    static Cells best(double split, const Fill& fill);
    // Each answers how many cells are good.
    template <class F>
    std::size_t fillLeft(const F& f);
    template <class F>
    std::size_t fillRight(const F& f);
    std::size_t mirrorLeft();
    template <class F>
    bool fillCell(const F& f, std::size_t j, double atStart, double atEnd);
    [[nodiscard]] double startOf(std::size_t j) const noexcept {
        return simd::first(split_) +
               (static_cast<double>(j) - static_cast<double>(perSide_)) * widthOf(j);
    }
    [[nodiscard]] double widthOf(std::size_t j) const noexcept {
        return j < perSide_ ? leftWidth_ : rightWidth_;
    }

    std::size_t perSide_;
    double leftWidth_;
    double rightWidth_;
    // The middle of cell j has position j.
    simd::Double2 split_;
    simd::Double2 perLeft_;
    simd::Double2 perRight_;
    simd::Double2 middle_;  // position of the split
    simd::Double2 last_;    // of the last cell
    std::vector<CellPolynomial> cells_;
};

template <class F>
Cells Cells::of(double split, const F& f) {
    return best(split, [&f](Cells& cells) { return cells.fillLeft(f) + cells.fillRight(f); });
}

template <class F>
Cells Cells::ofSymmetric(const F& f) {
    return best(0.5, [&f](Cells& cells) { return cells.fillLeft(f) + cells.mirrorLeft(); });
}

template <class Fill>
Cells Cells::best(double split, const Fill& fill) {
    for (const std::size_t perSide : {few, many}) {
        Cells cells(split, perSide);
        // Of a step there is little to see in equal cells, however many they are.
        const std::size_t least = perSide == few ? 3 * perSide / 2 : perSide / 2;
        if (fill(cells) >= least) return cells;
    }
    return {};
}

template <class F>
std::size_t Cells::fillLeft(const F& f) {
    std::size_t good = 0;
    double end = f(simd::first(split_));
    for (std::size_t j = perSide_ - 1; j > 0 && end > smallest; --j) {
        const double start = f(startOf(j));
        if (fillCell(f, j, start, end)) ++good;
        end = start;
    }
    return good;
}

template <class F>
std::size_t Cells::fillRight(const F& f) {
    std::size_t good = 0;
    double start = f(simd::first(split_));
    for (std::size_t j = perSide_; j + 2 < cells_.size() && start < largest; ++j) {
        const double end = f(startOf(j + 1));
        if (end < largest && fillCell(f, j, start, end)) ++good;
        start = end;
    }
    return good;
}

template <class F>
bool Cells::fillCell(const F& f, std::size_t j, double atStart, double atEnd) {
    const double middle = startOf(j) + widthOf(j) / 2;
    std::array<double, CellPolynomial::terms> values{};
    values.front() = atStart;
    values.back() = atEnd;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        values[i] = f(middle + cellNodes[i] * widthOf(j));
    }
    const CellPolynomial cell = interpolateCell(values);
    // Between the nodes, where the first term left out is largest.
    for (const double u : {0.0, 0.217}) {
        const double value = f(middle + u * widthOf(j));
        const double error = std::abs(cell.at(u) - value);
        if (!(error <= 5e-16 && error <= 1e-11 * value)) return false;
    }
    cells_[j] = cell;
    return true;
}

}  // namespace knotwork::b_function
