// Drawings: a scene at a moment as polylines, points and labels, to a tolerance. This is what the
// renderer paints, what exporters write and what tests look at.
#pragma once

#include "scene/colour.hpp"
#include "scene/effects.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::drawing {

using scene::Colour;

enum class Role {
    curve, surface, wireframe, polygon, points, knots, local, handle, basis, bFunction, comb,
    hodograph, hull, frame, sphere, residual, isoline, trace, label,
};
enum class Kind { polyline, points, triangles, label };

/// Which of the linked views a shape belongs to. In `curve` positions are world coordinates; in
/// `basis` and `bFunction` x is the parameter and y the value; in `knots` x is the knot and y the
/// row in a pile of equal knots (0, 1, …).
enum class Pane { curve, basis, knots, bFunction };

[[nodiscard]] std::string_view roleName(Role role) noexcept;
[[nodiscard]] std::string_view kindName(Kind kind) noexcept;
[[nodiscard]] std::string_view paneName(Pane pane) noexcept;

/// A curve over a part of its parameter, where it stands.
struct CurvePart {
    Curve curve;
    Interval part;
    Affine placement;
};

struct Shape {
    int object = 0;  ///< index among the scene's objects
    Role role = Role::curve;
    Kind kind = Kind::polyline;
    Pane pane = Pane::curve;
    std::vector<double> positions;  ///< x,y,z triples
    /// What a polyline approximates, for whoever can draw it exactly; null: nothing but itself.
    std::shared_ptr<const CurvePart> source;
    Colour colour;
    float width = 2;      ///< line width or point diameter, in CSS pixels
    bool dashed = false;
    bool square = false;  ///< points are squares (handles of local curves)
    int index = 0;        ///< which basis function, local curve, or order of derivative
    /// The list in the document whose k-th element the k-th position shows and moves, such as
    /// `objects[0].points`, `objects[0].knots` or `objects[0].poses`; empty: not to be dragged.
    std::string path;
    std::string text;     ///< of a label
};

struct Bounds {
    Vec3 min{0.0};
    Vec3 max{0.0};
    bool empty = true;
    void add(const Vec3& p) noexcept;
};

struct Drawing {
    Bounds bounds;  ///< of pane `curve`
    std::vector<Shape> shapes;  ///< in painting order
};

struct Options {
    scene::Moment moment;
    double tolerance = 1e-3;  ///< greatest chord error of polylines, world units
    bool dark = false;        ///< palette for a dark background
};

/// The polygon of the points that a curve is made from and is dragged by; none for other curves.
struct ControlPolygon {
    std::span<const Vec3> points{};
    bool closed = false;
};
[[nodiscard]] ControlPolygon controlPolygon(const Curve& curve) noexcept;

[[nodiscard]] Drawing draw(const scene::State& state, const Options& options);

}  // namespace knotwork::drawing
