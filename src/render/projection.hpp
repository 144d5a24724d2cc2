// Where a point of a pane's world lands on the screen, and back, in double precision.
//
// Screen positions are device pixels from the lower left corner of the framebuffer (OpenGL's
// convention); a view that is painted into the lower left corner has its own origin there. The
// projection subtracts the pane's centre before anything is rounded to float, so that a zoom by
// 1e9 shows the same curve and not its rounding.
#pragma once

#include "geometry/vec.hpp"

#include <glm/mat4x4.hpp>

namespace knotwork::render {

/// Device pixels, origin at the lower left.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] constexpr bool contains(double px, double py) const noexcept {
        return px >= x && px < x + width && py >= y && py < y + height;
    }
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

/// A box of the world, for plots: x and y fill the pane independently of each other.
struct Range {
    double min = 0;
    double max = 1;
    [[nodiscard]] constexpr double length() const noexcept { return max - min; }
};

class Projection {
public:
    /// The plane z = 0 with `centre` in the middle of the pane; scales in world units per device
    /// pixel, both greater than 0 (equal for a picture that keeps angles).
    [[nodiscard]] static Projection flat(const Rect& pane, const Vec3& centre,
                                         double unitsPerPixelX, double unitsPerPixelY) noexcept;
    /// The box x by y fills the pane exactly: the projection of a plot.
    [[nodiscard]] static Projection spanning(const Rect& pane, Range x, Range y) noexcept;
    /// CSS pixels from the pane's lower left corner, y upwards: for ticks, frames and handles.
    [[nodiscard]] static Projection cssPixels(const Rect& pane, double pixelRatio) noexcept;
    /// An eye infinitely far away: the rows of `orientation` are the world's unit vectors to the
    /// right, upwards and towards the eye. What is farther than `depthRange` > 0 before or behind
    /// the centre is not seen.
    [[nodiscard]] static Projection parallel(const Rect& pane, const Vec3& centre,
                                             const Mat3& orientation, double unitsPerPixel,
                                             double depthRange) noexcept;
    /// Any projective map: `clip` takes (world - centre, 1) to OpenGL's clip coordinates.
    [[nodiscard]] static Projection general(const Rect& pane, const Vec3& centre,
                                            const glm::dmat4& clip) noexcept;

    /// Device pixels of the framebuffer in x and y; z is the depth in [-1, 1]. A point behind the
    /// eye of a perspective has no image: its coordinates are not finite.
    [[nodiscard]] Vec3 toPixels(const Vec3& world) const noexcept;
    /// The same relative to the middle of the pane: what becomes float.
    [[nodiscard]] Vec3 toPane(const Vec3& world) const noexcept;
    /// The inverse of toPixels. z of `pixels` is the depth; a flat projection ignores it and
    /// answers with a point of the plane z = centre.z.
    [[nodiscard]] Vec3 fromPixels(const Vec3& pixels) const noexcept;
    /// World units per device pixel in x and y at the pane's centre.
    [[nodiscard]] Vec3 unitsPerPixel() const noexcept;

    /// Whether what is nearer hides what is behind it; in a flat projection painting order decides.
    [[nodiscard]] bool deep() const noexcept { return depthPerUnit_ != 0; }
    /// Rows as parallel() takes them; the plane seen from above for others.
    [[nodiscard]] const Mat3& orientation() const noexcept { return orientation_; }
    /// How much smaller the depth of a point becomes that moves towards the eye by one unit.
    [[nodiscard]] double depthPerUnit() const noexcept { return depthPerUnit_; }
    /// Takes (world - origin, 1) to OpenGL's clip coordinates.
    [[nodiscard]] glm::dmat4 clipFrom(const Vec3& origin) const noexcept;

    [[nodiscard]] const Rect& pane() const noexcept { return pane_; }
    [[nodiscard]] const Vec3& centre() const noexcept { return centre_; }

private:
    Projection(const Rect& pane, const Vec3& centre, const glm::dmat4& clip,
               const glm::dmat4& inverse) noexcept;

    Rect pane_;
    Vec3 centre_;
    glm::dmat4 clip_;     ///< clip coordinates from (world - centre, 1)
    glm::dmat4 inverse_;  ///< (world - centre, 1) from clip coordinates
    Mat3 orientation_{1.0};
    double depthPerUnit_ = 0;
};

}  // namespace knotwork::render
