// Inserting one knot u (W. Boehm, Inserting new knots into B-spline curves, 1980):
// b_i = (1 - a_i) c_{i-1} + a_i c_i, a_i = (u - t_i) / (t_{i+d} - t_i), on d - m legs of the
// polygon where u stands m times already; all other points stay.
#include "geometry/bspline_kernels.hpp"
#include "geometry/refinement.hpp"
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_spline.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "boehm.begin", "A new knot {knot}",
    "The knot {knot} is put between the knots {from} and {to}; its multiplicity is {present} so "
    "far and the degree is {degree}, so the number of legs of the control polygon that get a "
    "new point is {legs}."};
constexpr Sentence cut{
    "boehm.cut", "New points on the legs",
    "Each new point divides its leg as {knot} divides two knots that are {degree} apart: with "
    "{ratios} of the leg passed, the new points are {points}."};
constexpr Sentence result{
    "boehm.result", "The refined polygon",
    "The points between the new ones are left out, so that the control polygon has {more} "
    "points in place of {count}; {knot} now has the multiplicity {times}, and the curve is the "
    "same."};

/// The legs that are cut: from point i-1 to point i of the extended polygon, first ≤ i < end.
struct Cut {
    Cut(const BsplineCurve& of, double knot);

    std::vector<double> ratios() const;
    std::vector<Homogeneous> newPoints() const;
    std::vector<Homogeneous> refined() const;
    SentenceValues values() const;

    const BsplineCurve& curve;
    std::span<const double> knots;
    std::size_t degree;
    std::vector<Homogeneous> points;
    double u;
    std::size_t span;
    std::size_t first;
    std::size_t end;
    Reading parameters;
    Reading places;
};

Cut::Cut(const BsplineCurve& of, double knot)
    : curve(of),
      knots(of.knotVector().extended()),
      degree(static_cast<std::size_t>(of.degree())),
      points(homogeneousPoints(of)),
      u(of.knotVector().wrap(knot)),
      places(readingOf(of.points())) {
    const auto after = std::upper_bound(knots.begin(), knots.end(), u);
    span = static_cast<std::size_t>(after - knots.begin()) - 1;
    first = span + 1 - degree;
    end = span + 1;
    while (end > first && knots[end - 1] >= u) --end;
    parameters = {.size = std::max(std::abs(knots.front()), std::abs(knots.back())),
                  .gap = knots[span + 1] - knots[end - 1]};
}

std::vector<double> Cut::ratios() const {
    std::vector<double> all;
    for (std::size_t i = first; i < end; ++i) all.push_back(kernels::weight(knots, degree, i, u));
    return all;
}

std::vector<Homogeneous> Cut::newPoints() const {
    const std::size_t n = points.size();
    std::vector<Homogeneous> made;
    for (std::size_t i = first; i < end; ++i) {
        const double a = kernels::weight(knots, degree, i, u);
        made.push_back((1 - a) * points[(i - 1) % n] + a * points[i % n]);
    }
    return made;
}

/// Point i of the new polygon is c_i before the cut legs, and c_{i-1} behind them; around a closed
/// one everything that is not cut lies behind.
std::vector<Homogeneous> Cut::refined() const {
    const std::size_t n = points.size();
    const std::vector<Homogeneous> made = newPoints();
    std::vector<Homogeneous> polygon(n + 1);
    for (std::size_t i = 0; i < first && !curve.closed(); ++i) polygon[i] = points[i];
    const std::size_t behind = curve.closed() ? first + n : n;
    for (std::size_t i = end; i <= behind; ++i) polygon[i % (n + 1)] = points[(i - 1) % n];
    for (std::size_t i = first; i < end; ++i) polygon[i % (n + 1)] = made[i - first];
    return polygon;
}

SentenceValues Cut::values() const {
    const auto present = static_cast<std::size_t>(curve.knotVector().multiplicity(u));
    const std::size_t before = end - 1;
    return {{"knot", readable(u, parameters)},
            {"from", readable(knots[before], parameters)},
            {"to", readable(knots[span + 1], parameters)},
            {"degree", readable(degree)},
            {"present", readable(present)},
            {"times", readable(present + 1)},
            {"legs", readable(end - first)},
            {"count", readable(points.size())},
            {"more", readable(points.size() + 1)}};
}

TraceFrame beginFrame(const Cut& cutting) {
    TraceFrame frame = tell(begin, cutting.values());
    const std::size_t n = cutting.points.size();
    addPolygon(frame, cutting.curve.points(), cutting.curve.closed());
    for (std::size_t i = cutting.first - 1; i < cutting.end; ++i) frame.marked.push_back(i % n);
    const std::size_t before = cutting.end - 1;
    frame.formula = mathml(noted(cutting.knots[before], cutting.parameters) + "=" +
                           indexedTerm("t", before) + "\\le u=" +
                           noted(cutting.u, cutting.parameters) + "\\le " +
                           indexedTerm("t", cutting.span + 1) + "=" +
                           noted(cutting.knots[cutting.span + 1], cutting.parameters));
    return frame;
}

std::string ratioColumn(const Cut& cutting, std::size_t i, double a) {
    const std::string left = indexedTerm("t", i);
    const double from = cutting.knots[i];
    const auto minus = [&](double x, double y) {
        return notedDifference(x, y, cutting.parameters);
    };
    return indexedTerm("a", i) + "=" +
           fraction("u-" + left, indexedTerm("t", i + cutting.degree) + '-' + left) + "=" +
           fraction(minus(cutting.u, from), minus(cutting.knots[i + cutting.degree], from)) + "=" +
           noted(a);
}

/// What stands before the two points, and the sum of it where they have weights.
std::string mixColumn(const Cut& cutting, std::size_t i, double a) {
    const std::size_t n = cutting.points.size();
    const auto mix = [&](double first, double second) {
        return noted(first) + indexedTerm("c", (i - 1) % n) + "+" + noted(second) +
               indexedTerm("c", i % n);
    };
    if (cutting.curve.weights().empty()) return mix(1 - a, a);
    const double first = (1 - a) * cutting.points[(i - 1) % n].w;
    const double second = a * cutting.points[i % n].w;
    return fraction(mix(first, second), noted(first) + "+" + noted(second));
}

std::string cutRow(const Cut& cutting, std::size_t i, double a, const Vec3& made) {
    return ratioColumn(cutting, i, a) + "&" + indexedTerm("b", i % (cutting.points.size() + 1)) +
           "=" + mixColumn(cutting, i, a) + "=" +
           noted(made, cutting.curve.dimension(), cutting.places);
}

TraceFrame cutFrame(const Cut& cutting) {
    const bool weighted = !cutting.curve.weights().empty();
    const std::vector<Vec3> made = drawn(cutting.newPoints(), weighted);
    const std::vector<double> ratios = cutting.ratios();
    SentenceValues values = cutting.values();
    values.insert(values.end(),
                  {{"ratios", spoken(ratios)},
                   {"points", spoken(made, cutting.curve.dimension(), cutting.places)}});
    TraceFrame frame = tell(cut, std::move(values));
    addPolygon(frame, cutting.curve.points(), cutting.curve.closed());
    addMarked(frame, made);
    frame.weights = ratios;
    NotedRows rows;
    for (std::size_t j = 0; j < made.size(); ++j) {
        rows.add(cutRow(cutting, cutting.first + j, ratios[j], made[j]));
    }
    frame.formula = mathml(rows.table());
    return frame;
}

TraceFrame resultFrame(const Cut& cutting) {
    TraceFrame frame = tell(result, cutting.values());
    const std::vector<Vec3> polygon =
        drawn(cutting.refined(), !cutting.curve.weights().empty());
    addPolygon(frame, polygon, cutting.curve.closed());
    for (std::size_t i = cutting.first; i < cutting.end; ++i) {
        frame.marked.push_back(i % polygon.size());
    }
    return frame;
}

}  // namespace

Result<Trace> traceBoehm(const BsplineCurve& curve, double knot) {
    if (const auto inserted = insertKnot(curve, knot, 1); !inserted) {
        return refuse(inserted.error().code, "knot", inserted.error().message);
    }
    const Cut cutting(curve, knot);
    TraceWriter writer("boehm");
    writer.add(beginFrame(cutting));
    writer.add(cutFrame(cutting));
    writer.add(resultFrame(cutting));
    return std::move(writer).finish("curve.points");
}

}  // namespace knotwork::scene
