#include "geometry/triangle_weights.hpp"

#include <algorithm>

namespace knotwork {

namespace {

constexpr std::array<std::size_t, 3> degrees{0, 4, 7};  // of the polynomials by their order

std::size_t largestOf(const Barycentric& at) noexcept {
    if (at[0] >= at[1] && at[0] >= at[2]) return 0;
    return at[1] >= at[2] ? 1 : 2;
}

/// λ_k about the place, as a function of x = λ_1 and y = λ_2.
Bilinear coordinate(const Barycentric& at, std::size_t k) noexcept {
    switch (k) {
        case 0: return {at[0], -1, -1};
        case 1: return {at[1], 1, 0};
        default: return {at[2], 0, 1};
    }
}

/// terms += factor · affine + constant, as far as they go.
void addAffine(double factor, const Bilinear& affine, double constant,
               std::span<double> terms) noexcept {
    terms[0] += factor * affine.constant + constant;
    if (terms.size() == 1) return;
    terms[gradedAt(1, 0)] += factor * affine.x;
    terms[gradedAt(0, 1)] += factor * affine.y;
}

/// u² (3 − 2u + 6vw)
void firstOrder(const Bilinear& u, const Bilinear& v, const Bilinear& w, std::size_t order,
                std::span<double> terms) noexcept {
    std::fill(terms.begin(), terms.end(), 0.0);
    terms[0] = 6;
    timesBilinear(v, order, terms);
    timesBilinear(w, order, terms);
    addAffine(-2, u, 3, terms);
    for (int k = 0; k < 2; ++k) timesBilinear(u, order, terms);
}

/// u³ (10 − 15u + 6u² + 30vw (3vw − u + 1))
void secondOrder(const Bilinear& u, const Bilinear& v, const Bilinear& w, std::size_t order,
                 std::span<double> terms) noexcept {
    std::array<double, gradedSize(7)> alone{};
    const std::span<double> rest = std::span<double>(alone).first(terms.size());
    addAffine(6, u, -15, rest);
    timesBilinear(u, order, rest);
    std::fill(terms.begin(), terms.end(), 0.0);
    terms[0] = 90;
    timesBilinear(v, order, terms);
    timesBilinear(w, order, terms);
    addAffine(-30, u, 30, terms);
    timesBilinear(v, order, terms);
    timesBilinear(w, order, terms);
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] += rest[k];
    terms[0] += 10;
    for (int k = 0; k < 3; ++k) timesBilinear(u, order, terms);
}

}  // namespace

TriangleWeights::TriangleWeights(const TriangleBlend& blend, const Barycentric& at,
                                 std::size_t order) noexcept
    : TriangleWeights(blend, at, order, largestOf(at)) {}

TriangleWeights::TriangleWeights(const TriangleBlend& blend, const Barycentric& at,
                                 std::size_t order, std::size_t base) noexcept
    : base_(base), order_(order) {
    if (blend.blend) {
        takeQuotients(*blend.blend, at);
    } else {
        takePolynomials(blend.order, at);
    }
}

void TriangleWeights::takePolynomials(int order, const Barycentric& at) noexcept {
    order_ = std::min(order_, degrees[static_cast<std::size_t>(order)]);
    for (std::size_t which = 0; which < 2; ++which) {
        const std::size_t k = corner(which);
        const Bilinear u = coordinate(at, k);
        const Bilinear v = coordinate(at, (k + 1) % 3);
        const Bilinear w = coordinate(at, (k + 2) % 3);
        const auto terms = std::span<double>(series_[which]).first(gradedSize(order_));
        if (order == 1) {
            firstOrder(u, v, w, order_, terms);
        } else {
            secondOrder(u, v, w, order_, terms);
        }
    }
}

void TriangleWeights::takeQuotients(const BFunction& blend, const Barycentric& at) noexcept {
    const std::size_t size = gradedSize(order_);
    std::array<std::array<double, maxTriangleOrder + 1>, 3> along;  // B(λ_k + t) as series in t
    for (std::size_t k = 0; k < 3; ++k) {
        const auto rows = std::span<double>(along[k]).first(order_ + 1);
        blend.derivatives(at[k], rows);
        double factorial = 1;
        for (std::size_t n = 2; n < rows.size(); ++n) rows[n] /= factorial *= static_cast<double>(n);
    }
    std::array<double, gradedSize(maxTriangleOrder)> sum;
    std::array<double, gradedSize(maxTriangleOrder)> first;  // B(λ_0)
    for (std::size_t n = 0; n <= order_; ++n) {
        double binomial = n % 2 == 0 ? 1 : -1;
        for (std::size_t j = 0; j <= n; ++j) {
            const std::size_t entry = gradedAt(n - j, j);
            first[entry] = binomial * along[0][n];
            sum[entry] = first[entry];
            binomial *= static_cast<double>(n - j) / static_cast<double>(j + 1);
        }
        sum[gradedAt(n, 0)] += along[1][n];
        sum[gradedAt(0, n)] += along[2][n];
    }
    for (std::size_t which = 0; which < 2; ++which) {
        const std::size_t k = corner(which);
        const auto terms = std::span<double>(series_[which]).first(size);
        if (k == 0) {
            std::copy_n(first.begin(), size, terms.begin());
        } else {
            std::fill(terms.begin(), terms.end(), 0.0);
            for (std::size_t n = 0; n <= order_; ++n) {
                terms[k == 1 ? gradedAt(n, 0) : gradedAt(0, n)] = along[k][n];
            }
        }
        divideBy(std::span<const double>(sum).first(size), order_, terms);
    }
}

bool TriangleWeights::vanishes(std::size_t which) const noexcept {
    const std::span<const double> terms = series(which);
    return std::all_of(terms.begin(), terms.end(), [](double term) { return term == 0; });
}

Barycentric TriangleWeights::values() const noexcept {
    Barycentric values{};
    values[corner(0)] = series_[0][0];
    values[corner(1)] = series_[1][0];
    values[base_] = 1 - (series_[0][0] + series_[1][0]);
    return values;
}

}  // namespace knotwork
