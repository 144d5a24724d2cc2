// Curves of one piece: Bézier curves, lines and arcs.
#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"

namespace knotwork::scene {

namespace {

Interval domainOf(const Json& spec) {
    const Json& domain = *member(spec, "domain");
    return {domain[0].get<double>(), domain[1].get<double>()};
}

Json listOf(const Interval& domain) { return Json::array({domain.start, domain.end}); }

Vec3 pointAt(const Json& spec, std::string_view key) { return vec3Of(*member(spec, key)); }

template <class T>
Result<Curve> curveOf(Result<T> made) {
    if (!made) return made.error();
    return Curve(std::move(*made));
}

}  // namespace

Result<Curve> buildBezier(Json& spec) {
    std::vector<Vec3> points;
    for (const Json& point : *member(spec, "points")) points.push_back(vec3Of(point));
    const Json* weights = member(spec, "weights");
    return curveOf(BezierCurve::make(
        std::move(points), weights != nullptr ? numbersOf(*weights) : std::vector<double>{},
        domainOf(spec)));
}

Result<Curve> buildLine(Json& spec) {
    return curveOf(LineCurve::make(pointAt(spec, "from"), pointAt(spec, "to"), domainOf(spec)));
}

Result<Curve> buildArc(Json& spec) {
    return curveOf(ArcCurve::make(numberOr(spec, "at", 0), pointAt(spec, "point"),
                                  pointAt(spec, "first"), pointAt(spec, "second"), domainOf(spec)));
}

Json specOf(const BezierCurve& curve) {
    Json points = Json::array();
    for (const Vec3& point : curve.points()) points.push_back(pointJson(point, curve.dimension()));
    Json spec{{"type", "bezier-curve"}, {"points", std::move(points)}};
    if (!curve.weights().empty()) spec["weights"] = listOf(curve.weights());
    spec["domain"] = listOf(curve.domain());
    return spec;
}

Json specOf(const LineCurve& curve) {
    return {{"type", "line-curve"},
            {"from", pointJson(curve.from(), curve.dimension())},
            {"to", pointJson(curve.to(), curve.dimension())},
            {"domain", listOf(curve.domain())}};
}

Json specOf(const ArcCurve& curve) {
    return {{"type", "arc-curve"},
            {"at", curve.at()},
            {"point", pointJson(curve.point(), curve.dimension())},
            {"first", pointJson(curve.first(), curve.dimension())},
            {"second", pointJson(curve.second(), curve.dimension())},
            {"domain", listOf(curve.domain())}};
}

}  // namespace knotwork::scene
