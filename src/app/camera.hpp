// A camera over a plane: what it looks at and how large, moved without losing what is under the
// pointer, and eased towards where it is sent.
#pragma once

#include "drawing/drawing.hpp"
#include "ui/plane_map.hpp"

namespace knotwork::app {

using ui::Box;
using ui::Pixel;
using ui::PlaneMap;

/// What a camera looks at; the same aim shows the same world in a box of another size.
struct Aim {
    Vec3 centre{0.0};
    double scale = 1;  ///< CSS pixels per unit
    friend bool operator==(const Aim&, const Aim&) = default;
};

/// The aim that shows all of the bounds in the box with a margin round them (a share of the smaller
/// side). Bounds without extent, or none, are shown about the unit square's size.
[[nodiscard]] Aim fitAim(const drawing::Bounds& bounds, const Box& box) noexcept;
/// The aim that shows `height` units in the box's height.
[[nodiscard]] Aim heightAim(const Vec3& centre, double height, const Box& box) noexcept;
[[nodiscard]] PlaneMap mapOf(const Aim& aim, const Box& box) noexcept;

class Camera {
public:
    [[nodiscard]] const Aim& aim() const noexcept { return now_; }
    [[nodiscard]] PlaneMap map(const Box& box) const noexcept { return mapOf(now_, box); }

    /// There at once.
    void jump(const Aim& aim) noexcept;
    /// There in about a quarter of a second, by advance().
    void glide(const Aim& aim) noexcept;
    /// Moves the picture by pixels; stops a glide.
    void pan(const Pixel& by) noexcept;
    /// Scales about a place of the box, which stays where it is; successive zooms add up while
    /// the picture still follows.
    void zoom(const Box& box, const Pixel& about, double factor, bool gliding) noexcept;

    /// Follows a glide by this many seconds.
    void advance(double seconds) noexcept;
    [[nodiscard]] bool gliding() const noexcept { return !(now_ == goal_); }

private:
    Aim now_;
    Aim goal_;
};

}  // namespace knotwork::app
