#include "geometry/triangle_grid.hpp"

#include "geometry/surface_differential.hpp"

#include <array>

namespace knotwork {

namespace {

void write(const Vec3& v, double* to) noexcept {
    for (int axis = 0; axis < 3; ++axis) to[axis] = v[axis];
}

}  // namespace

void TriangleGrid::columns(std::size_t first, std::size_t count, double* positions,
                           double* normals) noexcept {
    unclear_.clear();
    const GridLine::Place u = u_.at(row_);
    std::array<Vec3, gradedSize(1)> terms;  // S, Su, Sv
    for (std::size_t j = first; j < first + count; ++j, positions += 3, normals += 3) {
        const GridLine::Place v = v_.at(j);
        surface_.series({u.parameter, v.parameter, u.side, v.side}, 1, terms);
        const Vec3 normal = plainNormal(terms[1], terms[2], 1, 1);
        if (normal == Vec3(0)) unclear_.push_back(j);
        write(terms[0], positions);
        write(normal, normals);
    }
}

}  // namespace knotwork
