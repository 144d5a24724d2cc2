// The parameters of a grid along one direction.
#pragma once

#include "geometry/interval.hpp"

#include <cstddef>

namespace knotwork {

/// `count` ≥ 2 parameters spread uniformly over the domain, both ends included. The last one of a
/// closed direction is the first one again, so that a seam meets itself to the bit.
struct GridLine {
    Interval domain;
    bool closed = false;
    std::size_t count = 2;

    struct Place {
        double parameter;
        Side side;
    };
    [[nodiscard]] constexpr Place at(std::size_t i) const noexcept {
        const bool last = i + 1 == count;
        if (last && closed) return {domain.start, Side::right};
        return {uniformParameter(domain, i, count), last ? Side::left : Side::right};
    }
};

}  // namespace knotwork
