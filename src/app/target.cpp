#include "app/target.hpp"

#include "scene/path.hpp"

namespace knotwork::app {

std::optional<TargetKind> kindOfList(std::string_view list) noexcept {
    if (list.starts_with("effects[")) return TargetKind::effect;
    if (list.find("].bFunction.") != std::string_view::npos) return TargetKind::parameter;
    const std::size_t dot = list.rfind('.');
    std::string_view name = dot == std::string_view::npos ? list : list.substr(dot + 1);
    name = name.substr(0, name.find('['));
    if (name == "points" || name == "vertices") return TargetKind::point;
    if (name == "knots") return TargetKind::knot;
    if (name == "poses") return TargetKind::pose;
    if (name == "line") return TargetKind::line;
    return std::nullopt;
}

std::optional<PosedLocal> posedLocal(const scene::Body& body, std::size_t k) {
    if (const auto* curve = body.as<BlendingCurve>()) {
        if (k >= curve->locals().size()) return std::nullopt;
        const LocalCurve& local = curve->locals()[k];
        return PosedLocal{k, local.pose(), local.origin()};
    }
    const auto* surface = body.as<BlendingSurface>();
    if (surface == nullptr) return std::nullopt;
    const std::size_t i = k / surface->alongV().count;
    const std::size_t j = k % surface->alongV().count;
    if (i >= surface->alongU().count) return std::nullopt;
    const PatchPlace& place = surface->place(i, j);
    return PosedLocal{scene::Json::array({i, j}), place.pose(), place.origin()};
}

scene::Json poseCommand(const std::string& object, const scene::Json& local, const Pose& pose) {
    const bool uniform = pose.scale.x == pose.scale.y && pose.scale.y == pose.scale.z;
    const auto list = [](const Vec3& v) { return scene::Json::array({v.x, v.y, v.z}); };
    scene::Json value = scene::Json::object();
    value["object"] = object;
    value["local"] = local;
    value["translate"] = list(pose.translate);
    value["rotate"] = scene::Json::object();
    value["rotate"]["axis"] = list(pose.axis);
    value["rotate"]["angle"] = pose.angle;
    value["scale"] = uniform ? scene::Json(pose.scale.x) : list(pose.scale);
    scene::Json command = scene::Json::object();
    command["pose"] = std::move(value);
    return command;
}

bool offers(const Shape& shape) noexcept {
    const auto kind = kindOfList(shape.path);
    // Knots are moved along their line; those marked on the curve are for looking at.
    return shape.kind == drawing::Kind::points && kind &&
           (kind == TargetKind::knot) == (shape.pane == Pane::knots);
}

Vec3 positionOf(const Shape& shape, std::size_t k) noexcept {
    return {shape.positions[3 * k], shape.positions[3 * k + 1], shape.positions[3 * k + 2]};
}

std::string_view kindName(TargetKind kind) noexcept {
    switch (kind) {
        case TargetKind::point: return "point";
        case TargetKind::knot: return "knot";
        case TargetKind::pose: return "pose";
        case TargetKind::line: return "line";
        case TargetKind::parameter: return "parameter";
        case TargetKind::effect: return "effect";
    }
    return "";
}

std::optional<Target> findTarget(const drawing::Drawing& drawing, std::string_view path) {
    const auto steps = scene::parsePath(path);
    if (!steps || !steps->back().isIndex()) return std::nullopt;
    const std::string_view list = path.substr(0, path.rfind('['));
    const std::size_t index = steps->back().index;
    for (const Shape& shape : drawing.shapes) {
        if (shape.path != list || !offers(shape) || index >= shape.positions.size() / 3) continue;
        return Target{shape.object, shape.pane, *kindOfList(list), std::string(list), index,
                      positionOf(shape, index)};
    }
    return std::nullopt;
}

bool siblings(const Shape& shape, const Target& target) noexcept {
    return shape.object == target.object && shape.pane == target.pane && offers(shape) &&
           kindOfList(shape.path) == target.kind;
}

std::vector<std::string> siblingsOf(const drawing::Drawing& drawing, const Target& target) {
    std::vector<std::string> paths;
    for (const Shape& shape : drawing.shapes) {
        const std::size_t count = siblings(shape, target) ? shape.positions.size() / 3 : 0;
        for (std::size_t k = 0; k < count; ++k) paths.push_back(indexed(shape.path, k));
    }
    return paths;
}

const scene::Json* valueAt(const scene::State& state, std::string_view path) {
    const auto steps = scene::parsePath(path);
    if (!steps || steps->size() < 2 || !(*steps)[1].isIndex()) return nullptr;
    const std::string& list = steps->front().key;
    const std::size_t k = (*steps)[1].index;
    const auto in = [&](const auto& entries) -> const scene::Json* {
        if (k >= entries.size()) return nullptr;
        return scene::find(entries[k]->spec, std::span(*steps).subspan(2));
    };
    return list == "objects" ? in(state.objects) : list == "effects" ? in(state.effects) : nullptr;
}

}  // namespace knotwork::app
