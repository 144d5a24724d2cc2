// A part of the tool at a handle while it is held: how far it has been taken.
#pragma once

#include "app/drag_moves.hpp"
#include "app/gizmo.hpp"

namespace knotwork::app {

class ToolHold {
public:
    /// The gizmo stays where it stood when it was pressed.
    ToolHold(const Gizmo& gizmo, const GizmoPart& part, const Pixel& pressed, const Sight& sight);

    [[nodiscard]] const GizmoPart& part() const noexcept { return part_; }

    /// By an arrow: units along that axis of an object that is placed so.
    [[nodiscard]] double along(const Pixel& pointer, const Sight& sight,
                               const Frame& frame) const noexcept;
    /// By a ring: radians about its axis, also more than once round; `snaps` to 15 degrees.
    double turn(const Pixel& pointer, const Sight& sight, bool snaps) noexcept;
    /// What turn() has answered last.
    [[nodiscard]] double turned() const noexcept { return turnedBy_; }
    /// By a box: how many times as far out it is as it was.
    [[nodiscard]] double factor(const Pixel& pointer, const Sight& sight) const noexcept;

private:
    Gizmo gizmo_;
    GizmoPart part_;
    Pixel pressed_;
    double lastAngle_ = 0;  ///< on the ring
    double turned_ = 0;     ///< since it was pressed
    double turnedBy_ = 0;   ///< the same, rounded
};

/// A factor as a decimal number; `snaps` to tenths.
[[nodiscard]] double roundedFactor(double factor, bool snaps) noexcept;

}  // namespace knotwork::app
