#include "app/picture.hpp"

#include "drawing/extent.hpp"
#include "drawing/measures.hpp"
#include "geometry/curve_sphere.hpp"

#include <array>
#include <cmath>

namespace knotwork::app {

namespace {

constexpr double invisible = 0.15;  // device pixels
constexpr int momentsOfLoop = 12;
constexpr std::size_t samplesOfCurve = 600;  // enough for the butterfly's six turns
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

void addSphereOf(drawing::Bounds& bounds, std::span<const Vec3> points, const Affine& placement) {
    const auto sphere = enclosingSphere(points);
    if (sphere) drawing::addSphere(bounds, *sphere, drawing::isFlat(points), placement);
}

/// Bodies that are no curves, with what they are made from where that is shown.
void addOther(drawing::Bounds& bounds, const scene::Placed& placed) {
    const scene::Show& show = placed.object->show;
    const Affine& placement = placed.placement;
    if (const Surface* surface = placed.body.surface()) {
        drawing::addSurface(bounds, *surface, placement, samplesOfSurface);
        const auto* spline = surface->as<BsplineSurface>();
        if (spline != nullptr && (show.polygon || show.points)) {
            drawing::addPoints(bounds, spline->points(), placement);
        }
    }
    if (const auto* mesh = placed.body.subdivision()) {
        drawing::addPoints(bounds, mesh->refined.points(), placement);
        if (show.polygon || show.points) {
            drawing::addPoints(bounds, mesh->control.points(), placement);
        }
    }
    if (const auto* graph = placed.body.graph()) drawing::addGraph(bounds, *graph, placement);
    if (const auto* cloud = placed.body.cloud()) {
        drawing::addPoints(bounds, cloud->points, placement);
        if (cloud->fit) drawing::addCurve(bounds, cloud->fit->curve, placement, samplesOfCurve);
        if (show.sphere) addSphereOf(bounds, cloud->points, placement);
    }
}

void addPlaced(drawing::Bounds& bounds, const scene::Placed& placed) {
    const Curve* curve = placed.body.curve();
    if (curve == nullptr) return addOther(bounds, placed);
    drawing::addCurve(bounds, *curve, placed.placement, samplesOfCurve);
    const auto* blend = placed.body.as<BlendingCurve>();
    if (blend != nullptr && placed.object->show.locals) addLocals(bounds, placed, *blend);
    if (placed.object->show.sphere) {
        drawing::addSphere(bounds, enclosingSphere(*curve), dimension(*curve) == 2,
                           placed.placement);
    }
    if (const auto& line = placed.object->line; line && placed.object->show.crossings) {
        drawing::addPoints(bounds, std::array{line->point, line->point + line->direction},
                           placed.placement);
    }
    if (!placed.object->show.polygon && !placed.object->show.points) return;
    drawing::addPoints(bounds, drawing::controlPolygon(*curve).points, placed.placement);
}

}  // namespace

double toleranceAt(double devicePixelsPerUnit) noexcept {
    const double exact = invisible / devicePixelsPerUnit;
    return std::isfinite(exact) && exact > 0 ? std::exp2(std::floor(std::log2(exact))) : 1e-3;
}

double pixelAt(double tolerance) noexcept { return tolerance / invisible; }

drawing::Bounds loopBounds(const scene::State& state, const drawing::Orientation& orientation) {
    drawing::Bounds bounds;
    const int moments = state.effects.empty() ? 1 : momentsOfLoop;
    for (int k = 0; k < moments; ++k) {
        const double phase = static_cast<double>(k) / momentsOfLoop;
        for (scene::Placed& placed : scene::place(state, {phase, std::nullopt})) {
            placed.placement = compose({orientation, Vec3(0.0)}, placed.placement);
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
