// How a plane lies on a view: x and y scaled on their own, y pointing up.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/vec.hpp"
#include "ui/box.hpp"

namespace knotwork::ui {

/// pixel = (originX + scaleX·x, originY − scaleY·y); both scales are positive CSS pixels per unit.
struct PlaneMap {
    double originX = 0;
    double originY = 0;
    double scaleX = 1;
    double scaleY = 1;

    [[nodiscard]] constexpr double pixelX(double x) const noexcept { return originX + scaleX * x; }
    [[nodiscard]] constexpr double pixelY(double y) const noexcept { return originY - scaleY * y; }
    [[nodiscard]] constexpr double unitX(double px) const noexcept { return (px - originX) / scaleX; }
    [[nodiscard]] constexpr double unitY(double py) const noexcept { return (originY - py) / scaleY; }
    [[nodiscard]] Pixel toPixels(const Vec3& p) const noexcept { return {pixelX(p.x), pixelY(p.y)}; }
    [[nodiscard]] Vec3 fromPixels(const Pixel& p) const noexcept {
        return {unitX(p.x), unitY(p.y), 0.0};
    }
    friend constexpr bool operator==(const PlaneMap&, const PlaneMap&) = default;
};

/// The map under which the interval x spans the box's width and y its height (both > 0).
[[nodiscard]] constexpr PlaneMap mapOnto(const Box& box, const Interval& x,
                                         const Interval& y) noexcept {
    const double scaleX = box.width / x.length();
    const double scaleY = box.height / y.length();
    return {box.x - scaleX * x.start, box.bottom() + scaleY * y.start, scaleX, scaleY};
}

}  // namespace knotwork::ui
