#include "scene/effects.hpp"

#include "geometry/turns.hpp"

#include <cmath>
#include <cstdint>

namespace knotwork::scene {

namespace {

/// SplitMix64 (Steele, Lea, Flood, 2014): the same dance from the same seed everywhere.
class Random {
public:
    explicit Random(double seed) : state_(static_cast<std::uint64_t>(seed)) {}

    /// Uniform in [−1, 1).
    double next() noexcept {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        z ^= z >> 31U;
        return std::ldexp(static_cast<double>(z >> 11U), -52) - 1;
    }

private:
    std::uint64_t state_;
};

/// How far an effect has gone with one local curve or patch.
struct Step {
    Vec3 by{0.0};
    Turn turn;
    Vec3 factor{1.0};
};

/// `pose` with a further step, its turn and scaling about the local's own origin.
Pose moved(const Pose& pose, const Step& step) {
    const Turn turn = compose(step.turn, {pose.axis, pose.angle});
    Pose next = pose;
    next.translate += step.by;
    next.axis = turn.axis;
    next.angle = turn.angle;
    next.scale *= step.factor;
    return next;
}

std::vector<Pose> posesOf(const Body& body) {
    std::vector<Pose> poses;
    if (const auto* blend = body.as<BlendingCurve>()) {
        for (const LocalCurve& local : blend->locals()) poses.push_back(local.pose());
    } else if (const auto* surface = body.as<BlendingSurface>()) {
        for (std::size_t i = 0; i < surface->alongU().count; ++i) {
            for (std::size_t j = 0; j < surface->alongV().count; ++j) {
                poses.push_back(surface->place(i, j).pose());
            }
        }
    }
    return poses;
}

Body withPoses(const Body& body, std::span<const Pose> poses) {
    if (const auto* blend = body.as<BlendingCurve>()) return Curve(blend->withPoses(poses));
    return Surface(body.as<BlendingSurface>()->withPoses(poses));
}

/// Every local by its own translation and rotation, `weight` of the way.
Body simulated(const Body& body, const Effect& effect, double weight) {
    std::vector<Pose> poses = posesOf(body);
    Random random(effect.seed);
    for (Pose& pose : poses) {
        const Vec3 share(random.next(), random.next(), random.next());
        const double angle = random.next() * effect.angle;
        pose = moved(pose, {weight * share * effect.translate, {effect.axis, weight * angle}});
    }
    return withPoses(body, poses);
}

/// `map` about another point than the origin.
Affine about(const Vec3& center, const Mat3& map) { return {map, center - map * center}; }

Mat3 scaling(const Vec3& factors) {
    Mat3 map(1.0);
    for (int k = 0; k < 3; ++k) map[k][k] = factors[k];
    return map;
}

/// A translation, a turn or a scaling of the whole object or of one local.
void move(const Effect& effect, double weight, Placed& placed) {
    const Step step{weight * effect.translate, {effect.axis, weight * effect.angle},
                    Vec3(1.0) + weight * (effect.factor - Vec3(1.0))};
    if (effect.local) {
        std::vector<Pose> poses = posesOf(placed.body);
        poses[*effect.local] = moved(poses[*effect.local], step);
        placed.body = withPoses(placed.body, poses);
        return;
    }
    const Mat3 map = effect.kind == EffectKind::scale ? scaling(step.factor)
                                                      : rotation(step.turn.axis, step.turn.angle);
    if (effect.kind == EffectKind::translate) {
        placed.placement.offset += step.by;
    } else {
        placed.placement = compose(about(effect.center, map), placed.placement);
    }
}

void apply(const Effect& effect, double weight, Placed& placed) {
    switch (effect.kind) {
        case EffectKind::translate:
        case EffectKind::rotate:
        case EffectKind::scale: return move(effect, weight, placed);
        case EffectKind::simulate:
            placed.body = simulated(placed.body, effect, weight);
            return;
        case EffectKind::morph:
            placed.body = morphed(*placed.body.curve(), *effect.curve, weight);
            return;
        case EffectKind::colour: {
            Colour to = effect.to;
            to.alpha = placed.colour.alpha;
            placed.colour = mixColours(placed.colour, to, weight);
            return;
        }
    }
}

double phaseOf(const Effect& effect, const Moment& moment) noexcept {
    if (moment.phase) return *moment.phase;
    return moment.time ? phaseAt(*moment.time, effect.period) : 0;
}

}  // namespace

double effectWeight(const BFunction& easing, double phase) noexcept {
    const double wrapped = phase - std::floor(phase);
    return easing.value(wrapped <= 0.5 ? 2 * wrapped : 2 * (1 - wrapped));
}

double phaseAt(double time, double period) noexcept {
    const double turns = time / period;
    const double phase = turns - std::floor(turns);
    return phase < 1 ? phase : 0;  // a tiny negative time rounds up to 1
}

std::vector<Placed> place(const State& state, const Moment& moment) {
    std::vector<Placed> all;
    all.reserve(state.objects.size());
    for (const auto& object : state.objects) {
        Placed placed{object.get(), object->body, {}, object->style.colour};
        for (const auto& effect : state.effects) {
            if (effect->target != object->id) continue;
            const double weight = effectWeight(effect->easing, phaseOf(*effect, moment));
            if (weight != 0) apply(*effect, weight, placed);
        }
        all.push_back(std::move(placed));
    }
    return all;
}

}  // namespace knotwork::scene
