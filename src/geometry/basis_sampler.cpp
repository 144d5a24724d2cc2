#include "geometry/basis_sampler.hpp"

#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace knotwork {

namespace {

using simd::Double2;

constexpr std::size_t rowSize(std::size_t degree) noexcept { return degree * (degree + 1) / 2; }

/// What the triangle needs of one span: its step k combines with the weights
/// w_j = (t - t_i) · 1 / (t_{i+k} - t_i), i = span + 1 - k + j, j = 0 … k-1. Fixed is the degree where
/// the compiler knows it, else 0.
template <std::size_t Fixed>
class SpanTriangle {
public:
    SpanTriangle(std::span<const double> knots, std::size_t degree, std::size_t span) noexcept
        : degree_(degree) {
        std::size_t at = 0;
        for (std::size_t k = 1; k <= this->degree(); ++k) {
            starts_[k - 1] = knots[span + 1 - k];
            for (std::size_t j = 0; j < k; ++j, ++at) {
                const std::size_t i = span + 1 - k + j;
                inverses_[at] = 1 / (knots[i + k] - knots[i]);
            }
        }
    }

    /// The functions at two parameters, which stand in the lanes.
    void pair(Double2 t, std::array<Double2, maxDegree + 1>& functions) const noexcept {
        std::array<Double2, most> past;  // from each of the knots before t
        functions[0] = simd::splat(1);
        if constexpr (Fixed == 3) {  // by name, so that all stays in registers
            past = {pastStart(t, 0), pastStart(t, 1), pastStart(t, 2)};
            step<1>(past, functions, std::make_index_sequence<1>());
            step<2>(past, functions, std::make_index_sequence<2>());
            step<3>(past, functions, std::make_index_sequence<3>());
        } else {
            for (std::size_t k = 1; k <= degree(); ++k) {
                past[k - 1] = pastStart(t, k - 1);
                Double2 carried = simd::splat(0);
                for (std::size_t j = 0; j < k; ++j) raise(past, k, j, carried, functions);
                functions[k] = carried;
            }
        }
    }

    [[nodiscard]] std::size_t degree() const noexcept { return Fixed > 0 ? Fixed : degree_; }

private:
    static constexpr std::size_t most = Fixed > 0 ? Fixed : maxDegree;

    [[nodiscard]] Double2 pastStart(Double2 t, std::size_t i) const noexcept {
        return t - simd::loadSplat(&starts_[i]);
    }

    /// Function j of degree k-1 gives its share to functions j and, carried, j+1 of degree k.
    void raise(const std::array<Double2, most>& past, std::size_t k, std::size_t j,
               Double2& carried, std::array<Double2, maxDegree + 1>& functions) const noexcept {
        const Double2 w = past[k - 1 - j] * simd::loadSplat(&inverses_[rowSize(k - 1) + j]);
        const Double2 upper = w * functions[j];
        functions[j] = carried + (functions[j] - upper);
        carried = upper;
    }

    template <std::size_t K, std::size_t... J>
    void step(const std::array<Double2, most>& past,
              std::array<Double2, maxDegree + 1>& functions,
              std::index_sequence<J...>) const noexcept {
        Double2 carried = simd::splat(0);
        (raise(past, K, J, carried, functions), ...);
        functions[K] = carried;
    }

    std::size_t degree_;
    std::array<double, most> starts_;  ///< from the span's own downwards
    std::array<double, rowSize(most)> inverses_;
};

/// Row 0 from the first lanes, row 1 from the second.
void storeRows(const std::array<Double2, maxDegree + 1>& functions, std::size_t width, double* row0,
               double* row1) noexcept {
    std::size_t j = 0;
    for (; j + 2 <= width; j += 2) {
        simd::store(row0 + j, simd::firstFirst(functions[j], functions[j + 1]));
        simd::store(row1 + j, simd::secondSecond(functions[j], functions[j + 1]));
    }
    if (j == width) return;
    std::array<double, 2> last;
    simd::store(last.data(), functions[j]);
    row0[j] = last[0];
    row1[j] = last[1];
}

/// Parameters of one span: ts.size() rows.
template <std::size_t Fixed>
void spanRows(std::span<const double> knots, std::size_t degree, std::size_t span,
              std::span<const double> ts, double* rows) noexcept {
    const SpanTriangle<Fixed> triangle(knots, degree, span);
    const std::size_t width = triangle.degree() + 1;
    std::array<Double2, maxDegree + 1> functions;
    std::size_t i = 0;
    for (; i + 2 <= ts.size(); i += 2) {
        triangle.pair(simd::load(&ts[i]), functions);
        storeRows(functions, width, rows + i * width, rows + (i + 1) * width);
    }
    if (i == ts.size()) return;
    triangle.pair(simd::splat(ts[i]), functions);
    double* row = rows + i * width;
    storeRows(functions, width, row, row);
}

/// How many parameters from `begin` on lie in the span [start, end) that the first one lies in.
std::size_t runLength(std::span<const double> ts, std::size_t begin, double start,
                      double end) noexcept {
    const auto inside = [&](Double2 t) {
        return simd::inBoth((t >= simd::splat(start)) & (simd::splat(end) > t));
    };
    std::size_t i = begin + 1;
    while (i + 2 <= ts.size() && inside(simd::load(&ts[i]))) i += 2;
    while (i < ts.size() && start <= ts[i] && ts[i] < end) ++i;
    return i - begin;
}

}  // namespace

void activeBasis(const KnotVector& knots, std::span<const double> ts, std::span<double> values,
                 std::span<std::int32_t> first) noexcept {
    const auto degree = static_cast<std::size_t>(knots.degree());
    const std::span<const double> all = knots.extended();
    for (std::size_t i = 0; i < ts.size();) {
        const double inside = knots.wrap(ts[i]);
        const std::size_t span = knots.findSpan(inside);
        const bool alone = inside != ts[i];
        const std::size_t count = alone ? 1 : runLength(ts, i, all[span], all[span + 1]);
        const std::span<const double> run = alone ? std::span(&inside, 1) : ts.subspan(i, count);
        double* rows = values.data() + i * (degree + 1);
        if (degree == 3) {
            spanRows<3>(all, degree, span, run, rows);
        } else {
            spanRows<0>(all, degree, span, run, rows);
        }
        std::fill_n(first.begin() + static_cast<std::ptrdiff_t>(i), count,
                    static_cast<std::int32_t>(knots.pointIndex(span, 0)));
        i += count;
    }
}

}  // namespace knotwork
