// Commands that place local curves and patches, one or a group.
#include "geometry/turns.hpp"
#include "scene/command_parts.hpp"
#include "scene/fields.hpp"
#include "scene/json_values.hpp"
#include "scene/rotation_fields.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace knotwork::scene {

namespace {

constexpr std::array byFields{
    Field{.name = "translate", .label = "Move", .kind = FieldKind::point,
          .help = "How much farther it moves.", .defaultJson = "[0,0,0]"},
    Field{.name = "rotate", .label = "Turn", .kind = FieldKind::group,
          .help = "How much farther it turns.", .defaultJson = "{}", .fields = rotateFields},
    Field{.name = "scale", .label = "Scale", .kind = FieldKind::number,
          .help = "How many times larger it becomes.", .min = 0, .minOpen = true,
          .defaultJson = "1"},
    Field{.name = "about", .label = "About", .kind = FieldKind::point,
          .help = "The point that stays where it is; each local curve's own if left out."},
};

/// A local curve is named by its number, a patch by two.
using Place = std::pair<double, double>;

Place placeOf(const Json& local) noexcept {
    if (local.is_array()) return {local[0].get<double>(), local[1].get<double>()};
    return {local.get<double>(), 0};
}

/// What the command says about the poses, without whose they are.
Json saidOf(const Json& arguments) {
    Json said = Json::object();
    for (const auto& item : arguments.items()) {
        const std::string& key = item.key();
        if (key != "object" && key != "local" && key != "locals") said[key] = item.value();
    }
    return said;
}

/// Where the pivot of a local curve or patch lies; it exists.
Vec3 originOf(const Body& body, const Place& place) noexcept {
    const auto i = static_cast<std::size_t>(place.first);
    if (const auto* curve = body.as<BlendingCurve>()) return curve->locals()[i].origin();
    return body.as<BlendingSurface>()->place(i, static_cast<std::size_t>(place.second)).origin();
}

bool exists(const Body& body, const Place& place) noexcept {
    if (const auto* curve = body.as<BlendingCurve>()) {
        return place.first < static_cast<double>(curve->locals().size());
    }
    const auto* surface = body.as<BlendingSurface>();
    return place.first < static_cast<double>(surface->alongU().count) &&
           place.second < static_cast<double>(surface->alongV().count);
}

/// `pose` as it is after it has been moved, turned and scaled farther by what `by` says.
Json carried(Json pose, const Json& by, const Vec3& origin) {
    const Pose before = poseOf(pose);
    const Pose farther = poseOf(by);
    const double factor = numberOr(by, "scale", 1);
    Vec3 moved = before.translate;
    if (const Json* given = member(by, "about")) {
        const Vec3 about = vec3Of(*given) - origin;
        moved = about + factor * (rotation(farther.axis, farther.angle) * (moved - about));
    }
    const Turn turn = compose({farther.axis, farther.angle}, {before.axis, before.angle});
    const Vec3 scale = factor * before.scale;
    pose["translate"] = pointJson(moved + farther.translate, 3);
    pose["rotate"] = {{"axis", pointJson(turn.axis, 3)}, {"angle", turn.angle}};
    const bool uniform = scale.x == scale.y && scale.y == scale.z;
    pose["scale"] = uniform ? Json(scale.x) : pointJson(scale, 3);
    return pose;
}

/// Those that the command names, checked as `local` of a pose is.
Result<std::vector<Json>> namedLocals(const Json& arguments, std::span<const Field> fields) {
    const Json* one = member(arguments, "local");
    const Json* many = member(arguments, "locals");
    if (one != nullptr && many != nullptr) {
        return refuse(Code::unknownField, "pose.locals", "Give \"local\" or \"locals\", not both.");
    }
    if (many != nullptr && (!many->is_array() || many->empty())) {
        return refuse(Code::wrongType, "pose.locals",
                      "Expected a list of local curves, got " + describeValue(*many) + ".");
    }
    std::vector<Json> locals;
    std::map<Place, std::size_t> seen;
    const std::size_t count = many != nullptr ? many->size() : 1;
    for (std::size_t k = 0; k < count; ++k) {
        Json pose = Json::object();
        if (many != nullptr) pose["local"] = (*many)[k];
        if (many == nullptr && one != nullptr) pose["local"] = *one;
        auto read = readGroup(pose, fields);
        if (!read && many == nullptr) return read.error().under("pose");
        if (!read) {
            const std::string within = read.error().path.substr(std::string_view("local").size());
            return refuse(read.error().code, indexed("pose.locals", k) + within,
                          read.error().message);
        }
        locals.push_back((*read)["local"]);
        if (!seen.emplace(placeOf(locals.back()), k).second) {
            return refuse(Code::outOfRange, indexed("pose.locals", k),
                          "This one stands in the list already.");
        }
    }
    return locals;
}

/// What is said about poses, checked: the fields of a pose that were given, or { by }, complete.
Result<Json> checkSaid(const Json& said, const Json& local, std::span<const Field> fields) {
    const Json* by = member(said, "by");
    if (by == nullptr) {
        Json pose = said;
        pose["local"] = local;
        if (const auto read = readGroup(pose, fields); !read) return read.error().under("pose");
        return said;
    }
    if (said.size() > 1) {
        return refuse(Code::unknownField, "pose.by",
                      "A pose is given by its fields, or changed \"by\" an amount, not both.");
    }
    auto read = readGroup(*by, byFields);
    if (!read) return read.error().under("pose.by");
    const Json& turn = *member(*read, "rotate");
    if (numberOr(turn, "angle", 0) != 0 && !(glm::length(vec3Of(*member(turn, "axis"))) > 0)) {
        return refuse(Code::outOfRange, "pose.by.rotate.axis",
                      "The axis has length zero and names no direction.");
    }
    return Json{{"by", std::move(*read)}};
}

Json posesWith(const Object& object, const std::vector<Json>& locals, const Json& said) {
    Json poses = *member(object.spec, "poses");
    std::map<Place, std::size_t> indices;
    for (std::size_t k = 0; k < poses.size(); ++k) indices[placeOf(poses[k]["local"])] = k;
    const Json* by = member(said, "by");
    for (const Json& local : locals) {
        const Place place = placeOf(local);
        const auto [found, fresh] = indices.emplace(place, poses.size());
        if (fresh) poses.push_back(Json{{"local", local}});
        Json& pose = poses[found->second];
        if (by == nullptr) {
            pose.update(said);
        } else if (exists(object.body, place)) {  // otherwise validation will say so
            pose = carried(std::move(pose), *by, originOf(object.body, place));
        }
    }
    return poses;
}

}  // namespace

Result<Executed> executePose(const State& state, const Json& arguments) {
    if (!arguments.is_object()) {
        return refuse(Code::wrongType, "pose",
                      "Expected { object, local, … }, got " + describeValue(arguments) + ".");
    }
    const auto i = objectNamed(state, arguments, "pose");
    if (!i) return i.error();
    const Object& object = *state.objects[*i];
    if (member(object.spec, "poses") == nullptr) {
        return refuse(Code::notSupported, "pose.object",
                      "\"" + object.id + "\" has no local curves that could be posed.");
    }
    const bool patches = object.body.as<BlendingSurface>() != nullptr;
    const auto fields = patches ? patchPoseFields() : poseFields();
    const auto locals = namedLocals(arguments, fields);
    if (!locals) return locals.error();
    const auto said = checkSaid(saidOf(arguments), locals->front(), fields);
    if (!said) return said.error();
    Json spec = object.spec;
    spec["poses"] = posesWith(object, *locals, *said);
    auto next = withObject(state, *i, spec);
    if (!next) return next.error();
    return Executed{std::move(*next), {"pose", indexed("objects", *i) + ".poses"}};
}

}  // namespace knotwork::scene
