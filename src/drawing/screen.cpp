#include "drawing/screen.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double share = 0.06;      // of the frame's smaller side that stays free at each edge
constexpr double leastMargin = 10;  // pixels: half of the largest point and a little
constexpr double emptyHeight = 2.5; // units

}  // namespace

Orientation orientationFrom(double azimuth, double elevation) noexcept {
    const double ca = std::cos(azimuth), sa = std::sin(azimuth);
    const double ce = std::cos(elevation), se = std::sin(elevation);
    // GLM's matrices are written column by column: what x, y and z contribute.
    return {-sa, -se * ca, ce * ca, ca, -se * sa, ce * sa, 0, ce, se};
}

Aim aimAt(const Bounds& bounds, const Frame& frame) noexcept {
    const double smaller = std::min(frame.width, frame.height);
    const double margin = std::min(std::max(share * smaller, leastMargin), 0.25 * smaller);
    const double across = bounds.max.x - bounds.min.x;
    const double up = bounds.max.y - bounds.min.y;
    const Aim aim{(bounds.min.x + bounds.max.x) / 2, (bounds.min.y + bounds.max.y) / 2,
                  frame.height / emptyHeight};
    if (bounds.empty || (!(across > 0) && !(up > 0))) return aim;
    const double scaleX = (frame.width - 2 * margin) / across;  // infinite without extent
    const double scaleY = (frame.height - 2 * margin) / up;
    return {aim.x, aim.y, std::min(scaleX, scaleY)};
}

Affine screenOf(const Orientation& orientation, const Aim& aim, const Frame& frame) noexcept {
    Mat3 flip{1.0};
    flip[0][0] = aim.scale;
    flip[1][1] = -aim.scale;
    flip[2][2] = aim.scale;
    return {flip * orientation, Vec3(frame.x + frame.width / 2 - aim.scale * aim.x,
                                     frame.y + frame.height / 2 + aim.scale * aim.y, 0)};
}

}  // namespace knotwork::drawing
