// What is measured on a body and drawn beside it: curvature, derivatives, frames, hulls and spheres.
#pragma once

#include "drawing/sketch.hpp"

namespace knotwork::drawing {

/// Everything that the flags of the object ask for, of a curve with these points around it (none for
/// a curve without control points).
void drawCurveMeasures(Sketch& sketch, const Curve& curve, std::span<const Vec3> control);

/// Teeth C(t) − scale κ N (positions in pairs, index 0) and the line through their ends (index 1).
/// Teeth longer than the curve is large are cut there.
void drawComb(Sketch& sketch, const Curve& curve);

/// The first derivative as a curve in pane `hodograph`, and as an arrow where the object's parameter
/// is. Its chord error is to its size what the tolerance is to the curve's, or 1/5000 of it.
void drawHodograph(Sketch& sketch, const Curve& curve);

/// The curvature over the parameter in pane `curvature`, signed in the plane, of the object before
/// effects place it: role comb, index 0 the graph in runs without jumps, index 1 the point at the
/// object's parameter, role knots the ends of the spans. It ends at a height that nine tenths of it
/// stay far below, or at its own; where it goes beyond, a mark (index 2) and a label say how far,
/// `∞` at a cusp. Nothing of a spline of more than 4096 spans.
void drawCurvature(Sketch& sketch, const Curve& curve);

/// Role frame, index 4: the object's line (dashed) with its direction, role handle the two points
/// by which it is held, index 5 where it crosses the curve, index 6 its control polygon, and a label
/// with both numbers, `2 ≤ 4`. Nothing of a curve without control polygon.
void drawCrossings(Sketch& sketch, const Curve& curve);

/// Role frame, index 3: the circle (of a large one an arc), its centre and its radius at the
/// object's parameter. Where the curvature vanishes, the tangent.
void drawOsculatingCircle(Sketch& sketch, const Curve& curve);

/// Role frame, index 0 tangents, 1 normals, 2 binormals (in space), in pairs of positions.
void drawFrames(Sketch& sketch, const Curve& curve);

/// The polygon around points in the plane z = 0, otherwise the edges of their hull in space.
void drawHull(Sketch& sketch, std::span<const Vec3> points);

/// The smallest sphere as a circle in the plane z = 0, or as three great circles.
void drawSphere(Sketch& sketch, const Curve& curve);
void drawSphere(Sketch& sketch, std::span<const Vec3> points);

/// Whether all lie in the plane z = 0.
[[nodiscard]] bool isFlat(std::span<const Vec3> points) noexcept;

/// The diagonal of the box around a curve, from samples of it.
[[nodiscard]] double sizeOf(const Curve& curve);

}  // namespace knotwork::drawing
