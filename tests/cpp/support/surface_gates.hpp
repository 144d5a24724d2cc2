// How far points and derivatives of surfaces may be from the truth.
#pragma once

namespace knotwork::test::gates {

// Points of model surfaces of size up to 5, a few ulp.
inline constexpr double modelPoint = 1e-14;
// Derivatives up to (4, 3) against Cauchy's integral in both variables, which loses digits with the
// order and with the radius.
inline constexpr double cauchyInTwo = 1e-10;
// B-spline surfaces, points in [-1, 1]³: against two nested curves, and after a refinement.
inline constexpr double nestedCurves = 2e-14;
// A weight times a point over the weight.
inline constexpr double weightedCorner = 3e-16;
inline constexpr double refinedSurface = 1e-13;
// Unit normals and curvatures of size up to 2 against closed forms; at a pole by power series.
inline constexpr double normal = 1e-14;
inline constexpr double curvature = 1e-13;
// Of any surface, relative to the squares of its curvatures.
inline constexpr double generalCurvature = 1e-10;
inline constexpr double poleNormal = 1e-13;
// Among knots that are close, times their distance.
inline constexpr double normalAmongCloseKnots = 1e-15;
inline constexpr double poleCurvature = 1e-9;
// Grids against single points, coordinates up to 3; normals over |Su × Sv|.
inline constexpr double gridPoint = 1e-13;
inline constexpr double gridNormal = 1e-12;

}  // namespace knotwork::test::gates
