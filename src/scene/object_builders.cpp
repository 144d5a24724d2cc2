#include "scene/object_builders.hpp"

#include "geometry/named.hpp"
#include "scene/counted_line.hpp"
#include "scene/fit_specs.hpp"
#include "scene/json_values.hpp"
#include "scene/mesh_specs.hpp"
#include "scene/mesh_stencils.hpp"
#include "scene/spec_builders.hpp"
#include "scene/surface_builders.hpp"
#include "scene/validation.hpp"

#include <utility>

namespace knotwork::scene {

namespace {

Result<Body> buildSubdivisionSurface(Json& spec) {
    auto control = makeMesh(*member(spec, "mesh"));
    if (!control) return control.error().under("mesh");
    spec["mesh"] = std::move(control->spec);
    const MeshScheme scheme = *meshSchemeNamed(stringOr(spec, "scheme", ""));
    const auto levels = static_cast<int>(numberOr(spec, "levels", 0));
    auto refined = subdivide(control->value, scheme, levels);
    if (!refined) {
        const Error& error = refined.error();
        const bool own = error.path == "levels" || error.path == "scheme";
        return own ? error : error.under("mesh");
    }
    SubdivisionSurface surface{scheme, levels, std::move(control->value), std::move(*refined)};
    if (const auto shown = stencilOf(spec, surface); !shown) return shown.error();
    return Body(std::move(surface));
}

Result<std::optional<Fit>> buildFit(const Json& spec, std::span<const Vec3> points) {
    const Json* asked = member(spec, "fit");
    if (asked == nullptr) return std::optional<Fit>();
    auto fit = fitCurve(points, fitRequestOf(*asked));
    if (fit) return std::optional(std::move(*fit));
    const Error& error = fit.error();
    return error.path.starts_with("points") ? error : error.under("fit");
}

Result<Body> buildPointCloud(Json& spec) {
    PointCloud cloud;
    const Json& list = *member(spec, "points");
    cloud.points.reserve(list.size());
    for (const Json& point : list) cloud.points.push_back(vec3Of(point));
    auto fit = buildFit(spec, cloud.points);
    if (!fit) return fit.error();
    cloud.fit = std::move(*fit);
    return Body(std::move(cloud));
}

Result<Body> buildGraph(Json& spec) {
    auto candidate = makeCandidate(*member(spec, "bFunction"));
    if (!candidate) return candidate.error().under("bFunction");
    spec["bFunction"] = std::move(candidate->spec);
    return Body(FunctionGraph{std::move(candidate->value), vec3Of(*member(spec, "at")),
                              numberOr(spec, "size", 1)});
}

/// What stands in the style and the show of an object, with the defaults of what does not.
Result<Done> fillGroup(Json& spec, std::string_view group) {
    const Field* field = findNamed(objectFields(), &Field::name, group);
    const Json* given = member(spec, group);
    auto filled = readGroup(given != nullptr ? *given : Json::object(), field->fields.all());
    if (!filled) return filled.error().under(group);
    spec[std::string(group)] = std::move(*filled);
    return Done{};
}

Result<Body> buildBody(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    if (findCurveType(type) != nullptr) {
        auto curve = buildCurve(spec);
        if (!curve) return curve.error();
        return Body(std::move(*curve));
    }
    if (findSurfaceType(type) != nullptr) {
        auto surface = buildSurface(spec);
        if (!surface) return surface.error();
        return Body(std::move(*surface));
    }
    auto body = type == "point-cloud"  ? buildPointCloud(spec)
                : type == "b-function" ? buildGraph(spec)
                                       : buildSubdivisionSurface(spec);
    if (body) spec = inOrder(std::move(spec), findObjectType(type)->fields);
    return body;
}

}  // namespace

Result<Made<Body>> makeObject(const Json& spec) {
    auto canonical = readObjectSpec(spec);
    if (!canonical) return canonical.error();
    for (const std::string_view group : {"style", "show"}) {
        if (const auto filled = fillGroup(*canonical, group); !filled) return filled.error();
    }
    auto made = buildBody(*canonical);
    if (!made) return made.error();
    fillLine(*canonical, *made);
    return Made<Body>{std::move(*canonical), std::move(*made)};
}

Result<Made<Body>> remakeObject(Json spec) {
    auto made = buildBody(spec);
    if (!made) return made.error();
    return Made<Body>{std::move(spec), std::move(*made)};
}

std::string_view objectTypeLabel(const Json& spec) noexcept {
    const ObjectType* type = findObjectType(stringOr(spec, "type", ""));
    return type != nullptr ? type->label : std::string_view();
}

}  // namespace knotwork::scene
