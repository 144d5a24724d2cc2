// What a view says and shows about a drag while it lasts: numbers, and the former shape.
#include "app/view.hpp"
#include "scene/json_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

using scene::Json;

namespace {

constexpr double degreesPerRadian = 57.29577951308232;
constexpr double ghostStrength = 0.4;

/// As many as the rounding of drags leaves.
int decimalsAt(double unitsPerPixel) noexcept {
    return static_cast<int>(std::clamp(-std::floor(std::log10(unitsPerPixel)), 0.0, 9.0));
}

std::string listed(const Vec3& p, bool spatial, int decimals) {
    std::string text = "(" + ui::numberText(p.x, decimals) + ", " + ui::numberText(p.y, decimals);
    if (spatial) text += ", " + ui::numberText(p.z, decimals);
    return text + ")";
}

bool isOutline(const Shape& shape) noexcept {
    using drawing::Role;
    if (shape.kind != drawing::Kind::polyline) return false;
    if (shape.pane == Pane::bFunction) return shape.index == 0;
    return shape.pane == Pane::curve &&
           (shape.role == Role::curve || shape.role == Role::polygon ||
            shape.role == Role::isoline || shape.role == Role::wireframe);
}

}  // namespace

std::optional<Reading> View::reading() const {
    const auto& target = emphasis_.selected;
    if (groupDrag_ && hold_ == Hold::dragging) return groupReading();
    if (valueDrag_ && hold_ == Hold::dragging) return valueReading();
    const bool dragged = hold_ == Hold::dragging && drag_ && target && target->pane == Pane::curve;
    if (!dragged) return std::nullopt;
    const auto& tool = drag_->tool();
    const auto& object = *scene()->state().objects[static_cast<std::size_t>(target->object)];
    const auto local = tool ? posedLocal(object.body, target->index) : std::nullopt;
    if (local && tool->part().kind == GizmoKind::turn) {
        return Reading{target->at, ui::numberText(tool->turned() * degreesPerRadian, 1) + "°"};
    }
    if (local && tool->part().kind == GizmoKind::scale) {
        return Reading{target->at, "× " + ui::numberText(local->pose.scale[tool->part().axis], 2)};
    }
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    return Reading{target->at, listed(target->at, spatial_, decimalsAt(pixel))};
}

/// The number or vector that a handle stands for.
std::optional<Reading> View::valueReading() const {
    const Target& target = *emphasis_.selected;
    const Json* value = valueAt(scene()->state(), target.path());
    if (value == nullptr) return std::nullopt;
    if (const FunctionHandle* handle = values_.function(target.path())) {
        const std::string number = ui::numberText(value->get<double>(), handle->integer ? 0 : 3);
        return Reading{target.at, handle->label + " = " + number, target.pane};
    }
    if (!value->is_array()) {
        const bool angle = target.list.ends_with("angle");
        const double number = value->get<double>();
        return Reading{target.at, angle ? ui::numberText(number * degreesPerRadian, 1) + "°"
                                        : "× " + ui::numberText(number, 2)};
    }
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    return Reading{target.at, listed(scene::vec3Of(*value), spatial_, decimalsAt(pixel))};
}

/// How far a group has been taken.
std::optional<Reading> View::groupReading() const {
    const auto tool = gizmo();
    if (!tool) return std::nullopt;
    const auto& held = groupDrag_->tool();
    const GizmoKind kind = held ? held->part().kind : GizmoKind::move;
    if (kind == GizmoKind::turn) {
        return Reading{tool->at, ui::numberText(held->turned() * degreesPerRadian, 1) + "°"};
    }
    if (kind == GizmoKind::scale) {
        return Reading{tool->at, "× " + ui::numberText(groupDrag_->factor(), 2)};
    }
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    return Reading{tool->at, "Δ " + listed(groupDrag_->by(), spatial_, decimalsAt(pixel))};
}

/// The lines of the objects that are about to be dragged, thin and faint. Their index buffers and
/// samples are shared with nobody: they are copied once a drag.
void View::rememberShape() {
    ghost_.clear();
    const std::vector<Target>& moved = emphasis_.others;
    for (const Shape& shape : drawing().shapes) {
        const auto ofShape = [&](const Target& target) { return target.object == shape.object; };
        if (!isOutline(shape)) continue;
        if (!ofShape(*held_) && std::none_of(moved.begin(), moved.end(), ofShape)) continue;
        Shape& ghost = ghost_.emplace_back(shape);
        if (ghost.pane == Pane::curve) ghost.object = -1;
        ghost.path.clear();
        ghost.width = 1;
        ghost.colour.alpha *= ghostStrength;
    }
}

}  // namespace knotwork::app
