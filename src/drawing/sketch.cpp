#include "drawing/sketch.hpp"

#include "drawing/normals.hpp"
#include "drawing/palette.hpp"
#include "geometry/tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace knotwork::drawing {

namespace {

/// The largest factor by which a map stretches: exact for rotations and for scales along the axes,
/// never too small.
double stretchOf(const Mat3& linear) noexcept {
    const Mat3 gram = glm::transpose(linear) * linear;
    double square = 0;
    for (int i = 0; i < 3; ++i) {
        square = std::max(square,
                          std::abs(gram[i][0]) + std::abs(gram[i][1]) + std::abs(gram[i][2]));
    }
    return std::sqrt(square);
}

void placeNormals(Shape& shape, const Mat3& linear) noexcept {
    turnNormals(shape.normals, linear);
    if (!mirrors(linear)) return;
    for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
        std::swap(shape.indices[i + 1], shape.indices[i + 2]);
    }
}

void placeShape(Shape& shape, const Affine& placement) {
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        const Vec3 p = placement.point(
            {shape.positions[i], shape.positions[i + 1], shape.positions[i + 2]});
        shape.positions[i] = p.x;
        shape.positions[i + 1] = p.y;
        shape.positions[i + 2] = p.z;
    }
    if (shape.kind == Kind::triangles) {
        placeNormals(shape, placement.linear);
        shape.identity = freshIdentity();
    }
    if (shape.source == nullptr) return;
    CurvePart part = *shape.source;
    part.placement = compose(placement, part.placement);
    shape.source = std::make_shared<const CurvePart>(std::move(part));
}

}  // namespace

std::string Sketch::path(std::string_view list) const {
    return indexed("objects", static_cast<std::size_t>(number_)) + "." + std::string(list);
}

double Sketch::parameterOn(const Curve& curve) const noexcept {
    const Interval whole = domain(curve);
    return std::clamp(object_.parameter, whole.start, whole.end);
}

Shape& Sketch::add(Role role, Kind kind, float width, Pane pane) {
    Shape shape;
    shape.object = number_;
    shape.role = role;
    shape.kind = kind;
    shape.pane = pane;
    shape.colour = roleColour(role, options_.dark);
    shape.width = width;
    if (kind == Kind::triangles) shape.identity = freshIdentity();
    shapes_.push_back(std::move(shape));
    return shapes_.back();
}

Shape& Sketch::addCurve(Role role, float width, const Curve& curve, const Interval& part,
                        const Affine& first) {
    Shape& shape = add(role, Kind::polyline, width);
    shape.positions =
        polyline(curve, part, ownTolerance(options_.tolerance, first)).xyz;
    shape.source = std::make_shared<const CurvePart>(CurvePart{curve, part, {}});
    if (!(first == Affine{})) placeShape(shape, first);
    return shape;
}

void Sketch::take(std::vector<Shape> shapes) {
    std::move(shapes.begin(), shapes.end(), std::back_inserter(shapes_));
}

std::shared_ptr<const void> freshIdentity() { return std::make_shared<const char>('\0'); }

void append(Shape& shape, const Vec3& p) {
    shape.positions.insert(shape.positions.end(), {p.x, p.y, p.z});
}

void append(Shape& shape, std::span<const Vec3> points) {
    shape.positions.reserve(shape.positions.size() + 3 * points.size());
    for (const Vec3& p : points) append(shape, p);
}

void appendSegment(Shape& shape, const Vec3& from, const Vec3& to) {
    const auto first = static_cast<std::uint32_t>(shape.positions.size() / 3);
    append(shape, from);
    append(shape, to);
    shape.indices.insert(shape.indices.end(), {first, first + 1});
}

Vec3 positionAt(const Shape& shape, std::size_t i) noexcept {
    return {shape.positions[3 * i], shape.positions[3 * i + 1], shape.positions[3 * i + 2]};
}

void placeShapes(std::span<Shape> shapes, const Affine& placement, const Colour& colour,
                 bool dark) {
    const bool moved = !(placement == Affine{});
    for (Shape& shape : shapes) {
        if (moved && shape.pane == Pane::curve) placeShape(shape, placement);
        if (moved && shape.pane == Pane::hodograph) placeShape(shape, {placement.linear, Vec3(0)});
        if (const auto own = objectColour(shape.role, colour, dark)) shape.colour = *own;
    }
}

double ownTolerance(double tolerance, const Affine& placement) noexcept {
    const double stretch = stretchOf(placement.linear);
    // In steps of 2, so that what grows slowly is not sampled anew in every frame. Rotations stretch
    // by 1 up to rounding.
    if (!(std::abs(stretch - 1) > 1e-9) || !(stretch > 0)) return tolerance;
    return tolerance * std::exp2(std::floor(-std::log2(stretch)));
}

}  // namespace knotwork::drawing
