// vertexNormals() (mesh.hpp) a piece at a time.
#pragma once

#include "geometry/mesh.hpp"

#include <cstddef>
#include <span>

namespace knotwork {

class NormalSums {
public:
    /// O(vertices).
    explicit NormalSums(const Mesh& mesh) noexcept;

    /// Adds what faces first … last − 1 give their vertices to sums that began as zeros, a triple
    /// for each vertex of the mesh.
    void add(std::size_t first, std::size_t last, std::span<double> xyz) const noexcept;
    /// Turns sums into the unit normals, or zero vectors, that they stand for.
    static void normalise(std::span<double> xyz) noexcept;

private:
    Mesh mesh_;
    double scale_;
};

}  // namespace knotwork
