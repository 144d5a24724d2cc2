// What edits of knots have in common, of curves and of surfaces, of splines and of blends.
#pragma once

#include "scene/json.hpp"

#include <cstddef>
#include <vector>

namespace knotwork::scene {

/// A spline with the form and the shape of this specification, and with all that it has besides.
[[nodiscard]] Json withShape(Json spline, const Json& spec);

struct InsertedKnot {
    std::vector<double> knots;
    std::size_t index = 0;  ///< of the new one
};

/// The knots of a blend with `at` after those that are equal to it. OUT_OF_RANGE `t` unless it lies
/// between the first and the last.
[[nodiscard]] Result<InsertedKnot> withKnotInside(std::vector<double> knots, double at);

/// OUT_OF_RANGE `t` for the first and the last of `count` knots of a closed blend, which stay.
[[nodiscard]] Result<Done> checkRemovable(bool closed, std::size_t index, std::size_t count);

}  // namespace knotwork::scene
