// The tool at a selected handle of a local curve or patch: arrows to move it along an axis, rings to
// turn it about one, boxes to scale it along one of its own. In a plane two arrows, one ring and two
// boxes.
//
// All of it has a fixed size on the screen, and points the other way where it would leave it. An arrow or box is left out where its axis is seen too
// short to be followed, a ring where it is seen from the side.
#pragma once

#include "app/sight.hpp"
#include "app/target.hpp"

#include <array>
#include <optional>
#include <vector>

namespace knotwork::app {

enum class GizmoKind { move, turn, scale };

struct GizmoPart {
    GizmoKind kind = GizmoKind::move;
    int axis = 0;
    friend bool operator==(const GizmoPart&, const GizmoPart&) = default;
};

struct Gizmo {
    Vec3 at{0.0};
    std::array<Vec3, 3> axes{};  ///< of the object, unit vectors of the world
    std::array<Vec3, 3> own{};   ///< of the local, as it is turned
    bool inPlane = false;
    Box within;  ///< that it should not leave
};

/// The axis that points most towards the eye: to turn about it is what a click or key can show.
[[nodiscard]] int facingAxis(const Gizmo& gizmo, const Sight& sight) noexcept;

/// That of a target that is a handle.
[[nodiscard]] std::optional<Gizmo> gizmoOf(const scene::State& state, const Target& target,
                                           const Affine& placement, bool inPlane,
                                           const Box& within);

/// The part within the radius in CSS pixels, the nearest one.
[[nodiscard]] std::optional<GizmoPart> partAt(const Gizmo& gizmo, const Sight& sight,
                                              const Pixel& p, double radius);

/// Where the arrow along an axis ends and its box stands; nothing where they are left out.
[[nodiscard]] std::optional<Pixel> arrowTip(const Gizmo& gizmo, const Sight& sight, int axis);
[[nodiscard]] std::optional<Pixel> boxPlace(const Gizmo& gizmo, const Sight& sight, int axis);
/// The front of a ring from end to end; empty where it is left out.
[[nodiscard]] std::vector<Pixel> ringOf(const Gizmo& gizmo, const Sight& sight, int axis);

/// The angle at which a pointer is seen on the plane of a ring, from some direction in it.
[[nodiscard]] double angleOnRing(const Gizmo& gizmo, const Sight& sight, int axis,
                                 const Pixel& p) noexcept;

/// As shapes of the world; `part` stands out.
[[nodiscard]] std::vector<Shape> gizmoShapes(const Gizmo& gizmo, const Sight& sight,
                                             const std::optional<GizmoPart>& part, bool dark);
[[nodiscard]] scene::Colour axisColour(int axis, bool dark) noexcept;

}  // namespace knotwork::app
