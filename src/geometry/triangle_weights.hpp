// The weights by which three local patches are blended over a triangle.
//
// In barycentric coordinates λ_0 + λ_1 + λ_2 = 1 and with (u, v, w) = (λ_k, λ_{k+1}, λ_{k+2}), W_k is
//     order 1:      u² (3 − 2u + 6vw),
//     order 2:      u³ (10 − 15u + 6u² + 30vw (3vw − u + 1)),
//     B-functions:  B(u) / (B(u) + B(v) + B(w)).
// They are not negative and their sum is 1. The polynomial ones are the terms with u² of (u + v + w)³
// and those with u³ of (u + v + w)⁵; what is left, 6uvw = 6uvw (u + v + w) and
// 30uvw (uv + vw + wu) (u + v + w)², is shared out in the same way, halves where v has the power too.
// W_k has the factor u^{s+1}, and B the order s at 0: it vanishes with its derivatives up to s on the
// side u = 0, so that in the corner k, where the two other weights do, W_k = 1 up to the order s.
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/graded_series.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace knotwork {

struct TriangleBlend {
    int order = 1;                   ///< of the polynomial weights, 1 or 2
    std::optional<BFunction> blend;  ///< in place of them

    /// Up to which order a patch alone counts in its corner: `order`, or that of B at 0; may be
    /// infinite.
    [[nodiscard]] double hermiteOrder() const noexcept {
        return blend ? blend->order()[0] : static_cast<double>(order);
    }
};

using Barycentric = std::array<double, 3>;

/// As far as the weights are expanded.
inline constexpr std::size_t maxTriangleOrder = 25;

/// Taylor series in x = λ_1 and y = λ_2 of two of the weights; the third, that of the base, is what is
/// missing to 1. O(order²), of B-functions O(order⁴).
class TriangleWeights {
public:
    /// The base is the corner that counts most.
    TriangleWeights(const TriangleBlend& blend, const Barycentric& at, std::size_t order) noexcept;
    /// Up to `order` ≤ 25, for any coordinates that sum to 1.
    TriangleWeights(const TriangleBlend& blend, const Barycentric& at, std::size_t order,
                    std::size_t base) noexcept;

    [[nodiscard]] std::size_t base() const noexcept { return base_; }
    /// The corners of the two weights, which = 0 or 1.
    [[nodiscard]] std::size_t corner(std::size_t which) const noexcept {
        return (base_ + 1 + which) % 3;
    }
    /// Coefficients beyond this order are 0, or have not been asked for.
    [[nodiscard]] std::size_t order() const noexcept { return order_; }
    [[nodiscard]] std::span<const double> series(std::size_t which) const noexcept {
        return std::span<const double>(series_[which]).first(gradedSize(order_));
    }
    [[nodiscard]] bool vanishes(std::size_t which) const noexcept;
    /// W_0, W_1, W_2.
    [[nodiscard]] Barycentric values() const noexcept;

private:
    void takePolynomials(int order, const Barycentric& at) noexcept;
    void takeQuotients(const BFunction& blend, const Barycentric& at) noexcept;

    std::size_t base_;
    std::size_t order_;
    std::array<std::array<double, gradedSize(maxTriangleOrder)>, 2> series_;
};

}  // namespace knotwork
