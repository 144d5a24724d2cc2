// The rows of a least-squares B-spline, span by span, with as few rows as will do.
//
// The m data of one span give m rows of A, N_j(u_k), j = 0 … d. Where there are many they are
// condensed into d+1 rows R with the same RᵀR and Rᵀb, without squaring the condition of the basis:
// in Chebyshev polynomials T_k of the span, which are nearly orthogonal over data spread in it, the
// Gram matrix G comes from 2d+1 sums (2 T_i T_j = T_{i+j} + T_{|i-j|}); with G = L Lᵀ and
// N = T M the rows are LᵀM, and their right sides L⁻¹ Σ T(u_k) Q_k.
#pragma once

#include "geometry/knot_vector.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

class SpanRows {
public:
    explicit SpanRows(const KnotVector& knots);

    /// d+1 numbers and then x, y, z of the right side.
    [[nodiscard]] std::size_t rowSize() const noexcept { return terms_ + 3; }

    // Of a span that is not empty; parameters and points belong together. The rows stand one after
    // the other and are the caller's until the next call.
    /// One row a datum. O(m d²).
    [[nodiscard]] std::span<double> each(std::size_t span, std::span<const double> parameters,
                                         std::span<const Vec3> points);
    /// d+1 rows instead; none where so few would not pay, or where the data are not spread over the
    /// span well enough. O(m d + d³).
    [[nodiscard]] std::span<double> condensed(std::size_t span, std::span<const double> parameters,
                                              std::span<const Vec3> points);

private:
    /// `Fixed` is the degree where it is known, so that loops unroll, else 0.
    template <std::size_t Fixed>
    [[nodiscard]] bool condense(std::size_t span, std::span<const double> parameters,
                                std::span<const Vec3> points);
    template <std::size_t Fixed>
    void expandBasis(std::size_t span);
    void prepareCosines();

    const KnotVector& knots_;
    std::size_t terms_;           // d+1
    std::vector<double> nodes_;   // of Chebyshev, d+1 of them, and one at 0 where that is odd
    std::vector<double> shares_;  // of a value at node q in coefficient k: k · nodes + q
    std::vector<double> basis_;   // M: coefficient k of function j at k · terms + j
    std::vector<double> rows_;
};

}  // namespace knotwork
