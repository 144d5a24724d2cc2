// Rows of grids of B-spline surfaces; for SurfaceGrid.
#pragma once

#include "geometry/bspline_surface.hpp"
#include "geometry/grid_line.hpp"
#include "geometry/table_grid.hpp"

#include <cstddef>
#include <vector>

namespace knotwork {

/// The functions of one direction that live at each of the parameters of a grid line, and their
/// first derivatives.
class BasisTable {
public:
    BasisTable(const KnotVector& knots, const GridLine& line);

    [[nodiscard]] std::size_t terms() const noexcept { return terms_; }
    /// terms() values, and then as many derivatives.
    [[nodiscard]] const double* at(std::size_t i) const noexcept {
        return &values_[2 * terms_ * i];
    }
    [[nodiscard]] std::size_t span(std::size_t i) const noexcept { return spans_[i]; }

private:
    std::size_t terms_;
    std::vector<double> values_;
    std::vector<std::size_t> spans_;
};

/// Polynomial surfaces of a degree up to maxPowerDegree in v. The control net's rows become power
/// forms piece by piece; a row of the grid is a combination of d_u + 1 of them, for S and for Su.
class PolynomialGrid {
public:
    /// The surface has to outlive it.
    PolynomialGrid(const BsplineSurface& surface, const GridLine& u, const GridLine& v);

    void prepare(std::size_t row) noexcept;
    /// Of the row prepared last, from `first` on. Where a normal cannot be told from Su × Sv its
    /// point is listed in unclear().
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept;
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept { return unclear_; }

private:
    /// Columns that lie in one piece.
    struct Run {
        std::size_t first;
        std::size_t count;
        std::size_t piece;
    };
    void addRuns(const KnotVector& knots, const GridLine& v);
    void addNet(const BsplineSurface& surface);

    const KnotVector& knotsU_;
    BasisTable basisU_;
    std::size_t degree_;
    std::size_t rowSize_ = 0;           // numbers of a net row: pieces · (d_v + 1) · 3
    std::vector<std::size_t> spans_;    // of the pieces
    std::vector<double> scales_;        // dw/dv of the pieces
    std::vector<double> net_;           // net row by net row: piece, term, axis
    std::vector<double> row_;           // of the grid: piece, term, S and Su, axis
    std::vector<double> local_;         // w of every column
    std::vector<double> inverses_;
    std::vector<Run> runs_;
    std::vector<std::size_t> unclear_;
    double least_ = 0;                  // of |Su × Sv| where it tells the normal
};

/// Any B-spline surface: tables of the basis functions of rows and of columns.
class TensorGrid {
public:
    /// The surface has to outlive it.
    TensorGrid(const BsplineSurface& surface, const GridLine& u, const GridLine& v);

    void prepare(std::size_t row) noexcept;
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept {
        columns_.columns(first, count, row_.data(), positions, normals);
    }
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept {
        return columns_.unclear();
    }

private:
    const BsplineSurface& surface_;
    BasisTable basisU_;
    std::size_t components_;   // 3, or 4 of a rational surface
    std::vector<double> net_;  // the control points by components, row by row
    std::vector<double> row_;  // the net's columns at the row's u: S and Su, those of a closed
                               // direction beyond its seam too
    TableColumns columns_;
};

}  // namespace knotwork
