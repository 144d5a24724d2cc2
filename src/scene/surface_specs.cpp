#include "scene/surface_specs.hpp"

#include "geometry/named.hpp"
#include "scene/json_values.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/spec_builders.hpp"
#include "scene/surface_builders.hpp"
#include "scene/validation.hpp"

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
    Builder{"blending-triangle", buildBlendingTriangle},
};

}  // namespace

Result<Surface> buildSurface(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    auto made = findNamed(builders, &Builder::type, type)->build(spec);
    if (made) spec = inOrder(std::move(spec), findSurfaceType(type)->fields);
    return made;
}

Result<Made<Surface>> makeSurface(const Json& spec) {
    auto canonical = readSurface(spec, objectFields());
    if (!canonical) return canonical.error();
    for (const Field& field : objectFields()) canonical->erase(std::string(field.name));
    auto made = buildSurface(*canonical);
    if (!made) return made.error();
    return Made<Surface>{std::move(*canonical), std::move(*made)};
}

Json specOf(const Surface& surface) {
    if (const auto* parametric = surface.as<ParametricSurface>()) return specOf(*parametric);
    if (const auto* blending = surface.as<BlendingSurface>()) return specOf(*blending);
    if (const auto* triangle = surface.as<BlendingTriangle>()) return specOf(*triangle);
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
