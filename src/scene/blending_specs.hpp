// What blending curves give besides points, as specifications: their local curves, and themselves
// over other knots.
#pragma once

#include "scene/specs.hpp"

namespace knotwork::scene {

/// Local curve j where it takes part, posed. `spec` is the canonical specification of `curve`.
///
/// Its own specification is that of what was given or cut, where that runs over this very interval
/// and is not posed; otherwise that of a blending curve between two copies of it, which is the same
/// curve. OUT_OF_RANGE `j`; and what makeCurve() refuses of an interval that is too short.
[[nodiscard]] Result<Made<Curve>> localCurve(const Json& spec, const BlendingCurve& curve,
                                             std::size_t j);

/// The specification with other knots, as many as there were. With `recut` local curves are cut
/// anew from the model (or fitted anew), and each pose has its pivot at the new knot. Without it
/// every local curve stays where it is: then they are given one by one, and the poses are written
/// about the new pivots. Refuses what checkBlendingKnots() does.
[[nodiscard]] Result<Json> withKnots(const Json& spec, const BlendingCurve& curve,
                                     const std::vector<double>& knots, bool recut);

}  // namespace knotwork::scene
