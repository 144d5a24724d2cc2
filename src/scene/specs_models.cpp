#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"

namespace knotwork::scene {

namespace {

std::vector<NamedValue> parametersOf(const Json& spec) {
    std::vector<NamedValue> parameters;
    for (const auto& item : member(spec, "parameters")->items()) {
        parameters.emplace_back(item.key(), item.value().get<double>());
    }
    return parameters;
}

}  // namespace

Result<Curve> buildParametric(Json& spec) {
    const auto parameters = parametersOf(spec);
    std::optional<Interval> over;
    if (const Json* given = member(spec, "domain")) {
        over = Interval{(*given)[0].get<double>(), (*given)[1].get<double>()};
    }
    auto curve = ParametricCurve::make(stringOr(spec, "name", ""), parameters, over);
    if (!curve) return curve.error();
    spec["domain"] = Json::array({curve->domain().start, curve->domain().end});
    return Curve(std::move(*curve));
}

Result<Curve> buildFormula(Json& spec) {
    const Json& over = *member(spec, "domain");
    FormulaCurveParts parts{.x = stringOr(spec, "x", ""),
                            .y = stringOr(spec, "y", ""),
                            .parameters = parametersOf(spec),
                            .domain = {over[0].get<double>(), over[1].get<double>()},
                            .closed = member(spec, "closed")->get<bool>()};
    if (member(spec, "z") != nullptr) parts.z = stringOr(spec, "z", "");
    auto curve = FormulaCurve::make(parts);
    if (!curve) return curve.error();
    return Curve(std::move(*curve));
}

}  // namespace knotwork::scene
