// Curvatures from triangles against those of the surfaces that the triangles approximate.
#include "geometry/parametric_surface.hpp"
#include "geometry/surface_differential.hpp"
#include "geometry/surface_grid.hpp"
#include "geometry/triangle_curvatures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace knotwork {
namespace {

constexpr std::size_t rows = 81;

/// The largest deviation from the surface's own curvatures at the points of a grid, relative to
/// the largest of them; without a border of `border` points.
struct Deviation {
    double gaussian = 0;
    double mean = 0;
};

Deviation deviationOn(const Surface& surface, std::size_t count, std::size_t border) {
    std::vector<double> positions(3 * count * count);
    std::vector<double> normals(3 * count * count);
    SurfaceGrid(surface, count, count).points(0, count * count, positions, normals);
    const auto triangles = gridTriangles(count, count, closedDirections(surface));
    const VertexCurvatures found = triangleCurvatures(positions, normals, triangles);
    Deviation worst;
    Deviation largest;
    const Rectangle whole = domain(surface);
    for (std::size_t i = border; i + 1 + border < count; ++i) {
        for (std::size_t j = border; j + 1 + border < count; ++j) {
            const SurfacePlace at{uniformParameter(whole.u, i, count),
                                  uniformParameter(whole.v, j, count), Side::right, Side::right};
            const SurfaceCurvatures own = curvatures(surface, at).value();
            const std::size_t k = i * count + j;
            worst.gaussian = std::max(worst.gaussian, std::abs(found.gaussian[k] - own.gaussian));
            worst.mean = std::max(worst.mean, std::abs(found.mean[k] - own.mean));
            largest.gaussian = std::max(largest.gaussian, std::abs(own.gaussian));
            largest.mean = std::max(largest.mean, std::abs(own.mean));
        }
    }
    return {worst.gaussian / std::max(largest.gaussian, 1e-300),
            worst.mean / std::max(largest.mean, 1e-300)};
}

TEST(TriangleCurvatures, AnOctahedronWithItsNormalsHasTheMeanCurvatureOfItsSphere) {
    const std::vector<double> corners{2, 0, 0, -2, 0, 0, 0, 2, 0, 0, -2, 0, 0, 0, 2, 0, 0, -2};
    std::vector<double> normals = corners;
    for (double& n : normals) n /= 2;
    const std::vector<std::uint32_t> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                               2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    const VertexCurvatures found = triangleCurvatures(corners, normals, triangles);
    for (const double mean : found.mean) EXPECT_NEAR(mean, -0.5, 1e-15);
    for (const double gaussian : found.gaussian) EXPECT_GT(gaussian, 0);
}

TEST(TriangleCurvatures, TheyAreThoseOfTheSurfaceInsideAndTendToThemFourfold) {
    const Surface surface = ParametricSurface::make("torus").value();
    const Deviation coarse = deviationOn(surface, rows, 1);
    const Deviation fine = deviationOn(surface, 2 * rows - 1, 2);
    EXPECT_LT(fine.gaussian, 0.02);
    EXPECT_LT(fine.mean, 0.02);
    EXPECT_LT(fine.gaussian, 0.35 * coarse.gaussian);
    EXPECT_LT(fine.mean, 0.35 * coarse.mean);
}

TEST(TriangleCurvatures, APlaneHasNoneAndALoneVertexHasNone) {
    const std::vector<double> corners{0, 0, 5, 1, 0, 5, 0, 1, 5, 9, 9, 9};
    const std::vector<double> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    const VertexCurvatures found =
        triangleCurvatures(corners, normals, std::vector<std::uint32_t>{0, 1, 2});
    EXPECT_EQ(found.gaussian, (std::vector<double>(4, 0)));
    EXPECT_EQ(found.mean, (std::vector<double>(4, 0)));
}

TEST(TriangleCurvatures, TheOtherSideHasTheOppositeMeanCurvature) {
    const std::vector<double> corners{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<double> inward{-1, 0, 0, 0, -1, 0, 0, 0, -1};
    const VertexCurvatures found =
        triangleCurvatures(corners, inward, std::vector<std::uint32_t>{0, 2, 1});
    EXPECT_NEAR(found.mean[0], 1, 1e-15);
}

}  // namespace
}  // namespace knotwork
