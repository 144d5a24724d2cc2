#include "app/camera.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

constexpr double margin = 0.09;           // of the box's smaller side
constexpr double leastScale = 1e-12;      // knots and points reach 1e9; beyond that is nothing
constexpr double mostScale = 1e12;
constexpr double timeConstant = 0.07;     // seconds; a glide is over in about four of them
constexpr double arrived = 0.05;          // CSS pixels: nobody sees less

Aim scaledAbout(const Aim& aim, const Box& box, const Pixel& about, double factor) noexcept {
    const PlaneMap map = mapOf(aim, box);
    const Vec3 fixed = map.fromPixels(about);
    const double scale = std::clamp(aim.scale * factor, leastScale, mostScale);
    const Vec3 fromFixed = aim.centre - fixed;
    return {fixed + fromFixed * (aim.scale / scale), scale};
}

}  // namespace

Aim heightAim(const Vec3& centre, double height, const Box& box) noexcept {
    return {centre, std::clamp(std::max(box.height, 1.0) / height, leastScale, mostScale)};
}

Aim fitAim(const drawing::Bounds& bounds, const Box& box) noexcept {
    if (bounds.empty) return heightAim(Vec3{0.0}, 2.5, box);
    const Vec3 size = bounds.max - bounds.min;
    const double free = 2 * margin * std::min(box.width, box.height);
    const double width = std::max(box.width - free, 1.0);
    const double height = std::max(box.height - free, 1.0);
    const Vec3 centre = (bounds.min + bounds.max) * 0.5;
    if (!(size.x > 0) && !(size.y > 0)) return heightAim(centre, 2.5, box);
    // A flat extent would ask for an infinite scale in its direction: the other one decides.
    const double acrossScale = size.x > 0 ? width / size.x : mostScale;
    const double upScale = size.y > 0 ? height / size.y : mostScale;
    return {centre, std::clamp(std::min(acrossScale, upScale), leastScale, mostScale)};
}

PlaneMap mapOf(const Aim& aim, const Box& box) noexcept {
    const Pixel middle = box.centre();
    return {middle.x - aim.scale * aim.centre.x, middle.y + aim.scale * aim.centre.y, aim.scale,
            aim.scale};
}

void Camera::jump(const Aim& aim) noexcept { now_ = goal_ = aim; }

void Camera::glide(const Aim& aim) noexcept { goal_ = aim; }

void Camera::pan(const Pixel& by) noexcept {
    goal_ = now_;
    goal_.centre -= Vec3{by.x, -by.y, 0} / goal_.scale;
    now_ = goal_;
}

void Camera::zoom(const Box& box, const Pixel& about, double factor, bool gliding) noexcept {
    goal_ = scaledAbout(goal_, box, about, factor);
    if (!gliding) now_ = goal_;
}

void Camera::advance(double seconds) noexcept {
    if (!gliding()) return;
    const double left = std::exp(-std::max(0.0, seconds) / timeConstant);
    // Zooming feels even when the logarithm of the scale moves; the centre goes along so that the
    // world point that both aims show at the same pixel stays there.
    const double scale = goal_.scale * std::pow(now_.scale / goal_.scale, left);
    const double away = now_.scale == goal_.scale
                            ? left
                            : (1 / scale - 1 / goal_.scale) / (1 / now_.scale - 1 / goal_.scale);
    now_ = {goal_.centre + (now_.centre - goal_.centre) * away, scale};
    const double offset = glm::length(now_.centre - goal_.centre) * goal_.scale;
    if (offset < arrived && std::abs(now_.scale / goal_.scale - 1) < 1e-4) now_ = goal_;
}

}  // namespace knotwork::app
