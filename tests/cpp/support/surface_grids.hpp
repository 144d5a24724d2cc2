// Grids of surfaces, and what is asked of those of every kind.
#pragma once

#include "geometry/surface_differential.hpp"
#include "geometry/surface_grid.hpp"
#include "support/surface_gates.hpp"
#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace knotwork::test {

struct Grid {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
};

/// Asked for in blocks that end within rows.
inline Grid gridOf(const Surface& surface, std::size_t nu, std::size_t nv, std::size_t block = 1024) {
    SurfaceGrid grid(surface, nu, nv);
    std::vector<double> positions(3 * nu * nv, 99);
    std::vector<double> normals(3 * nu * nv, 99);
    for (std::size_t first = 0; first < nu * nv; first += block) {
        const std::size_t count = std::min(block, nu * nv - first);
        grid.points(first, count, std::span(positions).subspan(3 * first, 3 * count),
                    std::span(normals).subspan(3 * first, 3 * count));
    }
    Grid read;
    for (std::size_t k = 0; k < positions.size(); k += 3) {
        read.points.emplace_back(positions[k], positions[k + 1], positions[k + 2]);
        read.normals.emplace_back(normals[k], normals[k + 1], normals[k + 2]);
    }
    return read;
}

inline SurfacePlace placeOf(const Surface& surface, std::size_t i, std::size_t j, std::size_t nu,
                     std::size_t nv) {
    const Rectangle whole = domain(surface);
    return placeInDomain(surface, uniformParameter(whole.u, i, nu),
                         uniformParameter(whole.v, j, nv))
        .value();
}

/// Every point and normal is that of the surface by itself.
inline void expectGrid(const Surface& surface, std::size_t nu, std::size_t nv, const std::string& name) {
    const Grid grid = gridOf(surface, nu, nv, 7);
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            const SurfacePlace at = placeOf(surface, i, j, nu, nv);
            const Vec3 moved = grid.points[i * nv + j] - pointAt(surface, at);
            EXPECT_LE(glm::length(moved), gates::gridPoint) << name << ' ' << i << ' ' << j;
            const auto rows = matrixAt(surface, at, {1, 1});
            const double clear = glm::length(glm::cross(rows[2], rows[1]));
            const Vec3 turned = grid.normals[i * nv + j] - unitNormal(surface, at);
            EXPECT_LE(glm::length(turned), gates::gridNormal / std::min(1.0, clear + 1e-3))
                << name << ' ' << i << ' ' << j;
        }
    }
}

}  // namespace knotwork::test
