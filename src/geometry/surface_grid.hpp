// Grids of points and normals over the whole of a surface, as they are drawn.
//
// Whatever depends on one direction only is tabulated once: a polynomial B-spline surface becomes,
// for every row, the polynomial pieces in v of S(u_i, ·) and Su(u_i, ·), which Horner's rule runs
// over; other tensor products sum tables of rows and columns.
#pragma once

#include "geometry/grid_line.hpp"
#include "geometry/surface.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace knotwork {

/// As many points as a grid may have.
inline constexpr std::size_t mostGridPoints = 4'000'000;

/// nu × nv points (each at least 2), uniform in both parameters with both ends included: point
/// (i, j), i along u, is number i · nv + j. Where a direction is closed the points of its last row or
/// column are those of its first to the bit.
class SurfaceGrid {
public:
    SurfaceGrid(Surface surface, std::size_t nu, std::size_t nv);
    ~SurfaceGrid();
    SurfaceGrid(SurfaceGrid&&) noexcept;
    SurfaceGrid& operator=(SurfaceGrid&&) noexcept;

    [[nodiscard]] std::size_t rowCount() const noexcept { return u_.count; }
    [[nodiscard]] std::size_t columnCount() const noexcept { return v_.count; }

    /// Points first … first+count−1 and their unit normals (as unitNormal() has them), x, y, z
    /// triples each. Quickest when asked for in order.
    void points(std::size_t first, std::size_t count, std::span<double> positions,
                std::span<double> normals) noexcept;

private:
    struct Engine;

    GridLine u_;
    GridLine v_;
    std::unique_ptr<Engine> engine_;
};

/// Two triangles a cell, counter-clockwise seen from where the normals point to. At a closed seam
/// they use the points of the first row or column, so that the mesh has no edge there.
[[nodiscard]] std::vector<std::uint32_t> gridTriangles(std::size_t nu, std::size_t nv,
                                                       ClosedDirections closed);

}  // namespace knotwork
