// Polylines that honour a tolerance.
//
// The distance of a curve from a chord over a parameter interval of length h is at most h²/8 times
// the largest part of C″ across the chord (and at most h²/8 max |C″| in any case, also where the
// curve turns back). That is bounded on each smooth piece by Taylor series at its ends and its
// middle, not looked at in samples; a stretch on which the bound is close to what the middle says
// is divided evenly, any other halved. So the number of points comes close to the least possible,
// ∫ √(κ/8ε) ds for a small tolerance ε.
#pragma once

#include "geometry/curve.hpp"
#include "geometry/sliced_work.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace knotwork {

struct Polyline {
    std::vector<double> xyz;         ///< triples
    std::vector<double> parameters;  ///< one a point, ascending
};

/// As many points as a polyline may have for whoever asks for one …
inline constexpr std::size_t mostPolylinePoints = std::size_t{1} << 22;
/// … and in a picture, where more cannot be seen.
inline constexpr std::size_t mostDrawnPoints = std::size_t{1} << 17;

/// A polyline whose distance from the curve is at most `tolerance` (> 0, world units) over the
/// parameters of every chord, its vertices on the curve, every knot a vertex (twice where the curve
/// jumps). TOO_LARGE at `tolerance` where that takes more than mostPolylinePoints points.
[[nodiscard]] Result<Polyline> polylineWithin(const Curve& curve, double tolerance);
/// The same in slices: `done` gets it, or the refusal, in a step of the work. It weighs 1 for about a
/// tenth of a microsecond.
void planPolyline(SlicedWork& work, const Curve& curve, double tolerance,
                  std::function<void(Result<Polyline>)> done);

/// The same for a picture: where it takes more than mostDrawnPoints points, the tolerance is
/// enlarged until it does not.
[[nodiscard]] Polyline polyline(const Curve& curve, double tolerance);
/// Over a part of the parameter, which may lie outside the domain (see evaluate()).
[[nodiscard]] Polyline polyline(const Curve& curve, const Interval& part, double tolerance);

}  // namespace knotwork
