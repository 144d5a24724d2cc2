// Drags: from where the pointer is to the command that puts what it holds there.
//
// Every command is absolute, made from what the document said when the drag began and from where
// the pointer is now; so no drift accumulates and the last command alone says where things ended.
#pragma once

#include "app/gizmo.hpp"
#include "app/sight.hpp"
#include "app/target.hpp"

#include <optional>
#include <string>
#include <vector>

namespace knotwork::app {

/// Modifier bits of the page.
enum Modifier : int { shiftKey = 1, commandKey = 2, altKey = 4 };

/// `value` to the decimal place below `size` of a pixel: an error nobody sees, a number one can read.
[[nodiscard]] double roundedTo(double value, double unitsPerPixel) noexcept;

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
    /// snaps to them; a local curve or patch moves as a point does and scales with Alt. In a plane
    /// Shift turns it.
    [[nodiscard]] std::vector<scene::Json> commands(const Pixel& pointer, const Sight& sight,
                                                    int modifiers);

    /// The same by a part of the tool at a handle, at which `begin` has found the target: an arrow
    /// moves along its axis, a ring turns about it, a box scales along an axis of the local (Shift:
    /// along all). Ctrl makes moves multiples of the grid's step, turns of 15 degrees, factors of a
    /// tenth.
    void hold(const Gizmo& gizmo, const GizmoPart& part, const Pixel& pressed, const Sight& sight);

    [[nodiscard]] const Target& target() const noexcept { return target_; }
    [[nodiscard]] const std::optional<GizmoPart>& part() const noexcept { return part_; }
    /// Radians by which a ring has been turned.
    [[nodiscard]] double turned() const noexcept { return turnedBy_; }

private:
    Drag() = default;
    // Of vectors in the object's coordinates: by what a point moves that is seen to move by so many
    // pixels; `inPlane` without leaving a plane z = constant.
    [[nodiscard]] Vec3 alongAxis(const Pixel& by, const Sight& sight, bool inPlane) const noexcept;
    [[nodiscard]] Vec3 acrossScreen(const Pixel& by, const Sight& sight,
                                    bool inPlane) const noexcept;
    /// Where `start` ends, as round as a pixel allows, when the target is seen at `held`.
    [[nodiscard]] Vec3 moved(const Vec3& start, const Pixel& held, const Sight& sight, int modifiers,
                             bool inPlane) const noexcept;
    [[nodiscard]] scene::Json movePoint(const Pixel& held, const Sight& sight, int modifiers) const;
    [[nodiscard]] std::vector<scene::Json> moveKnot(const Pixel& held, const Sight& sight);
    [[nodiscard]] scene::Json poseLocal(const Pixel& held, const Sight& sight, int modifiers) const;

    [[nodiscard]] scene::Json poseByTool(const Pixel& pointer, const Sight& sight, int modifiers);
    void moveAlong(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers) const;
    void turnAbout(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers);
    void scaleAlong(Pose& pose, const Pixel& pointer, const Sight& sight, int modifiers) const;

    Target target_;
    Pixel grabbed_;             ///< from the target to the pointer when it was pressed
    Affine placement_;          ///< of the object in the world
    Mat3 toObject_{1.0};        ///< vectors of the world in the object's own coordinates
    bool inSpace_ = false;
    std::string objectId_;
    scene::Json original_;      ///< of a point
    std::vector<double> knots_; ///< all of the list, of a knot
    PosedLocal local_;          ///< of a handle
    std::optional<std::size_t> movedKnot_;  ///< which of a pile was moved last
    std::optional<GizmoPart> part_;
    Gizmo gizmo_;               ///< where it stood when it was pressed
    Pixel pressed_;
    double lastAngle_ = 0;      ///< on the ring
    double turned_ = 0;         ///< since it was pressed, also more than once round
    double turnedBy_ = 0;       ///< the same, rounded
};

}  // namespace knotwork::app
