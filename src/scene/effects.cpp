#include "scene/effects.hpp"

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

/// `pose` with a further turn and move, the turn about its own axis.
Pose moved(const Pose& pose, const Vec3& by, const Vec3& axis, double angle) {
    Pose next = pose;
    next.translate += by;
    if (angle == 0) return next;
    if (pose.angle == 0) {
        next.axis = axis;
        next.angle = angle;
        return next;
    }
    // Two turns about different axes make one: read axis and angle off the product matrix.
    const Mat3 turn = rotation(axis, angle) * rotation(pose.axis, pose.angle);
    const Vec3 twice(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]);
    const double trace = turn[0][0] + turn[1][1] + turn[2][2];
    const double sine = glm::length(twice) / 2;
    next.angle = std::atan2(sine, (trace - 1) / 2);
    next.axis = sine > 0 ? twice : axis;
    return next;
}

/// Every local curve by its own translation and rotation, `weight` of the way.
Body simulated(const Body& body, const Effect& effect, double weight) {
    const auto& blend = *body.as<BlendingCurve>();
    std::vector<Pose> poses;
    poses.reserve(blend.locals().size());
    Random random(effect.seed);
    for (const LocalCurve& local : blend.locals()) {
        const Vec3 share(random.next(), random.next(), random.next());
        const double angle = random.next() * effect.angle;
        poses.push_back(moved(local.pose(), weight * share * effect.translate, effect.axis,
                              weight * angle));
    }
    return Curve(blend.withPoses(poses));
}

void apply(const Effect& effect, double weight, Placed& placed) {
    switch (effect.kind) {
        case EffectKind::translate:
            placed.placement.offset += weight * effect.translate;
            break;
        case EffectKind::rotate:
            placed.placement =
                compose({rotation(effect.axis, weight * effect.angle), Vec3(0.0)}, placed.placement);
            break;
        case EffectKind::simulate:
            placed.body = simulated(placed.body, effect, weight);
            break;
        case EffectKind::colour:
            placed.colour = mixColours(placed.colour, effect.to, weight);
            break;
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
