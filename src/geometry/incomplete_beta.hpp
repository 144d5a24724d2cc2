// The regularised incomplete Beta function for whole numbers, at one or two places.
#pragma once

#include "geometry/simd.hpp"

#include <array>
#include <cstddef>

namespace knotwork::b_function {

inline constexpr int largestPower = 20;  // of the description of `polynomial`

/// binomials[p][i] = C(p+i, i), all exact: the largest is 1.4e11.
inline constexpr auto binomials = [] {
    std::array<std::array<double, largestPower + 1>, largestPower + 1> table{};
    for (std::size_t p = 0; p <= largestPower; ++p) {
        table[p][0] = 1;
        for (std::size_t i = 1; i <= largestPower; ++i) {
            table[p][i] = p == 0 ? 1 : table[p - 1][i] + table[p][i - 1];
        }
    }
    return table;
}();

[[nodiscard]] constexpr double binomial(int p, int i) noexcept {
    return binomials[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)];
}

[[nodiscard]] inline double numberLike(double, double value) noexcept { return value; }
[[nodiscard]] inline simd::Double2 numberLike(simd::Double2, double value) noexcept {
    return simd::splat(value);
}

/// I_t(p+1, q+1) = t^(p+1) Σ_{i≤q} C(p+i, i) s^i with s = 1−t: no term is negative.
template <class Number>
[[nodiscard]] Number incompleteBeta(Number t, Number s, int p, int q) noexcept {
    Number sum = numberLike(s, binomial(p, q));
    for (int i = q; i-- > 0;) sum = sum * s + numberLike(s, binomial(p, i));
    Number power = t;
    for (int i = 0; i < p; ++i) power = power * t;
    return power * sum;
}

}  // namespace knotwork::b_function
