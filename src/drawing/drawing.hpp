// Drawings: a scene at a moment as polylines, points and labels, to a tolerance. This is what the
// renderer paints, what exporters write and what tests look at.
#pragma once

#include "scene/colour.hpp"
#include "scene/effects.hpp"

#include <array>
#include <cstdint>
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
/// row in a pile of equal knots (0, 1, …). In `hodograph` they are first derivatives; in
/// `curvature` x is the parameter and y the curvature.
enum class Pane { curve, basis, knots, bFunction, hodograph, curvature };
inline constexpr std::array allPanes{Pane::curve,     Pane::basis,     Pane::knots,
                                     Pane::bFunction, Pane::hodograph, Pane::curvature};

[[nodiscard]] std::string_view roleName(Role role) noexcept;
[[nodiscard]] std::string_view kindName(Kind kind) noexcept;
[[nodiscard]] std::string_view paneName(Pane pane) noexcept;

/// A curve over a part of its parameter, where it stands.
struct CurvePart {
    Curve curve;
    Interval part;
    Affine placement;
};

/// sRGB and opacity, not premultiplied (eight bits of a premultiplied colour lose its hue).
using ColourBytes = std::array<std::uint8_t, 4>;

struct Shape {
    int object = 0;  ///< index among the scene's objects
    Role role = Role::curve;
    Kind kind = Kind::polyline;
    Pane pane = Pane::curve;
    std::vector<double> positions;  ///< x,y,z triples
    /// Of triangles: unit vectors, one a position, on the side from which they go counter-clockwise.
    std::vector<double> normals;
    /// Of triangles: three positions each. Of a polyline: none where it runs from position to
    /// position; otherwise two for each of the segments that it consists of instead (the edges of a
    /// mesh, the teeth of a comb).
    std::vector<std::uint32_t> indices;
    /// Of triangles that are coloured by a quantity: one a position, in place of `colour` but for its
    /// opacity; or none. The strongest stand for `range`, the lightest for 0.
    std::vector<ColourBytes> colours;
    double range = 0;
    /// Of triangles: as long as two shapes share it, positions, normals, indices and colours are
    /// the same. Whoever keeps something made of them (a buffer of the GPU) may drop it when it
    /// expires.
    std::shared_ptr<const void> identity;
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
    /// Of a label: from its position to the middle of its text in CSS pixels, right and down.
    std::array<float, 2> offset{};
};

struct Bounds {
    Vec3 min{0.0};
    Vec3 max{0.0};
    bool empty = true;
    void add(const Vec3& p) noexcept;
    /// All that is drawn in pane `curve`.
    void add(const Shape& shape) noexcept;
    void add(const Bounds& other) noexcept;
};

struct Drawing {
    Bounds bounds;  ///< of pane `curve`
    std::vector<Shape> shapes;  ///< in painting order
};

/// Panes that are drawn.
struct Panes {
    bool curve = true;
    bool basis = true;
    bool knots = true;
    bool bFunction = true;
    bool hodograph = true;
    bool curvature = true;
    friend bool operator==(const Panes&, const Panes&) = default;
};

struct Options {
    scene::Moment moment = {};
    /// Greatest chord error of polylines and of triangles, world units. Triangles keep it as far as
    /// mostSurfacePoints (surface_samples.hpp) allow.
    double tolerance = 1e-3;
    bool dark = false;  ///< palette for a dark background
    Panes panes = {};
    /// World units a CSS pixel, for the placement of labels; 0: as in a picture in which the object
    /// is 640 pixels across.
    double pixel = 0;
    /// Of the curvature comb: world units a unit of curvature times the square of a world unit; 0:
    /// so that most teeth stay below an eighth of the object's size.
    double combScale = 0;
};

/// The polygon of the points that a curve is made from and is dragged by; none for other curves.
struct ControlPolygon {
    std::span<const Vec3> points{};
    bool closed = false;
};
[[nodiscard]] ControlPolygon controlPolygon(const Curve& curve) noexcept;

/// Everything anew; whoever draws again and again has a DrawingCache (drawing_cache.hpp).
[[nodiscard]] Drawing draw(const scene::State& state, const Options& options);

}  // namespace knotwork::drawing
