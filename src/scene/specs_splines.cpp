#include "scene/spec_builders.hpp"

#include "scene/form_names.hpp"
#include "scene/json_values.hpp"

#include <algorithm>

namespace knotwork::scene {

Result<Curve> buildBspline(Json& spec) {
    const Json& list = *member(spec, "points");
    if (list.size() > maxPointCount) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(list.size()) + " points; a curve has at most 100000.");
    }
    std::vector<Vec3> points;
    points.reserve(list.size());
    for (const Json& point : list) points.push_back(vec3Of(point));
    const bool planar = std::all_of(points.begin(), points.end(),
                                    [](const Vec3& p) { return p.z == 0; });
    const int degree = static_cast<int>(numberOr(spec, "degree", 0));
    const int count = static_cast<int>(points.size());
    const Form form = *formNamed(stringOr(spec, "form", "clamped"));
    const Json* given = member(spec, "knots");
    auto knots = given != nullptr ? KnotVector::make(numbersOf(*given), degree, count, form)
                                  : KnotVector::uniform(degree, count, form);
    if (!knots) return knots.error();
    if (given == nullptr) spec["knots"] = listOf(knots->knots());
    const Json* weights = member(spec, "weights");
    auto curve = BsplineCurve::make(std::move(*knots), std::move(points), planar ? 2 : 3,
                                    weights != nullptr ? numbersOf(*weights)
                                                       : std::vector<double>{});
    if (!curve) return curve.error();
    return Curve(std::move(*curve));
}

Json specOf(const BsplineCurve& curve) {
    Json points = Json::array();
    for (const Vec3& point : curve.points()) points.push_back(pointJson(point, curve.dimension()));
    Json spec{{"type", "bspline-curve"},
              {"degree", static_cast<double>(curve.degree())},
              {"form", formName(curve.knotVector().form())},
              {"points", std::move(points)},
              {"knots", listOf(curve.knotVector().knots())}};
    if (!curve.weights().empty()) spec["weights"] = listOf(curve.weights());
    return spec;
}

}  // namespace knotwork::scene
