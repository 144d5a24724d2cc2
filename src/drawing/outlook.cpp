#include "drawing/outlook.hpp"

#include "scene/json_values.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

constexpr double leastDepth = 1e-9;  // of the extent: rounding of turns makes no depth

}  // namespace

bool hasDepth(const Bounds& bounds) noexcept {
    if (bounds.empty) return false;
    const Vec3 size = bounds.max - bounds.min;
    return size.z > leastDepth * std::max({size.x, size.y, size.z});
}

Outlook outlookOf(const scene::State& state, const Bounds& bounds) {
    Outlook outlook;
    outlook.spatial = hasDepth(bounds);
    const scene::Json* view = state.header ? scene::member(*state.header, "view") : nullptr;
    if (view == nullptr) return outlook;
    outlook.spatial = outlook.spatial || scene::stringOr(*view, "mode", "") == "3d";
    const scene::Json* camera = scene::member(*view, "camera");
    if (camera == nullptr) return outlook;
    outlook.azimuth = scene::numberOr(*camera, "azimuth", usualAzimuth);
    outlook.elevation = scene::numberOr(*camera, "elevation", usualElevation);
    outlook.height = scene::numberOr(*camera, "height", 0);
    const scene::Json* centre = scene::member(*camera, "center");
    if (centre != nullptr && centre->is_array()) outlook.centre = scene::vec3Of(*centre);
    return outlook;
}

}  // namespace knotwork::drawing
