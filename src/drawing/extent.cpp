#include "drawing/extent.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

constexpr std::size_t samples = 65;
constexpr std::size_t surfaceSamples = 17;  // each way

void addPoints(Bounds& bounds, std::span<const Vec3> points, const Affine& placement) {
    for (const Vec3& p : points) bounds.add(placement.point(p));
}

void addSurface(Bounds& bounds, const Surface& surface, const Affine& placement) {
    const auto [u, v] = domain(surface);
    for (std::size_t i = 0; i < surfaceSamples; ++i) {
        for (std::size_t j = 0; j < surfaceSamples; ++j) {
            const SurfacePlace at{uniformParameter(u, i, surfaceSamples),
                                  uniformParameter(v, j, surfaceSamples)};
            const Vec3 p = placement.point(pointAt(surface, at));
            if (isFinite(p)) bounds.add(p);
        }
    }
}

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
        const scene::Body& body = placed.body;
        if (body.curve() != nullptr) addCurve(bounds, *body.curve(), placed.placement);
        if (body.surface() != nullptr) addSurface(bounds, *body.surface(), placed.placement);
        if (body.subdivision() != nullptr) {
            addPoints(bounds, body.subdivision()->control.points(), placed.placement);
        }
        if (const auto* graph = body.graph()) {
            bounds.add(placed.placement.point(graph->at));
            bounds.add(placed.placement.point(graph->at + graph->size * Vec3(1, 1, 0)));
        }
        if (body.cloud() != nullptr) addPoints(bounds, body.cloud()->points, placed.placement);
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
