#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"
#include "scene/specs.hpp"
#include "scene/validation.hpp"

namespace knotwork::scene {

namespace {

CurveScheme schemeOf(const Json& spec) {
    const std::string name = stringOr(spec, "scheme", "lane-riesenfeld");
    return name == "chaikin"      ? CurveScheme::chaikin
           : name == "four-point" ? CurveScheme::fourPoint
                                  : CurveScheme::laneRiesenfeld;
}

std::string_view schemeName(CurveScheme scheme) noexcept {
    switch (scheme) {
        case CurveScheme::laneRiesenfeld: return "lane-riesenfeld";
        case CurveScheme::chaikin: return "chaikin";
        case CurveScheme::fourPoint: break;
    }
    return "four-point";
}

Error notOfScheme(std::string field, CurveScheme scheme) {
    const std::string owner = field == "degree" ? "lane-riesenfeld" : "four-point";
    return refuse(Code::unknownField, field,
                  "The scheme \"" + std::string(schemeName(scheme)) + "\" has no " + field +
                      "; only \"" + owner + "\" has one. Leave it out.");
}

}  // namespace

Result<CurveSubdivision> buildCurveSubdivision(Json& spec) {
    CurveSubdivision subdivision;
    subdivision.scheme = schemeOf(spec);
    const bool hasDegree = subdivision.scheme == CurveScheme::laneRiesenfeld;
    const bool hasTension = subdivision.scheme == CurveScheme::fourPoint;
    if (!hasDegree && member(spec, "degree")) return notOfScheme("degree", subdivision.scheme);
    if (!hasTension && member(spec, "tension")) return notOfScheme("tension", subdivision.scheme);
    subdivision.degree = static_cast<int>(numberOr(spec, "degree", subdivision.degree));
    subdivision.tension = numberOr(spec, "tension", subdivision.tension);
    if (hasDegree) spec["degree"] = static_cast<double>(subdivision.degree);
    if (hasTension) spec["tension"] = subdivision.tension;
    subdivision.levels = static_cast<int>(numberOr(spec, "levels", subdivision.levels));
    subdivision.closed = flagOr(spec, "closed", false);
    const Json& list = *member(spec, "points");
    subdivision.points.reserve(list.size());
    for (const Json& point : list) subdivision.points.push_back(vec3Of(point));
    return subdivision;
}

Result<CurveSubdivision> makeSubdivision(const Json& spec) {
    constexpr std::string_view type = "subdivision-curve";
    if (stringOr(spec, "type", type) != type) {
        return refuse(Code::unknownName, "type",
                      "Only a \"subdivision-curve\" can be subdivided; leave the type out.");
    }
    Json typed = spec;
    if (typed.is_object() && !typed.contains("type")) typed["type"] = type;
    auto canonical = readCurve(typed);
    if (!canonical) return canonical.error();
    auto subdivision = buildCurveSubdivision(*canonical);
    if (!subdivision) return subdivision.error();
    const auto checked = checkSubdivision(*subdivision, maxSubdividedPoints);
    return checked ? std::move(subdivision) : checked.error();
}

Result<Curve> buildSubdivision(Json& spec) {
    auto subdivision = buildCurveSubdivision(spec);
    if (!subdivision) return subdivision.error();
    auto curve = SubdivisionCurve::make(std::move(*subdivision));
    if (!curve) return curve.error();
    return Curve(std::move(*curve));
}

Json specOf(const SubdivisionCurve& curve) {
    const CurveSubdivision& subdivision = curve.subdivision();
    Json points = Json::array();
    for (const Vec3& point : subdivision.points) {
        points.push_back(pointJson(point, curve.dimension()));
    }
    Json spec{{"type", "subdivision-curve"},
              {"scheme", schemeName(subdivision.scheme)},
              {"points", std::move(points)},
              {"closed", subdivision.closed},
              {"levels", static_cast<double>(subdivision.levels)}};
    if (subdivision.scheme == CurveScheme::laneRiesenfeld) {
        spec["degree"] = static_cast<double>(subdivision.degree);
    } else if (subdivision.scheme == CurveScheme::fourPoint) {
        spec["tension"] = subdivision.tension;
    }
    return spec;
}

}  // namespace knotwork::scene
