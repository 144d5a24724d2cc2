// How far values of B-functions and model curves may be from the truth.
#pragma once

namespace knotwork::test::gates {

// Closed forms, against fractions and decimals; a few ulp of 1.
inline constexpr double bFunction = 2e-15;
// Tables of expo-rational integrals. Promised: 2e-13, and 1e-9 of B in the tail. Measured over the
// whole range of the parameters: 3e-15 and 3e-12.
inline constexpr double erb = 2e-14;
inline constexpr double erbTail = 2e-11;
// Derivatives relative to their size: first ones against a complex step, higher ones against
// Cauchy's integral, which itself loses digits with the order.
inline constexpr double complexStepSlope = 1e-12;
inline constexpr double cauchy = 1e-10;
// Differences against integrals of the derivatives over a twentieth, relative to the integral of the
// derivative's size: 16 Gauss nodes see that much of a gentle B-function.
inline constexpr double integrals = 1e-9;
// Points of model curves relative to their size, parameters up to 12π.
inline constexpr double curvePoint = 1e-14;

}  // namespace knotwork::test::gates
