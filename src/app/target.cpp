#include "app/target.hpp"

#include "scene/path.hpp"

namespace knotwork::app {

std::optional<TargetKind> kindOfList(std::string_view list) noexcept {
    const std::size_t dot = list.rfind('.');
    const std::string_view name = dot == std::string_view::npos ? list : list.substr(dot + 1);
    if (name == "points") return TargetKind::point;
    if (name == "knots") return TargetKind::knot;
    if (name == "poses") return TargetKind::pose;
    return std::nullopt;
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

std::size_t listLength(const drawing::Drawing& drawing, std::string_view list) {
    for (const Shape& shape : drawing.shapes) {
        if (shape.path == list && offers(shape)) return shape.positions.size() / 3;
    }
    return 0;
}

const scene::Json* valueAt(const scene::State& state, std::string_view path) {
    const auto steps = scene::parsePath(path);
    if (!steps || steps->size() < 2 || steps->front().key != "objects") return nullptr;
    const scene::PathStep& object = (*steps)[1];
    if (!object.isIndex() || object.index >= state.objects.size()) return nullptr;
    return scene::find(state.objects[object.index]->spec, std::span(*steps).subspan(2));
}

}  // namespace knotwork::app
