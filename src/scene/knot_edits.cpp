#include "scene/knot_edits.hpp"

#include "geometry/knot_removal.hpp"
#include "geometry/refinement.hpp"
#include "scene/json_values.hpp"
#include "scene/specs.hpp"
#include "scene/validation.hpp"

#include <algorithm>

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
    Json* poses = const_cast<Json*>(member(curve, "poses"));
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
    if (Json* poses = const_cast<Json*>(member(changed, "poses"))) {
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
