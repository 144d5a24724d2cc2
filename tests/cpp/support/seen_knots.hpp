// The knots of one direction of a blending surface, from both sides.
#pragma once

#include "geometry/blending_surface.hpp"

#include <cstddef>
#include <vector>

namespace knotwork::test {

/// A knot, seen from a side on which there is something of the surface.
struct SeenKnot {
    std::size_t patch;  // which is centred there
    double t;           // in the parameter of the surface …
    double own;         // … and in that of the patch
    Side side;
    double order;  // up to which the B-function has no derivatives there
};

inline std::vector<SeenKnot> seenKnots(const BlendDirection& along) {
    std::vector<SeenKnot> seen;
    const auto& knots = along.knots;
    const auto [atZero, atOne] = along.blend.order();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const std::size_t patch = i == along.count ? 0 : i;
        if (i > 0 && knots[i - 1] < knots[i]) {
            seen.push_back({patch, knots[i], knots[patch], Side::left, atOne});
        }
        if (i + 1 < knots.size() && knots[i] < knots[i + 1]) {
            seen.push_back({patch, knots[i], knots[patch], Side::right, atZero});
        }
    }
    return seen;
}

}  // namespace knotwork::test
