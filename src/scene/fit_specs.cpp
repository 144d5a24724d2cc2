#include "scene/fit_specs.hpp"

#include "scene/form_names.hpp"
#include "scene/json_values.hpp"

namespace knotwork::scene {

std::optional<Parametrisation> parametrisationNamed(std::string_view name) noexcept {
    if (name == "chord") return Parametrisation::chord;
    if (name == "centripetal") return Parametrisation::centripetal;
    if (name == "uniform") return Parametrisation::uniform;
    return std::nullopt;
}

FitRequest fitRequestOf(const Json& fields) {
    FitRequest request;
    request.degree = static_cast<int>(numberOr(fields, "degree", request.degree));
    request.count = static_cast<int>(numberOr(fields, "count", request.count));
    request.form = formNamed(stringOr(fields, "form", "")).value_or(request.form);
    const auto named = parametrisationNamed(stringOr(fields, "parameters", ""));
    if (named) request.parameters = *named;
    if (const Json* knots = member(fields, "knots")) request.knots = numbersOf(*knots);
    request.options.smoothing = numberOr(fields, "smoothing", request.options.smoothing);
    request.options.interpolateEnds =
        flagOr(fields, "interpolateEnds", request.options.interpolateEnds);
    return request;
}

}  // namespace knotwork::scene
