// Blending curves and surfaces: knots and poses follow the numbers of locals, the model and the form.
#include "scene/adaptation_parts.hpp"
#include "scene/followed_locals.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_adaptation.hpp"
#include "scene/specs.hpp"
#include "scene/surface_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace knotwork::scene {

namespace {

/// A number of locals that is worth computing with.
std::optional<std::size_t> countOf(const Json* value) {
    const double count = value != nullptr && value->is_number() ? value->get<double>() : 0;
    if (!(count >= 2 && count <= 10'000) || count != std::floor(count)) return std::nullopt;
    return static_cast<std::size_t>(count);
}

/// Whether the knots stand as they would had they not been given.
bool areDefault(const Json& blend) {
    Json without = blend;
    without.erase("knots");
    if (findSurfaceType(stringOr(blend, "type", "")) != nullptr) {
        const auto made = makeSurface(without);
        return made.ok() && !differs(made->spec, blend, "knots");
    }
    const auto made = makeCurve(without);
    return made.ok() && !differs(made->spec, blend, "knots");
}

/// Whether the model is not the former one with other numbers but another one altogether.
bool isAnotherModel(const Json& before, const Json& after) {
    const Json* from = member(before, "model");
    const Json* to = member(after, "model");
    return from != nullptr && to != nullptr &&
           (differs(*from, *to, "type") || differs(*from, *to, "name"));
}

/// The poses of local curves and patches that are still there, whatever their numbers are now.
Json keepPoses(const Json& before, Json blend) {
    Json* poses = member(blend, "poses");
    if (poses == nullptr || !poses->is_array()) return blend;
    Json kept = Json::array();
    for (Json& pose : *poses) {
        auto local = followedLocal(before, blend, pose["local"]);
        if (!local) continue;
        pose["local"] = std::move(*local);
        kept.push_back(std::move(pose));
    }
    *poses = std::move(kept);
    return blend;
}

// --- curves -------------------------------------------------------------------------------------

/// The number of local curves, or nothing where `locals` is not yet known to be well formed.
std::optional<std::size_t> localCount(const Json& curve) {
    const Json* locals = member(curve, "locals");
    if (locals == nullptr) return std::nullopt;
    if (locals->is_array()) return locals->size();
    return countOf(member(*locals, "count"));
}

/// Another kind of local curves has its own degree; curves given one by one are not spaced.
Json adaptLocals(const Json& before, Json after) {
    Json* locals = member(after, "locals");
    const Json* former = member(before, "locals");
    if (locals == nullptr || former == nullptr) return after;
    if (locals->is_array()) {
        if (!former->is_array()) after.erase("spacing");
    } else if (locals->is_object() && former->is_object() && differs(*former, *locals, "kind") &&
               !differs(*former, *locals, "degree")) {
        locals->erase("degree");
    }
    return after;
}

Json adaptCurveKnots(const Json& before, Json after, std::size_t count) {
    if (differs(before, after, "knots")) {
        // Knots that were moved are no longer at equal lengths.
        const bool spaced = stringOr(after, "spacing", "") == "length";
        if (spaced && !differs(before, after, "spacing")) after["spacing"] = "parameter";
        return after;
    }
    const bool counts = localCount(before) != count || differs(before, after, "form");
    const bool spacing = differs(before, after, "spacing");
    if (!counts && !spacing && !differs(before, after, "model")) return after;
    if (spacing || areDefault(before) || isAnotherModel(before, after)) {
        after.erase("knots");
    } else if (counts && count >= 2) {
        const bool closed = stringOr(after, "form", "open") == "closed";
        after["knots"] =
            listOf(respaced(numbersOf(*member(before, "knots")), count + (closed ? 1 : 0)));
    }
    return after;
}

// --- surfaces -----------------------------------------------------------------------------------

using Counts = std::array<std::size_t, 2>;

std::optional<Counts> patchCounts(const Json& surface) {
    const Json* locals = member(surface, "locals");
    if (locals == nullptr || !locals->is_array() || locals->size() != 2) return std::nullopt;
    const auto u = countOf(&(*locals)[0]);
    const auto v = countOf(&(*locals)[1]);
    if (!u || !v) return std::nullopt;
    return Counts{*u, *v};
}

std::array<bool, 2> closedOf(const Json& surface) {
    std::array<bool, 2> closed{};
    const Json* forms = member(surface, "form");
    for (std::size_t k = 0; k < 2; ++k) {
        closed[k] = forms != nullptr && forms->is_array() && forms->size() == 2 &&
                    (*forms)[k] == "closed";
    }
    return closed;
}

Json adaptSurfaceKnots(const Json& before, Json after, const Counts& counts) {
    if (differs(before, after, "knots")) return after;
    const bool another = isAnotherModel(before, after);
    if (another && !differs(before, after, "form")) after.erase("form");
    const bool numbers = patchCounts(before) != counts || differs(before, after, "form");
    if (!numbers && !differs(before, after, "model")) return after;
    if (another || areDefault(before)) {
        after.erase("knots");
        return after;
    }
    const auto closed = closedOf(after);
    Json knots = *member(before, "knots");
    for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t wanted = counts[k] + (closed[k] ? 1 : 0);
        if (knots[k].size() != wanted) knots[k] = listOf(respaced(numbersOf(knots[k]), wanted));
    }
    after["knots"] = std::move(knots);
    return after;
}

}  // namespace

Json adaptBlending(const Json& before, Json after) {
    Json* model = member(after, "model");
    const Json* former = member(before, "model");
    if (model != nullptr && model->is_object() && former != nullptr && *former != *model) {
        *model = adaptCurve(*former, std::move(*model));
    }
    after = adaptLocals(before, std::move(after));
    const auto count = localCount(after);
    if (!count) return after;
    if (!differs(before, after, "poses")) after = keepPoses(before, std::move(after));
    return adaptCurveKnots(before, std::move(after), *count);
}

Json adaptBlendingSurface(const Json& before, Json after) {
    Json* model = member(after, "model");
    const Json& former = *member(before, "model");
    if (model != nullptr && model->is_object() && former != *model) {
        *model = adaptSurface(former, std::move(*model));
    }
    if (differs(before, after, "kind") && !differs(before, after, "degree")) after.erase("degree");
    const auto counts = patchCounts(after);
    if (!counts) return after;
    if (!differs(before, after, "poses")) after = keepPoses(before, std::move(after));
    return adaptSurfaceKnots(before, std::move(after), *counts);
}

}  // namespace knotwork::scene
