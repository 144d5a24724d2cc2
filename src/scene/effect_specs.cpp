// Effects read from their specifications.
#include "scene/document.hpp"
#include "scene/json_values.hpp"
#include "scene/specs.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace knotwork::scene {

namespace {

constexpr std::array<std::pair<std::string_view, EffectKind>, 6> kinds{{
    {"translate", EffectKind::translate},
    {"rotate", EffectKind::rotate},
    {"scale", EffectKind::scale},
    {"simulate", EffectKind::simulate},
    {"morph", EffectKind::morph},
    {"colour", EffectKind::colour},
}};

EffectKind kindNamed(std::string_view name) noexcept {
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const auto& kind) { return kind.first == name; });
    return found->second;
}

Result<Json> canonicalEffect(const Json& given) {
    if (!given.is_object()) {
        return refuse(Code::wrongType, "", "Expected an effect, got " + describeValue(given) + ".");
    }
    std::string names;
    for (const EffectType& type : effectTypes()) {
        names += (names.empty() ? "" : ", ") + std::string(type.kind);
    }
    const Json* kind = member(given, "kind");
    if (kind == nullptr || !kind->is_string()) {
        return refuse(Code::wrongType, "kind", "An effect needs its kind, one of " + names + ".");
    }
    const EffectType* type = findEffectType(kind->get_ref<const std::string&>());
    if (type == nullptr) {
        return refuse(Code::unknownName, "kind",
                      describeValue(*kind) + " is no effect; choose one of " + names + ".");
    }
    Json fields = given;
    fields.erase("kind");
    auto read = readGroup(fields, type->fields);
    if (!read) return read.error();
    Json canonical{{"target", *member(*read, "target")}, {"kind", *kind}};
    for (const auto& item : read->items()) canonical[item.key()] = item.value();
    return canonical;
}

/// [f, f, f] of one factor; a plane one leaves z alone.
Result<Vec3> factorsOf(const Json& factor) {
    Vec3 factors(1.0);
    for (int k = 0; k < 3; ++k) {
        const auto place = static_cast<std::size_t>(k);
        if (factor.is_number()) factors[k] = factor.get<double>();
        if (factor.is_array() && place < factor.size()) factors[k] = factor[place].get<double>();
        if (factors[k] > 0 && factors[k] <= 1000) continue;
        return refuse(Code::outOfRange, factor.is_array() ? indexed("factor", place) : "factor",
                      formatNumber(factors[k]) +
                          " is out of range; a factor must be in (0, 1000].");
    }
    return factors;
}

Result<Done> readTurn(Effect& effect, const Json& turn, std::string_view path) {
    if (const Json* axis = member(turn, "axis")) effect.axis = vec3Of(*axis);
    effect.angle = numberOr(turn, "angle", 0);
    if (effect.angle == 0 || glm::length(effect.axis) > 0) return Done{};
    return refuse(Code::outOfRange, std::string(path),
                  "The axis has length zero and names no direction; give for example [0, 0, 1].");
}

/// Fills in what the canonical specification says for the effect's own kind.
Result<Done> fillEffect(Effect& effect) {
    const Json& spec = effect.spec;
    if (const Json* center = member(spec, "center")) effect.center = vec3Of(*center);
    switch (effect.kind) {
        case EffectKind::translate:
            effect.translate = vec3Of(*member(spec, "by"));
            return Done{};
        case EffectKind::rotate: return readTurn(effect, spec, "axis");
        case EffectKind::scale: {
            const auto factors = factorsOf(*member(spec, "factor"));
            if (!factors) return factors.error();
            effect.factor = *factors;
            return Done{};
        }
        case EffectKind::simulate:
            effect.translate = vec3Of(*member(spec, "translate"));
            effect.seed = numberOr(spec, "seed", 1);
            return readTurn(effect, *member(spec, "rotate"), "rotate.axis");
        case EffectKind::morph: {
            auto to = makeCurve(*member(spec, "to"));
            if (!to) return to.error().under("to");
            effect.spec["to"] = std::move(to->spec);
            effect.curve = std::move(to->value);
            return Done{};
        }
        case EffectKind::colour:
            effect.to = *parseColour(member(spec, "to")->get_ref<const std::string&>());
            return Done{};
    }
    return Done{};
}

// --- what it is for ---------------------------------------------------------------------------

Error noSuchLocal(std::string path, double index, std::size_t count) {
    return refuse(Code::outOfRange, std::move(path),
                  "There is no local " + formatNumber(index) + "; they are 0 to " +
                      std::to_string(count - 1) + ".");
}

/// The place of the one local that moves among those of the object.
Result<std::size_t> localOf(const Json& local, const Object& target) {
    if (const auto* blend = target.body.as<BlendingCurve>(); blend && local.is_number()) {
        const double j = local.get<double>();
        if (j < static_cast<double>(blend->locals().size())) return static_cast<std::size_t>(j);
        return noSuchLocal("local", j, blend->locals().size());
    }
    if (const auto* blend = target.body.as<BlendingSurface>(); blend && local.is_array()) {
        const std::array counts{blend->alongU().count, blend->alongV().count};
        for (std::size_t k = 0; k < 2; ++k) {
            const double index = local[k].get<double>();
            if (index >= static_cast<double>(counts[k])) {
                return noSuchLocal(indexed("local", k), index, counts[k]);
            }
        }
        return local[0].get<std::size_t>() * counts[1] + local[1].get<std::size_t>();
    }
    return refuse(Code::notSupported, "local",
                  "\"" + target.id + "\" has no such local: one number names a local curve of a "
                  "blending curve, [i, j] a local patch of a blending surface.");
}

Result<Done> fitToTarget(Effect& effect, const Object& target) {
    const bool blends = target.body.as<BlendingCurve>() != nullptr ||
                        target.body.as<BlendingSurface>() != nullptr;
    if (effect.kind == EffectKind::simulate && !blends) {
        return refuse(Code::notSupported, "kind",
                      "\"simulate\" moves the locals of a blending curve or surface; \"" +
                          effect.target + "\" has none.");
    }
    if (effect.kind == EffectKind::morph && target.body.curve() == nullptr) {
        return refuse(Code::notSupported, "kind",
                      "\"morph\" makes another curve of a curve; \"" + effect.target +
                          "\" is none.");
    }
    const Json* local = member(effect.spec, "local");
    if (local == nullptr) return Done{};
    const auto place = localOf(*local, target);
    if (!place) return place.error();
    effect.local = *place;
    return Done{};
}

}  // namespace

Result<std::shared_ptr<const Effect>> readEffect(
    const Json& spec, std::span<const std::shared_ptr<const Object>> objects) {
    auto canonical = canonicalEffect(spec);
    if (!canonical) return canonical.error();
    Effect effect;
    effect.spec = std::move(*canonical);
    effect.kind = kindNamed(stringOr(effect.spec, "kind", ""));
    effect.target = stringOr(effect.spec, "target", "");
    effect.period = numberOr(effect.spec, "period", 10);
    const auto easing = makeBFunction(*member(effect.spec, "easing"));
    if (!easing) return easing.error().under("easing");
    effect.easing = easing->value;
    if (const auto filled = fillEffect(effect); !filled) return filled.error();
    const auto target = std::find_if(objects.begin(), objects.end(), [&](const auto& object) {
        return object->id == effect.target;
    });
    if (target == objects.end()) {
        return refuse(Code::unknownName, "target",
                      "There is no object \"" + effect.target + "\" in the scene.");
    }
    if (const auto fits = fitToTarget(effect, **target); !fits) return fits.error();
    return std::make_shared<const Effect>(std::move(effect));
}

}  // namespace knotwork::scene
