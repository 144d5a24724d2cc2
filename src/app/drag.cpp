#include "app/drag.hpp"

#include "geometry/turns.hpp"
#include "ui/plot.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double snapPixels = 6;             // to another knot
constexpr double radiansPerPixel = 0.01;     // a turn is a drag of 630 pixels
constexpr double pixelsPerDoubling = 100;
constexpr double pi = 3.141592653589793;
constexpr double snapAngle = pi / 12;
constexpr double finestAngle = 0.01;         // radians: a pixel on the ring
constexpr double finestFactor = 0.01;
constexpr double leastFactor = 0.05;         // a box is not pulled through its handle

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

/// An axis that is seen this much shorter than the longest is not one that a hand can mean.
constexpr double leastSeen = 0.1;
/// A plane that is seen at less than this sine is not one to slide along.
constexpr double leastTilt = 0.15;

double lengthOf(const Pixel& v) noexcept { return std::hypot(v.x, v.y); }
double dot(const Pixel& a, const Pixel& b) noexcept { return a.x * b.x + a.y * b.y; }

Vec3 pointOf(const std::vector<double>& numbers) noexcept {
    Vec3 p{0.0};
    for (std::size_t k = 0; k < std::min<std::size_t>(numbers.size(), 3); ++k) {
        p[static_cast<glm::length_t>(k)] = numbers[k];
    }
    return p;
}

/// The multiple of a step, as the decimal number that it is meant to be.
double multipleOf(double step, double value) noexcept {
    return roundedTo(std::round(value / step) * step, step / 10);
}

/// As round as a pixel allows, or on the grid.
Vec3 rounded(Vec3 to, const Vec3& start, const Sight& sight, int modifiers) noexcept {
    const double pixel = sight.unitsPerPixel();
    for (glm::length_t k = 0; k < 3; ++k) {
        // What stays where it is keeps all its digits.
        if (std::abs(to[k] - start[k]) < 1e-6 * pixel) {
            to[k] = start[k];
        } else if ((modifiers & commandKey) != 0) {
            to[k] = multipleOf(ui::planeGridStep(1 / pixel), to[k]);
        } else {
            to[k] = roundedTo(to[k], pixel);
        }
    }
    return to;
}

}  // namespace

double roundedTo(double value, double unitsPerPixel) noexcept {
    const double decade = std::floor(std::log10(unitsPerPixel));
    if (!std::isfinite(decade) || decade < -15 || decade > 15) return value;
    // Dividing by a whole power of ten gives the number nearest to the decimal; multiplying by a
    // fraction would give 0.30000000000000004.
    if (decade < 0) {
        const double power = std::pow(10.0, -decade);
        return std::round(value * power) / power;
    }
    const double power = std::pow(10.0, decade);
    return std::round(value / power) * power;
}

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
    drag.placement_ = placement;
    drag.toObject_ = glm::inverse(placement.linear);
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
    if (part_) return {poseByTool(pointer, sight, modifiers)};
    const Pixel held{pointer.x - grabbed_.x, pointer.y - grabbed_.y};
    switch (target_.kind) {
        case TargetKind::point:
        case TargetKind::line: return {movePoint(held, sight, modifiers)};
        case TargetKind::knot: return moveKnot(held, sight);
        case TargetKind::pose: return {poseLocal(held, sight, modifiers)};
    }
    return {};
}

Vec3 Drag::alongAxis(const Pixel& by, const Sight& sight, bool inPlane) const noexcept {
    Vec3 best{0.0};
    double farthest = 0;
    std::array<Pixel, 3> seen;
    double longest = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
        const Pixel axis = sight.pixelVector(placement_.linear[k]);
        seen[static_cast<std::size_t>(k)] = axis;
        longest = std::max(longest, lengthOf(axis));
    }
    for (glm::length_t k = 0; k < (inPlane ? 2 : 3); ++k) {
        const Pixel axis = seen[static_cast<std::size_t>(k)];
        const double length = lengthOf(axis);
        if (!(length > leastSeen * longest)) continue;
        const double reach = dot(by, axis) / length;
        if (std::abs(reach) <= std::abs(farthest)) continue;
        farthest = reach;
        best = Vec3{0.0};
        best[k] = reach / length;
    }
    return best;
}

Vec3 Drag::acrossScreen(const Pixel& by, const Sight& sight, bool inPlane) const noexcept {
    Vec3 to = toObject_ * sight.vector(by);
    if (!inPlane) return to;
    const Vec3 eye = glm::normalize(toObject_ * sight.towardsEye());
    if (std::abs(eye.z) > leastTilt) to -= eye * (to.z / eye.z);
    to.z = 0;
    return to;
}

Vec3 Drag::moved(const Vec3& start, const Pixel& held, const Sight& sight, int modifiers,
                 bool inPlane) const noexcept {
    const Pixel at = sight.toPixels(target_.at);
    const Pixel by{held.x - at.x, held.y - at.y};
    Vec3 to = start + ((modifiers & shiftKey) != 0 ? alongAxis(by, sight, inPlane)
                                                   : acrossScreen(by, sight, inPlane));
    return rounded(to, start, sight, modifiers);
}

Json Drag::movePoint(const Pixel& held, const Sight& sight, int modifiers) const {
    const std::vector<double> was = numbersOf(original_);
    const Vec3 to = moved(pointOf(was), held, sight, modifiers, was.size() < 3);
    return moveCommand(target_.path(), vector(to, was.size()));
}

std::vector<Json> Drag::moveKnot(const Pixel& held, const Sight& sight) {
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
    part_ = part;
    gizmo_ = gizmo;
    pressed_ = pressed;
    lastAngle_ = angleOnRing(gizmo, sight, part.axis, pressed);
}

Json Drag::poseByTool(const Pixel& pointer, const Sight& sight, int modifiers) {
    Pose pose = local_.pose;
    switch (part_->kind) {
        case GizmoKind::move: moveAlong(pose, pointer, sight, modifiers); break;
        case GizmoKind::turn: turnAbout(pose, pointer, sight, modifiers); break;
        case GizmoKind::scale: scaleAlong(pose, pointer, sight, modifiers); break;
    }
    return poseCommand(objectId_, local_.name, pose);
}

void Drag::moveAlong(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers) const {
    const Pixel by{pointer.x - pressed_.x, pointer.y - pressed_.y};
    const Pixel axis = sight.pixelVector(placement_.linear[part_->axis]);
    Vec3 to = pose.translate;
    to[part_->axis] += dot(by, axis) / dot(axis, axis);
    pose.translate = rounded(to, pose.translate, sight, modifiers);
}

void Drag::turnAbout(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers) {
    const double angle = angleOnRing(gizmo_, sight, part_->axis, pointer);
    turned_ += std::remainder(angle - lastAngle_, 2 * pi);
    lastAngle_ = angle;
    const bool snaps = (modifiers & commandKey) != 0;
    turnedBy_ = snaps ? std::round(turned_ / snapAngle) * snapAngle
                      : roundedTo(turned_, finestAngle);
    if (turnedBy_ == 0) return;
    Vec3 axis{0.0};
    axis[part_->axis] = 1;
    const Vec3 before = glm::normalize(pose.axis);
    if (pose.angle == 0 || before == axis) {
        pose.axis = axis;
        pose.angle += turnedBy_;
        return;
    }
    const Turn both = compose({axis, turnedBy_}, {pose.axis, pose.angle});
    pose.axis = both.axis;
    pose.angle = both.angle;
}

void Drag::scaleAlong(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers) const {
    const Pixel at = sight.toPixels(gizmo_.at);
    const Pixel axis = sight.pixelVector(gizmo_.own[static_cast<std::size_t>(part_->axis)]);
    const double before = dot({pressed_.x - at.x, pressed_.y - at.y}, axis);
    const double now = dot({pointer.x - at.x, pointer.y - at.y}, axis);
    const double factor = before != 0 ? std::max(now / before, leastFactor) : 1;
    const auto scaled = [&](double was) {
        const double to = was * factor;
        return (modifiers & commandKey) != 0 ? std::max(multipleOf(0.1, to), 0.1)
                                             : roundedTo(to, finestFactor);
    };
    for (glm::length_t k = 0; k < 3; ++k) {
        if (factor == 1 || (k != part_->axis && (modifiers & shiftKey) == 0)) continue;
        pose.scale[k] = scaled(pose.scale[k]);
    }
}

}  // namespace knotwork::app
