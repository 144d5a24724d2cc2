// Rows of grids of blending surfaces; for SurfaceGrid.
//
// The B-functions are tabulated once for the rows and once for the columns. In a row u is fixed, and
// between two knots of v the surface is P_0(v) + γ(v) (P_1 − P_0)(v), where
//     P_b(v) = β_0(u) P_{i, j+b}(u, v) + β_1(u) P_{i+1, j+b}(u, v):
// for planes and Bézier patches two polynomials in v, and two more for the derivative by u.
#pragma once

#include "geometry/blending_surface.hpp"
#include "geometry/grid_line.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace knotwork {

/// Where the parameters of a grid line lie between knots, and what the B-function and its first
/// derivative by the parameter are there.
class BlendTable {
public:
    BlendTable(const BlendDirection& along, const GridLine& line);

    [[nodiscard]] const BlendingSpan& span(std::size_t i) const noexcept { return spans_[i]; }
    [[nodiscard]] double value(std::size_t i) const noexcept { return values_[i]; }
    [[nodiscard]] double slope(std::size_t i) const noexcept { return values_[spans_.size() + i]; }

private:
    std::vector<BlendingSpan> spans_;
    std::vector<double> values_;  // all values, then all slopes
};

/// Columns of a grid that lie between the same two knots.
struct BlendRun {
    std::size_t first;
    std::size_t count;
    std::size_t cell;
};

/// Below this |Su × Sv| a normal is looked at closely: a small part of what it is at the knots.
[[nodiscard]] double leastNormal(const BlendingSurface& surface) noexcept;

/// Planes and Bézier patches.
class BlendedPolynomialGrid {
public:
    /// The surface has to outlive it.
    BlendedPolynomialGrid(const BlendingSurface& surface, const GridLine& u, const GridLine& v);

    void prepare(std::size_t row) noexcept;
    /// Of the row prepared last, from `first` on. Where a normal cannot be told from Su × Sv its
    /// point is listed in unclear().
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept;
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept { return unclear_; }

private:
    struct LineFactors;

    void addNet();
    [[nodiscard]] LineFactors factorsAt(std::size_t row) const noexcept;
    [[nodiscard]] const double* netAt(std::size_t patch, std::size_t cell,
                                      std::size_t b) const noexcept;

    const BlendingSurface& surface_;
    BlendTable u_;
    BlendTable v_;
    SurfaceOrders degree_;
    std::size_t stride_;  // numbers of one power form: 3 (d_v + 1), rounded up to even
    double least_;        // of |Su × Sv| where it tells the normal
    std::vector<BlendingSpan> cells_;  // along v, ascending
    std::vector<BlendRun> runs_;
    std::vector<double> net_;      // patch row by patch row: cell, b, power of u, power form in v
    std::vector<double> row_;      // of the grid: cell, term, P Pu D Du, axis
    std::vector<double> local_;    // w ∈ [−1, 1] of every column in its cell
    std::vector<double> weights_;  // γ …
    std::vector<double> slopes_;   // … and dγ/dw
    std::vector<double> inverses_;
    std::vector<std::size_t> unclear_;
};

}  // namespace knotwork
