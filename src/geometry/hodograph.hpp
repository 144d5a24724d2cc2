// The hodograph: the derivative of a B-spline curve as a B-spline curve.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

namespace knotwork {

/// The curve c'(t), exactly, over the same domain and of the same form.
/// - A polynomial curve of degree d ≥ 2 gives degree d-1 with the points
///   d (c_{i+1} - c_i) / (t_{i+d+1} - t_{i+1}); a gap has its two sides.
/// - Degree 1 gives the constants of the spans, which as curves have degree 1 and a gap at each
///   knot: there is no degree 0.
/// - A rational curve P/w gives (P' w - P w') / w² of degree 2d, piece by piece; where it is
///   continuous the pieces share their ends. Of an open one, nothing is kept outside the domain.
///   NOT_SUPPORTED `degree` beyond degree 12, and `weights` where the products leave 1e-9 … 1e9.
/// O(n) and O(n d²).
[[nodiscard]] Result<BsplineCurve> derivativeCurve(const BsplineCurve& curve);

}  // namespace knotwork
