// The drag of a group: by one of its members, or by a part of the tool in its middle.
//
// Every command says what happens since the drag began, and takes the place of the one before it
// (Editor::runAnew).
#pragma once

#include "app/group.hpp"
#include "app/tool_hold.hpp"

#include <optional>

namespace knotwork::app {

class GroupDrag {
public:
    GroupDrag(Group group, const Pixel& pressed) : group_(std::move(group)), pressed_(pressed) {}
    void hold(const Gizmo& gizmo, const GizmoPart& part, const Sight& sight);

    /// Moves across the screen (Shift: along the axis that is seen nearest to the move; Ctrl: by
    /// whole steps of the grid), or as the tool has it: an arrow along its axis, a ring about it
    /// (Ctrl: by 15 degrees), a box along its axis (Shift: in all directions; Ctrl: by tenths).
    [[nodiscard]] scene::Json command(const Pixel& pointer, const Sight& sight, int modifiers);

    [[nodiscard]] const std::optional<ToolHold>& tool() const noexcept { return tool_; }
    // What the last command did.
    [[nodiscard]] const Vec3& by() const noexcept { return by_; }
    [[nodiscard]] double factor() const noexcept { return factor_; }

private:
    [[nodiscard]] Vec3 movedBy(const Pixel& pointer, const Sight& sight, int modifiers) const;

    Group group_;
    Pixel pressed_;
    std::optional<ToolHold> tool_;
    Vec3 by_{0.0};
    double factor_ = 1;
};

}  // namespace knotwork::app
