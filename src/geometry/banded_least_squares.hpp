// Least squares with a banded matrix: A x = b for three right sides at once, a few rows at a time.
//
// Rows are reflected into the triangle R of A = Q R as they come, by one Householder reflection a
// column (C. L. Lawson and R. J. Hanson, Solving Least Squares Problems, 1974, ch. 27), so that A
// itself is never kept and errors grow with the condition of A, where normal equations square it.
//
// A row has at most `band` neighbouring columns that are not zero, and besides any of the last
// `border` columns, which is how the rows of a periodic spline look.
#pragma once

#include "geometry/vec.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace knotwork {

class BandedLeastSquares {
public:
    /// 1 ≤ band; border < columns. Keeps columns · (band + border + 3) numbers.
    BandedLeastSquares(std::size_t columns, std::size_t band, std::size_t border);

    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
    /// How many numbers a row has: `band` for the columns from its first on, `border`, and x, y, z
    /// of its right side. Of the band, what reaches into the border's columns is zero.
    [[nodiscard]] std::size_t rowSize() const noexcept { return band_ + border_ + 3; }
    /// Where column c stands in a row that begins with column `first`.
    [[nodiscard]] std::size_t placeOf(std::size_t column, std::size_t first) const noexcept {
        return column < core_ ? column - first : band_ + (column - core_);
    }

    /// Adds rows, one after the other in `rows`, whose bands begin at column `first`; they are used
    /// up. Later rows must not begin earlier. O(rows · band (band + border)).
    void add(std::size_t first, std::span<double> rows) noexcept;

    /// The first column that depends on those before it, to within rounding: |R_ii| is at most
    /// 1e-13 of the column's length.
    [[nodiscard]] std::optional<std::size_t> dependentColumn() const noexcept;

    /// The x of least |A x - b|. There must be no dependent column.
    [[nodiscard]] std::vector<Vec3> solve() const;

    /// The same among the x for which constraint_i · x = value_i. There may be one or two
    /// constraints, each a row of `columns` numbers, and they must be rows of A as well.
    struct Constraint {
        std::vector<double> row;
        Vec3 value;
    };
    [[nodiscard]] std::vector<Vec3> solve(std::span<const Constraint> constraints) const;

private:
    /// add() of four rows of a cubic's span, without border.
    void addFour(std::size_t first, double* rows) noexcept;
    [[nodiscard]] double* rowOf(std::size_t column) noexcept { return &r_[column * rowSize()]; }
    [[nodiscard]] const double* rowOf(std::size_t column) const noexcept {
        return &r_[column * rowSize()];
    }
    /// R_ij, zero where nothing is kept.
    [[nodiscard]] double at(std::size_t i, std::size_t j) const noexcept;
    /// The column after the last of the band in row i.
    [[nodiscard]] std::size_t bandEnd(std::size_t i) const noexcept;
    template <class Value>
    void solveUpper(std::span<Value> x) const noexcept;
    void solveLower(std::span<double> x) const noexcept;

    std::size_t columns_;
    std::size_t core_;  // columns before the border
    std::size_t band_;
    std::size_t border_;
    std::vector<double> r_;        // row i: columns i … i+band-1, the border, the right sides
    std::vector<double> squares_;  // of the lengths of A's columns
};

}  // namespace knotwork
