// Sine and cosine together, of whatever the models are evaluated on: double, std::complex<double> or
// Jet.
#pragma once

#include "geometry/jet.hpp"

#include <cmath>
#include <complex>

namespace knotwork {

template <class S>
struct Angle {
    S sin;
    S cos;
};
template <class S>
[[nodiscard]] Angle<S> angle(const S& t) noexcept {
    using std::cos, std::sin;
    return {sin(t), cos(t)};
}
[[nodiscard]] inline SinCos angle(const Jet& t) noexcept { return sinCos(t); }

}  // namespace knotwork
