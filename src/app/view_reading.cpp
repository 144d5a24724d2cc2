// What a view says and shows about a drag while it lasts: numbers, and the former shape.
#include "app/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

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
    return shape.kind == drawing::Kind::polyline && shape.pane == Pane::curve &&
           (shape.role == Role::curve || shape.role == Role::polygon ||
            shape.role == Role::isoline || shape.role == Role::wireframe);
}

}  // namespace

std::optional<Reading> View::reading() const {
    const auto& target = emphasis_.selected;
    const bool dragged = hold_ == Hold::dragging && drag_ && target && target->pane == Pane::curve;
    if (!dragged) return std::nullopt;
    const auto& part = drag_->part();
    const auto& object = *scene()->state().objects[static_cast<std::size_t>(target->object)];
    const auto local = part ? posedLocal(object.body, target->index) : std::nullopt;
    if (local && part->kind == GizmoKind::turn) {
        return Reading{target->at, ui::numberText(drag_->turned() * degreesPerRadian, 1) + "°"};
    }
    if (local && part->kind == GizmoKind::scale) {
        return Reading{target->at, "× " + ui::numberText(local->pose.scale[part->axis], 2)};
    }
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    return Reading{target->at, listed(target->at, spatial_, decimalsAt(pixel))};
}

/// The lines of the object that is about to be dragged, thin and faint. Its index buffers and
/// samples are shared with nobody: they are copied once a drag.
void View::rememberShape() {
    ghost_.clear();
    for (const Shape& shape : drawing().shapes) {
        if (shape.object != held_->object || !isOutline(shape)) continue;
        Shape& ghost = ghost_.emplace_back(shape);
        ghost.object = -1;
        ghost.path.clear();
        ghost.width = 1;
        ghost.colour.alpha *= ghostStrength;
    }
}

}  // namespace knotwork::app
