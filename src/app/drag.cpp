#include "app/drag.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double snapPixels = 6;             // to another knot
constexpr double radiansPerPixel = 0.01;     // a turn is a drag of 630 pixels
constexpr double pixelsPerDoubling = 100;

Affine inverseOf(const Affine& placement) noexcept {
    const Mat3 linear = glm::inverse(placement.linear);
    return {linear, -(linear * placement.offset)};
}

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

Json poseCommand(const std::string& object, std::size_t local, const Pose& pose) {
    Json value = Json::object();
    value["object"] = object;
    value["local"] = local;
    value["translate"] = vector(pose.translate, 3);
    value["rotate"] = Json::object();
    value["rotate"]["axis"] = vector(pose.axis, 3);
    value["rotate"]["angle"] = pose.angle;
    value["scale"] = pose.scale.x == pose.scale.y && pose.scale.y == pose.scale.z
                         ? Json(pose.scale.x)
                         : vector(pose.scale, 3);
    return command("pose", std::move(value));
}

double unitsPerPixel(const PlaneMap& map) noexcept { return 1 / std::max(map.scaleX, 1e-300); }

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
                                const PlaneMap& map) {
    if (target.object < 0 || static_cast<std::size_t>(target.object) >= state.objects.size()) {
        return std::nullopt;
    }
    const scene::Object& object = *state.objects[static_cast<std::size_t>(target.object)];
    Drag drag;
    drag.target_ = target;
    drag.pressed_ = pressed;
    const Pixel at = map.toPixels(target.at);
    drag.grabbed_ = {pressed.x - at.x, pressed.y - at.y};
    drag.toObject_ = inverseOf(placement);
    drag.objectId_ = object.id;
    if (target.kind == TargetKind::pose) {
        const auto* blend = object.body.as<BlendingCurve>();
        if (blend == nullptr || target.index >= blend->locals().size()) return std::nullopt;
        drag.pose_ = blend->locals()[target.index].pose();
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

Vec3 Drag::worldUnder(const Pixel& pointer, const PlaneMap& map) const noexcept {
    Vec3 world = map.fromPixels({pointer.x - grabbed_.x, pointer.y - grabbed_.y});
    world.z = target_.at.z;
    return world;
}

std::vector<Json> Drag::commands(const Pixel& pointer, const PlaneMap& map, int modifiers) {
    const Vec3 world = worldUnder(pointer, map);
    switch (target_.kind) {
        case TargetKind::point: return {movePoint(world, map, (modifiers & shiftKey) != 0)};
        case TargetKind::knot: return moveKnot(world.x, map);
        case TargetKind::pose: return {poseLocal(pointer, map, modifiers)};
    }
    return {};
}

Json Drag::movePoint(const Vec3& world, const PlaneMap& map, bool straight) const {
    const std::vector<double> was = numbersOf(original_);
    Vec3 to = toObject_.point(world);
    to.x = roundedTo(to.x, unitsPerPixel(map));
    to.y = roundedTo(to.y, unitsPerPixel(map));
    if (was.size() > 2) to.z = was[2];
    if (straight && was.size() >= 2) {
        const bool level = std::abs(to.x - was[0]) >= std::abs(to.y - was[1]);
        (level ? to.y : to.x) = level ? was[1] : was[0];
    }
    return moveCommand(target_.path(), vector(to, was.size()));
}

std::vector<Json> Drag::moveKnot(double t, const PlaneMap& map) {
    const double was = knots_[target_.index];
    const auto [first, last] = std::equal_range(knots_.begin(), knots_.end(), was);
    // Of a pile the outermost knot on the side of the move goes: the others could not let it by.
    const bool rightwards = t >= was;
    const auto moved = rightwards ? last - 1 : first;
    double low = moved == knots_.begin() ? -1e9 : *(moved - 1);
    double high = last == knots_.end() ? 1e9 : *last;
    if (rightwards) low = was;
    if (!rightwards) high = was;
    const double snap = snapPixels * unitsPerPixel(map);
    double to = roundedTo(t, unitsPerPixel(map));
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

Json Drag::poseLocal(const Pixel& pointer, const PlaneMap& map, int modifiers) const {
    Pose pose = pose_;
    const Pixel by{pointer.x - pressed_.x, pointer.y - pressed_.y};
    if ((modifiers & altKey) != 0) {
        pose.scale = pose_.scale * std::exp2(-by.y / pixelsPerDoubling);
    } else if ((modifiers & shiftKey) != 0) {
        pose.angle = pose_.angle + radiansPerPixel * by.x;
    } else {
        const Vec3 world{by.x / map.scaleX, -by.y / map.scaleY, 0};
        pose.translate = pose_.translate + toObject_.vector(world);
        pose.translate.x = roundedTo(pose.translate.x, unitsPerPixel(map));
        pose.translate.y = roundedTo(pose.translate.y, unitsPerPixel(map));
    }
    return poseCommand(objectId_, target_.index, pose);
}

}  // namespace knotwork::app
