#include "geometry/b_function_families.hpp"
#include "geometry/incomplete_beta.hpp"
#include "geometry/simd.hpp"

namespace knotwork::b_function {

using simd::Double2;

namespace {

/// B at two places in [0, 1].
Double2 valuesOf(const Polynomial& of, Double2 t) noexcept {
    const Double2 half = simd::splat(0.5);
    const Double2 s = simd::splat(1) - t;
    if (of.p == of.q) {
        const Double2 b = incompleteBeta(simd::smaller(t, s), simd::larger(t, s), of.p, of.q);
        return simd::fromOn(half, t, b, simd::splat(1) - b);
    }
    return simd::fromOn(half, t, incompleteBeta(t, s, of.p, of.q),
                        simd::splat(1) - incompleteBeta(s, t, of.q, of.p));
}

}  // namespace

double Polynomial::value(double t) const noexcept {
    const double s = 1 - t;
    return t <= 0.5 ? incompleteBeta(t, s, p, q) : 1 - incompleteBeta(s, t, q, p);
}

void Polynomial::sample(std::span<const double> ts, std::span<double> values) const noexcept {
    const Double2 zero = simd::splat(0);
    const Double2 one = simd::splat(1);
    const auto kept = [&](Double2 x) { return simd::smaller(one, simd::larger(zero, x)); };
    std::size_t i = 0;
    for (; i + 2 <= ts.size(); i += 2) {
        simd::store(&values[i], kept(valuesOf(*this, kept(simd::load(&ts[i])))));
    }
    if (i < ts.size()) {
        values[i] = simd::first(kept(valuesOf(*this, kept(simd::splat(ts[i])))));
    }
}

}  // namespace knotwork::b_function
