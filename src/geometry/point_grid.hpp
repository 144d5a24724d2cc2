// Rows of grids of surfaces of which nothing can be tabulated, point by point; for SurfaceGrid.
#pragma once

#include "geometry/blending_surface.hpp"
#include "geometry/blending_triangle.hpp"
#include "geometry/grid_line.hpp"
#include "geometry/surface_differential.hpp"
#include "geometry/triples.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace knotwork {

/// S, Su and Sv.
using FirstOrder = std::array<Vec3, 3>;

[[nodiscard]] inline FirstOrder firstOrder(const BlendingSurface& surface,
                                           const SurfacePlace& at) noexcept {
    constexpr SurfaceOrders orders{1, 1};
    std::array<Vec3, orders.size()> rows;
    surface.derivatives(at, orders, rows);
    return {rows[0], rows[orders.at(1, 0)], rows[orders.at(0, 1)]};
}

[[nodiscard]] inline FirstOrder firstOrder(const BlendingTriangle& triangle,
                                           const SurfacePlace& at) noexcept {
    FirstOrder terms;
    triangle.series(at, 1, terms);
    return terms;
}

/// Of a blending surface with patches of any sort, or of a blending triangle.
template <class Kind>
class PointGrid {
public:
    /// The surface has to outlive it.
    PointGrid(const Kind& surface, const GridLine& u, const GridLine& v)
        : surface_(surface), u_(u), v_(v) {}

    void prepare(std::size_t row) noexcept { row_ = row; }
    /// Of the row prepared last, from `first` on. Where a normal cannot be told from Su × Sv its
    /// point is listed in unclear().
    void columns(std::size_t first, std::size_t count, double* positions,
                 double* normals) noexcept {
        unclear_.clear();
        const GridLine::Place u = u_.at(row_);
        for (std::size_t j = first; j < first + count; ++j, positions += 3, normals += 3) {
            const GridLine::Place v = v_.at(j);
            const auto [point, alongU, alongV] =
                firstOrder(surface_, {u.parameter, v.parameter, u.side, v.side});
            const Vec3 normal =
                plainNormal(alongU, alongV, u_.domain.length(), v_.domain.length());
            if (normal == Vec3(0)) unclear_.push_back(j);
            write(point, positions);
            write(normal, normals);
        }
    }
    [[nodiscard]] const std::vector<std::size_t>& unclear() const noexcept { return unclear_; }

private:
    const Kind& surface_;
    GridLine u_;
    GridLine v_;
    std::size_t row_ = 0;
    std::vector<std::size_t> unclear_;
};

}  // namespace knotwork
