// Curvatures of a surface of which only triangles and normals at their corners are known.
//
// Over a triangle a, b, c whose normals u, v, w are interpolated linearly,
//     A = ½ ⟨n, (b − a) × (c − a)⟩,   n = (u + v + w)/3,
//     M = ½ ⟨n, (w − v) × a + (u − w) × b + (v − u) × c⟩,   G = ½ ⟨u, v × w⟩
// are its area and the integrals of the mean curvature (−2H) and of Gauss's. Their sums over the
// triangles round a vertex, divided by the area, tend to its curvatures as the triangles shrink.
// (J.-O. Lachaud, P. Romon, B. Thibert, D. Coeurjolly, Interpolated corrected curvature measures for
// polygonal surfaces, 2020.)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace knotwork {

/// One of each for every position; 0 at those without a triangle, or whose triangles have no area.
struct VertexCurvatures {
    std::vector<double> gaussian;
    std::vector<double> mean;  ///< −1/r on a sphere whose normals point outwards
};

/// Positions and unit normals as x,y,z triples, as many of one as of the other; triangles as three
/// indices each. O(positions + triangles).
[[nodiscard]] VertexCurvatures triangleCurvatures(std::span<const double> positions,
                                                  std::span<const double> normals,
                                                  std::span<const std::uint32_t> triangles);

}  // namespace knotwork
