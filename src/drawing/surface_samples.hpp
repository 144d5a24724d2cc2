// A surface as a picture needs it: triangles, and the lines of its knots on them.
//
// Grids are by far the quickest way to points of a surface. How many cells a direction needs for a
// tolerance ε is read off the second differences of a coarse grid, which are close to
// M_uu = max |Suu|, M_uv and M_vv times the squares of its cells: with
//     h_u² M_uu + 2 h_u h_v M_uv + h_v² M_vv ≤ 8 ε
// triangles are within ε of the surface (S. Waldron, The error in linear interpolation at the
// vertices of a simplex, 1998). Where the knots are uniform, every line of knots is a line of the
// grid. A surface that has an edge or a gap where no line of a grid can be is triangulated cell by
// cell (surface_tessellation.hpp) instead, to 16 ε, since that takes fifty times as long a vertex.
#pragma once

#include "geometry/surface.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knotwork::drawing {

/// As many points as the grid of a picture has; a tolerance that asks for more gets this many.
inline constexpr std::size_t mostSurfacePoints = 40'000;

/// The parameters of the lines that are drawn on a surface, those of its ends included.
struct SurfaceLines {
    std::vector<double> u;
    std::vector<double> v;
};

/// The knots, or 9 of a direction that has none inside; every second, third … of more than 64.
[[nodiscard]] SurfaceLines surfaceLines(const Surface& surface);

struct SurfaceSamples {
    std::vector<double> positions;  ///< x, y, z triples
    std::vector<double> normals;    ///< likewise, of unit length
    std::vector<std::uint32_t> triangles;
    /// Of a grid its rows along u and v, point (i, j) at i · nv + j; 0 where it is none.
    std::size_t nu = 0;
    std::size_t nv = 0;
};

[[nodiscard]] SurfaceSamples sampleSurface(const Surface& surface, double tolerance);

/// The points of a line of constant u (or, with `alongU`, of constant v), read off the grid where it
/// has that line.
[[nodiscard]] std::vector<double> lineOnSurface(const Surface& surface,
                                                const SurfaceSamples& samples, bool alongU,
                                                double at, double tolerance);

}  // namespace knotwork::drawing
