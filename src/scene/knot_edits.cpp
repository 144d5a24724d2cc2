#include "scene/knot_edits.hpp"

#include "geometry/knot_removal.hpp"
#include "geometry/refinement.hpp"
#include "scene/edits.hpp"
#include "scene/json_values.hpp"
#include "scene/specs.hpp"
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

/// How many steps of `rest` lead to the curve whose knots it names.
std::size_t stepsToCurve(std::span<const PathStep> rest) {
    return rest.size() - (rest.back().isIndex() ? 2 : 1);
}

/// The curve with other points and knots, and with all that it has besides.
Json withShapeOf(const Json& curve, const BsplineCurve& shape) {
    Json changed = curve;
    const Json spec = specOf(Curve(shape));
    for (const char* key : {"points", "knots", "weights"}) {
        if (const Json* value = member(spec, key)) changed[key] = *value;
    }
    return changed;
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
    std::vector<double> knots = blend.knots();
    if (!(at > knots.front() && at < knots.back())) {
        return refuse(Code::outOfRange, "t",
                      formatNumber(at) + " does not lie inside the domain [" +
                          formatNumber(knots.front()) + ", " + formatNumber(knots.back()) + "].");
    }
    const auto place = std::upper_bound(knots.begin(), knots.end(), at);
    const auto index = static_cast<double>(place - knots.begin());
    knots.insert(place, at);
    Json changed = curve;
    changed["knots"] = listOf(knots);
    changed["spacing"] = "parameter";  // these are no longer those of equal lengths
    changed["locals"]["count"] = static_cast<double>(blend.locals().size() + 1);
    spaceByKnots(changed);
    renumberPoses(changed, index, 1);
    return changed;
}

Result<Json> withoutLocal(const Json& curve, const BlendingCurve& blend, std::size_t index) {
    const std::size_t last = blend.knots().size() - 1;
    if (blend.closed() && (index == 0 || index == last)) {
        return refuse(Code::outOfRange, "t",
                      "The knot at which the period begins and ends stays; remove one inside.");
    }
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

/// What `rest`, which ends in an index, names a knot of.
std::optional<KnotLine> knotLineAt(const Json& part, std::span<const PathStep> rest) {
    if (rest.size() < 2 || !rest.back().isIndex()) return std::nullopt;
    const bool surface = rest[rest.size() - 2].isIndex();
    if (surface && rest.size() < 3) return std::nullopt;
    const std::size_t steps = rest.size() - (surface ? 3 : 2);
    if (rest[steps].key != "knots") return std::nullopt;
    const Json* owner = find(part, rest.first(steps));
    if (owner == nullptr || find(part, rest.first(rest.size() - 1)) == nullptr) return std::nullopt;
    const std::string type = stringOr(*owner, "type", "");
    if (!surface && (type == "bspline-curve" || type == "blending-curve")) {
        return lineOf(type, member(*owner, "form"), member(*owner, "degree"));
    }
    if (!surface || (type != "bspline-surface" && type != "blending-surface")) return std::nullopt;
    const std::size_t direction = rest[steps + 1].index;
    const auto of = [&](const char* key) {
        const Json* pair = member(*owner, key);
        return pair != nullptr ? &(*pair)[direction] : nullptr;
    };
    return lineOf(type, of("form"), of("degree"));
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
    if (removal->removed) return withShapeOf(curve, removal->curve);
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

/// `part` with the curve at `rest` changed; what is refused is refused at `rest`.
Result<Json> withCurve(const Json& part, std::span<const PathStep> rest, Result<Json> curve) {
    if (!curve) return refuse(curve.error().code, pathOf(rest), curve.error().message);
    Json changed = part;
    *find(changed, rest.first(stepsToCurve(rest))) = std::move(*curve);
    return changed;
}

}  // namespace

bool leadsToKnots(const Json& part, std::span<const PathStep> rest) {
    if (rest.empty() || (rest.back().isIndex() && rest.size() < 2)) return false;
    const std::size_t steps = stepsToCurve(rest);
    if (rest[steps].key != "knots") return false;
    const Json* curve = find(part, rest.first(steps));
    if (curve == nullptr) return false;
    const std::string type = stringOr(*curve, "type", "");
    return type == "bspline-curve" || type == "blending-curve";
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
        return withShapeOf(curve, *refined);
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
    const Json& curve = *find(part, rest.first(stepsToCurve(rest)));
    return withCurve(part, rest, withKnot(curve, value.get<double>()));
}

Result<Json> removeKnotIn(const Json& part, std::span<const PathStep> rest) {
    if (find(part, rest) == nullptr) {
        return refuse(Code::unknownField, pathOf(rest), "There is no " + pathOf(rest) + " here.");
    }
    const Json& curve = *find(part, rest.first(stepsToCurve(rest)));
    return withCurve(part, rest, withoutKnot(curve, rest.back().index));
}

}  // namespace knotwork::scene
