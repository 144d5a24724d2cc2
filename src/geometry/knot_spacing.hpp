// Knots that divide a curve into parts of equal length.
#pragma once

#include "geometry/curve.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace knotwork {

/// `number` ≥ 2 parameters, the ends of the domain and between them those that divide the curve
/// into equal lengths, to 1e-12 of the length. Nothing for a curve without length (or with one that
/// is not finite).
[[nodiscard]] std::optional<std::vector<double>> equalLengthKnots(const Curve& curve,
                                                                  std::size_t number);

}  // namespace knotwork
