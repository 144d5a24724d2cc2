#include "scene/trace_spline.hpp"

#include "geometry/bspline_kernels.hpp"
#include "scene/trace_formula.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

Vec3 drawn(const Homogeneous& point, bool weighted) noexcept {
    return weighted ? Vec3(point) / point.w : Vec3(point);
}

std::vector<Vec3> drawn(std::span<const Homogeneous> points, bool weighted) {
    std::vector<Vec3> places;
    places.reserve(points.size());
    for (const Homogeneous& point : points) places.push_back(drawn(point, weighted));
    return places;
}

SplineSpan::SplineSpan(const BsplineCurve& of, double parameter)
    : curve(&of),
      knots(of.knotVector().extended()),
      degree(static_cast<std::size_t>(of.degree())),
      places(readingOf(of.points())) {
    const KnotVector& vector = of.knotVector();
    const Side side = parameter == vector.domain().end ? Side::left : Side::right;
    t = vector.wrap(parameter, side);
    index = vector.findSpan(t, side);
    parameters = {.size = std::max(std::abs(knots.front()), std::abs(knots.back())),
                  .gap = knots[index + 1] - knots[index]};
}

double SplineSpan::weight(std::size_t k, std::size_t i) const {
    return kernels::weight(knots, k, i, t);
}

std::size_t SplineSpan::pointOf(std::size_t i) const noexcept {
    return i % curve->points().size();
}

std::vector<Homogeneous> SplineSpan::activePoints() const {
    const std::vector<Homogeneous> all = homogeneousPoints(*curve);
    std::vector<Homogeneous> active;
    for (std::size_t i = index - degree; i <= index; ++i) {
        const Homogeneous& point = all[pointOf(i)];
        active.push_back(curve->rational() ? point : Homogeneous(curve->points()[pointOf(i)], 1));
    }
    return active;
}

std::vector<std::vector<Homogeneous>> SplineSpan::levels() const {
    std::vector<Homogeneous> points = activePoints();
    std::vector<std::vector<Homogeneous>> all{points};
    for (std::size_t r = 1; r <= degree; ++r) {
        kernels::deBoorStep(knots, degree, index, r, t, std::span<Homogeneous>(points));
        all.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(r), points.end());
    }
    return all;
}

SentenceValues SplineSpan::values() const {
    return {{"t", text(t)},
            {"span", readable(index)},
            {"from", text(knots[index])},
            {"to", text(knots[index + 1])},
            {"degree", readable(degree)},
            {"count", readable(curve->points().size())},
            {"active", readable(degree + 1)},
            {"first", readable(pointOf(index - degree))},
            {"last", readable(pointOf(index))}};
}

std::string SplineSpan::text(const Vec3& point) const {
    return readable(point, curve->dimension(), places);
}

void drawPolygon(TraceFrame& frame, const SplineSpan& span) {
    const std::size_t first = addPolygon(frame, span.curve->points(), span.curve->closed());
    for (std::size_t i = span.index - span.degree; i <= span.index; ++i) {
        frame.marked.push_back(first + span.pointOf(i));
    }
}

std::string ratioSymbols(std::size_t k, std::size_t i) {
    const std::string left = indexedTerm("t", i);
    return fraction("t-" + left, indexedTerm("t", i + k) + '-' + left);
}

std::string ratioNumbers(std::span<const double> knots, std::size_t k, std::size_t i, double t,
                         const Reading& reading) {
    return fraction(notedDifference(t, knots[i], reading),
                    notedDifference(knots[i + k], knots[i], reading));
}

}  // namespace knotwork::scene
