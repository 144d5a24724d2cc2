// De Boor's algorithm (C. de Boor, On calculating with B-splines, 1972): d levels of mixing two
// neighbours, in the ratio in which t divides the knots around them.
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_spline.hpp"

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "de-boor.begin", "The span of {t}",
    "The parameter {t} lies between the knots {from} and {to}; because the "
    "degree is {degree}, only {active} of the {count} control points act there, number {first} to "
    "number {last}."};
constexpr Sentence level{
    "de-boor.level", "Level {level} of {degree}",
    "Level {level} of {degree} mixes each two neighbours, the second by the part of its knots that "
    "{t} has passed, {ratios}, and leaves {left} points, {points}."};
constexpr Sentence weightedLevel{
    "de-boor.weighted-level", "Level {level} of {degree}",
    "Level {level} of {degree} mixes each two neighbours together with their weights, the "
    "second by the part of its knots that {t} has passed, {ratios}; divided by their weights, "
    "the {left} points that are left stand at {points}."};
constexpr Sentence result{
    "de-boor.result", "Level {level} of {degree}: the point",
    "The last mix, with {ratios} of the second point, gives the point of the curve at {t}, "
    "{points}."};
constexpr Sentence weightedResult{
    "de-boor.weighted-result", "Level {level} of {degree}: the point",
    "The last mix, with {ratios} of the second point, has the weight {weight}, and divided by it "
    "gives the point of the curve at {t}, {points}."};

/// The ratios of a level, w_{d+1-r,i}.
std::vector<double> ratiosOf(const SplineSpan& span, std::size_t r) {
    std::vector<double> ratios;
    for (std::size_t j = r; j <= span.degree; ++j) {
        ratios.push_back(span.weight(span.degree + 1 - r, span.index + j - span.degree));
    }
    return ratios;
}

/// A weighted point with all its numbers, another as it is.
std::string notedPoint(const SplineSpan& span, const Homogeneous& point) {
    const int dimension = span.curve->dimension();
    if (!span.curve->rational()) return noted(Vec3(point), dimension, span.places);
    std::string text = noted(Vec3(point), dimension, span.places);
    text.back() = ',';
    return text + noted(point.w) + ')';
}

std::string mixRow(const SplineSpan& span, std::size_t r, std::size_t j, double w,
                   std::span<const Homogeneous> before, const Homogeneous& made) {
    const std::size_t i = span.index + j - span.degree;
    const std::size_t k = span.degree + 1 - r;
    return levelTerm("c", span.pointOf(i), r) + "&=&(1-w)" +
           levelTerm("c", span.pointOf(i - 1), r - 1) + "+w" +
           levelTerm("c", span.pointOf(i), r - 1) + "=" + noted(1 - w) +
           notedPoint(span, before[j - r]) + "+" + noted(w) + notedPoint(span, before[j - r + 1]) +
           "=" + notedPoint(span, made) + "&w=" + ratioSymbols(k, i) + "=" +
           ratioNumbers(span.knots, k, i, span.t, span.parameters) + "=" + noted(w);
}

std::string levelFormula(const SplineSpan& span, std::size_t r, std::span<const double> ratios,
                         std::span<const Homogeneous> before,
                         std::span<const Homogeneous> made) {
    NotedRows rows;
    for (std::size_t j = r; j <= span.degree; ++j) {
        rows.add(mixRow(span, r, j, ratios[j - r], before, made[j - r]));
    }
    if (r == span.degree && span.curve->rational()) {
        rows.add("c(t)&=&" + fraction("1", noted(made[0].w)) +
                 noted(Vec3(made[0]), span.curve->dimension(), span.places) + "=" +
                 noted(drawn(made[0], true), span.curve->dimension(), span.places) + '&');
    }
    return mathml(rows.table());
}

std::string spanFormula(const SplineSpan& span) {
    const auto knot = [&](std::size_t i) { return noted(span.knots[i], span.parameters); };
    return mathml(knot(span.index) + "=" + indexedTerm("t", span.index) + "\\le t=" +
                  noted(span.t, span.parameters) + "\\le " + indexedTerm("t", span.index + 1) +
                  "=" + knot(span.index + 1));
}

TraceFrame levelFrame(const SplineSpan& span, std::size_t r,
                      std::span<const std::vector<Homogeneous>> levels) {
    const bool weighted = span.curve->rational();
    const std::vector<Vec3> points = drawn(levels[r], weighted);
    const std::vector<double> ratios = ratiosOf(span, r);
    SentenceValues values = span.values();
    values.insert(values.end(),
                  {{"level", readable(r)}, {"left", readable(points.size())},
                   {"ratios", spoken(ratios)},
                   {"points", spoken(points, span.curve->dimension(), span.places)}});
    if (weighted) values.emplace_back("weight", readable(levels[r][0].w));
    const Sentence& sentence = r == span.degree ? (weighted ? weightedResult : result)
                                                : (weighted ? weightedLevel : level);
    TraceFrame frame = tell(sentence, std::move(values));
    for (std::size_t before = 0; before < r; ++before) {
        addPolygon(frame, drawn(levels[before], weighted));
    }
    addMarked(frame, points);
    frame.formula = levelFormula(span, r, ratios, levels[r - 1], levels[r]);
    frame.weights = ratios;
    return frame;
}

}  // namespace

Result<Trace> traceDeBoor(const BsplineCurve& curve, double t) {
    const SplineSpan span(curve, t);
    const auto levels = span.levels();
    TraceWriter writer("de-boor");
    TraceFrame first = tell(begin, span.values());
    drawPolygon(first, span);
    first.formula = spanFormula(span);
    writer.add(std::move(first));
    for (std::size_t r = 1; r <= span.degree; ++r) writer.add(levelFrame(span, r, levels));
    return std::move(writer).finish("curve.points");
}

}  // namespace knotwork::scene
