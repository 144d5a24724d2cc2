// Local curves cut from a model at a knot: what each kind keeps of it.
//
// A sub-curve is the model itself. A line is the tangent p + (t − t_0) p′; an arc (arc_curve.hpp)
// keeps the curvature too; a Bézier curve of degree m is the Taylor polynomial with all derivatives
// up to the m-th; a B-spline has no data of the knot but is next to the model, in the mean square,
// on all of the interval where it takes part.
#pragma once

#include "geometry/curve.hpp"
#include "geometry/interval.hpp"
#include "geometry/result.hpp"

#include <cstddef>
#include <vector>

namespace knotwork {

/// Control points of a B-spline local curve; its degree is below that.
inline constexpr std::size_t localSplinePoints = 8;

/// For every kind but the sub-curve, with what is the same for all local curves made once.
class LocalCutter {
public:
    /// `degree` matters for Bézier curves (1 … 25) and B-splines (1 … 7).
    LocalCutter(const Curve& model, const LocalCut& cut);

    /// The curve at `knot`, where the model is looked at from `side`, with the domain `over`.
    ///
    /// Where the model stands still (p′ = 0 to rounding: a cusp) a line and an arc rest at its
    /// point, which is what arcs shrink to on the way there. NOT_FINITE `model` where the model has
    /// no derivative of the order that is needed; OUT_OF_RANGE where the model does not fit the
    /// limits of the kind.
    [[nodiscard]] Result<Curve> at(double knot, Side side, const Interval& over) const;

private:
    [[nodiscard]] Result<Curve> spline(const Interval& over) const;

    const Curve& model_;
    LocalCut cut_;
    std::vector<double> unitKnots_;  // of the B-spline over [0, 1]
    std::vector<double> cholesky_;   // of its Gram matrix ∫ N_i N_j, row by row
};

}  // namespace knotwork
