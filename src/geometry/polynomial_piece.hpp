// One span of a B-spline curve as a polynomial: its coefficients and those of its derivatives.
#pragma once

#include "geometry/bspline_curve.hpp"

#include <array>
#include <cstddef>

namespace knotwork {

inline constexpr std::size_t maxTerms = maxDegree + 1;
/// Beyond it the power form costs more than 1e-13 of coordinates up to 20 (degree 9: 3e-13), where
/// Bernstein's costs 4e-14 and takes 1.4 times as long.
inline constexpr std::size_t maxPowerDegree = 7;

/// Term k, axis i at [k · components + i]. Components are x, y; or x, y, z; or, where there are
/// four, w x, w y, w z, w.
using Coefficients = std::array<double, maxTerms * 4>;

/// c_k with C = Σ c_k u^k, u = (t - centre) / halfWidth in [-1, 1] on the span: 2 or 3 components,
/// degree at most maxPowerDegree. O(d²).
void powerCoefficients(const BsplineCurve& curve, std::size_t span, std::size_t components,
                       Coefficients& c) noexcept;

/// b_k with C = Σ binomial(d, k) b_k u^k (1-u)^{d-k}, u = (t - start) / width in [0, 1]. O(d²).
void bernsteinCoefficients(const BsplineCurve& curve, std::size_t span, std::size_t components,
                           Coefficients& b) noexcept;

/// Terms of degree d become those of the derivative in t, of degree d-1; scale is du/dt.
void differentiatePower(Coefficients& c, std::size_t degree, std::size_t components,
                        double scale) noexcept;
void differentiateBernstein(Coefficients& b, std::size_t degree, std::size_t components,
                            double scale) noexcept;

/// b_k becomes binomial(d, k) b_k, as the kernels want them.
void multiplyBinomials(Coefficients& b, std::size_t degree, std::size_t components) noexcept;

}  // namespace knotwork
