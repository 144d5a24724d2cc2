// B-spline curves and surfaces: knots and weights follow points, degrees and forms.
#include "scene/adaptation_parts.hpp"
#include "scene/knot_parts.hpp"
#include "scene/form_changes.hpp"
#include "scene/form_names.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_adaptation.hpp"
#include "scene/specs.hpp"
#include "scene/surface_specs.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

bool isList(const Json* value) { return value != nullptr && value->is_array(); }

/// The degree as a whole number that a spline may have, or nothing.
std::optional<std::size_t> degreeOf(const Json* value) {
    if (value == nullptr || !value->is_number()) return std::nullopt;
    const double degree = value->get<double>();
    if (!(degree >= 1 && degree <= maxDegree) || degree != static_cast<int>(degree)) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(degree);
}

std::optional<Form> formOf(const Json* value) {
    if (value == nullptr || !value->is_string()) return std::nullopt;
    return formNamed(value->get_ref<const std::string&>());
}

/// Where two lists of points differ in number.
std::size_t placeOfChange(const Json& from, const Json& to) {
    return from.size() < to.size() ? changedIndex(from, to) : changedIndex(to, from);
}

/// Whether `form` is all that differs of what makes the shape.
bool onlyFormDiffers(const Json& before, const Json& after) {
    for (const char* key : {"degree", "points", "knots", "weights"}) {
        if (differs(before, after, key)) return false;
    }
    return differs(before, after, "form");
}

// --- curves -------------------------------------------------------------------------------------

/// The very same curve in the form that `after` wants, where there is one.
std::optional<Json> sameCurve(const Json& before, const Json& after) {
    const auto form = formOf(member(after, "form"));
    const auto made = makeCurve(before);
    if (!form || !made) return std::nullopt;
    const auto reformed = inForm(*made->value.as<BsplineCurve>(), *form);
    return reformed ? std::optional(withShape(after, specOf(Curve(*reformed)))) : std::nullopt;
}

std::optional<std::vector<double>> curveKnots(const Json& before, const Json& after) {
    const auto degree = degreeOf(member(after, "degree"));
    const auto form = formOf(member(after, "form"));
    if (!degree || !form) return std::nullopt;
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    return knotsAfter({*degreeOf(member(before, "degree")), *formOf(member(before, "form")),
                       from.size(), numbersOf(*member(before, "knots"))},
                      {*degree, *form, to.size(), placeOfChange(from, to)});
}

// --- surfaces -----------------------------------------------------------------------------------

/// Whether it is a list of lists, all as long as the first.
bool isNet(const Json* points) {
    if (!isList(points) || points->empty() || !isList(&points->front())) return false;
    return std::all_of(points->begin(), points->end(), [&](const Json& row) {
        return row.is_array() && row.size() == points->front().size();
    });
}

/// The first place along v at which the rows of two nets differ in number.
std::size_t columnOfChange(const Json& from, const Json& to) {
    std::size_t place = std::min(from.front().size(), to.front().size());
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) {
        place = std::min(place, placeOfChange(from[i], to[i]));
    }
    return place;
}

std::optional<std::vector<double>> surfaceKnots(const Json& before, const Json& after,
                                                std::size_t direction) {
    const auto of = [&](const Json& spec, const char* key) -> const Json* {
        const Json* pair = member(spec, key);
        return isList(pair) && pair->size() == 2 ? &(*pair)[direction] : nullptr;
    };
    const auto degree = degreeOf(of(after, "degree"));
    const auto form = formOf(of(after, "form"));
    if (!degree || !form) return std::nullopt;
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    const auto countOf = [&](const Json& net) {
        return direction == 0 ? net.size() : net.front().size();
    };
    const KnotRow row{*degreeOf(of(before, "degree")), *formOf(of(before, "form")), countOf(from),
                      numbersOf(*of(before, "knots"))};
    const std::size_t point = direction == 0 ? placeOfChange(from, to) : columnOfChange(from, to);
    if (row.degree == *degree && row.form == *form && row.count == countOf(to)) return row.knots;
    auto knots = knotsAfter(row, {*degree, *form, countOf(to), point});
    if (knots) return knots;
    const auto usual = KnotVector::uniform(static_cast<int>(*degree),
                                           static_cast<int>(countOf(to)), *form);
    if (!usual) return std::nullopt;
    return std::vector<double>(usual->knots().begin(), usual->knots().end());
}

/// Weights with a row, or a column, of ones more or of what was there less.
Json adaptNetWeights(const Json& before, Json after) {
    Json* weights = member(after, "weights");
    if (!isNet(weights) || differs(before, after, "weights")) return after;
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    const std::size_t row = placeOfChange(from, to);
    if (to.size() == from.size() + 1) {
        weights->insert(weights->begin() + static_cast<std::ptrdiff_t>(row),
                        Json(Json::array_t(from.front().size(), Json(1.0))));
    } else if (to.size() + 1 == from.size()) {
        weights->erase(row);
    }
    const std::size_t column = columnOfChange(from, to);
    const std::size_t columns = to.front().size();
    for (Json& line : *weights) {
        if (columns == line.size() + 1) {
            line.insert(line.begin() + static_cast<std::ptrdiff_t>(column), 1.0);
        } else if (columns + 1 == line.size()) {
            line.erase(column);
        }
    }
    return after;
}

/// The very same surface in the forms that `after` wants, where there is one.
std::optional<Json> sameSurface(const Json& before, const Json& after) {
    const Json* forms = member(after, "form");
    if (!isList(forms) || forms->size() != 2) return std::nullopt;
    const auto u = formOf(&(*forms)[0]);
    const auto v = formOf(&(*forms)[1]);
    const auto made = makeSurface(before);
    if (!u || !v || !made) return std::nullopt;
    const auto reformed = inForms(*made->value.as<BsplineSurface>(), *u, *v);
    return reformed ? std::optional(withShape(after, specOf(Surface(*reformed)))) : std::nullopt;
}

}  // namespace

Json adaptWeights(const Json& before, Json after) {
    Json* weights = member(after, "weights");
    if (!isList(weights) || !isList(member(after, "points"))) return after;
    if (differs(before, after, "weights")) return after;
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    const std::size_t place = placeOfChange(from, to);
    if (to.size() == from.size() + 1) {
        weights->insert(weights->begin() + static_cast<std::ptrdiff_t>(place), 1.0);
    } else if (to.size() + 1 == from.size()) {
        weights->erase(place);
    }
    return after;
}

Json adaptBspline(const Json& before, Json after) {
    if (!isList(member(after, "points"))) return after;
    if (onlyFormDiffers(before, after)) {
        if (auto same = sameCurve(before, after)) return std::move(*same);
    }
    const bool counts = member(before, "points")->size() != member(after, "points")->size();
    if (counts) after = adaptWeights(before, std::move(after));
    if (differs(before, after, "knots")) return after;
    if (!counts && !differs(before, after, "degree") && !differs(before, after, "form")) {
        return after;
    }
    const auto knots = curveKnots(before, after);
    if (knots) {
        after["knots"] = listOf(*knots);
    } else {
        after.erase("knots");
    }
    return after;
}

Json adaptBsplineSurface(const Json& before, Json after) {
    if (!isNet(member(after, "points"))) return after;
    if (onlyFormDiffers(before, after)) {
        if (auto same = sameSurface(before, after)) return std::move(*same);
    }
    const Json& from = *member(before, "points");
    const Json& to = *member(after, "points");
    const bool counts = from.size() != to.size() || from.front().size() != to.front().size();
    if (counts) after = adaptNetWeights(before, std::move(after));
    if (differs(before, after, "knots")) return after;
    if (!counts && !differs(before, after, "degree") && !differs(before, after, "form")) {
        return after;
    }
    const auto u = surfaceKnots(before, after, 0);
    const auto v = surfaceKnots(before, after, 1);
    if (u && v) {
        after["knots"] = Json::array({listOf(*u), listOf(*v)});
    } else {
        after.erase("knots");
    }
    return after;
}

}  // namespace knotwork::scene
