#include "scene/adaptation.hpp"

#include "scene/json_values.hpp"
#include "scene/specs.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

bool differs(const Json& before, const Json& after, std::string_view key) {
    const Json* a = member(before, key);
    const Json* b = member(after, key);
    return (a == nullptr) != (b == nullptr) || (a != nullptr && *a != *b);
}

/// Whether `key` of the canonical curve stands as it would had it not been given.
bool isDefault(const Json& curve, std::string_view key) {
    const Json* value = member(curve, key);
    if (value == nullptr) return true;
    Json without = curve;
    without.erase(std::string(key));
    const auto made = makeCurve(without);
    const Json* computed = made ? member(made->spec, key) : nullptr;
    return computed != nullptr && *computed == *value;
}

std::size_t sizeOf(const Json& object, std::string_view key) {
    const Json* list = member(object, key);
    return list != nullptr && list->is_array() ? list->size() : 0;
}

// --- B-spline curves ------------------------------------------------------------------------

/// Where one list has an element more than the other: the first place at which they differ.
std::size_t changedIndex(const Json& shorter, const Json& longer) {
    std::size_t i = 0;
    while (i < shorter.size() && shorter[i] == longer[i]) ++i;
    return i;
}

/// The middle of the span that t falls into, never an empty one, between two indices.
double midOfSpanNear(std::span<const double> knots, std::size_t first, std::size_t last, double t) {
    std::size_t end = first + 1;
    while (end < last && (knots[end] <= t || knots[end] == knots[end - 1])) ++end;
    while (end > first + 1 && knots[end] == knots[end - 1]) --end;
    return (knots[end - 1] + knots[end]) / 2;
}

/// The range of indices between whose knots the curve lives.
std::pair<std::size_t, std::size_t> domainIndices(std::size_t knots, std::size_t degree,
                                                  bool closed) {
    return closed ? std::pair{std::size_t{0}, knots - 1} : std::pair{degree, knots - 1 - degree};
}

double grevilleOf(std::span<const double> knots, std::size_t degree, bool closed, double index) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    const std::size_t points = closed ? last : knots.size() - degree - 1;
    const double share = points < 2 ? 0.5 : std::clamp(index / static_cast<double>(points - 1), 0.0, 1.0);
    return knots[first] + share * (knots[last] - knots[first]);
}

void insertKnotFor(std::vector<double>& knots, std::size_t degree, bool closed, std::size_t point) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    const double near = grevilleOf(knots, degree, closed, static_cast<double>(point) - 0.5);
    const double knot = midOfSpanNear(knots, first, last, near);
    knots.insert(std::upper_bound(knots.begin(), knots.end(), knot), knot);
}

void removeKnotFor(std::vector<double>& knots, std::size_t degree, bool closed, std::size_t point) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    if (last - first < 2) return;  // no inner knot: the points will be too few, and that is said
    const double near = grevilleOf(knots, degree, closed, static_cast<double>(point));
    auto nearest = knots.begin() + static_cast<std::ptrdiff_t>(first + 1);
    const auto end = knots.begin() + static_cast<std::ptrdiff_t>(last);
    for (auto at = nearest; at != end; ++at) {
        if (std::abs(*at - near) < std::abs(*nearest - near)) nearest = at;
    }
    knots.erase(nearest);
}

/// The end knots of a clamped vector from those of an open one, and back.
void changeEnds(std::vector<double>& knots, std::size_t degree, bool clamped) {
    const std::size_t last = knots.size() - 1;
    const double head = knots[degree];
    const double tail = knots[last - degree];
    const double step = (tail - head) / static_cast<double>(last - 2 * degree);
    for (std::size_t i = 0; i < degree; ++i) {
        const double away = clamped ? 0 : step * static_cast<double>(degree - i);
        knots[i] = head - away;
        knots[last - i] = tail + away;
    }
}

/// Knots for a changed number of points; nothing where a new default is the better answer.
std::optional<std::vector<double>> knotsForPoints(const Json& before, const Json& after) {
    std::vector<double> knots = numbersOf(*member(after, "knots"));
    const auto degree = static_cast<std::size_t>(numberOr(after, "degree", 1));
    const bool closed = stringOr(after, "form", "clamped") == "closed";
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    if (to.size() == from.size() + 1) {
        insertKnotFor(knots, degree, closed, changedIndex(from, to));
    } else if (to.size() + 1 == from.size()) {
        removeKnotFor(knots, degree, closed, changedIndex(to, from));
    } else {
        return std::nullopt;
    }
    return knots;
}

std::optional<std::vector<double>> adaptedKnots(const Json& before, const Json& after) {
    if (isDefault(before, "knots") || differs(before, after, "degree")) return std::nullopt;
    if (differs(before, after, "form")) {
        const std::string from = stringOr(before, "form", "");
        const std::string to = stringOr(after, "form", "");
        if (from == "closed" || to == "closed") return std::nullopt;
        std::vector<double> knots = numbersOf(*member(after, "knots"));
        changeEnds(knots, static_cast<std::size_t>(numberOr(after, "degree", 1)), to == "clamped");
        return knots;
    }
    return knotsForPoints(before, after);
}

void adaptWeights(const Json& before, Json& after) {
    Json* weights = const_cast<Json*>(member(after, "weights"));
    if (weights == nullptr || differs(before, after, "weights")) return;
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    if (to.size() == from.size() + 1) {
        const auto at = static_cast<std::ptrdiff_t>(changedIndex(from, to));
        weights->insert(weights->begin() + at, 1.0);
    } else if (to.size() + 1 == from.size()) {
        weights->erase(changedIndex(to, from));
    }
}

bool isListOfPoints(const Json& curve) {
    const Json* points = member(curve, "points");
    return points != nullptr && points->is_array();
}

void adaptBspline(const Json& before, Json& after) {
    if (!isListOfPoints(after)) return;  // validation will say so
    const bool counts = sizeOf(before, "points") != sizeOf(after, "points");
    if (counts) adaptWeights(before, after);
    if (differs(before, after, "knots")) return;
    if (!counts && !differs(before, after, "degree") && !differs(before, after, "form")) return;
    const auto knots = adaptedKnots(before, after);
    if (knots) {
        after["knots"] = listOf(*knots);
    } else {
        after.erase("knots");
    }
}

// --- parametric and blending curves ----------------------------------------------------------

void adaptParametric(const Json& before, Json& after) {
    if (differs(before, after, "name")) {
        after.erase("parameters");
        after.erase("domain");
    } else if (differs(before, after, "parameters") && !differs(before, after, "domain") &&
               isDefault(before, "domain")) {
        after.erase("domain");
    }
}

/// `degree` and `tension` belong to one scheme each.
void adaptSubdivision(const Json& before, Json& after) {
    if (!differs(before, after, "scheme")) return;
    after.erase("degree");
    after.erase("tension");
}

/// The number of local curves, or nothing where `locals` is not yet known to be well formed.
std::optional<std::size_t> localCount(const Json& curve) {
    const Json* locals = member(curve, "locals");
    if (locals == nullptr) return std::nullopt;
    if (locals->is_array()) return locals->size();
    const double count = numberOr(*locals, "count", 0);
    if (!(count >= 2 && count <= 10'000) || count != std::floor(count)) return std::nullopt;
    return static_cast<std::size_t>(count);
}

/// As many knots as wanted over the same interval, spaced as the given ones are.
std::vector<double> respaced(std::span<const double> knots, std::size_t wanted) {
    std::vector<double> spaced(wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        const double at = static_cast<double>(i * (knots.size() - 1)) / static_cast<double>(wanted - 1);
        const auto k = std::min(static_cast<std::size_t>(at), knots.size() - 2);
        const double share = at - static_cast<double>(k);
        spaced[i] = share == 0 ? knots[k] : (1 - share) * knots[k] + share * knots[k + 1];
    }
    spaced.back() = knots.back();
    return spaced;
}

void dropPosesBeyond(Json& curve, std::size_t count) {
    Json* poses = const_cast<Json*>(member(curve, "poses"));
    if (poses == nullptr || !poses->is_array()) return;
    Json kept = Json::array();
    for (Json& pose : *poses) {
        if (numberOr(pose, "local", 0) < static_cast<double>(count)) kept.push_back(std::move(pose));
    }
    *poses = std::move(kept);
}

void adaptCurve(const Json& before, Json& after);

/// Another kind of local curves has its own degree; curves given one by one are not spaced.
void adaptLocals(const Json& before, Json& after) {
    const Json* locals = member(after, "locals");
    const Json* former = member(before, "locals");
    if (locals == nullptr || former == nullptr) return;
    if (locals->is_array()) {
        if (!former->is_array()) after.erase("spacing");
        return;
    }
    if (locals->is_object() && former->is_object() && differs(*former, *locals, "kind") &&
        !differs(*former, *locals, "degree")) {
        after["locals"].erase("degree");
    }
}

/// Whether the model is not the former one with other numbers but another curve altogether.
bool isAnotherModel(const Json& before, const Json& after) {
    const Json* from = member(before, "model");
    const Json* to = member(after, "model");
    return from != nullptr && to != nullptr &&
           (differs(*from, *to, "type") || differs(*from, *to, "name"));
}

void adaptBlending(const Json& before, Json& after) {
    if (const Json* model = member(after, "model"); model != nullptr && model->is_object()) {
        const Json* former = member(before, "model");
        if (former != nullptr && *former != *model) adaptCurve(*former, after["model"]);
    }
    adaptLocals(before, after);
    const auto count = localCount(after);
    if (!count) return;
    if (!differs(before, after, "poses")) dropPosesBeyond(after, *count);
    if (differs(before, after, "knots")) {
        // Knots that were moved are no longer at equal lengths.
        const bool spaced = stringOr(after, "spacing", "") == "length";
        if (spaced && !differs(before, after, "spacing")) after["spacing"] = "parameter";
        return;
    }
    const bool counts = localCount(before) != count || differs(before, after, "form");
    const bool spacing = differs(before, after, "spacing");
    if (!counts && !spacing && !differs(before, after, "model")) return;
    if (spacing || isDefault(before, "knots") || isAnotherModel(before, after)) {
        after.erase("knots");
    } else if (counts) {
        const bool closed = stringOr(after, "form", "open") == "closed";
        after["knots"] = listOf(respaced(numbersOf(*member(before, "knots")), *count + (closed ? 1 : 0)));
    }
}

void adaptCurve(const Json& before, Json& after) {
    const std::string type = stringOr(before, "type", "");
    if (stringOr(after, "type", "") != type) return;
    if (type == "bspline-curve") adaptBspline(before, after);
    if (type == "bezier-curve" && isListOfPoints(after)) adaptWeights(before, after);
    if (type == "parametric-curve") adaptParametric(before, after);
    if (type == "blending-curve") adaptBlending(before, after);
    if (type == "subdivision-curve") adaptSubdivision(before, after);
}

/// Enough samples that the table looks like the function it was made from.
constexpr std::size_t tabulatedSamples = 17;

Json sampledValues(const Json& spec) {
    std::vector<double> values(tabulatedSamples);
    if (const auto made = makeBFunction(spec)) made->value.sampleUniform(values);
    values.back() = 1;
    return listOf(values);
}

/// The parameters that were left as they are, moved to the end of a domain that has shrunk.
void keepParameters(const Json& before, Json& after) {
    const auto stays = [](const Json& from, const Json& to) {
        const Json* t = member(to, "t");
        return t != nullptr && t->is_number() && !differs(from, to, "t");
    };
    const Json* former = member(before, "trace");
    const Json* trace = member(after, "trace");
    const bool own = stays(before, after);
    const bool traced = former != nullptr && trace != nullptr && stays(*former, *trace);
    if (!own && !traced) return;
    const auto made = makeCurve(after);
    if (!made || isClosed(made->value)) return;
    const Interval whole = domain(made->value);
    const auto keep = [&](Json& t) { t = std::clamp(t.get<double>(), whole.start, whole.end); };
    if (own) keep(after["t"]);
    if (traced) keep(after["trace"]["t"]);
}

}  // namespace

Json adaptObject(const Json& before, Json after) {
    if (findCurveType(stringOr(after, "type", "")) == nullptr) return after;
    adaptCurve(before, after);
    keepParameters(before, after);
    return after;
}

Json adaptFamily(const Json& before, const std::string& family) {
    Json adapted{{"family", family}};
    const BFamilyDescription* description = findBFamily(family);
    if (description == nullptr) return adapted;  // validation will say so
    for (const OperandDescription& operand : description->operands) {
        adapted[std::string(operand.name)] =
            operand.count == 1 ? before : Json::array({before, Json{{"family", "linear"}}});
    }
    if (description->tabulated) adapted["values"] = sampledValues(before);
    if (description->expression) adapted["expression"] = "t^2*(3-2*t)";
    return adapted;
}

}  // namespace knotwork::scene
