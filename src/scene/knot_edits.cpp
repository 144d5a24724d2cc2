#include "scene/knot_edits.hpp"

#include "geometry/knot_removal.hpp"
#include "geometry/refinement.hpp"
#include "scene/edits.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_parts.hpp"
#include "scene/specs.hpp"
#include "scene/surface_knot_edits.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace knotwork::scene {

namespace {

std::string pathOf(std::span<const PathStep> rest) {
    return formatPath(Path(rest.begin(), rest.end()));
}

/// What a path to knots names.
struct KnotPlace {
    std::size_t steps = 0;                   ///< to the curve or surface that has them
    std::optional<std::size_t> direction{};  ///< of a surface
    std::optional<std::size_t> index{};      ///< of one knot
};

/// `knots` and `knots[3]` of a curve, `knots[1]` and `knots[1][3]` of a surface.
std::optional<KnotPlace> knotPlace(const Json& part, std::span<const PathStep> rest) {
    std::size_t indices = 0;
    while (indices < rest.size() && rest[rest.size() - 1 - indices].isIndex()) ++indices;
    if (indices > 2 || indices == rest.size()) return std::nullopt;
    KnotPlace place{.steps = rest.size() - 1 - indices};
    if (rest[place.steps].key != "knots") return std::nullopt;
    const Json* owner = find(part, rest.first(place.steps));
    if (owner == nullptr) return std::nullopt;
    const std::string type = stringOr(*owner, "type", "");
    const bool surface = type == "bspline-surface" || type == "blending-surface";
    const bool curve = type == "bspline-curve" || type == "blending-curve";
    if (curve && indices < 2) {
        if (indices == 1) place.index = rest.back().index;
        return place;
    }
    if (!surface || indices == 0 || rest[place.steps + 1].index > 1) return std::nullopt;
    place.direction = rest[place.steps + 1].index;
    if (indices == 2) place.index = rest.back().index;
    return place;
}

// --- blending curves --------------------------------------------------------------------------

/// Knots that were spaced by length are so no more.
void spaceByKnots(Json& curve) {
    if (member(curve, "spacing") != nullptr) curve["spacing"] = "parameter";
}

/// Poses of local curves from `first` on move by `step`.
void renumberPoses(Json& curve, double first, double step) {
    Json* poses = member(curve, "poses");
    if (poses == nullptr) return;
    for (Json& pose : *poses) {
        const double local = numberOr(pose, "local", 0);
        if (local >= first) pose["local"] = local + step;
    }
}

Result<Json> withLocalAt(const Json& curve, const BlendingCurve& blend, double at) {
    const auto inserted = withKnotInside(blend.knots(), at);
    if (!inserted) return inserted.error();
    Json changed = curve;
    changed["knots"] = listOf(inserted->knots);
    changed["spacing"] = "parameter";  // these are no longer those of equal lengths
    changed["locals"]["count"] = static_cast<double>(blend.locals().size() + 1);
    renumberPoses(changed, static_cast<double>(inserted->index), 1);
    return changed;
}

Result<Json> withoutLocal(const Json& curve, const BlendingCurve& blend, std::size_t index) {
    const auto removable = checkRemovable(blend.closed(), index, blend.knots().size());
    if (!removable) return removable.error();
    Json changed = curve;
    changed["knots"].erase(index);
    Json& locals = changed["locals"];
    if (locals.is_array()) {
        locals.erase(index);
    } else {
        locals["count"] = static_cast<double>(blend.locals().size()) - 1;
    }
    const auto gone = static_cast<double>(index);
    if (Json* poses = member(changed, "poses")) {
        Json kept = Json::array();
        for (Json& pose : *poses) {
            if (numberOr(pose, "local", -1) != gone) kept.push_back(std::move(pose));
        }
        *poses = std::move(kept);
    }
    spaceByKnots(changed);
    renumberPoses(changed, gone, -1);
    return changed;
}

// --- moves -------------------------------------------------------------------------------------

/// The knots of a curve, or of one direction of a surface.
struct KnotLine {
    bool alike = false;  ///< whether equal knots are, as in a B-spline
    bool clamped = false;
    std::size_t degree = 0;
};

/// `form` and `degree` are those of a canonical specification.
KnotLine lineOf(std::string_view type, const Json* form, const Json* degree) {
    const bool spline = type == "bspline-curve" || type == "bspline-surface";
    if (!spline) return {};
    return {.alike = true,
            .clamped = *form == "clamped",
            .degree = static_cast<std::size_t>(degree->get<double>())};
}

/// What `rest` names a knot of, if it names one.
std::optional<KnotLine> knotLineAt(const Json& part, std::span<const PathStep> rest) {
    const auto place = knotPlace(part, rest);
    if (!place || !place->index) return std::nullopt;
    if (find(part, rest.first(rest.size() - 1)) == nullptr) return std::nullopt;
    const Json& owner = *find(part, rest.first(place->steps));
    const auto of = [&](const char* key) {
        const Json* value = member(owner, key);
        return value != nullptr && place->direction ? &(*value)[*place->direction] : value;
    };
    return lineOf(stringOr(owner, "type", ""), of("form"), of("degree"));
}

/// The first and the last of the knots that move with this one.
std::pair<std::size_t, std::size_t> movedTogether(const KnotLine& line, const Json& knots,
                                                  std::size_t index) {
    const std::size_t last = knots.size() - 1;
    if (line.clamped && index <= line.degree) return {0, line.degree};
    if (line.clamped && index + line.degree >= last) return {last - line.degree, last};
    return {index, index};
}

/// Of the knots equal to this one, that which moves without passing the others.
std::size_t pulledOff(const Json& knots, std::size_t index, double to) {
    const double from = knots[index].get<double>();
    while (to > from && index + 1 < knots.size() && knots[index + 1] == knots[index]) ++index;
    while (to < from && index > 0 && knots[index - 1] == knots[index]) --index;
    return index;
}

/// `to`, or the knot next to it within `snap`; those that move themselves do not count.
Result<Json> snappedTo(const Json& knots, const std::pair<std::size_t, std::size_t>& moving,
                       const Json& to, const Json& snap) {
    if (!snap.is_number()) {
        return refuse(Code::wrongType, "snap",
                      "Expected a distance, got " + describeValue(snap) + ".");
    }
    const double distance = snap.get<double>();
    if (!(distance >= 0)) {
        return refuse(Code::outOfRange, "snap",
                      "The distance within which knots merge is not negative.");
    }
    if (!to.is_number()) return to;
    const double at = to.get<double>();
    Json nearest = to;
    double least = distance;
    for (std::size_t k = 0; k < knots.size(); ++k) {
        const double away = std::abs(knots[k].get<double>() - at);
        if ((k >= moving.first && k <= moving.second) || away > least) continue;
        least = away;
        nearest = knots[k];
    }
    return nearest;
}

// --- removal ----------------------------------------------------------------------------------

Result<Json> withoutKnotOf(const Json& curve, const BsplineCurve& spline, std::size_t index) {
    const auto removal = removeKnotAnyway(spline, spline.knotVector().knots()[index]);
    if (!removal) return removal.error();
    if (removal->removed) return withShape(curve, specOf(Curve(removal->curve)));
    return refuse(Code::outOfRange, "t",
                  "Without this knot a weight would not be positive; change the weights first.");
}

Result<Json> withoutKnot(const Json& curve, std::size_t index) {
    const auto made = makeCurve(curve);
    if (!made) return made.error();
    if (const auto* spline = made->value.as<BsplineCurve>()) {
        return withoutKnotOf(curve, *spline, index);
    }
    return withoutLocal(curve, *made->value.as<BlendingCurve>(), index);
}

/// `part` with the curve or surface whose knots `rest` names changed; what is refused is refused at
/// `rest`.
Result<Json> withOwner(const Json& part, std::span<const PathStep> rest, std::size_t steps,
                       Result<Json> owner) {
    if (!owner) return refuse(owner.error().code, pathOf(rest), owner.error().message);
    Json changed = part;
    *find(changed, rest.first(steps)) = std::move(*owner);
    return changed;
}

}  // namespace

bool leadsToKnots(const Json& part, std::span<const PathStep> rest) {
    return knotPlace(part, rest).has_value();
}

bool namesKnot(const Json& part, std::span<const PathStep> rest) {
    return knotLineAt(part, rest).has_value();
}

Result<Json> withKnotAt(Json part, std::span<const PathStep> rest, const Json& value) {
    const auto line = knotLineAt(part, rest);
    Json& knots = *find(part, rest.first(rest.size() - 1));
    const auto [first, last] = movedTogether(*line, knots, rest.back().index);
    for (std::size_t k = first; k <= last; ++k) knots[k] = value;
    return part;
}

Result<MovedKnot> moveKnotIn(const Json& part, std::span<const PathStep> rest,
                             const Json& command) {
    const Json* knot = find(part, rest);
    if (knot == nullptr) {
        return refuse(Code::unknownField, pathOf(rest), "There is no " + pathOf(rest) + " here.");
    }
    auto to = movedValue(*knot, command);
    if (!to) return to.error();
    const auto line = knotLineAt(part, rest);
    const Json& knots = *find(part, rest.first(rest.size() - 1));
    std::vector<PathStep> place(rest.begin(), rest.end());
    if (const Json* snap = member(command, "snap")) {
        const auto moving = movedTogether(*line, knots, rest.back().index);
        auto snapped = snappedTo(knots, moving, *to, *snap);
        if (!snapped) return snapped.error();
        to = std::move(*snapped);
    }
    if (line->alike && to->is_number()) {
        place.back().index = pulledOff(knots, rest.back().index, to->get<double>());
    }
    auto moved = withKnotAt(part, place, *to);
    if (!moved) return moved.error();
    return MovedKnot{std::move(*moved), place.back().index};
}

Result<Json> withKnot(const Json& curve, double at) {
    const auto made = makeCurve(curve);
    if (!made) return made.error();
    if (const auto* spline = made->value.as<BsplineCurve>()) {
        const auto refined = insertKnot(*spline, at, 1);
        if (!refined) return refined.error();
        return withShape(curve, specOf(Curve(*refined)));
    }
    const auto* blend = made->value.as<BlendingCurve>();
    if (blend != nullptr && blend->model() != nullptr) return withLocalAt(curve, *blend, at);
    return refuse(Code::notSupported, "",
                  "Knots are inserted into B-spline curves and into blending curves that are cut "
                  "from a model.");
}

Result<Json> insertKnotIn(const Json& part, std::span<const PathStep> rest, const Json& value) {
    if (!value.is_number()) {
        return refuse(Code::wrongType, pathOf(rest),
                      "A knot is a number, not " + describeValue(value) + ".");
    }
    const KnotPlace place = *knotPlace(part, rest);
    const Json& owner = *find(part, rest.first(place.steps));
    const double at = value.get<double>();
    return withOwner(part, rest, place.steps,
                     place.direction ? withKnotAlong(owner, *place.direction, at)
                                     : withKnot(owner, at));
}

Result<Json> removeKnotIn(const Json& part, std::span<const PathStep> rest) {
    if (find(part, rest) == nullptr) {
        return refuse(Code::unknownField, pathOf(rest), "There is no " + pathOf(rest) + " here.");
    }
    const KnotPlace place = *knotPlace(part, rest);
    const Json& owner = *find(part, rest.first(place.steps));
    return withOwner(part, rest, place.steps,
                     place.direction ? withoutKnotAlong(owner, *place.direction, *place.index)
                                     : withoutKnot(owner, *place.index));
}

}  // namespace knotwork::scene
