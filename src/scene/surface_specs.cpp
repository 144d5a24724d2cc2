#include "scene/surface_specs.hpp"

#include "scene/json_values.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/surface_builders.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace knotwork::scene {

namespace {

struct Builder {
    std::string_view type;
    Result<Surface> (*build)(Json& spec);
};

/// One for every type of surfaceTypes().
constexpr std::array builders{
    Builder{"bspline-surface", buildBsplineSurface},
    Builder{"parametric-surface", buildParametricSurface},
    Builder{"blending-surface", buildBlendingSurface},
};

/// The keys in the order of the tables: what was computed stands last until then.
Json inOrder(const Json& spec) {
    Json ordered = Json::object();
    const std::string type = stringOr(spec, "type", "");
    ordered["type"] = type;
    for (const Field& field : findSurfaceType(type)->fields) {
        if (const Json* value = member(spec, field.name)) ordered[std::string(field.name)] = *value;
    }
    return ordered;
}

}  // namespace

Result<Surface> buildSurface(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    const auto builder = std::find_if(builders.begin(), builders.end(),
                                      [&](const Builder& b) { return b.type == type; });
    auto made = builder->build(spec);
    if (made) spec = inOrder(spec);
    return made;
}

Result<Made<Surface>> makeSurface(const Json& spec) {
    auto canonical = readSurface(spec);
    if (!canonical) return canonical.error();
    auto made = buildSurface(*canonical);
    if (!made) return made.error();
    return Made<Surface>{std::move(*canonical), std::move(*made)};
}

Json specOf(const Surface& surface) {
    if (const auto* parametric = surface.as<ParametricSurface>()) return specOf(*parametric);
    if (const auto* blending = surface.as<BlendingSurface>()) return specOf(*blending);
    return specOf(*surface.as<BsplineSurface>());
}

Json describeParametricSurfaces() {
    Json list = Json::array();
    for (const SurfaceModelDescription& model : surfaceModels()) {
        const ClosedDirections closed = ParametricSurface::make(model.name)->closed();
        list.push_back({{"name", model.name},
                        {"label", model.label},
                        {"formula", model.formula},
                        {"closed", Json::array({closed.u, closed.v})},
                        {"parameters", describeParameters(model.parameters)}});
    }
    return list;
}

}  // namespace knotwork::scene
