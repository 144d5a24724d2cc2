#include "scene/followed_locals.hpp"

#include "scene/adaptation_parts.hpp"
#include "scene/fields.hpp"

#include <algorithm>
#include <string>

namespace knotwork::scene {

namespace {

/// An element that came into a list or went out of it.
struct Step {
    std::size_t place = 0;
    bool came = false;
};

/// The one element by which two lists differ, where they differ by one.
std::optional<Step> stepBetween(const Json& before, const Json& after) {
    if (!before.is_array() || !after.is_array()) return std::nullopt;
    const bool came = after.size() == before.size() + 1;
    if (!came && after.size() + 1 != before.size()) return std::nullopt;
    const Json& shorter = came ? before : after;
    const Json& longer = came ? after : before;
    const std::size_t place = changedIndex(shorter, longer);
    const auto at = static_cast<std::ptrdiff_t>(place);
    if (!std::equal(shorter.begin() + at, shorter.end(), longer.begin() + at + 1)) {
        return std::nullopt;
    }
    return Step{place, came};
}

/// The same of the knots, those of one direction of a surface; `after` need not have any yet.
std::optional<Step> stepInKnots(const Json& before, const Json& after,
                                std::optional<std::size_t> direction) {
    const Json* from = member(before, "knots");
    const Json* to = member(after, "knots");
    if (from == nullptr || to == nullptr) return std::nullopt;
    if (!direction) return stepBetween(*from, *to);
    if (!to->is_array() || to->size() != 2) return std::nullopt;
    return stepBetween((*from)[*direction], (*to)[*direction]);
}

/// How many local curves or patches there are in a list, a { count } or a number.
double countOf(const Json& locals) {
    if (locals.is_array()) return static_cast<double>(locals.size());
    return locals.is_number() ? locals.get<double>() : numberOr(locals, "count", 0);
}

std::optional<double> followed(std::optional<Step> step, double count, double number) {
    if (step) {
        const auto place = static_cast<double>(step->place);
        if (!step->came && number == place) return std::nullopt;
        if (step->came ? number >= place : number > place) number += step->came ? 1 : -1;
    }
    if (number >= count) return std::nullopt;
    return number;
}

std::optional<Json> followedCurve(const Json& before, const Json& after, double number) {
    const Json& former = *member(before, "locals");
    const Json& locals = *member(after, "locals");
    auto step = stepBetween(former, locals);
    if (!step && countOf(former) != countOf(locals)) {
        step = stepInKnots(before, after, std::nullopt);
    }
    const auto found = followed(step, countOf(locals), number);
    return found ? std::optional<Json>(*found) : std::nullopt;
}

std::optional<Json> followedPatch(const Json& before, const Json& after, const Json& local) {
    Json found = local;
    for (std::size_t k = 0; k < 2; ++k) {
        const Json& former = (*member(before, "locals"))[k];
        const Json& locals = (*member(after, "locals"))[k];
        std::optional<Step> step;
        if (former != locals) step = stepInKnots(before, after, k);
        const auto number = followed(step, countOf(locals), local[k].get<double>());
        if (!number) return std::nullopt;
        found[k] = *number;
    }
    return found;
}

bool isBlend(std::string_view type) {
    return type == "blending-curve" || type == "blending-surface";
}

}  // namespace

std::optional<Json> followedLocal(const Json& before, const Json& after, const Json& local) {
    const std::string type = stringOr(after, "type", "");
    if (!isBlend(type) || stringOr(before, "type", "") != type) return std::nullopt;
    return type == "blending-curve" ? followedCurve(before, after, local.get<double>())
                                    : followedPatch(before, after, local);
}

std::optional<Json> followedEffect(const Json& before, const Json& after, const Json& effect) {
    const std::string type = stringOr(after, "type", "");
    const std::string kind = stringOr(effect, "kind", "");
    if (kind == "simulate" && !isBlend(type)) return std::nullopt;
    if (kind == "morph" && findCurveType(type) == nullptr) return std::nullopt;
    Json kept = effect;
    if (const Json* local = member(effect, "local")) {
        auto found = followedLocal(before, after, *local);
        if (!found) return std::nullopt;
        kept["local"] = std::move(*found);
    }
    return kept;
}

}  // namespace knotwork::scene
