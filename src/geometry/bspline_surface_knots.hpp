// Single knots of B-spline surfaces: each is a whole row or column of the net.
#pragma once

#include "geometry/bspline_surface.hpp"

namespace knotwork {

/// The same surface with one knot more in direction 0 (u) or 1 (v). A closed direction takes any t
/// and wraps it. Refusals are those of insertKnot() of curves, at `t`, and TOO_LARGE `t` beyond
/// 100 000 points in all. O(points · degree²).
[[nodiscard]] Result<BsplineSurface> insertKnot(const BsplineSurface& surface,
                                                std::size_t direction, double t);

/// The surface with one knot t less in direction 0 or 1: along that direction every line of the net
/// becomes the one that comes nearest. Refusals are those of removeKnot() of curves, at `t`, and
/// OUT_OF_RANGE `t` where what is left would have a weight that is not positive.
[[nodiscard]] Result<BsplineSurface> removeKnot(const BsplineSurface& surface,
                                                std::size_t direction, double t);

}  // namespace knotwork
