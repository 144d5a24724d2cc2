#include "drawing/extent.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

constexpr std::size_t samples = 65;

void addCurve(Bounds& bounds, const Curve& curve, const Affine& placement) {
    const Interval whole = domain(curve);
    for (std::size_t i = 0; i < samples; ++i) {
        const Vec3 p = placement.point(pointAt(curve, uniformParameter(whole, i, samples)));
        if (isFinite(p)) bounds.add(p);
    }
}

}  // namespace

Bounds roughBounds(const scene::State& state, const scene::Moment& moment) {
    Bounds bounds;
    for (const scene::Placed& placed : scene::place(state, moment)) {
        addCurve(bounds, placed.curve, placed.placement);
    }
    return bounds;
}

double roughSize(const scene::State& state, const scene::Moment& moment) {
    const Bounds bounds = roughBounds(state, moment);
    const Vec3 size = bounds.max - bounds.min;
    const double longest = std::max({size.x, size.y, size.z});
    return longest > 0 ? longest : 1;
}

}  // namespace knotwork::drawing
