// The part of the session that only B-spline curves answer.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "geometry/basis_sampler.hpp"
#include "geometry/bspline_basis.hpp"
#include "geometry/refinement.hpp"

#include <algorithm>
#include <cstring>

namespace knotwork::bindings {

const BsplineCurve* Session::findBspline(int handle) {
    const auto* held = find<CurveValue>(handle);
    const auto* spline = held ? held->curve.as<BsplineCurve>() : nullptr;
    if (held && !spline) refuse({Code::notSupported, "", "Only a B-spline curve answers this."});
    return spline;
}

int Session::curveKnots(int handle) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return -1;
    std::vector<double> knots;
    if (const auto* blending = held->curve.as<BlendingCurve>()) {
        knots = blending->knots();
    } else if (const auto* spline = findBspline(handle)) {
        const std::span<const double> given = spline->knotVector().knots();
        knots.assign(given.begin(), given.end());
    } else {
        return -1;
    }
    const std::size_t count = knots.size();
    return leave(std::move(knots), count);
}

int Session::curveGrevilles(int handle) {
    const auto* spline = findBspline(handle);
    if (!spline) return -1;
    std::vector<double> grevilles = spline->knotVector().grevilles();
    const std::size_t count = grevilles.size();
    return leave(std::move(grevilles), count);
}

int Session::curveControlPoints(int handle) {
    const auto* spline = findBspline(handle);
    if (!spline) return -1;
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    dropBulk();
    list_ = &spline->points().front().x;
    return static_cast<int>(spline->points().size());
}

int Session::curveInsertKnot(int handle, double t, int times) {
    const auto* spline = findBspline(handle);
    if (!spline) return 0;
    auto refined = insertKnot(*spline, t, times);
    if (!refined) return refuse(refined.error());
    return holdCurve({Curve(std::move(*refined)), std::nullopt, std::nullopt, {}});
}

int Session::curveRefine(int handle, unsigned count, bool byBoehm) {
    const auto* spline = findBspline(handle);
    if (!spline) return 0;
    std::vector<double> knots(std::min<std::size_t>(count, room_.size() / sizeof(double)));
    std::memcpy(knots.data(), room_.data(), knots.size() * sizeof(double));
    auto refined = byBoehm ? refineByBoehm(*spline, std::move(knots))
                           : refineByOslo(*spline, std::move(knots));
    if (!refined) return refuse(refined.error());
    return holdCurve({Curve(std::move(*refined)), std::nullopt, std::nullopt, {}});
}

int Session::curveBasis(int handle, double t, int derivatives) {
    const auto* spline = findBspline(handle);
    if (!spline) return -1;
    const auto inside = parameterInDomain(find<CurveValue>(handle)->curve, t);
    const auto order = checkDerivative(derivatives, "derivatives");
    if (!inside || !order) {
        refuse(inside ? order.error() : inside.error());
        return -1;
    }
    const auto count = static_cast<std::size_t>(spline->knotVector().pointCount());
    std::vector<double> rows(count * rowsOf(derivatives));
    const Side side = *inside == spline->domain().end ? Side::left : Side::right;
    basisRows(spline->knotVector(), *inside, side, derivatives, rows);
    return leave(std::move(rows), count);
}

int Session::curveBasisAt(int handle, unsigned first, unsigned count) {
    const auto* spline = findBspline(handle);
    if (!spline) return 0;
    const std::size_t width = rowsOf(spline->degree());
    const std::size_t rows = std::min<std::size_t>({count, block_.size() / width, blockPoints});
    if (!enterDomain(find<CurveValue>(handle)->curve, first, rows)) return 0;
    activeBasis(spline->knotVector(), {parameters_.data(), rows}, {block_.data(), rows * width},
                {integers_.data(), rows});
    return static_cast<int>(width);
}

}  // namespace knotwork::bindings
