// The fast way to the basis functions at many parameters: only those that are not zero.
#pragma once

#include "geometry/knot_vector.hpp"

#include <cstdint>
#include <span>

namespace knotwork {

/// The d+1 functions that live where each parameter falls, values[i (d+1) + j] = N_{first+j}(ts[i]),
/// and first[i], the point of the first of them; the points that follow are counted modulo n where
/// the vector is closed. The same as basisRows() from the right to 1e-15, for parameters in any order
/// (fast where neighbours fall into one span). The triangle of Cox and de Boor, two parameters at a
/// time, with its quotients made once a span. O(d²) a parameter; nothing is allocated.
void activeBasis(const KnotVector& knots, std::span<const double> ts, std::span<double> values,
                 std::span<std::int32_t> first) noexcept;

}  // namespace knotwork
