#include "geometry/span_rows.hpp"

#include "geometry/bspline_kernels.hpp"
#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knotwork {

namespace {

// From three times as many data as rows on, condensing them pays.
constexpr std::size_t enough = 3;
// What must be left of a Chebyshev polynomial when those before it are taken out, of its square:
// 0.4 for data spread evenly, nothing for data in one place.
constexpr double leastPivot = 0.02;

constexpr std::size_t mostTerms = maxDegree + 1;

struct Moments {
    std::array<double, 2 * mostTerms> gram{};  ///< Σ T_k, k = 0 … 2d
    std::array<Vec3, mostTerms> sums{};        ///< Σ T_k Q, k = 0 … d
};

/// Where a span's parameters go on [-1, 1].
struct Frame {
    double centre;
    double scale;
};

using simd::Double2;

/// T_0 … T_{2d} at two parameters, by T_{k+1} = 2 w T_k - T_{k-1}.
inline void chebyshev(Double2 w, std::size_t last, Double2* values) noexcept {
    const Double2 twice = w + w;
    values[0] = simd::splat(1);
    values[1] = w;
    for (std::size_t k = 2; k <= last; ++k) values[k] = twice * values[k - 1] - values[k - 2];
}

/// Two data at a time. `Fixed` is the degree where it is known, so that loops unroll, else 0.
template <std::size_t Fixed>
void accumulate(std::size_t degree, const Frame& frame, std::span<const double> parameters,
                const Vec3* points, Moments& moments) noexcept {
    const std::size_t d = Fixed > 0 ? Fixed : degree;
    constexpr std::size_t room = Fixed > 0 ? Fixed + 1 : mostTerms;
    std::array<Double2, 2 * room> values;
    std::array<Double2, 2 * room> gram;
    std::array<std::array<Double2, 3>, room> sums;
    gram.fill(simd::splat(0));
    for (auto& sum : sums) sum.fill(simd::splat(0));
    const Double2 centre = simd::splat(frame.centre);
    const Double2 scale = simd::splat(frame.scale);
    for (std::size_t k = 0; k + 1 < parameters.size(); k += 2) {
        chebyshev((simd::load(&parameters[k]) - centre) * scale, 2 * d, values.data());
        const simd::Points2 q = simd::loadInterleaved(&points[k].x);
        for (std::size_t i = 1; i <= 2 * d; ++i) gram[i] = gram[i] + values[i];
        for (std::size_t i = 0; i <= d; ++i) {
            sums[i][0] = sums[i][0] + values[i] * q.x;
            sums[i][1] = sums[i][1] + values[i] * q.y;
            sums[i][2] = sums[i][2] + values[i] * q.z;
        }
    }
    const auto both = [](Double2 sum) { return simd::first(sum) + simd::second(sum); };
    for (std::size_t i = 1; i <= 2 * d; ++i) moments.gram[i] = both(gram[i]);
    for (std::size_t i = 0; i <= d; ++i) {
        moments.sums[i] = Vec3(both(sums[i][0]), both(sums[i][1]), both(sums[i][2]));
    }
}

/// The last one of an odd number.
void accumulateOne(std::size_t degree, double w, const Vec3& point, Moments& moments) noexcept {
    double before = w;  // T_{-1} = T_1
    double value = 1;
    for (std::size_t k = 0; k <= 2 * degree; ++k) {
        moments.gram[k] += value;
        if (k <= degree) moments.sums[k] += value * point;
        const double next = 2 * w * value - before;
        before = value;
        value = next;
    }
}

template <std::size_t Fixed>
Moments momentsOf(std::size_t degree, const Frame& frame, std::span<const double> parameters,
                  std::span<const Vec3> points) noexcept {
    Moments moments;
    accumulate<Fixed>(degree, frame, parameters, points.data(), moments);
    const std::size_t count = parameters.size();
    moments.gram[0] = static_cast<double>(count - count % 2);
    if (count % 2 == 1) {
        accumulateOne(degree, (parameters.back() - frame.centre) * frame.scale, points.back(),
                      moments);
    }
    return moments;
}

/// L of G = L Lᵀ, G_ij = (Σ T_{i+j} + Σ T_{|i-j|}) / 2; row i at i · terms. False where data are
/// too crowded for it.
template <std::size_t Fixed>
bool factor(const Moments& moments, std::size_t count, double* lower) noexcept {
    const std::size_t terms = Fixed > 0 ? Fixed + 1 : count;
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const double whole = (moments.gram[i + j] + moments.gram[i - j]) / 2;
            double rest = whole;
            for (std::size_t k = 0; k < j; ++k) rest -= lower[i * terms + k] * lower[j * terms + k];
            if (i == j && !(rest > leastPivot * whole)) return false;
            lower[i * terms + j] = i == j ? std::sqrt(rest) : rest / lower[j * terms + j];
        }
    }
    return true;
}

}  // namespace

SpanRows::SpanRows(const KnotVector& knots)
    : knots_(knots), terms_(static_cast<std::size_t>(knots.degree()) + 1) {}

std::span<double> SpanRows::each(std::size_t span, std::span<const double> parameters,
                                 std::span<const Vec3> points) {
    rows_.resize(parameters.size() * rowSize());
    const std::span<double> rows(rows_);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const std::span<double> row = rows.subspan(k * rowSize(), rowSize());
        kernels::basis(knots_.extended(), terms_ - 1, span, parameters[k], row);
        row[terms_] = points[k].x;
        row[terms_ + 1] = points[k].y;
        row[terms_ + 2] = points[k].z;
    }
    return rows;
}

std::span<double> SpanRows::condensed(std::size_t span, std::span<const double> parameters,
                                      std::span<const Vec3> points) {
    if (parameters.size() < enough * terms_) return {};
    const bool done = terms_ == 4 ? condense<3>(span, parameters, points)
                                  : condense<0>(span, parameters, points);
    return done ? std::span<double>(rows_) : std::span<double>();
}

template <std::size_t Fixed>
bool SpanRows::condense(std::size_t span, std::span<const double> parameters,
                        std::span<const Vec3> points) {
    const std::size_t terms = Fixed > 0 ? Fixed + 1 : terms_;
    constexpr std::size_t room = Fixed > 0 ? Fixed + 1 : mostTerms;
    const std::span<const double> t = knots_.extended();
    const Frame frame{t[span] + (t[span + 1] - t[span]) / 2, 2 / (t[span + 1] - t[span])};
    const Moments moments = momentsOf<Fixed>(terms - 1, frame, parameters, points);
    std::array<double, room * room> lower;
    if (!factor<Fixed>(moments, terms, lower.data())) return false;
    expandBasis<Fixed>(span);
    rows_.assign(terms * (terms + 3), 0.0);
    std::array<Vec3, room> right;
    std::copy_n(moments.sums.begin(), terms, right.begin());
    for (std::size_t r = 0; r < terms; ++r) {
        double* const row = &rows_[r * (terms + 3)];
        for (std::size_t k = r; k < terms; ++k) {
            const double share = lower[k * terms + r];
            for (std::size_t j = 0; j < terms; ++j) row[j] += share * basis_[k * terms + j];
        }
        right[r] /= lower[r * terms + r];
        for (std::size_t k = r + 1; k < terms; ++k) right[k] -= lower[k * terms + r] * right[r];
        row[terms] = right[r].x;
        row[terms + 1] = right[r].y;
        row[terms + 2] = right[r].z;
    }
    return true;
}

// Coefficients from the values at the d+1 Chebyshev nodes, where the polynomials are orthogonal. All
// nodes go through the recurrence of kernels::basis() together, so that it divides once for them all.
template <std::size_t Fixed>
void SpanRows::expandBasis(std::size_t span) {
    const std::size_t terms = Fixed > 0 ? Fixed + 1 : terms_;
    constexpr std::size_t room = Fixed > 0 ? Fixed + 1 : mostTerms;
    constexpr std::size_t roomOfPairs = (room + 1) / 2;
    prepareCosines();
    const std::size_t pairs = (terms + 1) / 2;
    const std::span<const double> t = knots_.extended();
    const double half = (t[span + 1] - t[span]) / 2;
    const Double2 one = simd::splat(1);
    std::array<Double2, roomOfPairs> at;
    std::array<std::array<Double2, roomOfPairs>, room> values;
    for (std::size_t q = 0; q < pairs; ++q) {
        at[q] = simd::splat(t[span] + half) + simd::splat(half) * simd::load(&nodes_[2 * q]);
    }
    values[0].fill(one);
    for (std::size_t k = 1; k < terms; ++k) {
        values[k].fill(simd::splat(0));
        for (std::size_t j = k; j-- > 0;) {
            const std::size_t i = span + 1 + j - k;
            const Double2 start = simd::splat(t[i]);
            const Double2 inverse = simd::splat(1 / (t[i + k] - t[i]));
            for (std::size_t q = 0; q < pairs; ++q) {
                const Double2 upper = (at[q] - start) * inverse * values[j][q];
                values[j + 1][q] = values[j + 1][q] + upper;
                values[j][q] = values[j][q] - upper;
            }
        }
    }
    for (std::size_t k = 0; k < terms; ++k) {
        for (std::size_t j = 0; j < terms; ++j) {
            Double2 sum = simd::splat(0);
            for (std::size_t q = 0; q < pairs; ++q) {
                sum = sum + simd::load(&shares_[2 * (k * pairs + q)]) * values[j][q];
            }
            basis_[k * terms + j] = simd::first(sum) + simd::second(sum);
        }
    }
}

void SpanRows::prepareCosines() {
    if (!nodes_.empty()) return;
    const double count = static_cast<double>(terms_);
    const std::size_t even = terms_ + terms_ % 2;
    nodes_.resize(even);
    shares_.resize(terms_ * even);
    basis_.resize(terms_ * terms_);
    for (std::size_t q = 0; q < terms_; ++q) {
        const double angle = std::numbers::pi * (static_cast<double>(q) + 0.5) / count;
        nodes_[q] = std::cos(angle);
        for (std::size_t k = 0; k < terms_; ++k) {
            shares_[k * even + q] =
                (k == 0 ? 1 : 2) * std::cos(static_cast<double>(k) * angle) / count;
        }
    }
}

}  // namespace knotwork
