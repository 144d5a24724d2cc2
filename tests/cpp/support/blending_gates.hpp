// How far blending curves may be from what their theorems say.
#pragma once

namespace knotwork::test::gates {

// Derivatives at a knot against those of the local curve there, relative to the largest of them and
// to the power of the span by which they grow.
inline constexpr double hermite = 1e-12;
// A blend against what it reproduces, relative to its size.
inline constexpr double reproduction = 1e-12;
inline constexpr double weights = 1e-15;
// Two periods on, relative to the point and to the speed: the parameter is rounded.
inline constexpr double wrapped = 1e-12;
// Differences against integrals, relative to the integral of the derivative's size.
inline constexpr double blendIntegrals = 1e-9;

// Entries of the matrix of derivatives of a blending surface up to (4, 3) against all sums spelled
// out, and first derivatives under an affine map, relative to the largest entry.
inline constexpr double blendedRows = 1e-13;
inline constexpr double affine = 1e-12;
// One patch as a surface by itself, relative to its largest derivative up to (2, 2).
inline constexpr double patchAlone = 1e-11;
// The five point rule with a step of 1e-4, relative to the largest derivative.
inline constexpr double fivePoints = 1e-8;

}  // namespace knotwork::test::gates
