// The triangular schemes of B-splines on any scalar: double in the library, complex numbers and
// exact rationals in the tests.
//
// t lies in span s of the knots, t_s ≤ t ≤ t_{s+1}, t_s < t_{s+1}; w_{k,i}(t) is
// (t - t_i) / (t_{i+k} - t_i). Every quotient below spans s, so that none is ever 0/0.
// (C. de Boor, A Practical Guide to Splines, 1978, ch. X; Lyche and Mørken, Spline Methods.)
#pragma once

#include <cstddef>
#include <span>

namespace knotwork::kernels {

/// w_{k,i}(t).
template <class Knot, class Scalar>
[[nodiscard]] constexpr Scalar weight(std::span<const Knot> knots, std::size_t k, std::size_t i,
                                      const Scalar& t) {
    return (t - knots[i]) / (knots[i + k] - knots[i]);
}

/// One step of the Cox–de Boor recurrence: the k functions of degree k-1 in `values[0 … k-1]`
/// become the k+1 functions of degree k.
template <class Knot, class Scalar>
constexpr void raiseBasis(std::span<const Knot> knots, std::size_t span, std::size_t k,
                          const Scalar& t, std::span<Scalar> values) {
    Scalar carried{0};
    for (std::size_t j = 0; j < k; ++j) {
        const Scalar w = weight(knots, k, span + 1 + j - k, t);
        const Scalar lower = values[j];
        values[j] = carried + (Scalar{1} - w) * lower;
        carried = w * lower;
    }
    values[k] = carried;
}

/// The same step for a derivative: D N_{i,k} = k (N_{i,k-1} / (t_{i+k} - t_i) - …).
template <class Knot, class Scalar>
constexpr void differentiateBasis(std::span<const Knot> knots, std::size_t span, std::size_t k,
                                  std::span<Scalar> values) {
    Scalar carried{0};
    for (std::size_t j = 0; j < k; ++j) {
        const std::size_t i = span + 1 + j - k;
        const Scalar slope = values[j] * Knot(static_cast<int>(k)) / (knots[i + k] - knots[i]);
        values[j] = carried - slope;
        carried = slope;
    }
    values[k] = carried;
}

/// The d+1 functions of degree d that live on the span.
template <class Knot, class Scalar>
constexpr void basis(std::span<const Knot> knots, std::size_t degree, std::size_t span,
                     const Scalar& t, std::span<Scalar> values) {
    values[0] = Scalar{1};
    for (std::size_t k = 1; k <= degree; ++k) raiseBasis(knots, span, k, t, values);
}

/// The order-th derivatives of the same functions; all zero for order > d.
template <class Knot, class Scalar>
constexpr void basisDerivative(std::span<const Knot> knots, std::size_t degree, std::size_t span,
                               std::size_t order, const Scalar& t, std::span<Scalar> values) {
    if (order > degree) {
        for (std::size_t j = 0; j <= degree; ++j) values[j] = Scalar{0};
        return;
    }
    basis(knots, degree - order, span, t, values);
    for (std::size_t k = degree - order + 1; k <= degree; ++k) {
        differentiateBasis(knots, span, k, values);
    }
}

/// One step of de Boor's algorithm at t, row d-r+1 → r: afterwards `points[r … d]` hold the
/// points of level r. The steps with different parameters u_1 … u_d give the blossom.
template <class Knot, class Scalar, class Point>
constexpr void deBoorStep(std::span<const Knot> knots, std::size_t degree, std::size_t span,
                          std::size_t r, const Scalar& t, std::span<Point> points) {
    for (std::size_t j = degree; j >= r; --j) {
        const Scalar w = weight(knots, degree + 1 - r, span + j - degree, t);
        points[j] = (Scalar{1} - w) * points[j - 1] + w * points[j];
    }
}

/// The point at t from the d+1 active points, which are overwritten.
template <class Knot, class Scalar, class Point>
[[nodiscard]] constexpr Point deBoor(std::span<const Knot> knots, std::size_t degree,
                                     std::size_t span, const Scalar& t, std::span<Point> points) {
    for (std::size_t r = 1; r <= degree; ++r) deBoorStep(knots, degree, span, r, t, points);
    return points[degree];
}

/// The quotient rule f^(k) = ((w f)^(k) - sum_{i=1..k} binomial(k, i) w^(i) f^(k-i)) / w, in place:
/// row(k), k < rows, refers to (w f)^(k) and becomes f^(k). `weights` holds w, w', …; further
/// derivatives of w are zero.
template <class Row>
constexpr void quotientRule(std::size_t rows, std::span<const double> weights, Row row) {
    for (std::size_t k = 0; k < rows; ++k) {
        double binomial = 1;
        for (std::size_t i = 1; i <= k && i < weights.size(); ++i) {
            binomial *= static_cast<double>(k - i + 1) / static_cast<double>(i);
            row(k) -= binomial * weights[i] * row(k - i);
        }
        row(k) /= weights[0];
    }
}

}  // namespace knotwork::kernels
