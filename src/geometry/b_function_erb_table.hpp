// The integral of the expo-rational density as a table of polynomials, graded towards λ and the
// ends.
//
// On each side of λ, of width L, s = |t−λ|/L and e = 1−s are the relative distances from λ and from
// the end, and φ = exp(−β (s/e)^endPower (L s/(1−L+L s))^farPower). The side keeps
// G(s) = ∫_s^1 φ, positive and accurate relative to itself. The half at λ is indexed by s, the
// other by e: cells get finer towards both, where φ may have any scale (α = 0.01, β = 100 puts all
// the mass within 1e-14 of λ), and the index is read off the key's exponent bits.
#pragma once

#include "geometry/b_function_cells.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork::b_function {

struct ErbSide {
    double beta;
    double endPower;
    double farPower;
    double width;

    /// φ at relative distances s from λ and e from the end, s + e = 1; 1 at λ, 0 at the end.
    [[nodiscard]] double density(double s, double e) const noexcept;
};

/// Polynomials on cells: eight blocks in each octave of the key, equal cells in a block.
class OctaveTable {
public:
    static constexpr std::size_t degree = 8;
    struct Cell {
        std::array<double, degree + 1> coefficients;  ///< powers of x in [−1, 1]
        [[nodiscard]] double at(double x) const noexcept {
            double sum = coefficients[degree];
            for (std::size_t k = degree; k-- > 0;) sum = sum * x + coefficients[k];
            return sum;
        }
    };
    struct Block {
        double low;
        double cellsPerUnit;
        std::uint32_t first;
    };

    [[nodiscard]] static std::uint64_t blockNumber(double key) noexcept {
        return __builtin_bit_cast(std::uint64_t, key) >>
               49U;  // the exponent and three binary digits
    }
    /// key within the blocks.
    [[nodiscard]] double at(double key) const noexcept {
        const Block& block = blocks[static_cast<std::size_t>(blockNumber(key) - firstBlock)];
        const double position = (key - block.low) * block.cellsPerUnit;
        const auto cell = static_cast<std::uint32_t>(position);
        return cells[block.first + cell].at(2 * (position - cell) - 1);
    }

    std::uint64_t firstBlock = 0;
    std::vector<Block> blocks;  ///< by ascending key
    std::vector<Cell> cells;    ///< likewise
};

/// One side: G(s) / scale for every s.
class ErbIntegral {
public:
    enum class Tail { exact, negligible };
    /// `exact` integrates the far tail at each call, for relative accuracy; `negligible` takes the
    /// tail, below 1e-18 of the whole, as 0.
    ErbIntegral(const ErbSide& side, Tail tail);

    [[nodiscard]] double total() const noexcept { return total_; }
    [[nodiscard]] double at(double s, double e) const noexcept {
        if (s < innerLow_) return innermost_.at(2 * s * perInnerLow_ - 1);
        if (s < innerEnd_) return inner_.at(s);
        if (e >= outerStart_) return outer_.at(e < 0.5 ? e : belowHalf);
        return tail_ == Tail::exact ? scale_ * tailIntegral(e) : 0;
    }
    void multiply(double factor) noexcept;
    /// The same for the other side of a symmetric function.
    [[nodiscard]] ErbIntegral withTail(Tail tail) const {
        ErbIntegral other = *this;
        other.tail_ = tail;
        return other;
    }

private:
    /// Where s φ(s) is largest: a lower bound of the integral.
    struct Peak {
        double at;
        double area;
    };
    static constexpr double belowHalf = 0.5 - 0x1p-54;

    [[nodiscard]] double tailIntegral(double e) const noexcept;
    [[nodiscard]] Peak findPeak() const noexcept;
    void placeEnds(double area) noexcept;
    void accumulate() noexcept;

    ErbSide side_;
    Tail tail_;
    double innerLow_ = 0.5;  // [0, innerLow_] is one cell,
    double perInnerLow_ = 2;
    double innerEnd_ = 0.5;  // [innerLow_, innerEnd_) the inner table,
    double outerStart_ = 1;  // e in [outerStart_, 1/2) the outer one, and the rest is the tail
    OctaveTable::Cell innermost_{};
    OctaveTable inner_;
    OctaveTable outer_;
    double total_ = 0;
    double scale_ = 1;
};

/// B and S = 1/∫φ for one set of parameters.
class ErbTable {
public:
    ErbTable(double alpha, double beta, double gamma, double lambda);

    /// At any t.
    [[nodiscard]] double value(double t) const noexcept {
        return either(simd::first(cells_.at(cells_.find(simd::splat(t)))), t);
    }
    /// The same of many; the values may take the parameters' places.
    void sample(std::span<const double> ts, std::span<double> values) const noexcept;
    /// S.
    [[nodiscard]] double scale() const noexcept { return scale_; }

private:
    /// What the cells have for t, unless that is NaN.
    [[nodiscard]] double either(double fast, double t) const noexcept {
        if (!std::isnan(fast)) return fast;
        return t > 0 ? (t < 1 ? fine(t) : 1) : 0;
    }
    /// 0 < t < 1: from the tables that get finer where they must.
    [[nodiscard]] double fine(double t) const noexcept {
        if (t < lambda_) return left_.at((lambda_ - t) * perLeft_, t * perLeft_);
        return 1 - right_.at((t - lambda_) * perRight_, (1 - t) * perRight_);
    }

    double lambda_;
    double perLeft_;
    double perRight_;
    bool symmetric_;
    ErbIntegral left_;
    ErbIntegral right_;
    double scale_;
    Cells cells_;  // for most of [0, 1], unless B is a step
};

}  // namespace knotwork::b_function
