// The builder of blending triangles, and the way back.
#include "geometry/surface.hpp"
#include "scene/json_values.hpp"
#include "scene/spec_builders.hpp"
#include "scene/surface_builders.hpp"
#include "scene/surface_specs.hpp"

#include <utility>

namespace knotwork::scene {

namespace {

Result<TriangleBlend> triangleBlendOf(Json& spec) {
    TriangleBlend blend;
    const Json* order = member(spec, "order");
    const Json* function = member(spec, "bFunction");
    if (order != nullptr && function != nullptr) {
        return refuse(Code::notSupported, "order",
                      "A B-function has an order of its own; leave `order` or `bFunction` out.");
    }
    if (function != nullptr) {
        auto made = buildBFunction(*function);
        if (!made) return made.error().under("bFunction");
        blend.blend = std::move(*made);
        return blend;
    }
    if (order != nullptr) blend.order = static_cast<int>(order->get<double>());
    spec["order"] = static_cast<double>(blend.order);
    return blend;
}

/// Local patch k; its specification is completed.
Result<Surface> localOf(Json& locals, std::size_t k) {
    Json completed = locals[k];
    auto made = buildSurface(completed);
    if (!made) return made.error().under(indexed("locals", k));
    locals[k] = std::move(completed);
    return made;
}

}  // namespace

Result<Surface> buildBlendingTriangle(Json& spec) {
    auto blend = triangleBlendOf(spec);
    if (!blend) return blend.error();
    Json& locals = spec["locals"];
    auto first = localOf(locals, 0);
    if (!first) return first.error();
    auto second = localOf(locals, 1);
    if (!second) return second.error();
    auto third = localOf(locals, 2);
    if (!third) return third.error();
    auto made = BlendingTriangle::make({*first, *second, *third}, std::move(*blend));
    if (!made) return made.error();
    return Surface(std::move(*made));
}

Json specOf(const BlendingTriangle& triangle) {
    Json locals = Json::array();
    for (std::size_t k = 0; k < 3; ++k) locals.push_back(specOf(triangle.local(k)));
    Json spec{{"type", "blending-triangle"}, {"locals", std::move(locals)}};
    const TriangleBlend& blend = triangle.blend();
    if (blend.blend) {
        spec["bFunction"] = specOf(*blend.blend);
    } else {
        spec["order"] = static_cast<double>(blend.order);
    }
    return spec;
}

}  // namespace knotwork::scene
