// From what a pointer does on the screen to what that means for an object that is placed in the
// world, as round numbers.
#pragma once

#include "app/sight.hpp"
#include "scene/scene.hpp"

namespace knotwork::app {

/// Modifier bits of the page.
enum Modifier : int { shiftKey = 1, commandKey = 2, altKey = 4 };

/// `value` to the decimal place below `size` of a pixel: an error nobody sees, a number one can read.
[[nodiscard]] double roundedTo(double value, double unitsPerPixel) noexcept;
/// The multiple of a step, as the decimal number that it is meant to be.
[[nodiscard]] double multipleOf(double step, double value) noexcept;
/// Of the grid of a plane at this size.
[[nodiscard]] double stepOfGrid(const Sight& sight) noexcept;
/// As round as a pixel allows, or on the grid; a coordinate that stays where it was keeps its digits.
[[nodiscard]] Vec3 rounded(Vec3 to, const Vec3& start, const Sight& sight, bool onGrid) noexcept;

/// How an object is placed in the world, and back for vectors.
struct Frame {
    Frame() = default;
    explicit Frame(const Affine& of) noexcept;
    Affine placement;
    Mat3 toObject{1.0};
};

// Of vectors in the object's coordinates: by what a point moves that is seen to move by so many
// pixels; `inPlane` without leaving a plane z = constant.
/// Along the axis that is seen nearest to the move.
[[nodiscard]] Vec3 alongAxis(const Pixel& by, const Frame& frame, const Sight& sight,
                             bool inPlane) noexcept;
/// In the plane parallel to the screen, or along its own plane.
[[nodiscard]] Vec3 acrossScreen(const Pixel& by, const Frame& frame, const Sight& sight,
                                bool inPlane) noexcept;

}  // namespace knotwork::app
