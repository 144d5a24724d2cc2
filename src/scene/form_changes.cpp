#include "scene/form_changes.hpp"

#include "geometry/bspline_indexing.hpp"
#include "geometry/bspline_operations.hpp"
#include "geometry/homogeneous.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

std::optional<BsplineCurve> optionally(Result<BsplineCurve> made) {
    if (!made) return std::nullopt;
    return std::move(*made);
}

/// A closed curve as an open one, its first d points repeated.
std::optional<BsplineCurve> opened(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const auto extended = knots.extended();
    std::vector<Vec3> points(curve.points().begin(), curve.points().end());
    std::vector<double> weights(curve.weights().begin(), curve.weights().end());
    for (std::size_t i = 0; i < static_cast<std::size_t>(knots.degree()); ++i) {
        points.push_back(points[i]);
        if (!weights.empty()) weights.push_back(weights[i]);
    }
    auto made = KnotVector::make({extended.begin(), extended.end()}, knots.degree(),
                                 static_cast<int>(points.size()), Form::open);
    if (!made) return std::nullopt;
    return optionally(BsplineCurve::make(std::move(*made), std::move(points), curve.dimension(),
                                         std::move(weights)));
}

/// The blossom of the piece over a span that is not empty.
Homogeneous blossom(std::span<const double> knots, std::span<const Homogeneous> points,
                    std::size_t span, std::span<const double> arguments) {
    const std::size_t degree = arguments.size();
    std::vector<Homogeneous> row(points.begin() + static_cast<std::ptrdiff_t>(span - degree),
                                 points.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = degree; j >= r; --j) {
            const std::size_t i = span - degree + j;
            const double share = (arguments[r - 1] - knots[i]) / (knots[i + degree + 1 - r] - knots[i]);
            row[j] = (1 - share) * row[j - 1] + share * row[j];
        }
    }
    return row[degree];
}

/// The points with which the curve is written over knots that are the same in its domain.
std::vector<Homogeneous> pointsOver(const BsplineCurve& curve, std::span<const double> other) {
    const auto knots = curve.knotVector().knots();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const std::vector<Homogeneous> points = homogeneousPoints(curve);
    std::vector<Homogeneous> changed;
    for (std::size_t j = 0; j < points.size(); ++j) {
        // Any piece that the point has a part in will do; near the middle of them it is safest.
        std::size_t span = std::clamp(j + degree / 2, degree, points.size() - 1);
        while (span > degree && span > j && knots[span] == knots[span + 1]) --span;
        while (span + 1 < points.size() && knots[span] == knots[span + 1]) ++span;
        changed.push_back(blossom(knots, points, span, other.subspan(j + 1, degree)));
    }
    return changed;
}

bool repeat(std::span<const Homogeneous> points, std::size_t degree) {
    double size = 0;
    for (const Homogeneous& p : points) size = std::max(size, glm::length(p));
    for (std::size_t i = 0; i < degree; ++i) {
        const double apart = glm::length(points[i] - points[points.size() - degree + i]);
        if (!(apart <= 1e-9 * size)) return false;
    }
    return true;
}

/// A curve that closes by itself as a closed one.
std::optional<BsplineCurve> joined(const BsplineCurve& curve) {
    const auto knots = curve.knotVector().knots();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const std::size_t count = curve.points().size();
    if (count < 2 * degree + 1) return std::nullopt;
    auto period = KnotVector::make({knots.begin() + static_cast<std::ptrdiff_t>(degree),
                                    knots.begin() + static_cast<std::ptrdiff_t>(count + 1)},
                                   curve.degree(), static_cast<int>(count - degree), Form::closed);
    if (!period) return std::nullopt;
    const std::vector<Homogeneous> points = pointsOver(curve, period->extended());
    if (!repeat(points, degree)) return std::nullopt;
    return optionally(fromHomogeneous(std::move(*period),
                                      std::span(points).first(count - degree), curve.dimension(),
                                      !curve.weights().empty()));
}

using Lines = std::vector<BsplineCurve>;

/// The lines of a surface along u, or along v.
Lines linesOf(const BsplineSurface& surface, bool alongU) {
    const KnotVector& knots = alongU ? surface.knotsU() : surface.knotsV();
    const std::size_t columns = surface.columnCount();
    const std::size_t lines = alongU ? columns : surface.rowCount();
    const std::size_t length = alongU ? surface.rowCount() : columns;
    Lines made;
    for (std::size_t line = 0; line < lines; ++line) {
        std::vector<Vec3> points;
        std::vector<double> weights;
        for (std::size_t i = 0; i < length; ++i) {
            const std::size_t at = alongU ? i * columns + line : line * columns + i;
            points.push_back(surface.points()[at]);
            if (!surface.weights().empty()) weights.push_back(surface.weights()[at]);
        }
        made.push_back(*BsplineCurve::make(knots, std::move(points), 3, std::move(weights)));
    }
    return made;
}

std::optional<BsplineSurface> surfaceOf(const Lines& lines, bool alongU, const KnotVector& across) {
    const std::size_t length = lines.front().points().size();
    std::vector<Vec3> points(lines.size() * length);
    std::vector<double> weights(lines.front().weights().empty() ? 0 : points.size());
    for (std::size_t line = 0; line < lines.size(); ++line) {
        for (std::size_t i = 0; i < length; ++i) {
            const std::size_t at = alongU ? i * lines.size() + line : line * length + i;
            points[at] = lines[line].points()[i];
            if (!weights.empty()) weights[at] = lines[line].weights()[i];
        }
    }
    const KnotVector& along = lines.front().knotVector();
    auto made = BsplineSurface::make(alongU ? along : across, alongU ? across : along,
                                     std::move(points), std::move(weights));
    if (!made) return std::nullopt;
    return std::move(*made);
}

std::optional<BsplineSurface> inFormAlong(const BsplineSurface& surface, bool alongU, Form form) {
    if ((alongU ? surface.knotsU() : surface.knotsV()).form() == form) return surface;
    Lines lines = linesOf(surface, alongU);
    for (BsplineCurve& line : lines) {
        auto reformed = inForm(line, form);
        if (!reformed) return std::nullopt;
        line = std::move(*reformed);
    }
    return surfaceOf(lines, alongU, alongU ? surface.knotsV() : surface.knotsU());
}

}  // namespace

std::optional<BsplineCurve> inForm(const BsplineCurve& curve, Form form) {
    const Form from = curve.knotVector().form();
    if (from == Form::closed && form == Form::open) return opened(curve);
    if (from == Form::closed && form == Form::clamped) {
        auto parts = split(curve, curve.domain().start);
        if (!parts) return std::nullopt;
        return std::move(parts->front());
    }
    if (from != Form::closed && form == Form::closed) return joined(curve);
    return std::nullopt;
}

std::optional<BsplineSurface> inForms(const BsplineSurface& surface, Form u, Form v) {
    const auto along = inFormAlong(surface, true, u);
    if (!along) return std::nullopt;
    return inFormAlong(*along, false, v);
}

}  // namespace knotwork::scene
