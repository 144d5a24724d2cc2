// Points and normals of one row of a blend of two polynomials: the inner loop of grids of blending
// surfaces.
#pragma once

#include "geometry/surface_kernels.hpp"

namespace knotwork::kernels {

/// P(w) + γ(w) D(w), and the same of their derivatives by u: x, y, z of term k of P at [12k], of Pu
/// at [12k + 3], of D at [12k + 6], of Du at [12k + 9].
struct BlendPiece {
    const double* terms;
    std::size_t degree;
};

/// What belongs to the columns of a row: w, γ(w) and dγ/dw, each reaching to the next even number.
struct BlendColumns {
    const double* ws;
    const double* weights;
    const double* slopes;
};

/// Two points with their normals, those of Su × dS/dw. Fixed is the degree where it is known to the
/// compiler, else 0.
template <std::size_t Fixed>
[[nodiscard]] inline Double2 blendedPair(const BlendPiece& piece, Double2 w, Double2 weight,
                                         Double2 weightSlope, double* position,
                                         double* normal) noexcept {
    const std::size_t degree = Fixed > 0 ? Fixed : piece.degree;
    const double* term = piece.terms + 12 * degree;
    Points2 point = splatTerm(term);
    Points2 along = splatTerm(term + 3);
    Points2 step = splatTerm(term + 6);
    Points2 alongStep = splatTerm(term + 9);
    Points2 slope = point;
    Points2 stepSlope = step;
    for (std::size_t k = degree; k-- > 1;) {
        term -= 12;
        point = timesPlus(point, w, splatTerm(term));
        along = timesPlus(along, w, splatTerm(term + 3));
        step = timesPlus(step, w, splatTerm(term + 6));
        alongStep = timesPlus(alongStep, w, splatTerm(term + 9));
        slope = timesPlus(slope, w, point);
        stepSlope = timesPlus(stepSlope, w, step);
    }
    term = piece.terms;
    point = timesPlus(point, w, splatTerm(term));
    along = timesPlus(along, w, splatTerm(term + 3));
    step = timesPlus(step, w, splatTerm(term + 6));
    alongStep = timesPlus(alongStep, w, splatTerm(term + 9));
    const Points2 blended = timesPlus(step, weight, point);
    simd::storeInterleaved(position, blended.x, blended.y, blended.z);
    const Points2 su = timesPlus(alongStep, weight, along);
    const Points2 sw = timesPlus(step, weightSlope, timesPlus(stepSlope, weight, slope));
    Double2 inverse;
    const Points2 unit = unitCross(su, sw, inverse);
    simd::storeInterleaved(normal, unit.x, unit.y, unit.z);
    return inverse;
}

/// `count` points. Answers the largest 1/|Su × dS/dw|; each by itself is left in `inverses`, which
/// reaches as far as the columns.
template <std::size_t Fixed>
[[nodiscard]] double blendedRun(const BlendPiece& piece, const BlendColumns& at, std::size_t count,
                                double* positions, double* normals, double* inverses) noexcept {
    Double2 largest = simd::splat(0);
    std::size_t j = 0;
    for (; j + 2 <= count; j += 2) {
        const Double2 inverse = blendedPair<Fixed>(
            piece, simd::load(at.ws + j), simd::load(at.weights + j), simd::load(at.slopes + j),
            positions + 3 * j, normals + 3 * j);
        simd::store(inverses + j, inverse);
        largest = simd::larger(largest, inverse);
    }
    double last = 0;
    if (j < count) {
        std::array<double, 6> position;
        std::array<double, 6> normal;
        last = simd::first(blendedPair<Fixed>(
            piece, simd::loadSplat(at.ws + j), simd::loadSplat(at.weights + j),
            simd::loadSplat(at.slopes + j), position.data(), normal.data()));
        inverses[j] = last;
        std::copy_n(position.begin(), 3, positions + 3 * j);
        std::copy_n(normal.begin(), 3, normals + 3 * j);
    }
    return std::max({simd::first(largest), simd::second(largest), last});
}

[[nodiscard]] inline double blendedRow(const BlendPiece& piece, const BlendColumns& at,
                                       std::size_t count, double* positions, double* normals,
                                       double* inverses) noexcept {
    switch (piece.degree) {
        case 1: return blendedRun<1>(piece, at, count, positions, normals, inverses);
        case 2: return blendedRun<2>(piece, at, count, positions, normals, inverses);
        case 3: return blendedRun<3>(piece, at, count, positions, normals, inverses);
        default: return blendedRun<0>(piece, at, count, positions, normals, inverses);
    }
}

}  // namespace knotwork::kernels
