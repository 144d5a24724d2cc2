#include "scene/surface_knot_edits.hpp"

#include "geometry/bspline_surface_knots.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_parts.hpp"
#include "scene/surface_specs.hpp"

#include <utility>

namespace knotwork::scene {

namespace {

/// The surface with another net and other knots, and with all that it has besides.
Result<Json> withNetOf(const Json& surface, const Result<BsplineSurface>& net) {
    if (!net) return net.error();
    return withShape(surface, specOf(Surface(*net)));
}

/// Poses of local patches from line `first` on move by `step`; those of line `gone` go.
void renumberPoses(Json& surface, std::size_t direction, double first, double step, double gone) {
    Json* poses = member(surface, "poses");
    if (poses == nullptr) return;
    Json kept = Json::array();
    for (Json& pose : *poses) {
        Json& line = pose["local"][direction];
        const double number = line.get<double>();
        if (number == gone) continue;
        if (number >= first) line = number + step;
        kept.push_back(std::move(pose));
    }
    *poses = std::move(kept);
}

constexpr double none = -1;

Result<Json> withPatchesAt(const Json& surface, const BlendDirection& along, std::size_t direction,
                           double at) {
    const auto inserted = withKnotInside(along.knots, at);
    if (!inserted) return inserted.error();
    Json changed = surface;
    changed["knots"][direction] = listOf(inserted->knots);
    changed["locals"][direction] = static_cast<double>(along.count + 1);
    renumberPoses(changed, direction, static_cast<double>(inserted->index), 1, none);
    return changed;
}

Result<Json> withoutPatchesAt(const Json& surface, const BlendDirection& along,
                              std::size_t direction, std::size_t index) {
    const auto removable = checkRemovable(along.closed(), index, along.knots.size());
    if (!removable) return removable.error();
    Json changed = surface;
    changed["knots"][direction].erase(index);
    changed["locals"][direction] = static_cast<double>(along.count) - 1;
    const auto gone = static_cast<double>(index);
    renumberPoses(changed, direction, gone, -1, gone);
    return changed;
}

const BlendDirection& directionOf(const BlendingSurface& blend, std::size_t direction) noexcept {
    return direction == 0 ? blend.alongU() : blend.alongV();
}

}  // namespace

Result<Json> withKnotAlong(const Json& surface, std::size_t direction, double at) {
    const auto made = makeSurface(surface);
    if (!made) return made.error();
    if (const auto* spline = made->value.as<BsplineSurface>()) {
        return withNetOf(surface, insertKnot(*spline, direction, at));
    }
    if (const auto* blend = made->value.as<BlendingSurface>()) {
        return withPatchesAt(surface, directionOf(*blend, direction), direction, at);
    }
    return refuse(Code::notSupported, "", "Surfaces of this type have no knots.");
}

Result<Json> withoutKnotAlong(const Json& surface, std::size_t direction, std::size_t index) {
    const auto made = makeSurface(surface);
    if (!made) return made.error();
    if (const auto* spline = made->value.as<BsplineSurface>()) {
        const double knot = (*member(surface, "knots"))[direction][index].get<double>();
        return withNetOf(surface, removeKnot(*spline, direction, knot));
    }
    const auto& blend = *made->value.as<BlendingSurface>();
    return withoutPatchesAt(surface, directionOf(blend, direction), direction, index);
}

}  // namespace knotwork::scene
