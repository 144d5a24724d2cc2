#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"
#include "scene/parameter_fields.hpp"

namespace knotwork::scene {

Result<Curve> buildParametric(Json& spec) {
    const auto parameters = namedValues(*member(spec, "parameters"));
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
                            .parameters = namedValues(*member(spec, "parameters")),
                            .domain = {over[0].get<double>(), over[1].get<double>()},
                            .closed = member(spec, "closed")->get<bool>()};
    if (member(spec, "z") != nullptr) parts.z = stringOr(spec, "z", "");
    auto curve = FormulaCurve::make(parts);
    if (!curve) return curve.error();
    return Curve(std::move(*curve));
}

}  // namespace knotwork::scene
