#include "app/picture.hpp"

#include <cmath>

namespace knotwork::app {

namespace {

constexpr double invisible = 0.15;      // device pixels
constexpr int momentsOfLoop = 12;
constexpr std::size_t samples = 600;    // enough for the butterfly's six turns
constexpr std::size_t samplesOfLocal = 32;

void addLocals(drawing::Bounds& bounds, const scene::Placed& placed, const BlendingCurve& blend) {
    for (std::size_t j = 0; j < blend.locals().size(); ++j) {
        const Interval support = blend.support(j);
        for (std::size_t i = 0; i < samplesOfLocal; ++i) {
            const double t = uniformParameter(support, i, samplesOfLocal);
            bounds.add(placed.placement.point(blend.locals()[j].point(t)));
        }
    }
}

void addPlaced(drawing::Bounds& bounds, const scene::Placed& placed) {
    const Curve* curve = placed.body.curve();
    if (curve == nullptr) return;
    const Interval whole = domain(*curve);
    for (std::size_t i = 0; i < samples; ++i) {
        bounds.add(placed.placement.point(pointAt(*curve, uniformParameter(whole, i, samples))));
    }
    const auto* blend = placed.body.as<BlendingCurve>();
    if (blend != nullptr && placed.object->show.locals) addLocals(bounds, placed, *blend);
    if (!placed.object->show.polygon && !placed.object->show.points) return;
    for (const Vec3& p : drawing::controlPolygon(*curve).points) {
        bounds.add(placed.placement.point(p));
    }
}

}  // namespace

double toleranceAt(double devicePixelsPerUnit) noexcept {
    const double exact = invisible / devicePixelsPerUnit;
    return std::isfinite(exact) && exact > 0 ? std::exp2(std::floor(std::log2(exact))) : 1e-3;
}

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
        drawing_ = drawing::draw(state, {moment, key.tolerance, key.dark});
        key_ = key;
        ++made_;
    }
    return drawing_;
}

}  // namespace knotwork::app
