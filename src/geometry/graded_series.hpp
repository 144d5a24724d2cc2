// Taylor series of functions of two variables, cut off at an order in all.
//
// The coefficient of x^i y^j stands at gradedAt(i, j): those of a lower i + j first, and among equal
// ones those of a lower j. So multiplying adds the grades i + j and the places j within them, and a
// factor without a constant term can be multiplied in where the series stands, highest grade first.
#pragma once

#include <cstddef>
#include <span>

namespace knotwork {

/// How many coefficients a series up to this order has.
[[nodiscard]] constexpr std::size_t gradedSize(std::size_t order) noexcept {
    return (order + 1) * (order + 2) / 2;
}
[[nodiscard]] constexpr std::size_t gradedAt(std::size_t i, std::size_t j) noexcept {
    return (i + j) * (i + j + 1) / 2 + j;
}

/// constant + x·X + y·Y + xy·X·Y.
struct Bilinear {
    double constant = 0;
    double x = 0;
    double y = 0;
    double xy = 0;
};

/// Multiplies a series of gradedSize(order) terms by `factor`, in place.
template <class Term>
void timesBilinear(const Bilinear& factor, std::size_t order, std::span<Term> terms) noexcept {
    for (std::size_t grade = order + 1; grade-- > 0;) {
        Term* of = &terms[gradedAt(grade, 0)];
        const Term* below = of - grade;  // one grade less; where there is none nothing is read
        for (std::size_t j = 0; j <= grade; ++j) {
            Term sum = factor.constant * of[j];
            if (j < grade) sum += factor.x * below[j];
            if (j > 0) sum += factor.y * below[j - 1];
            if (j > 0 && j < grade) sum += factor.xy * (below - (grade - 1))[j - 1];
            of[j] = sum;
        }
    }
}

/// sum += factor · terms, cut off at `order`; the factor goes up to `factorOrder` ≤ order.
template <class Term>
void addProduct(std::span<const double> factor, std::size_t factorOrder,
                std::span<const Term> terms, std::size_t order, std::span<Term> sum) noexcept {
    for (std::size_t m = 0; m <= factorOrder; ++m) {
        for (std::size_t j = 0; j <= m; ++j) {
            const double one = factor[gradedAt(m, 0) + j];
            if (one == 0) continue;
            for (std::size_t n = 0; n + m <= order; ++n) {
                const Term* of = &terms[gradedAt(n, 0)];
                Term* to = &sum[gradedAt(m + n, 0) + j];
                for (std::size_t l = 0; l <= n; ++l) to[l] += one * of[l];
            }
        }
    }
}

/// terms / divisor in place of the terms; both go up to `order`, and the divisor is not 0 at its
/// centre.
inline void divideBy(std::span<const double> divisor, std::size_t order,
                     std::span<double> terms) noexcept {
    for (std::size_t grade = 0; grade <= order; ++grade) {
        for (std::size_t j = 0; j <= grade; ++j) {
            double rest = terms[gradedAt(grade - j, j)];
            for (std::size_t m = 0; m < grade; ++m) {  // of the quotient
                const std::size_t left = grade - m;
                const std::size_t first = j > left ? j - left : 0;
                for (std::size_t l = first; l <= m && l <= j; ++l) {
                    rest -= terms[gradedAt(m - l, l)] * divisor[gradedAt(left - (j - l), j - l)];
                }
            }
            terms[gradedAt(grade - j, j)] = rest / divisor[0];
        }
    }
}

}  // namespace knotwork
