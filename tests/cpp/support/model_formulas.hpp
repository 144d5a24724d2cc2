// The formulas of the model surfaces once more, as their descriptions have them, for numbers of any
// kind: what the library's are compared with.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <string_view>

namespace knotwork::test {

/// S(u, v) of the model with parameters in the order of its description.
template <class S>
std::array<S, 3> modelFormula(std::string_view name, std::span<const double> p, const S& u,
                              const S& v) {
    using std::cos, std::exp, std::sin;
    const auto turned = [&u](const S& rho, const S& z) {
        return std::array<S, 3>{rho * cos(u), rho * sin(u), z};
    };
    const S half = 0.5 * u;
    if (name == "plane") return {u, v, S(0)};
    if (name == "cylinder") return turned(S(p[0]), v);
    if (name == "torus") return turned(p[0] + p[1] * cos(v), p[1] * sin(v));
    if (name == "sphere") return turned(p[0] * cos(v), p[0] * sin(v));
    if (name == "cone") return turned(p[0] * (1.0 - v / p[1]), v);
    if (name == "moebius") return turned(p[0] + v * cos(half), v * sin(half));
    if (name == "klein") {
        const S w = p[1] * (cos(half) * sin(v) - sin(half) * sin(2.0 * v));
        return turned(p[0] + w, p[1] * (sin(half) * sin(v) + cos(half) * sin(2.0 * v)));
    }
    constexpr double turn = 2 * std::numbers::pi;
    if (name == "helicoid") return turned(v, p[1] * u / turn);
    const S w = exp(std::log(p[3]) * (u / turn - p[4]));  // the seashell: growth^(u/2π − turns)
    return turned(w * (p[0] + p[1] * cos(v)), w * (p[1] * sin(v) - p[2]));
}

}  // namespace knotwork::test
