// Drags: from where the pointer is to the command that puts what it holds there.
//
// Every command is absolute, made from what the document said when the drag began and from where
// the pointer is now; so no drift accumulates and the last command alone says where things ended.
#pragma once

#include "app/target.hpp"
#include "ui/plane_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace knotwork::app {

using ui::Pixel;
using ui::PlaneMap;

/// Modifier bits of the page.
enum Modifier : int { shiftKey = 1, commandKey = 2, altKey = 4 };

/// `value` to the decimal place below `size` of a pixel: an error nobody sees, a number one can read.
[[nodiscard]] double roundedTo(double value, double unitsPerPixel) noexcept;

class Drag {
public:
    /// Nothing where the target is not (or no longer) in the document. `placement` is how effects
    /// have placed the target's object at the moment.
    [[nodiscard]] static std::optional<Drag> begin(const scene::State& state, const Target& target,
                                                   const Affine& placement, const Pixel& pressed,
                                                   const PlaneMap& map);

    /// The commands, without a gesture, that bring the target under the pointer. A point moves
    /// (Shift: along one axis); a knot stays between its neighbours and snaps to them; a local
    /// curve moves, turns with Shift and scales with Alt.
    [[nodiscard]] std::vector<scene::Json> commands(const Pixel& pointer, const PlaneMap& map,
                                                    int modifiers);

    [[nodiscard]] const Target& target() const noexcept { return target_; }

private:
    Drag() = default;
    [[nodiscard]] Vec3 worldUnder(const Pixel& pointer, const PlaneMap& map) const noexcept;
    [[nodiscard]] scene::Json movePoint(const Vec3& world, const PlaneMap& map, bool straight) const;
    [[nodiscard]] std::vector<scene::Json> moveKnot(double t, const PlaneMap& map);
    [[nodiscard]] scene::Json poseLocal(const Pixel& pointer, const PlaneMap& map,
                                        int modifiers) const;

    Target target_;
    Pixel pressed_;
    Pixel grabbed_;             ///< from the target to the pointer when it was pressed
    Affine toObject_;           ///< from the world to the object's own coordinates
    std::string objectId_;
    scene::Json original_;      ///< of a point
    std::vector<double> knots_; ///< all of the list, of a knot
    Pose pose_;                 ///< of a local curve
    std::optional<std::size_t> movedKnot_;  ///< which of a pile was moved last
};

}  // namespace knotwork::app
