// Objects that become objects of another type.
#include "geometry/named.hpp"
#include "geometry/uniform_parameters.hpp"
#include "scene/adaptation_parts.hpp"
#include "scene/json_values.hpp"
#include "scene/specs.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

/// So many points of a curve that has none of its own.
constexpr std::size_t sampledPoints = 8;

constexpr std::string_view polygon = "[[0,0],[1,2],[3,3],[5,0],[6,2]]";
constexpr std::string_view net =
    "[[[0,0,0],[0,1,0],[0,2,0],[0,3,0]],[[1,0,0],[1,1,1],[1,2,1],[1,3,0]],"
    "[[2,0,0],[2,1,1],[2,2,1],[2,3,0]],[[3,0,0],[3,1,0],[3,2,0],[3,3,0]]]";

struct Beginning {
    std::string_view type;
    std::string_view json;  ///< what it begins with, besides its type and its points
    bool hasPoints = false;
};

/// One for every type that is not made of points alone.
constexpr std::array beginnings{
    Beginning{"bspline-curve", R"({"degree":3})", true},
    Beginning{"bezier-curve", "{}", true},
    Beginning{"subdivision-curve", R"({"scheme":"lane-riesenfeld"})", true},
    Beginning{"point-cloud", "{}", true},
    Beginning{"parametric-curve", R"({"name":"circle"})"},
    Beginning{"blending-curve", R"({"bFunction":{"family":"expo-rational"},"locals":{"count":6}})"},
    Beginning{"line-curve", R"({"from":[0,0],"to":[4,2]})"},
    Beginning{"arc-curve",
              R"({"at":0,"point":[0,0],"first":[1,0],"second":[0,1],"domain":[0,3]})"},
    Beginning{"formula-curve", R"json({"x":"t","y":"sin(t)","domain":[0,6]})json"},
    Beginning{"parametric-surface", R"({"name":"torus"})"},
    Beginning{"bspline-surface", R"({"degree":[3,3]})"},
    Beginning{"blending-surface",
              R"({"bFunction":{"family":"expo-rational"},"locals":[4,4]})"},
    Beginning{"blending-triangle", R"({"locals":[{"type":"parametric-surface","name":"plane"},
        {"type":"parametric-surface","name":"plane"},{"type":"parametric-surface","name":"plane"}]})"},
    Beginning{"subdivision-surface", R"({"mesh":{"solid":"cube"}})"},
    Beginning{"b-function", R"({"bFunction":{"family":"expo-rational"}})"},
};

/// Those that it has, or some on the curve that it is, or some.
Json pointsFrom(const Json& before) {
    const Json* own = member(before, "points");
    if (own != nullptr && stringOr(before, "type", "") != "bspline-surface") return *own;
    const auto made = makeCurve(before);
    if (!made) return *parseJson(polygon);
    Json points = Json::array();
    for (std::size_t i = 0; i < sampledPoints; ++i) {
        const double t = uniformParameter(domain(made->value), i, sampledPoints);
        points.push_back(pointJson(pointAt(made->value, t), dimension(made->value)));
    }
    return points;
}

/// The curve or surface that local curves or patches can be cut from.
Json modelFrom(const Json& before, bool surface) {
    const std::string type = stringOr(before, "type", "");
    const bool fits = surface ? findSurfaceType(type) != nullptr : findCurveType(type) != nullptr;
    if (!fits) {
        return surface ? Json{{"type", "parametric-surface"}, {"name", "torus"}}
                       : Json{{"type", "parametric-curve"}, {"name", "circle"}};
    }
    Json model = before;
    for (const Field& own : objectFields()) model.erase(std::string(own.name));
    return model;
}

Json withPoints(Json object, std::string_view type, Json points) {
    if (type == "bspline-curve") {
        const auto most = static_cast<double>(points.size()) - 1;
        object["degree"] = std::clamp(3.0, 1.0, std::max(1.0, most));
    }
    object["points"] = std::move(points);
    return object;
}

}  // namespace

Json ofType(const Json& before, std::string_view type) {
    const Beginning* found = findNamed(beginnings, &Beginning::type, type);
    Json object{{"type", type}};
    for (const char* own : {"id", "style", "show", "t"}) {
        if (const Json* value = member(before, own)) object[own] = *value;
    }
    if (found == nullptr) return object;  // validation will say what is missing
    object.update(*parseJson(found->json));
    if (found->hasPoints) object = withPoints(std::move(object), type, pointsFrom(before));
    if (type == "bspline-surface") object["points"] = *parseJson(net);
    if (type == "blending-curve") object["model"] = modelFrom(before, false);
    if (type == "blending-surface") object["model"] = modelFrom(before, true);
    return object;
}

}  // namespace knotwork::scene
