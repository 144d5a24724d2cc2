// A sketch: the shapes of one object in its own coordinates, before effects place and colour it.
//
// One file a kind of object draws what it consists of (draw_curves.cpp …), and one file a topic what
// is measured on it (draw_measures.cpp, labels.cpp …), each as free functions that add to a sketch.
#pragma once

#include "drawing/drawing.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::drawing {

class Sketch {
public:
    /// `options.tolerance` is one of the object's own units. What it is given must outlive it.
    Sketch(const scene::Object& object, const scene::Body& body, int number,
           const Options& options) noexcept
        : object_(object), body_(body), number_(number), options_(options) {}

    [[nodiscard]] const scene::Object& object() const noexcept { return object_; }
    [[nodiscard]] const scene::Show& show() const noexcept { return object_.show; }
    [[nodiscard]] const scene::Body& body() const noexcept { return body_; }
    [[nodiscard]] const Options& options() const noexcept { return options_; }
    [[nodiscard]] double tolerance() const noexcept { return options_.tolerance; }
    /// Where the object is measured; an effect may have given it a curve with another domain.
    [[nodiscard]] double parameterOn(const Curve& curve) const noexcept;
    [[nodiscard]] int number() const noexcept { return number_; }
    /// `objects[number].list`.
    [[nodiscard]] std::string path(std::string_view list) const;

    /// A new shape in the colour of its role; the reference is good until the next one.
    Shape& add(Role role, Kind kind, float width, Pane pane = Pane::curve);
    /// A part of a curve that is first placed.
    Shape& addCurve(Role role, float width, const Curve& curve, const Interval& part,
                    const Affine& first = {});
    void take(std::vector<Shape> shapes);

    [[nodiscard]] const std::vector<Shape>& shapes() const noexcept { return shapes_; }
    [[nodiscard]] std::vector<Shape> finish() && { return std::move(shapes_); }

private:
    const scene::Object& object_;
    const scene::Body& body_;
    int number_;
    const Options& options_;
    std::vector<Shape> shapes_;
};

/// For triangles that were made or altered: shared with nothing else yet.
[[nodiscard]] std::shared_ptr<const void> freshIdentity();

void append(Shape& shape, const Vec3& p);
void append(Shape& shape, std::span<const Vec3> points);
/// Two positions and the segment between them.
void appendSegment(Shape& shape, const Vec3& from, const Vec3& to);
[[nodiscard]] Vec3 positionAt(const Shape& shape, std::size_t i) noexcept;

/// What a curve, a surface … consists of, in painting order.
void drawCurveFigure(Sketch& sketch, const Curve& curve);
void drawSurfaceFigure(Sketch& sketch, const Surface& surface);
void drawMeshFigure(Sketch& sketch, const scene::SubdivisionSurface& surface);
void drawCloudFigure(Sketch& sketch, const scene::PointCloud& cloud);
void drawGraphFigure(Sketch& sketch, const scene::FunctionGraph& graph);

// The parts that several of them have.
/// Triangles with their normals, in the colours that the object's style asks for.
void drawTriangles(Sketch& sketch, std::vector<double> positions, std::vector<double> normals,
                   std::vector<std::uint32_t> indices);
void drawPolygon(Sketch& sketch, std::span<const Vec3> points, bool closed);
/// Every knot of the domain once, where the curve passes it.
void drawKnotsOnCurve(Sketch& sketch, const Curve& curve, std::span<const double> knots);
/// Where the locals of a blend are taken hold of, patches row by row.
[[nodiscard]] std::vector<Vec3> handlePoints(const BlendingCurve& blend);
[[nodiscard]] std::vector<Vec3> handlePoints(const BlendingSurface& blend);
void drawHandles(Sketch& sketch, std::span<const Vec3> points);

/// All in pane `curve` and in `hodograph`: what changes with the points.
[[nodiscard]] std::vector<Shape> sketchFigure(const scene::Object& object, const scene::Body& body,
                                              int number, const Options& options);
/// The functions behind it, in the panes of plots: what changes with knots and B-functions only.
[[nodiscard]] std::vector<Shape> sketchPlots(const scene::Object& object, const scene::Body& body,
                                             int number, const Options& options);

/// Puts shapes of a sketch where the object stands, in its colour of the moment.
void placeShapes(std::span<Shape> shapes, const Affine& placement, const Colour& colour, bool dark);
/// Adds the shapes of an object, the figure and its functions, to a drawing.
void drawObject(Drawing& drawing, const scene::Placed& placed, int number, const Options& options);
/// The tolerance in the units of an object that stands so: the same at rest.
[[nodiscard]] double ownTolerance(double tolerance, const Affine& placement) noexcept;

}  // namespace knotwork::drawing
