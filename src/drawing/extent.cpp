#include "drawing/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knotwork::drawing {

namespace {

constexpr std::size_t samplesOfCurve = 65;
constexpr std::size_t samplesOfSurface = 17;  // each way

void addFinite(Bounds& bounds, const Vec3& p) noexcept {
    if (isFinite(p)) bounds.add(p);
}

}  // namespace

void addPoints(Bounds& bounds, std::span<const Vec3> points, const Affine& placement) {
    for (const Vec3& p : points) addFinite(bounds, placement.point(p));
}

void addCurve(Bounds& bounds, const Curve& curve, const Affine& placement, std::size_t samples) {
    const Interval whole = domain(curve);
    for (std::size_t i = 0; i < samples; ++i) {
        addFinite(bounds, placement.point(pointAt(curve, uniformParameter(whole, i, samples))));
    }
}

void addSurface(Bounds& bounds, const Surface& surface, const Affine& placement,
                std::size_t samples) {
    const auto [u, v] = domain(surface);
    for (std::size_t i = 0; i < samples; ++i) {
        for (std::size_t j = 0; j < samples; ++j) {
            const SurfacePlace at{uniformParameter(u, i, samples), uniformParameter(v, j, samples)};
            addFinite(bounds, placement.point(pointAt(surface, at)));
        }
    }
}

void addSphere(Bounds& bounds, const Sphere& sphere, bool inPlane, const Affine& placement) {
    constexpr std::size_t corners = 64;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / corners;
        const double x = sphere.radius * std::cos(angle);
        const double y = sphere.radius * std::sin(angle);
        const std::array<Vec3, 3> round{sphere.center + Vec3(x, y, 0), sphere.center + Vec3(0, x, y),
                                        sphere.center + Vec3(y, 0, x)};
        addPoints(bounds, std::span(round).first(inPlane ? 1 : 3), placement);
    }
}

void addGraph(Bounds& bounds, const scene::FunctionGraph& graph, const Affine& placement) {
    bounds.add(placement.point(graph.at));
    bounds.add(placement.point(graph.at + graph.size * Vec3(1, 1, 0)));
}

Bounds roughBounds(const scene::State& state, const scene::Moment& moment) {
    Bounds bounds;
    for (const scene::Placed& placed : scene::place(state, moment)) {
        const scene::Body& body = placed.body;
        const Affine& placement = placed.placement;
        if (const Curve* curve = body.curve()) addCurve(bounds, *curve, placement, samplesOfCurve);
        if (const Surface* surface = body.surface()) {
            addSurface(bounds, *surface, placement, samplesOfSurface);
        }
        if (body.subdivision() != nullptr) {
            addPoints(bounds, body.subdivision()->control.points(), placement);
        }
        if (body.graph() != nullptr) addGraph(bounds, *body.graph(), placement);
        if (body.cloud() != nullptr) addPoints(bounds, body.cloud()->points, placement);
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
