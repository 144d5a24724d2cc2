#include "app/picture.hpp"

#include <cmath>

namespace knotwork::app {

namespace {

constexpr double invisible = 0.15;      // device pixels
constexpr int momentsOfLoop = 12;
constexpr std::size_t samples = 600;    // enough for the butterfly's six turns
constexpr std::size_t samplesOfLocal = 32;
constexpr std::size_t samplesOfSurface = 25;  // in either direction

void addLocals(drawing::Bounds& bounds, const scene::Placed& placed, const BlendingCurve& blend) {
    for (std::size_t j = 0; j < blend.locals().size(); ++j) {
        const Interval support = blend.support(j);
        for (std::size_t i = 0; i < samplesOfLocal; ++i) {
            const double t = uniformParameter(support, i, samplesOfLocal);
            bounds.add(placed.placement.point(blend.locals()[j].point(t)));
        }
    }
}

void addCurve(drawing::Bounds& bounds, const Affine& placement, const Curve& curve) {
    const Interval whole = domain(curve);
    for (std::size_t i = 0; i < samples; ++i) {
        bounds.add(placement.point(pointAt(curve, uniformParameter(whole, i, samples))));
    }
}

void addPoints(drawing::Bounds& bounds, const Affine& placement, std::span<const Vec3> points) {
    for (const Vec3& p : points) bounds.add(placement.point(p));
}

void addSurface(drawing::Bounds& bounds, const Affine& placement, const Surface& surface) {
    const Rectangle whole = domain(surface);
    for (std::size_t i = 0; i < samplesOfSurface; ++i) {
        for (std::size_t j = 0; j < samplesOfSurface; ++j) {
            bounds.add(placement.point(
                pointAt(surface, {uniformParameter(whole.u, i, samplesOfSurface),
                                  uniformParameter(whole.v, j, samplesOfSurface), Side::right,
                                  Side::right})));
        }
    }
}

/// Bodies that are no curves, with what they are made from where that is shown.
void addOther(drawing::Bounds& bounds, const scene::Placed& placed) {
    const scene::Show& show = placed.object->show;
    if (const Surface* surface = placed.body.surface()) {
        addSurface(bounds, placed.placement, *surface);
        const auto* spline = surface->as<BsplineSurface>();
        if (spline != nullptr && (show.polygon || show.points)) {
            addPoints(bounds, placed.placement, spline->points());
        }
    }
    if (const auto* mesh = placed.body.subdivision()) {
        addPoints(bounds, placed.placement, mesh->refined.points());
        if (show.polygon || show.points) {
            addPoints(bounds, placed.placement, mesh->control.points());
        }
    }
    if (const auto* graph = placed.body.graph()) {
        bounds.add(placed.placement.point(graph->at));
        bounds.add(placed.placement.point(graph->at + graph->size * Vec3(1, 1, 0)));
    }
    if (const auto* cloud = placed.body.cloud()) {
        addPoints(bounds, placed.placement, cloud->points);
        if (cloud->fit) addCurve(bounds, placed.placement, cloud->fit->curve);
    }
}

void addPlaced(drawing::Bounds& bounds, const scene::Placed& placed) {
    const Curve* curve = placed.body.curve();
    if (curve == nullptr) return addOther(bounds, placed);
    addCurve(bounds, placed.placement, *curve);
    const auto* blend = placed.body.as<BlendingCurve>();
    if (blend != nullptr && placed.object->show.locals) addLocals(bounds, placed, *blend);
    if (!placed.object->show.polygon && !placed.object->show.points) return;
    addPoints(bounds, placed.placement, drawing::controlPolygon(*curve).points);
}

}  // namespace

double toleranceAt(double devicePixelsPerUnit) noexcept {
    const double exact = invisible / devicePixelsPerUnit;
    return std::isfinite(exact) && exact > 0 ? std::exp2(std::floor(std::log2(exact))) : 1e-3;
}

double pixelAt(double tolerance) noexcept { return tolerance / invisible; }

drawing::Bounds loopBounds(const scene::State& state) {
    drawing::Bounds bounds;
    const int moments = state.effects.empty() ? 1 : momentsOfLoop;
    for (int k = 0; k < moments; ++k) {
        const double phase = static_cast<double>(k) / momentsOfLoop;
        for (const scene::Placed& placed : scene::place(state, {phase, std::nullopt})) {
            addPlaced(bounds, placed);
        }
    }
    return bounds;
}

const drawing::Drawing& Picture::get(const scene::State& state, const Key& key,
                                     const scene::Moment& moment) {
    if (key_ != key) {
        drawing::Options options{moment, key.tolerance, key.dark, key.panes};
        options.pixel = key.pixel;
        drawings_.draw(state, options);
        key_ = key;
        ++made_;
    }
    return drawings_.drawing();
}

}  // namespace knotwork::app
