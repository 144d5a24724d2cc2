// Rows of grids of tensor products, by tables of their functions of v; for SurfaceGrid.
//
// On a run of columns the same terms live, S(u, v_j) = Σ_k B_k(v_j) R_k(u): the table holds B_k and
// its derivative for every column, a row R_k and its derivative for every term.
#pragma once

#include "geometry/bspline_surface.hpp"
#include "geometry/grid_line.hpp"
#include "geometry/parametric_surface.hpp"

#include <cstddef>
#include <vector>

namespace knotwork {

class TableColumns {
public:
    /// So many terms live on each of the columns, of so many components: 3, or 4 where they are
    /// homogeneous. A normal is clear where |Su × Sv| ≥ least.
    TableColumns(std::size_t columns, std::size_t terms, std::size_t components, double least);

    /// Column j, one after the other: its terms are those of the row from `first` on.
    void add(std::size_t j, std::size_t first, const double* values, const double* slopes,
             std::size_t step);
    /// Points and normals of columns from `first` on; `row` holds S and Su of every term.
    void columns(std::size_t first, std::size_t count, const double* row, double* positions,
                 double* normals) noexcept;
    /// Those of them whose normals are not clear.
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept { return unclear_; }

private:
    struct Run {
        std::size_t first;
        std::size_t count;
        std::size_t term;
    };
    template <std::size_t Components>
    void run(std::size_t from, std::size_t to, const double* row, double* positions,
             double* normals) noexcept;

    std::size_t terms_;
    std::size_t components_;
    std::size_t stride_;
    double most_;                 // of 1 / |Su × Sv| where that is clear
    std::vector<double> values_;  // term by term
    std::vector<double> slopes_;
    std::vector<Run> runs_;
    std::vector<std::size_t> unclear_;
};

/// Parametric surfaces: terms f_k(u) g_k(v) e_k.
class ProductGrid {
public:
    ProductGrid(const ParametricSurface& surface, const GridLine& u, const GridLine& v);

    void prepare(std::size_t row) noexcept { row_ = &rows_[row * rowSize_]; }
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept {
        columns_.columns(first, count, row_, positions, normals);
    }
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept {
        return columns_.unclear();
    }

private:
    std::size_t rowSize_;
    std::vector<double> rows_;
    const double* row_ = nullptr;
    TableColumns columns_;
};

}  // namespace knotwork
