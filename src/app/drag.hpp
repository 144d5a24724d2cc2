// Drags: from where the pointer is to the command that puts what it holds there.
//
// Every command is absolute, made from what the document said when the drag began and from where
// the pointer is now; so no drift accumulates and the last command alone says where things ended.
#pragma once

#include "app/drag_moves.hpp"
#include "app/gizmo.hpp"
#include "app/sight.hpp"
#include "app/target.hpp"
#include "app/tool_hold.hpp"

#include <optional>
#include <string>
#include <vector>

namespace knotwork::app {

class Drag {
public:
    /// Nothing where the target is not (or no longer) in the document. `placement` is how effects
    /// have placed the target's object at the moment; `inSpace` where the pane is no plane.
    [[nodiscard]] static std::optional<Drag> begin(const scene::State& state, const Target& target,
                                                   const Affine& placement, const Pixel& pressed,
                                                   const Sight& sight, bool inSpace);

    /// The commands, without a gesture, that bring the target under the pointer. A point moves in
    /// the plane through it parallel to the screen, one of two coordinates in its own plane (Shift:
    /// along the axis that is seen nearest to the move); a knot stays between its neighbours and
    /// snaps to them (Ctrl: to the grid); a local curve or patch moves as a point does and scales with Alt. In a plane
    /// Shift turns it.
    [[nodiscard]] std::vector<scene::Json> commands(const Pixel& pointer, const Sight& sight,
                                                    int modifiers);

    /// The same by a part of the tool at a handle, at which `begin` has found the target: an arrow
    /// moves along its axis, a ring turns about it, a box scales along an axis of the local (Shift:
    /// along all). Ctrl makes moves multiples of the grid's step, turns of 15 degrees, factors of a
    /// tenth.
    void hold(const Gizmo& gizmo, const GizmoPart& part, const Pixel& pressed, const Sight& sight);

    [[nodiscard]] const Target& target() const noexcept { return target_; }
    /// The part of the tool that is held, if one is.
    [[nodiscard]] const std::optional<ToolHold>& tool() const noexcept { return tool_; }

private:
    Drag() = default;
    /// Where `start` ends, as round as a pixel allows, when the target is seen at `held`.
    [[nodiscard]] Vec3 moved(const Vec3& start, const Pixel& held, const Sight& sight, int modifiers,
                             bool inPlane) const noexcept;
    [[nodiscard]] scene::Json movePoint(const Pixel& held, const Sight& sight, int modifiers) const;
    [[nodiscard]] std::vector<scene::Json> moveKnot(const Pixel& held, const Sight& sight,
                                                    int modifiers);
    [[nodiscard]] scene::Json poseLocal(const Pixel& held, const Sight& sight, int modifiers) const;

    [[nodiscard]] scene::Json poseByTool(const Pixel& pointer, const Sight& sight, int modifiers);
    void scaleAlong(Pose& pose, double factor, int modifiers) const noexcept;

    Target target_;
    Pixel grabbed_;             ///< from the target to the pointer when it was pressed
    Frame frame_;               ///< of the object
    bool inSpace_ = false;
    std::string objectId_;
    scene::Json original_;      ///< of a point
    std::vector<double> knots_; ///< all of the list, of a knot
    PosedLocal local_;          ///< of a handle
    std::optional<std::size_t> movedKnot_;  ///< which of a pile was moved last
    std::optional<ToolHold> tool_;
};

/// A pose that is turned on by so many radians about a unit vector, its place and its own origin
/// staying where they are.
[[nodiscard]] Pose turnedFarther(Pose pose, const Vec3& axis, double angle) noexcept;

}  // namespace knotwork::app
