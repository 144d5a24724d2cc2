// What surfaces consist of: triangles, lines of knots, control nets, patches and handles.
#include "drawing/curvature_colours.hpp"
#include "drawing/measures.hpp"
#include "drawing/surface_samples.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

/// Points a side of a patch's outline.
constexpr std::size_t outlinePoints = 12;

void drawIsolines(Sketch& sketch, const Surface& surface, const SurfaceSamples& samples) {
    const SurfaceLines lines = surfaceLines(surface);
    const ClosedDirections closed = closedDirections(surface);
    const auto draw = [&](const std::vector<double>& at, bool alongU, bool seam) {
        // The last line of a closed direction is its first once more.
        for (std::size_t i = 0; i + (seam ? 1 : 0) < at.size(); ++i) {
            Shape& shape = sketch.add(Role::isoline, Kind::polyline, 1);
            shape.index = static_cast<int>(i);
            shape.positions =
                lineOnSurface(surface, samples, alongU, at[i], sketch.tolerance());
        }
    };
    draw(lines.u, false, closed.u);
    draw(lines.v, true, closed.v);
}

/// The lines of the grid, or the sides of all triangles where there is none.
void drawGridEdges(Sketch& sketch, const SurfaceSamples& samples) {
    Shape& shape = sketch.add(Role::wireframe, Kind::polyline, 0.75F);
    shape.positions = samples.positions;
    std::vector<std::array<std::uint32_t, 2>> edges;
    const auto& corners = samples.triangles;
    // Of the triangles a, b, c and a, c, d of a cell the side c, a is its diagonal.
    const bool cells = samples.nu > 0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (cells && k == (i / 3 % 2 == 0 ? 2U : 0U)) continue;
            const auto [low, high] = std::minmax(corners[i + k], corners[i + (k + 1) % 3]);
            edges.push_back({low, high});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    shape.indices.reserve(2 * edges.size());
    for (const auto& edge : edges) {
        shape.indices.insert(shape.indices.end(), edge.begin(), edge.end());
    }
}

void drawNet(Sketch& sketch, const BsplineSurface& spline) {
    Shape& shape = sketch.add(Role::polygon, Kind::polyline, 1.25F);
    append(shape, spline.points());
    const std::size_t rows = spline.rowCount();
    const std::size_t columns = spline.columnCount();
    const ClosedDirections closed = spline.closed();
    const auto join = [&](std::size_t from, std::size_t to) {
        shape.indices.push_back(static_cast<std::uint32_t>(from));
        shape.indices.push_back(static_cast<std::uint32_t>(to));
    };
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const std::size_t next = (i + 1) % rows;
            const std::size_t right = (j + 1) % columns;
            if (next != 0 || closed.u) join(i * columns + j, next * columns + j);
            if (right != 0 || closed.v) join(i * columns + j, i * columns + right);
        }
    }
}

/// A shape a row, each showing its own list of the document.
void drawNetPoints(Sketch& sketch, const BsplineSurface& spline) {
    const std::size_t columns = spline.columnCount();
    for (std::size_t i = 0; i < spline.rowCount(); ++i) {
        Shape& shape = sketch.add(Role::points, Kind::points, 9);
        shape.path = indexed(sketch.path("points"), i);
        shape.index = static_cast<int>(i);
        append(shape, spline.points().subspan(i * columns, columns));
    }
}

void drawSphereAround(Sketch& sketch, const SurfaceSamples& samples) {
    std::vector<Vec3> points;
    points.reserve(samples.positions.size() / 3);
    for (std::size_t i = 0; i < samples.positions.size(); i += 3) {
        points.emplace_back(samples.positions[i], samples.positions[i + 1],
                            samples.positions[i + 2]);
    }
    drawSphere(sketch, points);
}

/// Where a patch has the greatest weight: half-way to its neighbours.
Interval strongPart(const BlendDirection& along, std::size_t index) noexcept {
    const Interval support = along.support(index);
    const double centre = along.knots[index];
    return {(support.start + centre) / 2, (centre + support.end) / 2};
}

void drawPatch(Sketch& sketch, const BlendingSurface& blend, std::size_t i, std::size_t j) {
    const Interval u = strongPart(blend.alongU(), i);
    const Interval v = strongPart(blend.alongV(), j);
    if (!(u.length() > 0) || !(v.length() > 0)) return;
    Shape& shape = sketch.add(Role::local, Kind::polyline, 1.5F);
    shape.index = static_cast<int>(i * blend.alongV().count + j);
    const auto corner = [&](double a, double b) {
        Vec3 point;
        blend.patch(i, j, {a, b, Side::right, Side::right}, {0, 0}, std::span(&point, 1));
        append(shape, point);
    };
    const auto side = [&](const Interval& along, bool back, auto at) {
        for (std::size_t k = 0; k < outlinePoints; ++k) {
            at(uniformParameter(along, back ? outlinePoints - k : k, outlinePoints + 1));
        }
    };
    side(u, false, [&](double t) { corner(t, v.start); });
    side(v, false, [&](double t) { corner(u.end, t); });
    side(u, true, [&](double t) { corner(t, v.end); });
    side(v, true, [&](double t) { corner(u.start, t); });
    corner(u.start, v.start);
}

void drawPatches(Sketch& sketch, const BlendingSurface& blend) {
    for (std::size_t i = 0; i < blend.alongU().count; ++i) {
        for (std::size_t j = 0; j < blend.alongV().count; ++j) drawPatch(sketch, blend, i, j);
    }
}

}  // namespace

std::vector<Vec3> handlePoints(const BlendingSurface& blend) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < blend.alongU().count; ++i) {
        for (std::size_t j = 0; j < blend.alongV().count; ++j) {
            const PatchPlace& place = blend.place(i, j);
            points.push_back(place.placement().point(place.origin()));
        }
    }
    return points;
}

void drawTriangles(Sketch& sketch, std::vector<double> positions, std::vector<double> normals,
                   std::vector<std::uint32_t> indices) {
    Shape& shape = sketch.add(Role::surface, Kind::triangles, 1);
    shape.positions = std::move(positions);
    shape.normals = std::move(normals);
    shape.indices = std::move(indices);
    const scene::Colouring by = sketch.object().style.colouring;
    if (by == scene::Colouring::colour) return;
    CurvatureColours made = curvatureColours(shape, by);
    shape.colours = std::move(made.colours);
    shape.range = made.range;
}

void drawSurfaceFigure(Sketch& sketch, const Surface& surface) {
    const scene::Show& show = sketch.show();
    if (show.surface || show.isolines || show.wireframe || show.sphere) {
        SurfaceSamples samples = sampleSurface(surface, sketch.tolerance());
        if (show.sphere) drawSphereAround(sketch, samples);
        if (show.wireframe) drawGridEdges(sketch, samples);
        if (show.isolines) drawIsolines(sketch, surface, samples);
        if (show.surface) {
            drawTriangles(sketch, std::move(samples.positions), std::move(samples.normals),
                          std::move(samples.triangles));
        }
    }
    const auto* spline = surface.as<BsplineSurface>();
    const auto* blend = surface.as<BlendingSurface>();
    if (blend != nullptr && show.locals) drawPatches(sketch, *blend);
    if (spline != nullptr && show.polygon) drawNet(sketch, *spline);
    if (spline != nullptr && show.points) drawNetPoints(sketch, *spline);
    if (blend != nullptr && show.handles) drawHandles(sketch, handlePoints(*blend));
}

}  // namespace knotwork::drawing
