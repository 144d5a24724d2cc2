// From the world of a scene to the pixels of a picture: parallel projections, which keep lines
// straight and Bézier curves what they are.
#pragma once

#include "drawing/drawing.hpp"

namespace knotwork::drawing {

/// Right, up and towards the eye as rows: what is seen, before it is scaled.
using Orientation = Mat3;

/// Looking down on the plane z = 0.
[[nodiscard]] inline Orientation planeOrientation() noexcept { return Orientation{1.0}; }

/// From an eye that stands so many radians round the z-axis, from the x-axis, and above the plane
/// z = 0; z points upwards.
[[nodiscard]] Orientation orientationFrom(double azimuth, double elevation) noexcept;

/// The front right and a little above: how a solid is usually drawn.
inline constexpr double usualAzimuth = -0.95;
inline constexpr double usualElevation = 0.45;

/// CSS pixels of a picture, from its upper left corner.
struct Frame {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
};

/// What is in the middle of the frame (after the orientation) and how large.
struct Aim {
    double x = 0;
    double y = 0;
    double scale = 1;  ///< pixels per unit
};

/// All of the bounds (after the orientation) with room for points and lines at the edge; about the
/// unit square's size for bounds without extent.
[[nodiscard]] Aim aimAt(const Bounds& bounds, const Frame& frame) noexcept;

/// x and y are pixels with y downwards, z grows towards the eye.
[[nodiscard]] Affine screenOf(const Orientation& orientation, const Aim& aim,
                              const Frame& frame) noexcept;

}  // namespace knotwork::drawing
