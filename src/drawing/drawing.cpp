#include "drawing/drawing.hpp"

#include "drawing/annotations.hpp"
#include "drawing/palette.hpp"
#include "drawing/plots.hpp"
#include "drawing/sketch.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace knotwork::drawing {

namespace {

constexpr std::array roleNames{
    std::string_view("curve"), std::string_view("surface"), std::string_view("wireframe"),
    std::string_view("polygon"), std::string_view("points"), std::string_view("knots"),
    std::string_view("local"), std::string_view("handle"), std::string_view("basis"),
    std::string_view("bFunction"), std::string_view("comb"), std::string_view("hodograph"),
    std::string_view("hull"), std::string_view("frame"), std::string_view("sphere"),
    std::string_view("residual"), std::string_view("isoline"), std::string_view("trace"),
    std::string_view("label")};
static_assert(roleNames.size() == static_cast<std::size_t>(Role::label) + 1);

Pen penOf(const Sketch& sketch) {
    const scene::Style& style = sketch.object().style;
    Colour colour = onBackground(style.colour, sketch.options().dark);
    colour.alpha = 1;
    return {colour, style.dashed};
}

/// The functions in the panes of plots, and the B-functions of both directions of a surface.
void drawBFunctions(Sketch& sketch, const BlendingSurface& blend) {
    const BFunction& along = blend.alongU().blend;
    Pen pen = penOf(sketch);
    sketch.take(bFunctionPlot(along, sketch.number(), pen));
    if (blend.alongV().blend == along) return;
    pen.dashed = !pen.dashed;
    sketch.take(bFunctionPlot(blend.alongV().blend, sketch.number(), pen));
}

void drawFunctions(Sketch& sketch, const Curve& curve, bool editable) {
    const auto* spline = curve.as<BsplineCurve>();
    const auto* blend = curve.as<BlendingCurve>();
    if (spline == nullptr && blend == nullptr) return;
    const Panes& panes = sketch.options().panes;
    const scene::Show& show = sketch.show();
    const bool dark = sketch.options().dark;
    if (show.basis && panes.basis) sketch.take(basisPlot(curve, sketch.number(), dark));
    const std::span<const double> knots =
        spline != nullptr ? spline->knotVector().knots() : std::span<const double>(blend->knots());
    if ((show.knots || show.basis) && panes.knots) {
        std::vector<Shape> line;
        line.push_back(knotLine(knots, sketch.number(),
                                editable ? sketch.path("knots") : std::string(), dark));
        sketch.take(std::move(line));
    }
    if (blend != nullptr && show.bFunction && panes.bFunction) {
        sketch.take(bFunctionPlot(blend->blend(), sketch.number(), penOf(sketch)));
    }
}

}  // namespace

std::string_view roleName(Role role) noexcept { return roleNames[static_cast<std::size_t>(role)]; }

std::string_view kindName(Kind kind) noexcept {
    constexpr std::array names{std::string_view("polyline"), std::string_view("points"),
                               std::string_view("triangles"), std::string_view("label")};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view paneName(Pane pane) noexcept {
    constexpr std::array names{std::string_view("curve"), std::string_view("basis"),
                               std::string_view("knots"), std::string_view("bFunction"),
                               std::string_view("hodograph"), std::string_view("curvature")};
    static_assert(names.size() == allPanes.size());
    return names[static_cast<std::size_t>(pane)];
}

void Bounds::add(const Vec3& p) noexcept {
    min = empty ? p : Vec3(std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z));
    max = empty ? p : Vec3(std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z));
    empty = false;
}

void Bounds::add(const Bounds& other) noexcept {
    if (other.empty) return;
    add(other.min);
    add(other.max);
}

void Bounds::add(const Shape& shape) noexcept {
    if (shape.pane != Pane::curve) return;
    for (std::size_t i = 0; i < shape.positions.size() / 3; ++i) add(positionAt(shape, i));
}

std::vector<Shape> sketchFigure(const scene::Object& object, const scene::Body& body, int number,
                                const Options& options) {
    if (!options.panes.curve && !options.panes.hodograph && !options.panes.curvature) return {};
    Sketch sketch(object, body, number, options);
    if (const Curve* curve = body.curve()) drawCurveFigure(sketch, *curve);
    if (const Surface* surface = body.surface()) drawSurfaceFigure(sketch, *surface);
    if (const auto* mesh = body.subdivision()) drawMeshFigure(sketch, *mesh);
    if (const auto* cloud = body.cloud()) drawCloudFigure(sketch, *cloud);
    if (const auto* graph = body.graph()) drawGraphFigure(sketch, *graph);
    drawTrace(sketch);
    drawStencil(sketch);
    drawLabels(sketch);
    std::vector<Shape> shapes = std::move(sketch).finish();
    if (!options.panes.curve) {
        std::erase_if(shapes, [](const Shape& shape) { return shape.pane == Pane::curve; });
    }
    return shapes;
}

std::vector<Shape> sketchPlots(const scene::Object& object, const scene::Body& body, int number,
                               const Options& options) {
    Sketch sketch(object, body, number, options);
    if (const Curve* curve = body.curve()) drawFunctions(sketch, *curve, true);
    if (const auto* cloud = body.cloud(); cloud != nullptr && cloud->fit) {
        drawFunctions(sketch, Curve(cloud->fit->curve), false);
    }
    const auto* blend = body.as<BlendingSurface>();
    if (blend != nullptr && object.show.bFunction && options.panes.bFunction) {
        drawBFunctions(sketch, *blend);
    }
    return std::move(sketch).finish();
}

void drawObject(Drawing& drawing, const scene::Placed& placed, int number, const Options& options) {
    const scene::Object& object = *placed.object;
    Options own = options;
    own.tolerance = ownTolerance(options.tolerance, placed.placement);
    std::vector<Shape> figure = sketchFigure(object, placed.body, number, own);
    placeShapes(figure, placed.placement, placed.colour, options.dark);
    for (const Shape& shape : figure) drawing.bounds.add(shape);
    std::move(figure.begin(), figure.end(), std::back_inserter(drawing.shapes));
    std::vector<Shape> plots = sketchPlots(object, placed.body, number, own);
    std::move(plots.begin(), plots.end(), std::back_inserter(drawing.shapes));
}

Drawing draw(const scene::State& state, const Options& options) {
    Drawing drawing;
    const std::vector<scene::Placed> placed = scene::place(state, options.moment);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        drawObject(drawing, placed[i], static_cast<int>(i), options);
    }
    return drawing;
}

}  // namespace knotwork::drawing
