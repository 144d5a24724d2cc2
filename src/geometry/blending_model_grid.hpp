// Rows of grids of blends of sub-surfaces; for SurfaceGrid.
//
// On a column of the grid a model is a sum Σ_k g_k(v) p_k(u). In a row the maps by which the four
// patches of a cell are placed become two, A_0 and A_1, one for each knot of v:
//     S = Σ_k (1 − γ) g_k A_0 p_k + γ g_k A_1 p_k,
// again a sum over products, of twice as many terms.
#pragma once

#include "geometry/blending_grid.hpp"
#include "geometry/bspline_grid.hpp"
#include "geometry/table_grid.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace knotwork {

/// Parametric models, and B-spline surfaces that are not rational over all of their domain; neither
/// shifted at a seam.
class BlendedModelGrid {
public:
    /// Whether this is a surface of that sort.
    [[nodiscard]] static bool suits(const BlendingSurface& surface) noexcept;
    /// The surface has to outlive it.
    BlendedModelGrid(const BlendingSurface& surface, const GridLine& u, const GridLine& v);

    void prepare(std::size_t row) noexcept;
    /// Of the row prepared last, from `first` on. Where a normal cannot be told from Su × Sv its
    /// point is listed in unclear().
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept {
        columns_.columns(first, count, row_.data(), positions, normals);
    }
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept {
        return columns_.unclear();
    }

private:
    /// Columns between the same knots of the surface and of the model.
    struct Run {
        std::size_t cell;
        std::size_t span;
    };
    struct Maps {
        Affine map;
        Affine slope;  // by u
    };

    void addColumns(const GridLine& v);
    [[nodiscard]] std::size_t runOf(std::size_t cell, std::size_t span);
    void takeModel(std::size_t row) noexcept;
    [[nodiscard]] Maps mapsAt(std::size_t row, std::size_t j) const noexcept;

    const BlendingSurface& surface_;
    const ParametricSurface* model_;   // one of the two
    const BsplineSurface* spline_;
    BlendTable u_;
    BlendTable v_;
    std::optional<BasisTable> basisU_;  // of a spline …
    std::optional<BasisTable> basisV_;
    std::vector<double> alongU_;  // … and of a model f_k and its derivative, parameter by parameter
    std::size_t terms_;           // that live on a column
    TableColumns columns_;
    std::vector<Run> runs_;
    std::vector<Vec3> points_;  // p_k at the row …
    std::vector<Vec3> slopes_;  // … and their derivatives by u
    std::vector<double> row_;   // run by run: terms of A_0, terms of A_1; S and Su, axis
};

}  // namespace knotwork
