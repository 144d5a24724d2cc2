#include "geometry/patch_surface.hpp"

#include "geometry/bezier_curve.hpp"
#include "geometry/local_curve.hpp"

#include <array>
#include <vector>

namespace knotwork {

namespace {

/// The Taylor coefficients of a curve from its derivatives at t0, as its control points.
std::vector<Vec3> controlPoints(std::vector<Vec3> derivatives, double t0, const Interval& over) {
    double factorial = 1;
    for (std::size_t k = 2; k < derivatives.size(); ++k) {
        factorial *= static_cast<double>(k);
        derivatives[k] /= factorial;
    }
    const BezierCurve curve = BezierCurve::fromTaylor(derivatives, t0, over);
    return {curve.points().begin(), curve.points().end()};
}

Result<KnotVector> onePiece(int degree, const Interval& over) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, over.start);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, over.end);
    return KnotVector::make(std::move(knots), degree, degree + 1, Form::clamped);
}

/// First along v, line by line of the matrix, then along u.
Result<Surface> polynomialPatch(const BlendingSurface& surface, std::size_t i, std::size_t j,
                                const Rectangle& over) {
    const SurfaceOrders degree = surface.cut().orders();
    const std::size_t lines = static_cast<std::size_t>(degree.u) + 1;
    const std::span<const Vec3> matrix = surface.matrix(i, j);
    std::vector<Vec3> points;
    for (std::size_t line = 0; line < lines; ++line) {
        const auto row = matrix.subspan(line * degree.columns(), degree.columns());
        const auto made =
            controlPoints({row.begin(), row.end()}, surface.alongV().knots[j], over.v);
        points.insert(points.end(), made.begin(), made.end());
    }
    const Affine& placement = surface.place(i, j).placement();
    std::vector<Vec3> column(lines);
    for (std::size_t k = 0; k < degree.columns(); ++k) {
        for (std::size_t line = 0; line < lines; ++line) column[line] = points[degree.at(line, k)];
        const auto made = controlPoints(column, surface.alongU().knots[i], over.u);
        for (std::size_t line = 0; line < lines; ++line) {
            points[degree.at(line, k)] = placement.point(made[line]);
        }
    }
    auto knotsU = onePiece(degree.u, over.u);
    if (!knotsU) return ofDirection(knotsU.error(), 0);
    auto knotsV = onePiece(degree.v, over.v);
    if (!knotsV) return ofDirection(knotsV.error(), 1);
    auto made = BsplineSurface::make(std::move(*knotsU), std::move(*knotsV), std::move(points));
    if (!made) return made.error();
    return Surface(std::move(*made));
}

Result<Surface> fourCopies(const BlendingSurface& surface, const PatchPlace& place,
                           const Rectangle& over) {
    std::vector<Pose> poses;
    for (const auto& [u, sideU] : {std::pair{over.u.start, Side::right}, {over.u.end, Side::left}}) {
        for (const auto& [v, sideV] :
             {std::pair{over.v.start, Side::right}, {over.v.end, Side::left}}) {
            const Vec3 pivot = pointAt(surface.model(), {u, v, sideU, sideV});
            poses.push_back(aboutAnother(place.pose(), place.origin(), pivot));
        }
    }
    auto made = BlendingSurface::make(
        surface.model(), {2, BlendForm::open, {}, {over.u.start, over.u.end}},
        {2, BlendForm::open, {}, {over.v.start, over.v.end}}, {}, poses);
    if (!made) return made.error();
    return Surface(std::move(*made));
}

}  // namespace

Result<Surface> patchSurface(const BlendingSurface& surface, std::size_t i, std::size_t j) {
    const BlendDirection& u = surface.alongU();
    const BlendDirection& v = surface.alongV();
    const Rectangle over{blendingDomain(u.knots, i, u.form), blendingDomain(v.knots, j, v.form)};
    if (!surface.cutsModel()) return polynomialPatch(surface, i, j, over);
    const PatchPlace& place = surface.place(i, j);
    const ClosedDirections turns = closedDirections(surface.model());
    const bool whole = domain(surface.model()) == over && !turns.u && !turns.v;
    if (whole && place.pose().isIdentity()) return surface.model();
    return fourCopies(surface, place, over);
}

}  // namespace knotwork
