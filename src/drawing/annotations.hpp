// What explains an object in words and steps: labels that keep out of each other's way, the frame of
// a trace, and the stencil of a subdivision.
#pragma once

#include "drawing/sketch.hpp"

#include <string>
#include <vector>

namespace knotwork::drawing {

/// A text and the place that it names.
struct Wanted {
    std::string text;
    Vec3 anchor{0};
    Role role = Role::label;
};

/// More labels than this are not drawn: nobody could read them.
inline constexpr std::size_t mostLabels = 150;

/// Points, edges and marked points (index 1) of the frame that is shown, role trace.
void drawTrace(Sketch& sketch);
/// The title of that frame at the last point that it is about.
[[nodiscard]] std::vector<Wanted> traceLabels(const scene::Object& object);

/// The new point, the vertices that make it and the lines between them, role trace; the new point has
/// index 1.
void drawStencil(Sketch& sketch);
/// The weights at those vertices, and the letter of the new point.
[[nodiscard]] std::vector<Wanted> stencilLabels(const Sketch& sketch);

/// How often the object's line crosses its curve and its polygon, where its direction is held.
[[nodiscard]] std::vector<Wanted> crossingLabels(const Sketch& sketch);

/// The names that the object's `show.labels` asks for (P0 …, t3, t = 0.5), and those of its trace
/// and its stencil.
void drawLabels(Sketch& sketch);

/// One label shape for each, beside its place in the plane: of eight positions the one that covers
/// the least of points, lines and labels that are there already. Sizes are guessed from the number of
/// letters.
void placeLabels(Sketch& sketch, const std::vector<Wanted>& wanted);

}  // namespace knotwork::drawing
