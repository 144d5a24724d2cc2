#include "app/group.hpp"

#include "scene/json_values.hpp"
#include "scene/path.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <span>
#include <utility>

namespace knotwork::app {

using scene::Json;

namespace {

/// The whole list, of which a net's rows are parts: `objects[0].points` of `objects[0].points[2]`.
std::string wholeOf(const std::string& list) {
    const std::size_t dot = list.rfind('.');
    return list.substr(0, list.find('[', dot == std::string::npos ? 0 : dot));
}

Json alone(std::string_view verb, Json value) {
    Json command = Json::object();
    command[std::string(verb)] = std::move(value);
    return command;
}

/// One command, or several as one.
Json inOne(Json commands) {
    if (commands.size() == 1) return std::move(commands.front());
    return alone("all", std::move(commands));
}

Vec3 roundedPoint(Vec3 p, double pixel) noexcept {
    for (glm::length_t k = 0; k < 3; ++k) p[k] = roundedTo(p[k], pixel);
    return p;
}

}  // namespace

Vec3 centreOf(const std::vector<Target>& targets, double pixel) noexcept {
    Vec3 sum{0.0};
    for (const Target& target : targets) sum += target.at;
    return roundedPoint(sum / static_cast<double>(targets.size()), pixel);
}

Group::Part Group::partOf(const scene::State& state, const Member& member) {
    const Target& target = member.target;
    const scene::Object& object = *state.objects[static_cast<std::size_t>(target.object)];
    Part part;
    part.frame = member.frame;
    part.object = object.id;
    if (target.kind == TargetKind::pose) return part;
    part.list = wholeOf(target.list);
    if (const Json* values = valueAt(state, part.list)) part.values = *values;
    return part;
}

Group Group::of(const scene::State& state, const std::vector<Member>& members, double pixel) {
    Group group;
    group.pixel_ = pixel;
    group.frame_ = members.front().frame;
    group.poses_ = members.front().target.kind == TargetKind::pose;
    std::vector<Target> targets;
    for (const Member& member : members) {
        targets.push_back(member.target);
        const scene::Object& object =
            *state.objects[static_cast<std::size_t>(member.target.object)];
        auto part = std::find_if(group.parts_.begin(), group.parts_.end(),
                                 [&](const Part& one) { return one.object == object.id; });
        if (part == group.parts_.end()) {
            part = group.parts_.insert(part, partOf(state, member));
        }
        part->paths.push_back(member.target.path());
        if (group.poses_) {
            const auto local = posedLocal(object.body, member.target.index);
            if (local) part->locals.push_back(local->name);
        } else if (const Json* value = valueAt(state, member.target.path())) {
            group.inPlane_ = group.inPlane_ || value->size() < 3;
        }
    }
    group.centre_ = centreOf(targets, pixel);
    return group;
}

std::vector<std::string> Group::paths() const {
    std::vector<std::string> all;
    for (const Part& part : parts_) all.insert(all.end(), part.paths.begin(), part.paths.end());
    return all;
}

Vec3 Group::centreIn(const Part& part) const noexcept {
    return part.frame.toObject * (centre_ - part.frame.placement.offset);
}

/// The same for the members of each object, as one command.
template <class Make>
Json Group::together(const Make& make) const {
    Json commands = Json::array();
    for (const Part& part : parts_) commands.push_back(make(part));
    return inOne(std::move(commands));
}

Json Group::posed(const Part& part, Json by) const {
    Json pose = Json::object();
    pose["object"] = part.object;
    pose["locals"] = part.locals;
    pose["by"] = std::move(by);
    return alone("pose", std::move(pose));
}

/// All points of the object, the members among them where `map` takes them.
template <class Map>
Json Group::mapped(const Part& part, const Map& map) const {
    Json values = part.values;
    const std::size_t depth = scene::parsePath(part.list)->size();
    for (const std::string& path : part.paths) {
        const auto steps = scene::parsePath(path);
        Json* value = scene::find(values, std::span(*steps).subspan(depth));
        if (value == nullptr) continue;
        const Vec3 to = roundedPoint(map(scene::vec3Of(*value)), pixel_);
        *value = scene::pointJson(to, value->size() < 3 ? 2 : 3);
    }
    Json command = alone("set", part.list);
    command["value"] = std::move(values);
    return command;
}

Json Group::moved(const Vec3& by) const {
    return together([&](const Part& part) {
        const bool same = part.frame.placement.linear == frame_.placement.linear;
        const Vec3 own = same ? by
                              : roundedPoint(part.frame.toObject *
                                                 frame_.placement.vector(by), pixel_);
        if (poses_) return posed(part, Json{{"translate", scene::pointJson(own, 3)}});
        Json command = alone("move", part.paths);
        command["by"] = scene::pointJson(own, inPlane_ ? 2 : 3);
        return command;
    });
}

Json Group::turned(int axis, double angle) const {
    const Vec3 inWorld = glm::normalize(frame_.placement.linear[axis]);
    return together([&](const Part& part) {
        const Vec3 about = centreIn(part);
        const Vec3 own = part.frame.placement.linear == frame_.placement.linear
                             ? Vec3(axis == 0, axis == 1, axis == 2)
                             : glm::normalize(part.frame.toObject * inWorld);
        if (!poses_) {
            const Mat3 turn = rotation(own, angle);
            return mapped(part, [&](const Vec3& p) { return about + turn * (p - about); });
        }
        Json by = Json::object();
        by["rotate"] = {{"axis", scene::pointJson(own, 3)}, {"angle", angle}};
        by["about"] = scene::pointJson(about, 3);
        return posed(part, std::move(by));
    });
}

Json Group::scaled(double factor) const {
    return together([&](const Part& part) {
        const Vec3 about = centreIn(part);
        if (!poses_) {
            return mapped(part, [&](const Vec3& p) { return about + factor * (p - about); });
        }
        return posed(part, Json{{"scale", factor}, {"about", scene::pointJson(about, 3)}});
    });
}

Json Group::scaledAlong(int axis, double factor) const {
    if (poses_) return scaled(factor);
    const Vec3 inWorld = glm::normalize(frame_.placement.linear[axis]);
    return together([&](const Part& part) {
        const Vec3 about = centreIn(part);
        const Vec3 own = glm::normalize(part.frame.toObject * inWorld);
        return mapped(part, [&](const Vec3& p) {
            return p + (factor - 1) * glm::dot(p - about, own) * own;
        });
    });
}

Json removal(std::vector<Target> targets) {
    // From the last to the first, so that none of them gets another number before its turn.
    std::sort(targets.begin(), targets.end(), [](const Target& a, const Target& b) {
        return a.list != b.list ? a.list > b.list : a.index > b.index;
    });
    Json commands = Json::array();
    for (const Target& target : targets) {
        if (target.kind == TargetKind::pose) return nullptr;
        commands.push_back(alone("remove", target.path()));
    }
    return commands.empty() ? Json(nullptr) : inOne(std::move(commands));
}

}  // namespace knotwork::app
