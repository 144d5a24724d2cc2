#include "app/tool_hold.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

constexpr double pi = 3.141592653589793;
constexpr double snapAngle = pi / 12;
constexpr double finestAngle = 0.01;  // radians: a pixel on the ring
constexpr double finestFactor = 0.01;
constexpr double snapFactor = 0.1;
constexpr double leastFactor = 0.05;  // a box is not pulled through its handle

double dot(const Pixel& a, const Pixel& b) noexcept { return a.x * b.x + a.y * b.y; }

}  // namespace

ToolHold::ToolHold(const Gizmo& gizmo, const GizmoPart& part, const Pixel& pressed,
                   const Sight& sight)
    : gizmo_(gizmo), part_(part), pressed_(pressed) {
    if (part.kind == GizmoKind::turn) lastAngle_ = angleOnRing(gizmo, sight, part.axis, pressed);
}

double ToolHold::along(const Pixel& pointer, const Sight& sight,
                       const Frame& frame) const noexcept {
    const Pixel by{pointer.x - pressed_.x, pointer.y - pressed_.y};
    const Pixel axis = sight.pixelVector(frame.placement.linear[part_.axis]);
    return dot(by, axis) / dot(axis, axis);
}

double ToolHold::turn(const Pixel& pointer, const Sight& sight, bool snaps) noexcept {
    const double angle = angleOnRing(gizmo_, sight, part_.axis, pointer);
    turned_ += std::remainder(angle - lastAngle_, 2 * pi);
    lastAngle_ = angle;
    turnedBy_ = snaps ? std::round(turned_ / snapAngle) * snapAngle
                      : roundedTo(turned_, finestAngle);
    return turnedBy_;
}

double ToolHold::factor(const Pixel& pointer, const Sight& sight) const noexcept {
    const Pixel at = sight.toPixels(gizmo_.at);
    const Pixel axis = sight.pixelVector(gizmo_.own[static_cast<std::size_t>(part_.axis)]);
    const double before = dot({pressed_.x - at.x, pressed_.y - at.y}, axis);
    const double now = dot({pointer.x - at.x, pointer.y - at.y}, axis);
    return before != 0 ? std::max(now / before, leastFactor) : 1;
}

double roundedFactor(double factor, bool snaps) noexcept {
    return snaps ? std::max(multipleOf(snapFactor, factor), snapFactor)
                 : roundedTo(factor, finestFactor);
}

}  // namespace knotwork::app
