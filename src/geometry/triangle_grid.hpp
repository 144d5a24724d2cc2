// Rows of grids of blending triangles; for SurfaceGrid. Where the lines of a grid run, its patches
// have no lines of their own: each point is evaluated by itself, of first order.
#pragma once

#include "geometry/blending_triangle.hpp"
#include "geometry/grid_line.hpp"

#include <cstddef>
#include <vector>

namespace knotwork {

class TriangleGrid {
public:
    /// The surface has to outlive it.
    TriangleGrid(const BlendingTriangle& surface, const GridLine& u, const GridLine& v)
        : surface_(surface), u_(u), v_(v) {}

    void prepare(std::size_t row) noexcept { row_ = row; }
    /// Of the row prepared last, from `first` on. Where a normal cannot be told from Su × Sv its
    /// point is listed in unclear().
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept;
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept { return unclear_; }

private:
    const BlendingTriangle& surface_;
    GridLine u_;
    GridLine v_;
    std::size_t row_ = 0;
    std::vector<std::size_t> unclear_;
};

}  // namespace knotwork
