// The builder of blending surfaces, and the way back.
#include "geometry/named.hpp"
#include "geometry/surface.hpp"
#include "scene/json_values.hpp"
#include "scene/spec_builders.hpp"
#include "scene/surface_builders.hpp"
#include "scene/surface_specs.hpp"

#include <array>

namespace knotwork::scene {

namespace {

struct NamedKind {
    std::string_view name;
    PatchKind kind;
};
constexpr std::array patchKinds{NamedKind{"sub-surface", PatchKind::subSurface},
                                NamedKind{"plane", PatchKind::plane},
                                NamedKind{"bezier", PatchKind::bezier}};

Json numberPair(double first, double second) { return Json::array({first, second}); }

/// One B-function for both directions, or one each.
Result<std::array<BFunction, 2>> blendsOf(const Json& spec) {
    const Json& given = *member(spec, "bFunction");
    std::array<BFunction, 2> blends;
    for (std::size_t direction = 0; direction < 2; ++direction) {
        auto made = buildBFunction(given.is_array() ? given[direction] : given);
        if (!made) {
            return made.error().under(given.is_array() ? indexed("bFunction", direction)
                                                       : "bFunction");
        }
        blends[direction] = std::move(*made);
    }
    return blends;
}

/// What is cut; the degrees are filled in where the kind has any.
Result<PatchCut> patchCutOf(Json& spec) {
    const std::string name = stringOr(spec, "kind", "sub-surface");
    PatchCut cut;
    cut.kind = findNamed(patchKinds, &NamedKind::name, name)->kind;
    const Json* degree = member(spec, "degree");
    if (cut.kind != PatchKind::bezier) {
        if (degree == nullptr) return cut;
        return refuse(Code::notSupported, "degree",
                      "Local patches of the kind \"" + name + "\" have no degree; leave it out.");
    }
    for (std::size_t direction = 0; degree != nullptr && direction < 2; ++direction) {
        cut.degree[direction] = static_cast<int>((*degree)[direction].get<double>());
    }
    spec["degree"] = numberPair(cut.degree[0], cut.degree[1]);
    return cut;
}

BlendDirection directionOf(const Json& spec, std::size_t direction, BFunction blend,
                           bool modelCloses) {
    BlendDirection along{.blend = std::move(blend)};
    along.count = static_cast<std::size_t>((*member(spec, "locals"))[direction].get<double>());
    along.form = modelCloses ? BlendForm::closed : BlendForm::open;
    if (const Json* form = member(spec, "form")) {
        along.form = (*form)[direction] == "closed" ? BlendForm::closed : BlendForm::open;
    }
    if (const Json* knots = member(spec, "knots")) along.knots = numbersOf((*knots)[direction]);
    return along;
}

/// The index of a patch that a pose is for.
Result<std::size_t> posedPatch(const Json& pose, const Json& locals) {
    std::array<std::size_t, 2> place{};
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const double count = locals[direction].get<double>();
        const double index = (*member(pose, "local"))[direction].get<double>();
        if (index >= count) {
            return refuse(Code::outOfRange, indexed("local", direction),
                          "There is no local patch " + formatNumber(index) + " along " +
                              (direction == 0 ? "u" : "v") + "; they are 0 to " +
                              formatNumber(count - 1) + ".");
        }
        place[direction] = static_cast<std::size_t>(index);
    }
    return place[0] * static_cast<std::size_t>(locals[1].get<double>()) + place[1];
}

Result<std::vector<Pose>> posesOf(const Json& spec, std::size_t count) {
    const Json& list = *member(spec, "poses");
    std::vector<Pose> poses(list.empty() ? 0 : count);
    std::vector<bool> seen(poses.size(), false);
    for (std::size_t k = 0; k < list.size(); ++k) {
        const std::string path = indexed("poses", k);
        const auto patch = posedPatch(list[k], *member(spec, "locals"));
        if (!patch) return patch.error().under(path);
        if (seen[*patch]) {
            return refuse(Code::outOfRange, path + ".local",
                          "This local patch has a pose already; there is one pose for each.");
        }
        seen[*patch] = true;
        poses[*patch] = poseOf(list[k]);
        const auto checked = checkPose(poses[*patch]);
        if (!checked) return checked.error().under(path);
    }
    return poses;
}

std::string_view formName(const BlendDirection& along) noexcept {
    return along.closed() ? "closed" : "open";
}

Json poseSpec(std::size_t i, std::size_t j, const Pose& pose) {
    const bool uniform = pose.scale.x == pose.scale.y && pose.scale.y == pose.scale.z;
    return {{"local", numberPair(static_cast<double>(i), static_cast<double>(j))},
            {"translate", pointJson(pose.translate, 3)},
            {"rotate", {{"axis", pointJson(pose.axis, 3)}, {"angle", pose.angle}}},
            {"scale", uniform ? Json(pose.scale.x) : pointJson(pose.scale, 3)}};
}

void complete(Json& spec, const BlendingSurface& surface) {
    spec["form"] = Json::array({formName(surface.alongU()), formName(surface.alongV())});
    spec["knots"] =
        Json::array({listOf(surface.alongU().knots), listOf(surface.alongV().knots)});
}

}  // namespace

Result<Surface> buildBlendingSurface(Json& spec) {
    auto blends = blendsOf(spec);
    if (!blends) return blends.error();
    Json completed = *member(spec, "model");
    auto model = buildSurface(completed);
    if (!model) return model.error().under("model");
    spec["model"] = std::move(completed);
    const auto cut = patchCutOf(spec);
    if (!cut) return cut.error();
    const ClosedDirections closed = closedDirections(*model);
    BlendDirection u = directionOf(spec, 0, std::move((*blends)[0]), closed.u);
    BlendDirection v = directionOf(spec, 1, std::move((*blends)[1]), closed.v);
    // Made without poses first: then it is known that there are not too many patches for a list.
    auto surface = BlendingSurface::make(std::move(*model), std::move(u), std::move(v), *cut);
    if (!surface) return surface.error();
    const auto poses = posesOf(spec, surface->alongU().count * surface->alongV().count);
    if (!poses) return poses.error();
    if (!poses->empty()) surface = surface->withPoses(*poses);
    complete(spec, *surface);
    return Surface(std::move(*surface));
}

Json specOf(const BlendingSurface& surface) {
    const BlendDirection& u = surface.alongU();
    const BlendDirection& v = surface.alongV();
    const PatchCut& cut = surface.cut();
    Json spec{{"type", "blending-surface"}};
    spec["bFunction"] = u.blend == v.blend ? specOf(u.blend)
                                           : Json::array({specOf(u.blend), specOf(v.blend)});
    spec["model"] = specOf(surface.model());
    spec["locals"] = numberPair(static_cast<double>(u.count), static_cast<double>(v.count));
    spec["kind"] = patchKinds[static_cast<std::size_t>(cut.kind)].name;
    if (cut.kind == PatchKind::bezier) spec["degree"] = numberPair(cut.degree[0], cut.degree[1]);
    complete(spec, surface);
    Json poses = Json::array();
    for (std::size_t i = 0; i < u.count; ++i) {
        for (std::size_t j = 0; j < v.count; ++j) {
            const Pose& pose = surface.place(i, j).pose();
            if (!pose.isIdentity()) poses.push_back(poseSpec(i, j, pose));
        }
    }
    spec["poses"] = std::move(poses);
    return spec;
}

}  // namespace knotwork::scene
