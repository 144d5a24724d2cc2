// How far curves are from each other.
#pragma once

#include "geometry/curve.hpp"

#include <algorithm>
#include <cstddef>

namespace knotwork::test {

/// The largest distance at 65 equal parameters of the first curve's domain.
inline double distanceBetween(const Curve& a, const Curve& b) {
    constexpr std::size_t samples = 65;
    double largest = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double t = uniformParameter(domain(a), i, samples);
        largest = std::max(largest, glm::length(pointAt(a, t) - pointAt(b, t)));
    }
    return largest;
}

}  // namespace knotwork::test
