#include "scene/knot_parts.hpp"

#include <algorithm>
#include <utility>

namespace knotwork::scene {

Json withShape(Json spline, const Json& spec) {
    for (const char* key : {"form", "points", "knots", "weights"}) {
        if (const Json* value = member(spec, key)) spline[key] = *value;
    }
    return spline;
}

Result<InsertedKnot> withKnotInside(std::vector<double> knots, double at) {
    if (!(at > knots.front() && at < knots.back())) {
        return refuse(Code::outOfRange, "t",
                      formatNumber(at) + " does not lie inside the domain [" +
                          formatNumber(knots.front()) + ", " + formatNumber(knots.back()) + "].");
    }
    const auto place = std::upper_bound(knots.begin(), knots.end(), at);
    const auto index = static_cast<std::size_t>(place - knots.begin());
    knots.insert(place, at);
    return InsertedKnot{std::move(knots), index};
}

Result<Done> checkRemovable(bool closed, std::size_t index, std::size_t count) {
    if (!closed || (index != 0 && index + 1 != count)) return Done{};
    return refuse(Code::outOfRange, "t",
                  "The knot at which the period begins and ends stays; remove one inside.");
}

}  // namespace knotwork::scene
