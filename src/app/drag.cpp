#include "app/drag.hpp"

#include "geometry/turns.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double snapPixels = 6;             // to another knot
constexpr double radiansPerPixel = 0.01;     // a turn is a drag of 630 pixels
constexpr double pixelsPerDoubling = 100;

std::vector<double> numbersOf(const Json& list) {
    std::vector<double> numbers;
    if (!list.is_array()) return numbers;
    for (const Json& number : list) {
        if (number.is_number()) numbers.push_back(number.get<double>());
    }
    return numbers;
}

Json vector(const Vec3& v, std::size_t dimension) {
    Json list = Json::array({v.x, v.y});
    if (dimension > 2) list.push_back(v.z);
    return list;
}

Json command(std::string_view name, Json value) {
    Json result = Json::object();
    result[std::string(name)] = std::move(value);
    return result;
}

Json moveCommand(std::string path, Json to) {
    Json result = command("move", std::move(path));
    result["to"] = std::move(to);
    return result;
}

Vec3 pointOf(const std::vector<double>& numbers) noexcept {
    Vec3 p{0.0};
    for (std::size_t k = 0; k < std::min<std::size_t>(numbers.size(), 3); ++k) {
        p[static_cast<glm::length_t>(k)] = numbers[k];
    }
    return p;
}

}  // namespace

std::optional<Drag> Drag::begin(const scene::State& state, const Target& target,
                                const Affine& placement, const Pixel& pressed,
                                const Sight& sight, bool inSpace) {
    if (target.object < 0 || static_cast<std::size_t>(target.object) >= state.objects.size()) {
        return std::nullopt;
    }
    const scene::Object& object = *state.objects[static_cast<std::size_t>(target.object)];
    Drag drag;
    drag.target_ = target;
    const Pixel at = sight.toPixels(target.at);
    drag.grabbed_ = {pressed.x - at.x, pressed.y - at.y};
    drag.frame_ = Frame(placement);
    drag.inSpace_ = inSpace;
    drag.objectId_ = object.id;
    if (target.kind == TargetKind::pose) {
        const auto local = posedLocal(object.body, target.index);
        if (!local) return std::nullopt;
        drag.local_ = *local;
        return drag;
    }
    const bool knot = target.kind == TargetKind::knot;
    const Json* value = valueAt(state, knot ? target.list : target.path());
    if (value == nullptr || !value->is_array()) return std::nullopt;
    if (knot) {
        drag.knots_ = numbersOf(*value);
        if (target.index >= drag.knots_.size()) return std::nullopt;
    } else {
        drag.original_ = *value;
    }
    return drag;
}

std::vector<Json> Drag::commands(const Pixel& pointer, const Sight& sight, int modifiers) {
    if (tool_) return {poseByTool(pointer, sight, modifiers)};
    const Pixel held{pointer.x - grabbed_.x, pointer.y - grabbed_.y};
    switch (target_.kind) {
        case TargetKind::point:
        case TargetKind::line: return {movePoint(held, sight, modifiers)};
        case TargetKind::knot: return moveKnot(held, sight, modifiers);
        case TargetKind::pose: return {poseLocal(held, sight, modifiers)};
        case TargetKind::parameter:
        case TargetKind::effect: break;  // see ValueDrag
    }
    return {};
}

Vec3 Drag::moved(const Vec3& start, const Pixel& held, const Sight& sight, int modifiers,
                 bool inPlane) const noexcept {
    const Pixel at = sight.toPixels(target_.at);
    const Pixel by{held.x - at.x, held.y - at.y};
    Vec3 to = start + ((modifiers & shiftKey) != 0 ? alongAxis(by, frame_, sight, inPlane)
                                                   : acrossScreen(by, frame_, sight, inPlane));
    return rounded(to, start, sight, (modifiers & commandKey) != 0);
}

Json Drag::movePoint(const Pixel& held, const Sight& sight, int modifiers) const {
    const std::vector<double> was = numbersOf(original_);
    const Vec3 to = moved(pointOf(was), held, sight, modifiers, was.size() < 3);
    return moveCommand(target_.path(), vector(to, was.size()));
}

std::vector<Json> Drag::moveKnot(const Pixel& held, const Sight& sight, int modifiers) {
    const double t = sight.fromPixels(held, target_.at).x;
    const double was = knots_[target_.index];
    const auto [first, last] = std::equal_range(knots_.begin(), knots_.end(), was);
    // Of a pile the outermost knot on the side of the move goes: the others could not let it by.
    const bool rightwards = t >= was;
    const auto moved = rightwards ? last - 1 : first;
    double low = moved == knots_.begin() ? -1e9 : *(moved - 1);
    double high = last == knots_.end() ? 1e9 : *last;
    if (rightwards) low = was;
    if (!rightwards) high = was;
    const double snap = snapPixels * sight.unitsPerPixel();
    double to = roundedTo(t, sight.unitsPerPixel());
    for (const double place : {low, high}) {
        if (std::abs(t - place) <= snap) to = place;
    }
    if ((modifiers & commandKey) != 0) to = multipleOf(stepOfGrid(sight), t);
    to = std::clamp(to, low, high);
    const auto index = static_cast<std::size_t>(moved - knots_.begin());
    std::vector<Json> commands;
    if (movedKnot_ && *movedKnot_ != index) {
        commands.push_back(moveCommand(indexed(target_.list, *movedKnot_), knots_[*movedKnot_]));
    }
    movedKnot_ = index;
    commands.push_back(moveCommand(indexed(target_.list, index), to));
    return commands;
}

Json Drag::poseLocal(const Pixel& held, const Sight& sight, int modifiers) const {
    Pose pose = local_.pose;
    const Pixel at = sight.toPixels(target_.at);
    if ((modifiers & altKey) != 0) {
        pose.scale = pose.scale * std::exp2(-(held.y - at.y) / pixelsPerDoubling);
    } else if ((modifiers & shiftKey) != 0 && !inSpace_) {
        pose.angle += radiansPerPixel * (held.x - at.x);
    } else {
        pose.translate = moved(pose.translate, held, sight, modifiers, false);
    }
    return poseCommand(objectId_, local_.name, pose);
}

void Drag::hold(const Gizmo& gizmo, const GizmoPart& part, const Pixel& pressed,
                const Sight& sight) {
    tool_.emplace(gizmo, part, pressed, sight);
}

Json Drag::poseByTool(const Pixel& pointer, const Sight& sight, int modifiers) {
    Pose pose = local_.pose;
    const bool snaps = (modifiers & commandKey) != 0;
    const auto axis = static_cast<glm::length_t>(tool_->part().axis);
    if (tool_->part().kind == GizmoKind::move) {
        Vec3 to = pose.translate;
        to[axis] += tool_->along(pointer, sight, frame_);
        pose.translate = rounded(to, pose.translate, sight, snaps);
    } else if (tool_->part().kind == GizmoKind::turn) {
        Vec3 about{0.0};
        about[axis] = 1;
        pose = turnedFarther(pose, about, tool_->turn(pointer, sight, snaps));
    } else {
        scaleAlong(pose, tool_->factor(pointer, sight), modifiers);
    }
    return poseCommand(objectId_, local_.name, pose);
}

void Drag::scaleAlong(Pose& pose, double factor, int modifiers) const noexcept {
    for (glm::length_t k = 0; k < 3; ++k) {
        if (factor == 1 || (k != tool_->part().axis && (modifiers & shiftKey) == 0)) continue;
        pose.scale[k] = roundedFactor(pose.scale[k] * factor, (modifiers & commandKey) != 0);
    }
}

Pose turnedFarther(Pose pose, const Vec3& axis, double angle) noexcept {
    if (angle == 0) return pose;
    if (pose.angle == 0 || glm::normalize(pose.axis) == axis) {
        pose.axis = axis;
        pose.angle += angle;
        return pose;
    }
    const Turn both = compose({axis, angle}, {pose.axis, pose.angle});
    pose.axis = both.axis;
    pose.angle = both.angle;
    return pose;
}

}  // namespace knotwork::app
