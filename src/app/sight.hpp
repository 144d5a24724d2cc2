// How a pane shows its world: a parallel projection to CSS pixels, from above (as plots are, with
// scales of their own across and up) or from anywhere.
#pragma once

#include "drawing/screen.hpp"
#include "ui/plane_map.hpp"

namespace knotwork::app {

using drawing::Orientation;
using ui::Box;
using ui::Pixel;
using ui::PlaneMap;

class Sight {
public:
    Sight() = default;
    explicit Sight(const PlaneMap& map) noexcept
        : origin_{map.originX, map.originY}, scaleX_(map.scaleX), scaleY_(map.scaleY) {}
    /// `centre` is seen in `middle`, `scale` CSS pixels a unit.
    Sight(const Orientation& orientation, const Vec3& centre, double scale,
          const Pixel& middle) noexcept;

    [[nodiscard]] Pixel toPixels(const Vec3& p) const noexcept;
    /// A vector of the world as one of the screen, right and down.
    [[nodiscard]] Pixel pixelVector(const Vec3& v) const noexcept;
    /// How much nearer to the eye than the world's origin, in pixels.
    [[nodiscard]] double nearness(const Vec3& p) const noexcept;
    /// The vector of the world, parallel to the screen, that is seen as this one.
    [[nodiscard]] Vec3 vector(const Pixel& by) const noexcept;
    /// The point under a pixel in the plane parallel to the screen through `through`.
    [[nodiscard]] Vec3 fromPixels(const Pixel& p, const Vec3& through) const noexcept;
    /// Unit vector.
    [[nodiscard]] Vec3 towardsEye() const noexcept;

    [[nodiscard]] const Orientation& orientation() const noexcept { return orientation_; }
    /// Straight from above.
    [[nodiscard]] bool flat() const noexcept { return orientation_ == Orientation(1.0); }
    [[nodiscard]] double unitsPerPixel() const noexcept;

private:
    Orientation orientation_{1.0};  ///< right, up, towards the eye as rows
    Pixel origin_;                  ///< where the world's origin is seen
    double scaleX_ = 1;
    double scaleY_ = 1;
};

}  // namespace knotwork::app
