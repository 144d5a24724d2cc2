// A camera over a plane or round a target in space: what it looks at, from where and how large,
// moved without losing what is under the pointer, and eased towards where it is sent.
//
// It goes round the z-axis like someone round a turntable. A plane is seen from above, and is the
// case in which nobody turns it.
#pragma once

#include "app/sight.hpp"
#include "drawing/drawing.hpp"

namespace knotwork::app {

/// Radians round the z-axis, from the x-axis, and above the plane z = 0.
struct Viewpoint {
    double azimuth = -1.5707963267948966;
    double elevation = 1.5707963267948966;
    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// The default viewpoint: x to the right, y upwards.
inline constexpr Viewpoint fromAbove{};
inline constexpr Viewpoint fromFront{-1.5707963267948966, 0};
inline constexpr Viewpoint fromSide{0, 0};
/// All three axes equally foreshortened.
inline constexpr Viewpoint fromCorner{-0.7853981633974483, 0.6154797086703873};

/// From above exactly the plane's.
[[nodiscard]] Orientation orientationOf(const Viewpoint& from) noexcept;

/// What a camera looks at; the same aim shows the same world in a box of another size.
struct Aim {
    Vec3 centre{0.0};
    double scale = 1;  ///< CSS pixels per unit
    Viewpoint from{};
    friend bool operator==(const Aim&, const Aim&) = default;
};

/// The aim that shows all of the bounds in the box with a margin round them (a share of the smaller
/// side). Bounds are those of what is seen, after the orientation. Without extent, or where there
/// are none, they are shown about the unit square's size.
[[nodiscard]] Aim fitAim(const drawing::Bounds& seen, const Box& box,
                         const Viewpoint& from = fromAbove) noexcept;
/// The aim that shows `height` units in the box's height.
[[nodiscard]] Aim heightAim(const Vec3& centre, double height, const Box& box,
                            const Viewpoint& from = fromAbove) noexcept;
/// Of the plane z = 0 from above.
[[nodiscard]] PlaneMap mapOf(const Aim& aim, const Box& box) noexcept;
[[nodiscard]] Sight sightOf(const Aim& aim, const Box& box) noexcept;

class Camera {
public:
    [[nodiscard]] const Aim& aim() const noexcept { return now_; }
    [[nodiscard]] PlaneMap map(const Box& box) const noexcept { return mapOf(now_, box); }
    [[nodiscard]] Sight sight(const Box& box) const noexcept { return sightOf(now_, box); }

    /// There at once.
    void jump(const Aim& aim) noexcept;
    /// There in about a quarter of a second, by advance(), the shorter way round.
    void glide(const Aim& aim) noexcept;
    /// Moves the picture by pixels; stops a glide.
    void pan(const Pixel& by) noexcept;
    /// Scales about a place of the box, which stays where it is; successive zooms add up while
    /// the picture still follows.
    void zoom(const Box& box, const Pixel& about, double factor, bool gliding) noexcept;
    /// Turns what is seen about the target as a hand does that takes hold of its front: round the
    /// z-axis by pixels to the right, over by pixels downwards, never past straight above or below.
    /// Successive turns add up; without `gliding` a glide is stopped.
    void orbit(const Pixel& by, bool gliding) noexcept;

    /// Follows a glide by this many seconds.
    void advance(double seconds) noexcept;
    [[nodiscard]] bool gliding() const noexcept { return !(now_ == goal_); }

private:
    Aim now_;
    Aim goal_;
};

}  // namespace knotwork::app
