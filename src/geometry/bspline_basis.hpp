// The basis functions of a B-spline space and their derivatives.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/knot_vector.hpp"

#include <cstddef>
#include <span>

namespace knotwork {

/// The d+1 functions that live on a span (of the extended vector), at t; they are not negative on
/// the span and sum to 1 (within 1e-14). Beyond the span they are continued as polynomials.
/// `values` holds d+1 numbers. O(d²).
void basisFunctions(const KnotVector& knots, std::size_t span, double t,
                    std::span<double> values) noexcept;

/// Row k holds the k-th derivatives of the same functions, k = 0 … derivatives; rows beyond the
/// degree are zero. `rows` holds (derivatives+1)(d+1) numbers.
void basisDerivatives(const KnotVector& knots, std::size_t span, double t, int derivatives,
                      std::span<double> rows) noexcept;

/// The same for all n functions of the space, each in the column of its point, at any t: a closed
/// vector wraps, the others are continued by their end pieces. `rows` holds (derivatives+1) n
/// numbers.
void basisRows(const KnotVector& knots, double t, Side side, int derivatives,
               std::span<double> rows) noexcept;

}  // namespace knotwork
