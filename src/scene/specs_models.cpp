#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"

namespace knotwork::scene {

Result<Curve> buildParametric(Json& spec) {
    std::vector<NamedValue> parameters;
    for (const auto& item : member(spec, "parameters")->items()) {
        parameters.emplace_back(item.key(), item.value().get<double>());
    }
    std::optional<Interval> over;
    if (const Json* given = member(spec, "domain")) {
        over = Interval{(*given)[0].get<double>(), (*given)[1].get<double>()};
    }
    auto curve = ParametricCurve::make(stringOr(spec, "name", ""), parameters, over);
    if (!curve) return curve.error();
    spec["domain"] = Json::array({curve->domain().start, curve->domain().end});
    return Curve(std::move(*curve));
}

}  // namespace knotwork::scene
