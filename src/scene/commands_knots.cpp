// Commands on knots.
#include "scene/command_parts.hpp"
#include "scene/adaptation.hpp"
#include "scene/blending_specs.hpp"
#include "scene/edits.hpp"
#include "scene/fields.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_edits.hpp"
#include "scene/object_builders.hpp"
#include "scene/surface_knot_edits.hpp"
#include "scene/validation.hpp"

#include <cmath>
#include <optional>

namespace knotwork::scene {

namespace {

/// `along: 'u' | 'v'`, which knots of surfaces need and no others have.
Result<std::optional<std::size_t>> directionIn(const Json& arguments, const Body& body) {
    const Json* along = member(arguments, "along");
    const bool surface =
        body.as<BsplineSurface>() != nullptr || body.as<BlendingSurface>() != nullptr;
    if (!surface && along == nullptr) return std::optional<std::size_t>();
    if (!surface) {
        return refuse(Code::notSupported, "insertKnot.along",
                      "Only knots of surfaces have a direction.");
    }
    if (along != nullptr && *along == "u") return std::optional<std::size_t>(0);
    if (along != nullptr && *along == "v") return std::optional<std::size_t>(1);
    return refuse(along != nullptr && along->is_string() ? Code::unknownName : Code::wrongType,
                  "insertKnot.along", "Knots of a surface are put in along \"u\" or along \"v\".");
}

Result<Done> checkArguments(const Json& arguments) {
    for (const auto& item : arguments.items()) {
        if (item.key() == "object" || item.key() == "at" || item.key() == "along") continue;
        return refuse(Code::unknownField, "insertKnot." + item.key(),
                      "A knot is put in by { object, at }, and { along } of a surface.");
    }
    return Done{};
}

}  // namespace

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
    for (const Field& own : objectFields()) {
        const Json* value = member(object.spec, own.name);
        if (value != nullptr) (*spec)[std::string(own.name)] = *value;
    }
    return withObject(state, i, keepParameters(object.spec, std::move(*spec)));
}

Result<Executed> executeInsertKnot(const State& state, const Json& arguments) {
    if (!arguments.is_object()) {
        return refuse(Code::wrongType, "insertKnot",
                      "Expected { object, at }, got " + describeValue(arguments) + ".");
    }
    if (const auto known = checkArguments(arguments); !known) return known.error();
    const auto i = objectNamed(state, arguments, "insertKnot");
    if (!i) return i.error();
    const Json* at = member(arguments, "at");
    if (at == nullptr || !at->is_number()) {
        return refuse(Code::wrongType, "insertKnot.at", "Give the parameter of the new knot.");
    }
    if (!std::isfinite(at->get<double>())) {
        return refuse(Code::notFinite, "insertKnot.at", "The knot must be a finite number.");
    }
    const Object& object = *state.objects[*i];
    const auto along = directionIn(arguments, object.body);
    if (!along) return along.error();
    if (!*along && object.body.curve() == nullptr) {
        return refuse(Code::notSupported, "insertKnot.object",
                      "\"" + object.id + "\" has no knots.");
    }
    auto spec = *along ? withKnotAlong(object.spec, **along, at->get<double>())
                       : withKnot(object.spec, at->get<double>());
    if (!spec) {
        const bool unsuited = spec.error().code == Code::notSupported;
        return refuse(spec.error().code, unsuited ? "insertKnot.object" : "insertKnot.at",
                      spec.error().message);
    }
    auto next = withObject(state, *i, *spec);
    if (!next) return next.error();
    std::string path = indexed("objects", *i) + ".knots";
    if (*along) path = indexed(path, **along);
    return Executed{std::move(*next), {"insertKnot", std::move(path)}};
}

}  // namespace knotwork::scene
