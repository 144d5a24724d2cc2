#include "app/group_drag.hpp"

namespace knotwork::app {

void GroupDrag::hold(const Gizmo& gizmo, const GizmoPart& part, const Sight& sight) {
    tool_.emplace(gizmo, part, pressed_, sight);
}

Vec3 GroupDrag::movedBy(const Pixel& pointer, const Sight& sight, int modifiers) const {
    const bool inPlane = group_.inPlane();
    const Pixel way{pointer.x - pressed_.x, pointer.y - pressed_.y};
    Vec3 by{0.0};
    if (tool_) {
        const auto axis = static_cast<glm::length_t>(tool_->part().axis);
        by[axis] = tool_->along(pointer, sight, group_.frame());
    } else {
        by = (modifiers & shiftKey) != 0 ? alongAxis(way, group_.frame(), sight, inPlane)
                                         : acrossScreen(way, group_.frame(), sight, inPlane);
    }
    return rounded(by, Vec3(0.0), sight, (modifiers & commandKey) != 0);
}

scene::Json GroupDrag::command(const Pixel& pointer, const Sight& sight, int modifiers) {
    const bool snaps = (modifiers & commandKey) != 0;
    const GizmoKind kind = tool_ ? tool_->part().kind : GizmoKind::move;
    if (kind == GizmoKind::turn) {
        return group_.turned(tool_->part().axis, tool_->turn(pointer, sight, snaps));
    }
    if (kind == GizmoKind::scale) {
        factor_ = roundedFactor(tool_->factor(pointer, sight), snaps);
        return (modifiers & shiftKey) != 0 ? group_.scaled(factor_)
                                           : group_.scaledAlong(tool_->part().axis, factor_);
    }
    by_ = movedBy(pointer, sight, modifiers);
    return group_.moved(by_);
}

}  // namespace knotwork::app
