#include "app/effect_handles.hpp"

#include "app/target.hpp"
#include "drawing/extent.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

namespace knotwork::app {

namespace {

using Kind = EffectHandle::Kind;
using drawing::Shape;

constexpr std::size_t samples = 65;
constexpr std::size_t samplesOfSurface = 9;  // either way
constexpr std::size_t arcPoints = 65;
constexpr double armOfObject = 0.6;   // of its half diagonal
constexpr double armOfLocal = 0.3;
constexpr double leastArm = 0.15;     // nearer to the centre than this, a start says no direction
constexpr double twoPi = 6.283185307179586;

/// What an effect moves, as it is at rest.
struct Rest {
    Vec3 middle{0.0};
    double size = 1;  ///< half its diagonal
};

Rest restOf(const scene::Body& body) {
    drawing::Bounds bounds;
    if (const Curve* curve = body.curve()) drawing::addCurve(bounds, *curve, {}, samples);
    if (const Surface* surface = body.surface()) {
        drawing::addSurface(bounds, *surface, {}, samplesOfSurface);
    }
    if (const auto* mesh = body.subdivision()) {
        drawing::addPoints(bounds, mesh->control.points(), {});
    }
    if (const auto* cloud = body.cloud()) drawing::addPoints(bounds, cloud->points, {});
    if (const auto* graph = body.graph()) drawing::addGraph(bounds, *graph, {});
    if (bounds.empty) return {};
    const Vec3 half = (bounds.max - bounds.min) / 2.0;
    return {bounds.min + half, std::max(glm::length(half), 1e-9)};
}

Vec3 across(const Vec3& axis) noexcept {
    const Vec3 helper = std::abs(axis.z) > 0.9 * glm::length(axis) ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    return glm::normalize(helper - axis * (glm::dot(helper, axis) / glm::dot(axis, axis)));
}

/// Makes the handles of one effect.
class Maker {
public:
    Maker(const scene::State& state, std::size_t effect, int object, bool inSpace,
          const NearLocal& near)
        : effect_(*state.effects[effect]), index_(effect), object_(object), inSpace_(inSpace) {
        const scene::Body& body = state.objects[static_cast<std::size_t>(object)]->body;
        rest_ = restOf(body);
        std::optional<std::size_t> local = effect_.local;
        if (effect_.kind == scene::EffectKind::simulate) local = near.object == object ? near.index : 0;
        const auto posed = local ? posedLocal(body, *local) : std::nullopt;
        ofLocal_ = posed.has_value();
        if (posed) rest_.middle = posed->origin + posed->pose.translate;
    }

    std::vector<EffectHandle> make() {
        switch (effect_.kind) {
            case scene::EffectKind::translate: way("by", effect_.translate); break;
            case scene::EffectKind::rotate: turn(); break;
            case scene::EffectKind::scale: scaling(); break;
            case scene::EffectKind::simulate:
                way("translate", effect_.translate);
                angle("rotate.angle", rest_.middle);
                break;
            default: break;
        }
        return std::move(handles_);
    }

private:
    EffectHandle& add(const char* field, Kind kind, const Vec3& at) {
        EffectHandle handle;
        handle.path = indexed("effects", index_) + "." + field;
        handle.effect = index_;
        handle.object = object_;
        handle.kind = kind;
        handle.at = at;
        handle.axis = effect_.axis;
        return handles_.emplace_back(std::move(handle));
    }

    [[nodiscard]] double arm() const noexcept {
        return rest_.size * (ofLocal_ ? armOfLocal : armOfObject);
    }
    [[nodiscard]] Vec3 centre() const noexcept { return ofLocal_ ? rest_.middle : effect_.center; }

    void way(const char* field, const Vec3& by) {
        EffectHandle& handle = add(field, Kind::vector, rest_.middle + by);
        handle.from = rest_.middle;
        handle.value = by;
    }

    void angle(const char* field, const Vec3& about) {
        const Vec3 unit = glm::normalize(effect_.axis);
        Vec3 out = rest_.middle - about;
        out -= unit * glm::dot(out, unit);
        if (glm::length(out) < leastArm * rest_.size) out = arm() * across(unit);
        EffectHandle& handle = add(field, Kind::angle,
                                   about + rotation(unit, effect_.angle) * out);
        handle.from = about;
        handle.start = about + out;
        handle.value.x = effect_.angle;
    }

    void place() {
        if (ofLocal_) return;
        EffectHandle& handle = add("center", Kind::place, effect_.center);
        handle.value = effect_.center;
    }

    void turn() {
        place();
        angle("angle", centre());
        if (!inSpace_) return;
        EffectHandle& handle = add("axis", Kind::axis,
                                   centre() + arm() * glm::normalize(effect_.axis));
        handle.from = centre();
        handle.value = effect_.axis;
    }

    void scaling() {
        place();
        const scene::Json* factor = scene::member(effect_.spec, "factor");
        if (factor == nullptr || !factor->is_number()) return;
        const Vec3 start = centre() + Vec3(arm(), 0, 0);
        EffectHandle& handle =
            add("factor", Kind::factor, centre() + effect_.factor.x * (start - centre()));
        handle.from = centre();
        handle.start = start;
        handle.value.x = effect_.factor.x;
    }

    const scene::Effect& effect_;
    std::size_t index_;
    int object_;
    bool inSpace_;
    bool ofLocal_ = false;
    Rest rest_;
    std::vector<EffectHandle> handles_;
};

int objectNamed(const scene::State& state, const std::string& id) noexcept {
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        if (state.objects[i]->id == id) return static_cast<int>(i);
    }
    return -1;
}

Shape lineOf(const scene::Colour& colour, std::initializer_list<Vec3> points, bool dashed) {
    Shape line;
    line.object = -1;
    line.role = drawing::Role::handle;
    line.colour = colour;
    line.width = 1.5F;
    line.dashed = dashed;
    for (const Vec3& p : points) line.positions.insert(line.positions.end(), {p.x, p.y, p.z});
    return line;
}

Shape arcOf(const EffectHandle& handle, const scene::Colour& colour) {
    Shape arc = lineOf(colour, {}, false);
    const double angle = std::clamp(handle.value.x, -twoPi, twoPi);
    for (std::size_t i = 0; i < arcPoints; ++i) {
        const double part = angle * static_cast<double>(i) / static_cast<double>(arcPoints - 1);
        const Vec3 p =
            handle.from + rotation(handle.axis, part) * (handle.start - handle.from);
        arc.positions.insert(arc.positions.end(), {p.x, p.y, p.z});
    }
    return arc;
}

/// As far as a dance may go: a rectangle, or the edges of a box.
Shape reachOf(const EffectHandle& handle, bool inSpace, const scene::Colour& colour) {
    Shape box = lineOf(colour, {}, true);
    const auto corner = [&](int k) {
        const Vec3 sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
        return handle.from + sign * handle.value;
    };
    const int corners = inSpace && handle.value.z != 0 ? 8 : 4;
    for (int k = 0; k < corners; ++k) {
        for (const int other : {k ^ 1, k ^ 2, k ^ 4}) {
            if (other < k || other >= corners) continue;
            for (const int end : {k, other}) {
                const Vec3 p = corner(end);
                box.indices.push_back(static_cast<std::uint32_t>(box.positions.size() / 3));
                box.positions.insert(box.positions.end(), {p.x, p.y, p.z});
            }
        }
    }
    return box;
}

}  // namespace

bool isNumber(const EffectHandle& handle) noexcept {
    return handle.kind == Kind::angle || handle.kind == Kind::factor;
}

std::vector<EffectHandle> effectHandles(const scene::State& state, bool inSpace,
                                        const NearLocal& near) {
    std::vector<EffectHandle> all;
    for (std::size_t i = 0; i < state.effects.size(); ++i) {
        const int object = objectNamed(state, state.effects[i]->target);
        if (object < 0) continue;
        std::vector<EffectHandle> some = Maker(state, i, object, inSpace, near).make();
        all.insert(all.end(), std::make_move_iterator(some.begin()),
                   std::make_move_iterator(some.end()));
    }
    return all;
}

std::vector<Shape> guidesOf(const EffectHandle& handle, bool inSpace,
                            const scene::Colour& colour) {
    switch (handle.kind) {
        case Kind::vector: {
            std::vector<Shape> guides{lineOf(colour, {handle.from, handle.at}, false)};
            const bool dance = handle.path.ends_with(".translate");
            if (dance) guides.push_back(reachOf(handle, inSpace, colour));
            return guides;
        }
        case Kind::place: return {};
        case Kind::angle:
            return {lineOf(colour, {handle.start, handle.from, handle.at}, true),
                    arcOf(handle, colour)};
        case Kind::factor:
            return {lineOf(colour, {handle.from, handle.start}, true),
                    lineOf(colour, {handle.start, handle.at}, false)};
        case Kind::axis: return {lineOf(colour, {handle.from, handle.at}, false)};
    }
    return {};
}

}  // namespace knotwork::app
