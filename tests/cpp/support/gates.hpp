// How far results may be from the truth. Bounds measured on half a million random splines of
// degree 1 to 7 with |c| ≤ 1, rounded up; derivatives relative to the size of the derivative.
#pragma once

namespace knotwork::test::gates {

inline constexpr double exact = 1e-14;  // against fractions
inline constexpr double partitionOfUnity = 1e-14;
inline constexpr double basisAgainstDeBoor = 2e-14;
inline constexpr double osloAgainstBoehm = 2e-14;
inline constexpr double refinement = 5e-14;
inline constexpr double removal = 5e-13;  // of a knot that was inserted: the inverse of a refinement
inline constexpr double complexStep = 1e-10;
// Derivatives of a rational spline on the two sides of a knot, weights from 0.25 to 3.
inline constexpr double rationalJumps = 1e-11;

// Fast sampling against de Boor's algorithm, each coordinate up to 20. Largest differences of 3000
// random curves: 3.6e-14, 7.8e-14, 7.8e-14 (degree 25), 9.4e-14.
inline constexpr double cubicSamples = 4e-14;
inline constexpr double powerSamples = 1e-13;
inline constexpr double bernsteinSamples = 1e-13;
inline constexpr double rationalSamples = 1.2e-13;
// Spans that differ by factors up to 1e9 (nearly equal knots) cost a bit more: of 40 000 curves the
// worst missed by 1.7 times the gates above.
inline constexpr double unevenSpans = 3;
// Relative to the largest derivative of the order on the curve.
inline constexpr double sampledDerivatives = 1e-11;
inline constexpr double highDegreeDerivatives = 1e-10;  // third derivatives, degree 8 to 25: 3e-11

// Least squares: the curve, and the control points of clamped and closed ones, against the spline
// that the data come from. Largest differences up to degree 9: 2e-13.
inline constexpr double fitted = 1e-12;
// At the data, relative to the largest control point. Largest up to degree 7: 3e-14.
inline constexpr double interpolated = 1e-13;

}  // namespace knotwork::test::gates
