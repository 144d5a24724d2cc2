#include "geometry/bspline_surface_knots.hpp"

#include "geometry/knot_removal.hpp"
#include "geometry/refinement.hpp"

#include <utility>

namespace knotwork {

namespace {

const KnotVector& along(const BsplineSurface& surface, std::size_t direction) noexcept {
    return direction == 0 ? surface.knotsU() : surface.knotsV();
}

std::vector<double> listOf(const KnotVector& knots) {
    return {knots.knots().begin(), knots.knots().end()};
}

/// The lines of the net along one direction: point k of line l lies at l · across + k · step.
struct Lines {
    std::size_t count = 0;
    std::size_t length = 0;
    std::size_t across = 0;
    std::size_t step = 0;
};

Lines linesOf(const BsplineSurface& surface, std::size_t direction) noexcept {
    const std::size_t rows = surface.rowCount();
    const std::size_t columns = surface.columnCount();
    return direction == 0 ? Lines{columns, rows, 1, columns} : Lines{rows, columns, columns, 1};
}

BsplineCurve lineCurve(const BsplineSurface& surface, const Lines& lines, std::size_t direction,
                       std::size_t line) {
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (std::size_t k = 0; k < lines.length; ++k) {
        const std::size_t at = line * lines.across + k * lines.step;
        points.push_back(surface.points()[at]);
        if (!surface.weights().empty()) weights.push_back(surface.weights()[at]);
    }
    return *BsplineCurve::make(along(surface, direction), std::move(points), 3, std::move(weights));
}

}  // namespace

Result<BsplineSurface> insertKnot(const BsplineSurface& surface, std::size_t direction, double t) {
    // What may be inserted, and where it goes, is for every line what it is for the first.
    const auto line = insertKnot(lineCurve(surface, linesOf(surface, direction), direction, 0), t, 1);
    if (!line) return line.error();
    std::vector<double> finer = listOf(line->knotVector());
    auto refined = direction == 0
                       ? refine(surface, std::move(finer), listOf(surface.knotsV()))
                       : refine(surface, listOf(surface.knotsU()), std::move(finer));
    if (!refined) return refuse(refined.error().code, "t", refined.error().message);
    return refined;
}

Result<BsplineSurface> removeKnot(const BsplineSurface& surface, std::size_t direction, double t) {
    const Lines lines = linesOf(surface, direction);
    const Lines fewer{lines.count, lines.length - 1, direction == 0 ? 1 : lines.length - 1,
                      direction == 0 ? lines.across * lines.count : 1};
    std::vector<Vec3> points(fewer.count * fewer.length);
    std::vector<double> weights(surface.weights().empty() ? 0 : points.size());
    std::vector<double> knots;
    for (std::size_t l = 0; l < lines.count; ++l) {
        const auto removal = removeKnotAnyway(lineCurve(surface, lines, direction, l), t);
        if (!removal) return removal.error();
        if (!removal->removed) {
            return refuse(Code::outOfRange, "t",
                          "Without this knot a weight would not be positive; change the weights "
                          "first.");
        }
        for (std::size_t k = 0; k < fewer.length; ++k) {
            const std::size_t at = l * fewer.across + k * fewer.step;
            points[at] = removal->curve.points()[k];
            if (!weights.empty()) weights[at] = removal->curve.weights()[k];
        }
        if (l == 0) knots = listOf(removal->curve.knotVector());
    }
    const KnotVector& former = along(surface, direction);
    auto changed = KnotVector::make(std::move(knots), former.degree(), former.pointCount() - 1,
                                    former.form());
    if (!changed) return refuse(changed.error().code, "t", changed.error().message);
    return direction == 0
               ? BsplineSurface::make(std::move(*changed), surface.knotsV(), std::move(points),
                                      std::move(weights))
               : BsplineSurface::make(surface.knotsU(), std::move(*changed), std::move(points),
                                      std::move(weights));
}

}  // namespace knotwork
