// Many points of one polynomial, as x, y, z triples: the inner loops of the fast path.
//
// A kernel reads local parameters in fours, so that `us` must reach to the next multiple of four
// beyond `count` (what stands there does not matter); it writes 3·count numbers. Two components
// give z = 0, four are divided by the last.
#pragma once

#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace knotwork::kernels {

using simd::Double2;

template <std::size_t Components>
struct Pair {
    std::array<Double2, Components> axes;
};

template <std::size_t Components>
Pair<Components> loadTerm(const double* from) noexcept {
    Pair<Components> term;
    for (std::size_t c = 0; c < Components; ++c) term.axes[c] = simd::loadSplat(from + c);
    return term;
}

template <std::size_t Components>
void storePair(double* to, const Pair<Components>& sum) noexcept {
    if constexpr (Components == 2) {
        simd::storeInterleaved(to, sum.axes[0], sum.axes[1], simd::splat(0));
    } else if constexpr (Components == 3) {
        simd::storeInterleaved(to, sum.axes[0], sum.axes[1], sum.axes[2]);
    } else {
        const Double2 inverse = simd::splat(1) / sum.axes[3];
        simd::storeInterleaved(to, sum.axes[0] * inverse, sum.axes[1] * inverse,
                               sum.axes[2] * inverse);
    }
}

// Horner's rule in lanes that stand as they are written: x0 y0, z0 x1 and y1 z1, so that nothing is
// shuffled. Term k is x y z x y z at c + 6k. Two pairs at a time hide the latency of the chain of
// products. Fixed is the degree where it is known to the compiler, else 0.
template <std::size_t Fixed>
void hornerFour(const double* c, std::size_t degree, const double* u, double* xyz) noexcept {
    const std::size_t d = Fixed > 0 ? Fixed : degree;
    const std::array<Double2, 6> at{simd::loadSplat(u),     simd::load(u),
                                    simd::loadSplat(u + 1), simd::loadSplat(u + 2),
                                    simd::load(u + 2),      simd::loadSplat(u + 3)};
    std::array<Double2, 6> sums;
    for (std::size_t i = 0; i < 6; ++i) sums[i] = simd::load(c + 6 * d + 2 * (i % 3));
    for (std::size_t k = d; k-- > 0;) {
        for (std::size_t i = 0; i < 6; ++i) {
            sums[i] = sums[i] * at[i] + simd::load(c + 6 * k + 2 * (i % 3));
        }
    }
    for (std::size_t i = 0; i < 6; ++i) simd::store(xyz + 2 * i, sums[i]);
}

// sum binomial b_k u^k (1-u)^(d-k) by one pass of Horner's rule in both: no cancellation on [0, 1].
template <std::size_t Components>
void bernsteinFour(const double* c, std::size_t degree, const double* u, double* xyz) noexcept {
    const Double2 u0 = simd::load(u);
    const Double2 u1 = simd::load(u + 2);
    const Double2 v0 = simd::splat(1) - u0;
    const Double2 v1 = simd::splat(1) - u1;
    Double2 power0 = simd::splat(1);
    Double2 power1 = power0;
    Pair<Components> sum0 = loadTerm<Components>(c);
    Pair<Components> sum1 = sum0;
    for (std::size_t k = 1; k <= degree; ++k) {
        const Pair<Components> term = loadTerm<Components>(c + k * Components);
        power0 = power0 * u0;
        power1 = power1 * u1;
        for (std::size_t i = 0; i < Components; ++i) {
            sum0.axes[i] = sum0.axes[i] * v0 + power0 * term.axes[i];
            sum1.axes[i] = sum1.axes[i] * v1 + power1 * term.axes[i];
        }
    }
    storePair(xyz, sum0);
    storePair(xyz + 6, sum1);
}

// Runs a kernel for four over any number; the last group goes through a buffer of its own.
template <class Kernel>
void inFours(const Kernel& kernel, const double* us, std::size_t count, double* xyz) noexcept {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) kernel(us + i, xyz + 3 * i);
    if (i == count) return;
    std::array<double, 12> last;
    kernel(us + i, last.data());
    std::copy_n(last.data(), 3 * (count - i), xyz + 3 * i);
}

template <std::size_t Fixed>
void hornerBlock(const double* c, std::size_t degree, const double* us, std::size_t count,
                 double* xyz) noexcept {
    inFours([=](const double* u, double* to) { hornerFour<Fixed>(c, degree, u, to); }, us, count,
            xyz);
}

/// Of terms as hornerFour() reads them.
inline void powerBlock(const double* c, std::size_t degree, const double* us, std::size_t count,
                       double* xyz) noexcept {
    switch (degree) {
        case 1:
            return hornerBlock<1>(c, degree, us, count, xyz);
        case 2:
            return hornerBlock<2>(c, degree, us, count, xyz);
        case 3:
            return hornerBlock<3>(c, degree, us, count, xyz);
        default:
            return hornerBlock<0>(c, degree, us, count, xyz);
    }
}

template <std::size_t Components>
void bernsteinBlock(const double* c, std::size_t degree, const double* us, std::size_t count,
                    double* xyz) noexcept {
    inFours([=](const double* u, double* to) { bernsteinFour<Components>(c, degree, u, to); }, us,
            count, xyz);
}

// P(u) + b D(u), every point with a b of its own: the terms are blended on the way. Term k of P is
// followed by that of D.
template <std::size_t Components, std::size_t Fixed>
void blendFour(const double* c, std::size_t degree, const double* u, const double* b,
               double* xyz) noexcept {
    const std::size_t d = Fixed > 0 ? Fixed : degree;
    const Double2 u0 = simd::load(u);
    const Double2 u1 = simd::load(u + 2);
    const Double2 b0 = simd::load(b);
    const Double2 b1 = simd::load(b + 2);
    const auto blended = [c](std::size_t k, std::size_t axis, Double2 weight) {
        const double* term = c + 2 * k * Components + axis;
        return simd::loadSplat(term) + weight * simd::loadSplat(term + Components);
    };
    Pair<Components> sum0;
    Pair<Components> sum1;
    for (std::size_t i = 0; i < Components; ++i) {
        sum0.axes[i] = blended(d, i, b0);
        sum1.axes[i] = blended(d, i, b1);
    }
    for (std::size_t k = d; k-- > 0;) {
        for (std::size_t i = 0; i < Components; ++i) {
            sum0.axes[i] = sum0.axes[i] * u0 + blended(k, i, b0);
            sum1.axes[i] = sum1.axes[i] * u1 + blended(k, i, b1);
        }
    }
    storePair(xyz, sum0);
    storePair(xyz + 6, sum1);
}

template <std::size_t Components, std::size_t Fixed>
void blendRun(const double* c, std::size_t degree, const double* us, const double* bs,
              std::size_t count, double* xyz) noexcept {
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        blendFour<Components, Fixed>(c, degree, us + i, bs + i, xyz + 3 * i);
    }
    if (i == count) return;
    std::array<double, 12> last;
    blendFour<Components, Fixed>(c, degree, us + i, bs + i, last.data());
    std::copy_n(last.data(), 3 * (count - i), xyz + 3 * i);
}

template <std::size_t Components>
void blendBlock(const double* c, std::size_t degree, const double* us, const double* bs,
                std::size_t count, double* xyz) noexcept {
    switch (degree) {
        case 1:
            return blendRun<Components, 1>(c, degree, us, bs, count, xyz);
        case 3:
            return blendRun<Components, 3>(c, degree, us, bs, count, xyz);
        default:
            return blendRun<Components, 0>(c, degree, us, bs, count, xyz);
    }
}

/// One homogeneous point of the same form.
inline std::array<double, 4> bernsteinPoint(const double* c, std::size_t degree,
                                            double u) noexcept {
    std::array<double, 4> sum{c[0], c[1], c[2], c[3]};
    double power = 1;
    for (std::size_t k = 1; k <= degree; ++k) {
        power *= u;
        for (std::size_t i = 0; i < 4; ++i) sum[i] = sum[i] * (1 - u) + power * c[4 * k + i];
    }
    return sum;
}

}  // namespace knotwork::kernels
