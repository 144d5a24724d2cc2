// Commands on knots.
#include "scene/command_parts.hpp"
#include "scene/blending_specs.hpp"
#include "scene/edits.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_edits.hpp"
#include "scene/object_builders.hpp"
#include "scene/validation.hpp"

#include <cmath>

namespace knotwork::scene {

Result<State> withLocalsKept(const State& state, const Path& path, const Json& command) {
    const std::size_t i = path[1].index;
    const Object& object = *state.objects[i];
    const auto moved = moveKnotIn(object.spec, std::span<const PathStep>(path).subspan(2), command);
    if (!moved) return moved.error().under(indexed("objects", i));
    // Whatever is wrong with the knots is said as it is of any others.
    if (const auto checked = readObjectSpec(moved->part); !checked) {
        return checked.error().under(indexed("objects", i));
    }
    auto spec = withKnots(object.spec, *object.body.as<BlendingCurve>(),
                          numbersOf(*member(moved->part, "knots")), false);
    if (!spec) return spec.error().under(indexed("objects", i));
    return withObject(state, i, dressed(std::move(*spec), object));
}

Result<Executed> executeInsertKnot(const State& state, const Json& arguments) {
    if (!arguments.is_object()) {
        return refuse(Code::wrongType, "insertKnot",
                      "Expected { object, at }, got " + describeValue(arguments) + ".");
    }
    const auto i = objectNamed(state, arguments, "insertKnot");
    if (!i) return i.error();
    const Json* at = member(arguments, "at");
    if (at == nullptr || !at->is_number()) {
        return refuse(Code::wrongType, "insertKnot.at", "Give the parameter of the new knot.");
    }
    if (!std::isfinite(at->get<double>())) {
        return refuse(Code::notFinite, "insertKnot.at", "The knot must be a finite number.");
    }
    auto spec = withKnot(state.objects[*i]->spec, at->get<double>());
    if (!spec) {
        const bool unsuited = spec.error().code == Code::notSupported;
        return refuse(spec.error().code, unsuited ? "insertKnot.object" : "insertKnot.at",
                      spec.error().message);
    }
    auto next = withObject(state, *i, *spec);
    if (!next) return next.error();
    return Executed{std::move(*next), {"insertKnot", indexed("objects", *i) + ".knots"}};
}

}  // namespace knotwork::scene
