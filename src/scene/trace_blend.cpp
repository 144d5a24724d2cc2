// A blending curve at a parameter: C(t) = (1 - B(w)) c_i(t) + B(w) c_{i+1}(t), w = (t - t_i) / h.
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_parts.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "blend.begin", "The span of {t}",
    "The parameter {t} lies between the knots {from} and {to}; there local curve {first} is "
    "blended into local curve {second}."};
constexpr Sentence ratio{
    "blend.ratio", "The value of the B-function",
    "The part of the span that {t} has passed is w = {w}, and the {family} B-function takes it to "
    "{b}."};
constexpr Sentence locals{
    "blend.locals", "The two local curves",
    "At {t} local curve {first} is at {firstPoint} and counts {a}, and local curve {second} is at "
    "{secondPoint} and counts {b}."};
constexpr Sentence result{
    "blend.result", "The point",
    "Blended with these weights, {a} and {b}, they give the point of the curve at {t}, {point}."};

/// Points that show a local curve over the span.
constexpr std::size_t curvePoints = 17;

/// The span in which curve.point() evaluates t, and what it blends there.
struct Blend {
    Blend(const BlendingCurve& of, double parameter);

    Vec3 at(std::size_t local, double parameter, double later) const;
    std::vector<Vec3> shown(std::size_t local, double later) const;
    SentenceValues values() const;
    std::string text(const Vec3& point) const { return readable(point, curve.dimension(), places); }
    std::string note(const Vec3& point) const { return noted(point, curve.dimension(), places); }

    const BlendingCurve& curve;
    double t;
    Side side;
    std::size_t first;
    std::size_t second;
    double from;
    double to;
    double shift;  ///< the period, where the second local is that of the next turn
    double w;
    double b;
    Vec3 firstPoint;
    Vec3 secondPoint;
    Reading parameters;
    Reading places;
};

Blend::Blend(const BlendingCurve& of, double parameter)
    : curve(of),
      t(parameter),
      side(parameter == of.domain().end ? Side::left : Side::right) {
    const std::vector<double>& knots = of.knots();
    const BlendForm form = of.closed() ? BlendForm::closed : BlendForm::open;
    const BlendingSpan span = blendingSpan(knots, form, t, side);
    first = span.first;
    second = span.second;
    shift = span.shift;
    from = span.start;
    to = span.start + span.length;
    w = span.ratio();
    b = of.blend().value(w);
    firstPoint = at(first, t, 0);
    secondPoint = at(second, t, shift);
    parameters = {.size = std::max(std::abs(knots.front()), std::abs(knots.back())),
                  .gap = to - from};
    places = readingOf(std::array{firstPoint, secondPoint});
}

Vec3 Blend::at(std::size_t local, double parameter, double later) const {
    Vec3 point;
    curve.locals()[local].evaluate(parameter - later, side, {&point, 1});
    return point;
}

std::vector<Vec3> Blend::shown(std::size_t local, double later) const {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < curvePoints; ++i) {
        points.push_back(at(local, uniformParameter({from, to}, i, curvePoints), later));
    }
    return points;
}

SentenceValues Blend::values() const {
    return {{"t", readable(t, parameters)},
            {"from", readable(from, parameters)},
            {"to", readable(to, parameters)},
            {"first", readable(first)},
            {"second", readable(second)},
            {"family", std::string(curve.blend().description().name)},
            {"w", readable(w)},
            {"a", readable(1 - b)},
            {"b", readable(b)},
            {"firstPoint", text(firstPoint)},
            {"secondPoint", text(secondPoint)}};
}

/// A frame with both local curves in the picture.
TraceFrame withLocals(const Sentence& sentence, const Blend& blend, SentenceValues values) {
    TraceFrame frame = tell(sentence, std::move(values));
    addPolygon(frame, blend.shown(blend.first, 0));
    addPolygon(frame, blend.shown(blend.second, blend.shift));
    return frame;
}

TraceFrame beginFrame(const Blend& blend) {
    TraceFrame frame = withLocals(begin, blend, blend.values());
    frame.formula = mathml(
        "c(t)=(1-B(w))" + indexedTerm("c", blend.first) + "(t)+B(w)" +
        indexedTerm("c", blend.second) +
        (blend.shift == 0 ? "(t)" : "(t-" + noted(blend.shift, blend.parameters) + ")"));
    return frame;
}

TraceFrame ratioFrame(const Blend& blend) {
    TraceFrame frame = withLocals(ratio, blend, blend.values());
    frame.weights = {1 - blend.b, blend.b};
    const std::string left = indexedTerm("t", blend.first);
    frame.formula = mathml(
        "\\table{w&=&" + fraction("t-" + left, indexedTerm("t", blend.first + 1) + '-' + left) +
        "&=&" +
        fraction(notedDifference(blend.t, blend.from, blend.parameters),
                 notedDifference(blend.to, blend.from, blend.parameters)) +
        "&=&" + noted(blend.w) + "\\\\B(w)&=&" + noted(blend.b) + '}');
    return frame;
}

TraceFrame localsFrame(const Blend& blend) {
    TraceFrame frame = withLocals(locals, blend, blend.values());
    addMarked(frame, std::array{blend.firstPoint, blend.secondPoint});
    frame.weights = {1 - blend.b, blend.b};
    frame.formula =
        mathml("\\table{" + indexedTerm("c", blend.first) + "&=&" + blend.note(blend.firstPoint) +
               "\\\\" + indexedTerm("c", blend.second) + "&=&" + blend.note(blend.secondPoint) +
               '}');
    return frame;
}

TraceFrame resultFrame(const Blend& blend) {
    const Vec3 point = (1 - blend.b) * blend.firstPoint + blend.b * blend.secondPoint;
    SentenceValues values = blend.values();
    values.emplace_back("point", blend.text(point));
    TraceFrame frame = withLocals(result, blend, std::move(values));
    const std::size_t ends = frame.points.size();
    frame.points.insert(frame.points.end(), {blend.firstPoint, blend.secondPoint, point});
    frame.edges.push_back({ends, ends + 2});
    frame.edges.push_back({ends + 2, ends + 1});
    frame.marked.push_back(ends + 2);
    frame.weights = {1 - blend.b, blend.b};
    frame.formula =
        mathml("c(t)=" + noted(1 - blend.b) + blend.note(blend.firstPoint) + "+" + noted(blend.b) +
               blend.note(blend.secondPoint) + "=" + blend.note(point));
    return frame;
}

}  // namespace

Result<Trace> traceBlend(const BlendingCurve& curve, double t) {
    const Blend blend(curve, t);
    TraceWriter writer("blend");
    writer.add(beginFrame(blend));
    writer.add(ratioFrame(blend));
    writer.add(localsFrame(blend));
    writer.add(resultFrame(blend));
    return std::move(writer).finish("curve");
}

}  // namespace knotwork::scene
