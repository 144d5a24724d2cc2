// Knot removal: the curve with one knot less that comes nearest, and how far it moves.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/result.hpp"

namespace knotwork {

struct KnotRemoval {
    BsplineCurve curve;  ///< without the knot, or as it was where `removed` is false
    /// No point of the curve moves farther than this when the knot is taken out: a bound on the
    /// distance at equal parameters, at most 5 % above it (and rounding, 1e-15 of the size of the
    /// points). Infinity where what is left would have a weight that is not positive.
    double deviation = 0;
    bool removed = false;
};

/// Takes one knot t out, if that moves the curve by no more than `tolerance`. The points c' of the
/// new curve are to give the old ones by inserting t again,
///     c_i = (1 - a_i) c'_{i-1} + a_i c'_i,  i = r-d … r-s (t = t_r of multiplicity s),
/// which is one equation more than there are unknowns. All are met with one and the same residual,
/// of alternating sign, the least possible for the largest of them; then they are solved from both
/// sides towards a_i = 1/2, where no step magnifies an error (W. Tiller, Knot-removal algorithms
/// for NURBS curves and surfaces, 1992). A rational curve is treated in homogeneous form, and the
/// deviation is that of the curve itself. O(n + d³).
/// Refusals: NOT_FINITE `t` and `tolerance`; OUT_OF_RANGE `tolerance` (at least 0) and `t` where t is
/// no knot in the domain, or ends it (modulo the period of a closed curve, whose seam can be thinned
/// out but not removed); KNOTS_COUNT `t` where fewer than d+1 points would be left.
[[nodiscard]] Result<KnotRemoval> removeKnot(const BsplineCurve& curve, double t,
                                             double tolerance);

/// The same whatever it moves.
[[nodiscard]] Result<KnotRemoval> removeKnotAnyway(const BsplineCurve& curve, double t);

}  // namespace knotwork
