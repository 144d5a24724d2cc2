// Knots that follow when degree, form or number of points of a B-spline change, in numbers.
#pragma once

#include "geometry/knot_vector.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace knotwork::scene {

/// A valid knot vector of a curve, or of one direction of a surface.
struct KnotRow {
    std::size_t degree = 1;
    Form form = Form::clamped;
    std::size_t count = 0;  ///< of the points
    std::vector<double> knots;
};

/// What such a row becomes. `point` is the place where the numbers of points first differ.
struct RowChange {
    std::size_t degree = 1;
    Form form = Form::clamped;
    std::size_t count = 0;
    std::size_t point = 0;
};

/// The knots after the change; nothing where the default is the better answer, as it is for knots
/// that were the default.
///  - One point more or less takes a knot with it, near it.
///  - Between clamped and open the ends are pulled together or apart.
///  - Closing keeps the knots of the domain, and with them the curve wherever it does not depend on
///    what stands beyond; those that an open vector has there follow, or spans of mean length.
[[nodiscard]] std::optional<std::vector<double>> knotsAfter(const KnotRow& before,
                                                            const RowChange& after);

/// As many knots as wanted over the same interval, spaced as the given ones are.
[[nodiscard]] std::vector<double> respaced(std::span<const double> knots, std::size_t wanted);

}  // namespace knotwork::scene
