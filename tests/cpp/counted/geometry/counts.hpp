// What the algorithms on meshes do, counted: see geometry/vec.hpp and geometry/steps.hpp beside this.
#pragma once

#include <cstddef>

namespace knotwork {

struct Counts {
    std::size_t arithmetic = 0;  ///< sums, products and moves of points
    std::size_t steps = 0;       ///< from corner to corner, and edges numbered
};

inline Counts counted;

}  // namespace knotwork
