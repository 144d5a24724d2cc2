// Gauss–Legendre quadrature on an interval, and Gauss–Laguerre's for what decays.
#pragma once

#include <array>
#include <cstddef>

namespace knotwork {

struct GaussNode {
    double x;
    double weight;
};

/// The positive half of the N nodes in (−1, 1); the rule is symmetric. To 18 digits, from Newton's iteration
/// on the Legendre polynomial in 40-digit arithmetic.
template <std::size_t N>
inline constexpr std::array<GaussNode, N / 2> gaussHalf{};

template <>
inline constexpr std::array<GaussNode, 4> gaussHalf<8>{{
    {0.960289856497536232, 0.101228536290376259},
    {0.79666647741362674, 0.222381034453374471},
    {0.525532409916328986, 0.313706645877887287},
    {0.183434642495649805, 0.362683783378361983},
}};
template <>
inline constexpr std::array<GaussNode, 8> gaussHalf<16>{{
    {0.989400934991649933, 0.0271524594117540949},
    {0.944575023073232576, 0.0622535239386478929},
    {0.865631202387831744, 0.0951585116824927848},
    {0.755404408355003034, 0.124628971255533872},
    {0.617876244402643748, 0.149595988816576732},
    {0.458016777657227386, 0.169156519395002538},
    {0.281603550779258913, 0.182603415044923589},
    {0.0950125098376374402, 0.189450610455068496},
}};

/// All N nodes in ascending order.
template <std::size_t N>
[[nodiscard]] constexpr std::array<GaussNode, N> gaussNodes() noexcept {
    std::array<GaussNode, N> nodes{};
    for (std::size_t i = 0; i < N / 2; ++i) {
        const GaussNode half = gaussHalf<N>[i];
        nodes[i] = {-half.x, half.weight};
        nodes[N - 1 - i] = half;
    }
    return nodes;
}

/// ∫_a^b f, exact up to rounding for polynomials of degree 2N − 1. N evaluations of f(double).
template <std::size_t N, class F>
[[nodiscard]] double integrateGauss(F&& f, double a, double b) {
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    double sum = 0;
    for (const GaussNode& node : gaussHalf<N>) {
        sum += node.weight * (f(middle - half * node.x) + f(middle + half * node.x));
    }
    return half * sum;
}

/// Nodes of Gauss–Laguerre with their weights times exp(x), to 18 digits by the same iteration.
inline constexpr std::array<GaussNode, 10> laguerreNodes{{
    {0.137793470540492431, 0.354009738606996309},
    {0.729454549503170498, 0.831902301043580738},
    {1.80834290174031605, 1.33028856174932818},
    {3.40143369785489951, 1.86306390311113099},
    {5.55249614006380363, 2.45025555808301017},
    {8.3301527467644967, 3.1227641551351825},
    {11.8437858379000656, 3.9341526955615211},
    {16.2792578313781021, 4.9924148721930231},
    {21.996585811980762, 6.57220248513080298},
    {29.9206970122738916, 9.78469584037463069},
}};

/// ∫_0^∞ f for an f that is nearly exp(−rate x). 10 evaluations of f(double).
template <class F>
[[nodiscard]] double integrateLaguerre(F&& f, double rate) {
    double sum = 0;
    for (const GaussNode& node : laguerreNodes) sum += node.weight * f(node.x / rate);
    return sum / rate;
}

}  // namespace knotwork
