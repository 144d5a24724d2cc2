// Points and normals of one row of a surface, where it is a polynomial: the inner loop of grids.
#pragma once

#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace knotwork::kernels {

/// S(w) = Σ c_k w^k and Su(w) = Σ b_k w^k, x, y, z of c_k at [6k], of b_k at [6k + 3].
struct RowPiece {
    const double* terms;
    std::size_t degree;
};

using simd::Double2;
using simd::Points2;

[[nodiscard]] inline Points2 splatTerm(const double* from) noexcept {
    return {simd::loadSplat(from), simd::loadSplat(from + 1), simd::loadSplat(from + 2)};
}
[[nodiscard]] inline Points2 timesPlus(const Points2& a, Double2 w, const Points2& b) noexcept {
    return {a.x * w + b.x, a.y * w + b.y, a.z * w + b.z};
}

/// The unit vectors of a × b, and 1/|a × b|: infinite where that vanishes, and they are no numbers.
[[nodiscard]] inline Points2 unitCross(const Points2& a, const Points2& b,
                                       Double2& inverse) noexcept {
    const Double2 x = a.y * b.z - a.z * b.y;
    const Double2 y = a.z * b.x - a.x * b.z;
    const Double2 z = a.x * b.y - a.y * b.x;
    inverse = simd::splat(1) / simd::squareRoot(x * x + y * y + z * z);
    return {x * inverse, y * inverse, z * inverse};
}

/// Two points at w with their normals, those of Su × dS/dw. Fixed is the degree where it is known to
/// the compiler, else 0.
template <std::size_t Fixed>
[[nodiscard]] inline Double2 surfacePair(const RowPiece& piece, Double2 w, double* position,
                                         double* normal) noexcept {
    const std::size_t degree = Fixed > 0 ? Fixed : piece.degree;
    const double* term = piece.terms + 6 * degree;
    Points2 point = splatTerm(term);
    Points2 along = splatTerm(term + 3);
    Points2 slope = point;
    for (std::size_t k = degree; k-- > 1;) {
        term -= 6;
        point = timesPlus(point, w, splatTerm(term));
        along = timesPlus(along, w, splatTerm(term + 3));
        slope = timesPlus(slope, w, point);
    }
    point = timesPlus(point, w, splatTerm(piece.terms));
    along = timesPlus(along, w, splatTerm(piece.terms + 3));
    simd::storeInterleaved(position, point.x, point.y, point.z);
    Double2 inverse;
    const Points2 unit = unitCross(along, slope, inverse);
    simd::storeInterleaved(normal, unit.x, unit.y, unit.z);
    return inverse;
}

/// Σ_k values_k row_k and the same of slopes, for two columns: values of term k stand at
/// [k · stride], those of the row at [2k · Components], S and then Su. With four components the last
/// is the weight by which the others are divided.
struct RowTable {
    const double* values;
    const double* slopes;
    std::size_t stride;
    const double* row;
    std::size_t terms;
};

template <std::size_t Components>
[[nodiscard]] inline Double2 tablePair(const RowTable& table, double* position,
                                       double* normal) noexcept {
    std::array<Double2, Components> point;
    std::array<Double2, Components> along;
    std::array<Double2, Components> across;
    point.fill(simd::splat(0));
    along.fill(simd::splat(0));
    across.fill(simd::splat(0));
    for (std::size_t k = 0; k < table.terms; ++k) {
        const Double2 value = simd::load(table.values + k * table.stride);
        const Double2 slope = simd::load(table.slopes + k * table.stride);
        const double* of = table.row + 2 * Components * k;
        for (std::size_t c = 0; c < Components; ++c) {
            const Double2 term = simd::loadSplat(of + c);
            point[c] = point[c] + value * term;
            across[c] = across[c] + slope * term;
            along[c] = along[c] + value * simd::loadSplat(of + Components + c);
        }
    }
    Double2 scale = simd::splat(1);
    if constexpr (Components == 4) {
        // w² (Su × Sv) without the divisions that do not turn it.
        const Double2 inverse = simd::splat(1) / point[3];
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] = point[c] * inverse;
            along[c] = along[c] - along[3] * point[c];
            across[c] = across[c] - across[3] * point[c];
        }
        scale = inverse * inverse;
    }
    simd::storeInterleaved(position, point[0], point[1], point[2]);
    Double2 inverse;
    const Points2 unit = unitCross({along[0], along[1], along[2]},
                                   {across[0], across[1], across[2]}, inverse);
    simd::storeInterleaved(normal, unit.x, unit.y, unit.z);
    return inverse / scale;
}

/// `count` points; `ws` must reach to the next even number. Answers the largest 1/|Su × dS/dw|;
/// each by itself is left in `inverses`, which reaches as far as `ws`.
template <std::size_t Fixed>
[[nodiscard]] double surfaceRun(const RowPiece& piece, const double* ws, std::size_t count,
                                double* positions, double* normals, double* inverses) noexcept {
    Double2 largest = simd::splat(0);
    std::size_t j = 0;
    for (; j + 2 <= count; j += 2) {
        const Double2 inverse =
            surfacePair<Fixed>(piece, simd::load(ws + j), positions + 3 * j, normals + 3 * j);
        simd::store(inverses + j, inverse);
        largest = simd::larger(largest, inverse);
    }
    double last = 0;
    if (j < count) {
        std::array<double, 6> position;
        std::array<double, 6> normal;
        last = simd::first(surfacePair<Fixed>(piece, simd::loadSplat(ws + j), position.data(),
                                              normal.data()));
        inverses[j] = last;
        std::copy_n(position.begin(), 3, positions + 3 * j);
        std::copy_n(normal.begin(), 3, normals + 3 * j);
    }
    return std::max({simd::first(largest), simd::second(largest), last});
}

[[nodiscard]] inline double surfaceRow(const RowPiece& piece, const double* ws, std::size_t count,
                                       double* positions, double* normals,
                                       double* inverses) noexcept {
    switch (piece.degree) {
        case 1: return surfaceRun<1>(piece, ws, count, positions, normals, inverses);
        case 2: return surfaceRun<2>(piece, ws, count, positions, normals, inverses);
        case 3: return surfaceRun<3>(piece, ws, count, positions, normals, inverses);
        default: return surfaceRun<0>(piece, ws, count, positions, normals, inverses);
    }
}

}  // namespace knotwork::kernels
