#include "app/camera.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

constexpr double margin = 0.09;           // of the box's smaller side
constexpr double leastScale = 1e-12;      // knots and points reach 1e9; beyond that is nothing
constexpr double mostScale = 1e12;
constexpr double timeConstant = 0.07;     // seconds; a glide is over in about four of them
constexpr double arrived = 0.05;          // CSS pixels: nobody sees less

constexpr double pi = 3.141592653589793;
constexpr double steepest = pi / 2;
constexpr double radiansPerPixel = 0.0075;  // half a turn is a drag of 420 pixels

Aim scaledAbout(const Aim& aim, const Box& box, const Pixel& about, double factor) noexcept {
    const Vec3 fixed = sightOf(aim, box).fromPixels(about, aim.centre);
    const double scale = std::clamp(aim.scale * factor, leastScale, mostScale);
    const Vec3 fromFixed = aim.centre - fixed;
    return {fixed + fromFixed * (aim.scale / scale), scale, aim.from};
}

/// The same viewpoint, less than half a turn from `to`.
Viewpoint unwound(const Viewpoint& from, const Viewpoint& to) noexcept {
    const double turns = std::round((to.azimuth - from.azimuth) / (2 * pi));
    return {from.azimuth + 2 * pi * turns, from.elevation};
}

/// From `goal` towards `was`, this share of the way.
Viewpoint between(const Viewpoint& goal, const Viewpoint& was, double share) noexcept {
    return {goal.azimuth + (was.azimuth - goal.azimuth) * share,
            goal.elevation + (was.elevation - goal.elevation) * share};
}

}  // namespace

Orientation orientationOf(const Viewpoint& from) noexcept {
    return from == fromAbove ? drawing::planeOrientation()
                         : drawing::orientationFrom(from.azimuth, from.elevation);
}

Aim heightAim(const Vec3& centre, double height, const Box& box, const Viewpoint& from) noexcept {
    return {centre, std::clamp(std::max(box.height, 1.0) / height, leastScale, mostScale), from};
}

Aim fitAim(const drawing::Bounds& seen, const Box& box, const Viewpoint& from) noexcept {
    if (seen.empty) return heightAim(Vec3{0.0}, 2.5, box, from);
    const Vec3 size = seen.max - seen.min;
    const double free = 2 * margin * std::min(box.width, box.height);
    const double width = std::max(box.width - free, 1.0);
    const double height = std::max(box.height - free, 1.0);
    const Vec3 centre = glm::transpose(orientationOf(from)) * ((seen.min + seen.max) * 0.5);
    if (!(size.x > 0) && !(size.y > 0)) return heightAim(centre, 2.5, box, from);
    // A flat extent would ask for an infinite scale in its direction: the other one decides.
    const double acrossScale = size.x > 0 ? width / size.x : mostScale;
    const double upScale = size.y > 0 ? height / size.y : mostScale;
    return {centre, std::clamp(std::min(acrossScale, upScale), leastScale, mostScale), from};
}

Sight sightOf(const Aim& aim, const Box& box) noexcept {
    return {orientationOf(aim.from), aim.centre, aim.scale, box.centre()};
}

PlaneMap mapOf(const Aim& aim, const Box& box) noexcept {
    const Pixel middle = box.centre();
    return {middle.x - aim.scale * aim.centre.x, middle.y + aim.scale * aim.centre.y, aim.scale,
            aim.scale};
}

void Camera::jump(const Aim& aim) noexcept { now_ = goal_ = aim; }

void Camera::glide(const Aim& aim) noexcept {
    goal_ = aim;
    now_.from = unwound(now_.from, goal_.from);
}

void Camera::pan(const Pixel& by) noexcept {
    goal_ = now_;
    goal_.centre -= sightOf(goal_, {}).vector(by);
    now_ = goal_;
}

void Camera::orbit(const Pixel& by, bool gliding) noexcept {
    if (!gliding) goal_ = now_;
    goal_.from.azimuth -= radiansPerPixel * by.x;
    goal_.from.elevation =
        std::clamp(goal_.from.elevation + radiansPerPixel * by.y, -steepest, steepest);
    if (!gliding) now_ = goal_;
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
    now_ = {goal_.centre + (now_.centre - goal_.centre) * away, scale,
            between(goal_.from, now_.from, left)};
    const double offset = glm::length(now_.centre - goal_.centre) * goal_.scale;
    const double turn = std::abs(now_.from.azimuth - goal_.from.azimuth) +
                        std::abs(now_.from.elevation - goal_.from.elevation);
    const bool still = turn < 1e-4 && std::abs(now_.scale / goal_.scale - 1) < 1e-4;
    if (still && offset < arrived) now_ = goal_;
}

}  // namespace knotwork::app
