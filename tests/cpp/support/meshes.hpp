// Meshes as tests make them: solids by hand, grids, and noisy ones with holes as of scanners.
#pragma once

#include "geometry/mesh.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace knotwork::test {

using Corners = std::vector<std::uint32_t>;
using FaceLists = std::vector<Corners>;

inline Result<Mesh> meshOf(std::vector<Vec3> points, const FaceLists& faces) {
    Corners corners;
    Corners starts{0};
    for (const Corners& face : faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    return Mesh::make(std::move(points), std::move(corners), std::move(starts));
}

inline Mesh cubeMesh() {
    return *meshOf({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                    {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                   {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                    {3, 0, 4, 7}});
}

inline Mesh tetrahedronMesh() {
    return *meshOf({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

/// Quads over whole coordinates in the plane z = 0, columns × rows of them.
inline Mesh gridMesh(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Vec3> points;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i <= columns; ++i) points.emplace_back(i, j, 0);
    }
    Corners corners;
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t at = j * (columns + 1) + i;
            for (const std::uint32_t v : {at, at + 1, at + columns + 2, at + columns + 1}) {
                corners.push_back(v);
            }
        }
    }
    return *Mesh::make(std::move(points), std::move(corners), 4);
}

/// Every quad of the grid cut along the same diagonal.
inline Mesh triangleGrid(std::uint32_t columns, std::uint32_t rows) {
    const Mesh quads = gridMesh(columns, rows);
    Corners corners;
    for (std::size_t f = 0; f < quads.faces().count(); ++f) {
        const auto q = quads.faces()[f];
        for (const std::uint32_t v : {q[0], q[1], q[2], q[0], q[2], q[3]}) corners.push_back(v);
    }
    return *Mesh::make({quads.points().begin(), quads.points().end()}, std::move(corners), 3);
}

/// A fan of `blades` triangles around the vertex 0, which is also the smallest: closed all round.
inline Mesh fanMesh(std::uint32_t blades) {
    std::vector<Vec3> points(blades + 1, Vec3{0});
    Corners corners;
    for (std::uint32_t i = 0; i < blades; ++i) {
        points[i + 1] = {i, 1, 0};
        for (const std::uint32_t v : {0U, i + 1, (i + 1) % blades + 1}) corners.push_back(v);
    }
    return *Mesh::make(std::move(points), std::move(corners), 3);
}

/// What a scanner leaves of a bumpy sphere: about 2 · size² triangles with noise, `holes` in every
/// hundred faces missing here and there (bow ties included), and vertices that no face uses.
inline Mesh scannedMesh(std::uint32_t size, unsigned holes, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> noise(-0.05, 0.05);
    std::uniform_int_distribution<unsigned> percent(0, 99);
    const Mesh grid = triangleGrid(size, size);
    std::vector<Vec3> points(grid.points().begin(), grid.points().end());
    for (Vec3& p : points) {
        const double u = 0.1 + 6 * p.x / size;
        const double v = -1.5 + 3 * p.y / size;
        p = {std::cos(v) * std::cos(u) + noise(engine), std::cos(v) * std::sin(u) + noise(engine),
             std::sin(v) + noise(engine)};
    }
    Corners corners;
    for (std::size_t f = 0; f < grid.faces().count(); ++f) {
        if (percent(engine) < holes) continue;
        const auto face = grid.faces()[f];
        corners.insert(corners.end(), face.begin(), face.end());
    }
    for (unsigned i = 0; i < 100; ++i) points.emplace_back(noise(engine), noise(engine), 3);
    return *Mesh::make(std::move(points), std::move(corners), 3);
}

}  // namespace knotwork::test
