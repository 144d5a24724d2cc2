// Many knots at once (E. Cohen, T. Lyche, R. Riesenfeld, Discrete B-splines and subdivision
// techniques, 1980: the Oslo algorithm). With old knots t and new knots u, point j of the refined
// polygon is b_j = sum_i alpha_{i,d}(j) c_i, where alpha_{i,0}(j) = [t_i ≤ u_j < t_{i+1}] and
//     alpha_{i,k}(j) = (u_{j+k} - t_i) / (t_{i+k} - t_i) alpha_{i,k-1}(j)
//                      + (t_{i+k+1} - u_{j+k}) / (t_{i+k+1} - t_{i+1}) alpha_{i+1,k-1}(j).
#include "geometry/bspline_indexing.hpp"
#include "geometry/bspline_kernels.hpp"
#include "geometry/refinement.hpp"
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_spline.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "oslo.begin", "{more} points from {count}",
    "Of {count} control points become {more}, because the number of new knots is {added}; each new "
    "point is a mix of at most {order} neighbours with weights that sum to 1."};
constexpr Sentence mixedPoint{
    "oslo.point", "Point {j}",
    "New point {j} belongs to the new knots {knots}; with the weights {weights} of the old points "
    "{numbers} it lies at {point}."};
constexpr Sentence samePoint{
    "oslo.same", "Point {j}",
    "New point {j} belongs to the new knots {knots}, between which no knot is missing in the old "
    "ones, so that it is old point {numbers}, at {point}."};
constexpr Sentence result{
    "oslo.result", "The matrix of discrete B-splines",
    "All weights together are a matrix of {more} rows and {count} columns, each row with the "
    "sum 1, which takes the old control points to the {more} new ones; the curve is the same."};

using Row = std::vector<double>;

/// The refined vector and the rows of the matrix.
struct Refinement {
    Refinement(const BsplineCurve& of, KnotVector to);

    /// Levels k = 0 … d of the recurrence for new point j, the values for i = mu-k … mu.
    struct Triangle {
        std::size_t mu = 0;
        std::size_t place = 0;  ///< of the new point among the extended new knots
        std::vector<Row> levels;
    };
    Triangle triangle(std::size_t j) const;
    Row row(const Triangle& triangle) const;
    Vec3 point(const Row& row) const;
    SentenceValues values() const;

    const BsplineCurve& curve;
    KnotVector fresh;
    std::span<const double> old;
    std::size_t degree;
    std::size_t count;
    std::size_t more;
    std::vector<Homogeneous> points;
    Reading parameters;
    Reading places;
};

Refinement::Refinement(const BsplineCurve& of, KnotVector to)
    : curve(of),
      fresh(std::move(to)),
      old(of.knotVector().extended()),
      degree(static_cast<std::size_t>(of.degree())),
      count(of.points().size()),
      more(static_cast<std::size_t>(fresh.pointCount())),
      points(homogeneousPoints(of)),
      places(readingOf(of.points())) {
    const auto all = fresh.extended();
    parameters = {.size = std::max(std::abs(all.front()), std::abs(all.back()))};
    for (std::size_t i = 1; i < all.size(); ++i) {
        const double gap = all[i] - all[i - 1];
        if (gap > 0) parameters.gap = std::min(parameters.gap, gap);
    }
}

/// The recurrence from old span mu, t_mu ≤ u_j < t_{mu+1}. Outside the domain of an open curve it
/// would use functions beyond the first and the last, but these have the weight 0.
Refinement::Triangle Refinement::triangle(std::size_t j) const {
    const auto all = fresh.extended();
    const std::size_t place = fresh.closed() && j < seamIndex(fresh) ? j + more : j;
    const auto after = std::upper_bound(old.begin(), old.end(), all[place]);
    const std::size_t mu = static_cast<std::size_t>(after - old.begin()) - 1;
    Triangle made{mu, place, {{1}}};
    for (std::size_t k = 1; k <= degree; ++k) {
        const Row& lower = made.levels.back();
        Row values(k + 1, 0.0);
        for (std::size_t s = 0; s < k; ++s) {
            if (mu + 1 + s < k || mu + 1 + s >= old.size()) continue;
            const double w = kernels::weight(old, k, mu + 1 + s - k, all[place + k]);
            if (mu + s >= k) values[s] += (1 - w) * lower[s];
            values[s + 1] += w * lower[s];
        }
        made.levels.push_back(std::move(values));
    }
    return made;
}

Row Refinement::row(const Triangle& triangle) const {
    Row all(count, 0.0);
    for (std::size_t s = 0; s <= degree; ++s) {
        const bool exists = triangle.mu + s >= degree &&
                            (curve.closed() || triangle.mu + s - degree < count);
        if (exists) all[(triangle.mu + s - degree) % count] += triangle.levels[degree][s];
    }
    return all;
}

Vec3 Refinement::point(const Row& weights) const {
    Homogeneous sum(0);
    for (std::size_t i = 0; i < count; ++i) sum += weights[i] * points[i];
    return drawn(sum, !curve.weights().empty());
}

SentenceValues Refinement::values() const {
    return {{"count", readable(count)},
            {"more", readable(more)},
            {"added", readable(more - count)},
            {"order", readable(degree + 1)}};
}

TraceFrame beginFrame(const Refinement& refinement) {
    TraceFrame frame = tell(begin, refinement.values());
    addMarked(frame, refinement.curve.points(), refinement.curve.closed());
    frame.formula = mathml(
        "\\table{\\alpha_{i,k}(j)&=&\\frac{u_{j+k}-t_{i}}{t_{i+k}-t_{i}}\\alpha_{i,k-1}(j)+"
        "\\frac{t_{i+k+1}-u_{j+k}}{t_{i+k+1}-t_{i+1}}\\alpha_{i+1,k-1}(j)\\\\"
        "b_{j}&=&\\sum_{i}\\alpha_{i," + readable(refinement.degree) + "}(j)c_{i}}");
    return frame;
}

/// The numbers of the old points that take part.
std::vector<std::size_t> usedColumns(const Row& row) {
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != 0) columns.push_back(i);
    }
    return columns;
}

std::string rowFormula(const Refinement& refinement, std::size_t j,
                       const Refinement::Triangle& triangle, const Row& row, const Vec3& point) {
    const auto knots = refinement.fresh.extended();
    std::string text = "\\table{";
    for (std::size_t k = 0; k <= refinement.degree; ++k) {
        const std::string number = std::to_string(k);
        text += "\\alpha_{i," + number + "}(" + std::to_string(j) + ")&";
        if (k > 0) {
            text += indexedTerm("u", triangle.place + k) + "=" +
                    noted(knots[triangle.place + k], refinement.parameters);
        }
        for (const double value : triangle.levels[k]) text += '&' + noted(value);
        text += "\\\\";
    }
    text += indexedTerm("b", j) + "&=&";
    bool first = true;
    for (const std::size_t i : usedColumns(row)) {
        text += (first ? "" : "+") + noted(row[i]) + indexedTerm("c", i);
        first = false;
    }
    return mathml(text + "=" + noted(point, refinement.curve.dimension(), refinement.places) + '}');
}

TraceFrame rowFrame(const Refinement& refinement, std::size_t j,
                    const Refinement::Triangle& triangle, const Row& row,
                    std::span<const Vec3> soFar) {
    std::vector<std::string> knots;
    for (std::size_t k = 1; k <= refinement.degree; ++k) {
        knots.push_back(readable(refinement.fresh.extended()[triangle.place + k],
                                 refinement.parameters));
    }
    std::vector<std::string> numbers;
    Row used;
    for (const std::size_t i : usedColumns(row)) {
        numbers.push_back(readable(i));
        used.push_back(row[i]);
    }
    const Vec3& made = soFar.back();
    TraceFrame frame =
        tell(used.size() == 1 ? samePoint : mixedPoint,
             {{"j", readable(j)}, {"knots", spoken(knots)}, {"weights", spoken(used)},
              {"numbers", spoken(numbers)},
              {"point", readable(made, refinement.curve.dimension(), refinement.places)}});
    addPolygon(frame, refinement.curve.points(), refinement.curve.closed());
    frame.marked.push_back(addPolygon(frame, soFar) + j);
    frame.weights = row;
    frame.formula = rowFormula(refinement, j, triangle, row, made);
    return frame;
}

TraceFrame resultFrame(const Refinement& refinement, std::vector<Row> matrix,
                       std::span<const Vec3> points) {
    TraceFrame frame = tell(result, refinement.values());
    addMarked(frame, points, refinement.curve.closed());
    frame.formula = mathml("\\alpha=" + notedMatrix(matrix));
    frame.matrix = std::move(matrix);
    return frame;
}

}  // namespace

Result<Trace> traceOslo(const BsplineCurve& curve, std::vector<double> knots) {
    auto fresh = refinedKnots(curve.knotVector(), std::move(knots));
    if (!fresh) return fresh.error();
    const Refinement refinement(curve, std::move(*fresh));
    TraceWriter writer("oslo");
    writer.add(beginFrame(refinement));
    std::vector<Row> matrix;
    std::vector<Vec3> points;
    for (std::size_t j = 0; j < refinement.more && !writer.full(); ++j) {
        const Refinement::Triangle triangle = refinement.triangle(j);
        matrix.push_back(refinement.row(triangle));
        points.push_back(refinement.point(matrix.back()));
        TraceFrame frame = rowFrame(refinement, j, triangle, matrix.back(), points);
        frame.matrix = matrix;
        writer.add(std::move(frame));
    }
    writer.add(resultFrame(refinement, std::move(matrix), points));
    return std::move(writer).finish("knots");
}

}  // namespace knotwork::scene
