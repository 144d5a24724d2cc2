#include "app/value_drag.hpp"

#include "app/tool_hold.hpp"
#include "scene/json_values.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::app {

using scene::Json;

namespace {

using Kind = EffectHandle::Kind;

constexpr double twoPi = 6.283185307179586;
constexpr double snapAngle = twoPi / 24;
constexpr double finestAngle = 0.01;   // radians
constexpr double leastFactor = 0.05;
constexpr double leastOpen = 0.1;      // of a plane: sine of the angle at which it is seen
constexpr double finestDirection = 0.01;

Pixel grabbedAt(const Vec3& at, const Pixel& pressed, const Sight& sight) noexcept {
    const Pixel seen = sight.toPixels(at);
    return {pressed.x - seen.x, pressed.y - seen.y};
}

template <class Handle>
Target wholeTarget(const Handle& handle, TargetKind kind, Pane pane) {
    return {handle.object, pane, kind, handle.path, 0, handle.at};
}

template <class Handle>
const Handle* named(const std::vector<Handle>& handles, std::string_view path) noexcept {
    const auto found = std::find_if(handles.begin(), handles.end(),
                                    [&](const Handle& one) { return one.path == path; });
    return found != handles.end() ? &*found : nullptr;
}

}  // namespace

Target targetOf(const FunctionHandle& handle) {
    return wholeTarget(handle, TargetKind::parameter, handle.pane);
}

Target targetOf(const EffectHandle& handle) {
    return wholeTarget(handle, TargetKind::effect, Pane::curve);
}

const FunctionHandle* ValueHandles::function(std::string_view path) const noexcept {
    return named(functions, path);
}

const EffectHandle* ValueHandles::effect(std::string_view path) const noexcept {
    return named(effects, path);
}

std::optional<Target> ValueHandles::find(std::string_view path) const {
    if (const FunctionHandle* handle = function(path)) return targetOf(*handle);
    if (const EffectHandle* handle = effect(path)) return targetOf(*handle);
    return std::nullopt;
}

std::vector<std::string> ValueHandles::pathsLike(const Target& target) const {
    std::vector<std::string> paths;
    const auto add = [&](const auto& handles) {
        for (const auto& handle : handles) {
            if (handle.object == target.object) paths.push_back(handle.path);
        }
    };
    if (target.kind == TargetKind::parameter) add(functions);
    if (target.kind == TargetKind::effect) add(effects);
    return paths;
}

ValueDrag::ValueDrag(const FunctionHandle& handle, const Pixel& pressed, const Sight& sight)
    : handle_(handle), grabbed_(grabbedAt(handle.at, pressed, sight)) {}

ValueDrag::ValueDrag(const EffectHandle& handle, const Pixel& pressed, const Sight& sight)
    : handle_(handle), grabbed_(grabbedAt(handle.at, pressed, sight)) {
    lastAngle_ = angleAt(handle, sight.toPixels(handle.at), sight);
}

/// Of the pointer in the plane of the turn, from where the turn begins; seen from the side, of its
/// projection along the eye the next best.
double ValueDrag::angleAt(const EffectHandle& handle, const Pixel& held,
                          const Sight& sight) const noexcept {
    const Vec3 axis = glm::normalize(handle.axis);
    const Vec3 eye = sight.towardsEye();
    Vec3 there = sight.fromPixels(held, handle.from) - handle.from;
    const double open = glm::dot(eye, axis);
    if (std::abs(open) > leastOpen) there -= eye * (glm::dot(there, axis) / open);
    const Vec3 first = handle.start - handle.from;
    return std::atan2(glm::dot(there, glm::cross(axis, first)), glm::dot(there, first));
}

Json ValueDrag::effectValue(const EffectHandle& handle, const Pixel& held, const Sight& sight,
                            int modifiers) {
    const bool snaps = (modifiers & commandKey) != 0;
    if (handle.kind == Kind::angle) {
        const double angle = angleAt(handle, held, sight);
        turned_ += std::remainder(angle - lastAngle_, twoPi);
        lastAngle_ = angle;
        const double to = handle.value.x + turned_;
        return snaps ? std::round(to / snapAngle) * snapAngle : roundedTo(to, finestAngle);
    }
    if (handle.kind == Kind::factor) {
        const Vec3 arm = handle.start - handle.from;
        const Vec3 there = sight.fromPixels(held, handle.at) - handle.from;
        return std::max(roundedFactor(glm::dot(there, arm) / glm::dot(arm, arm), snaps),
                        leastFactor);
    }
    const Pixel at = sight.toPixels(handle.at);
    const Pixel by{held.x - at.x, held.y - at.y};
    const Frame world{};
    const Vec3 moved = (modifiers & shiftKey) != 0 ? alongAxis(by, world, sight, false)
                                                   : acrossScreen(by, world, sight, false);
    if (handle.kind == Kind::axis) {
        Vec3 to = handle.at + moved - handle.from;
        if (!(glm::length(to) > 0)) return scene::pointJson(handle.value, 3);
        to *= glm::length(handle.value) / glm::length(to);
        for (glm::length_t k = 0; k < 3; ++k) to[k] = roundedTo(to[k], finestDirection);
        return scene::pointJson(to, 3);
    }
    return scene::pointJson(rounded(handle.value + moved, handle.value, sight, snaps), 3);
}

Json ValueDrag::command(const scene::State& state, const Pixel& pointer, const Sight& sight,
                        int modifiers) {
    const Pixel held{pointer.x - grabbed_.x, pointer.y - grabbed_.y};
    if (const auto* effect = std::get_if<EffectHandle>(&handle_)) {
        return setCommand(effect->path, effectValue(*effect, held, sight, modifiers));
    }
    const auto& function = std::get<FunctionHandle>(handle_);
    return setCommand(function.path,
                      parameterFor(state, function, sight.fromPixels(held, function.at),
                                   (modifiers & commandKey) != 0));
}

}  // namespace knotwork::app
