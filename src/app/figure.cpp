#include "app/figure.hpp"

#include "app/emphasis.hpp"
#include "drawing/letters.hpp"
#include "drawing/plots.hpp"
#include "ui/basis_plot.hpp"
#include "ui/bfunction_plot.hpp"
#include "ui/curvature_plot.hpp"
#include "ui/legend.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

namespace {

using drawing::Kind;

constexpr double nameAside = 12;  // CSS pixels from an arrow to its letter

std::vector<const Shape*> shapesOf(const drawing::Drawing& drawing, Pane pane, int object) {
    std::vector<const Shape*> found;
    for (const Shape& shape : drawing.shapes) {
        if (shape.pane == pane && shape.object == object) found.push_back(&shape);
    }
    return found;
}

/// The wanted object where it has shapes in the pane, else the first that has, else -1.
int plottedObject(const drawing::Drawing& drawing, Pane pane, int wanted) noexcept {
    int first = -1;
    for (const Shape& shape : drawing.shapes) {
        if (shape.pane != pane) continue;
        if (shape.object == wanted) return wanted;
        if (first < 0) first = shape.object;
    }
    return first;
}

bool asksFor(const scene::State& state, std::string_view pane) noexcept {
    const scene::Json* view = state.header ? scene::member(*state.header, "view") : nullptr;
    const scene::Json* panes = view != nullptr ? scene::member(*view, "panes") : nullptr;
    if (panes == nullptr || !panes->is_array()) return true;
    return std::any_of(panes->begin(), panes->end(),
                       [pane](const scene::Json& name) { return name == pane; });
}

std::vector<double> knotsOf(const std::vector<const Shape*>& shapes) {
    std::vector<double> knots;
    for (const Shape* shape : shapes) {
        if (shape->kind != Kind::points) continue;
        for (std::size_t i = 0; i < shape->positions.size(); i += 3) {
            knots.push_back(shape->positions[i]);
        }
    }
    std::sort(knots.begin(), knots.end());
    return knots;
}

const Curve* curveOf(const scene::State& state, int object) noexcept {
    if (object < 0 || static_cast<std::size_t>(object) >= state.objects.size()) return nullptr;
    return state.objects[static_cast<std::size_t>(object)]->body.curve();
}

/// What the curvature, the basis functions and the knot line of one object have in common.
struct ParameterPlots {
    int object = -1;
    std::vector<const Shape*> basis;
    std::vector<const Shape*> knotShapes;
    std::vector<const Shape*> curvature;
    std::vector<double> knots;
    Interval domain;
    Interval range;
};

ParameterPlots parameterPlots(const FigureRequest& request) {
    const drawing::Drawing& drawing = *request.drawing;
    ParameterPlots plots;
    plots.object = plottedObject(drawing, Pane::knots, request.object);
    if (plots.object < 0) plots.object = plottedObject(drawing, Pane::basis, request.object);
    if (plots.object < 0) plots.object = plottedObject(drawing, Pane::curvature, request.object);
    plots.curvature = shapesOf(drawing, Pane::curvature, plots.object);
    plots.basis = shapesOf(drawing, Pane::basis, plots.object);
    plots.knotShapes = shapesOf(drawing, Pane::knots, plots.object);
    plots.knots = knotsOf(plots.knotShapes);
    std::vector<const Shape*> all = plots.basis;
    all.insert(all.end(), plots.knotShapes.begin(), plots.knotShapes.end());
    const Curve* curve = curveOf(*request.state, plots.object);
    const Interval extent = ui::extentX(all);
    plots.domain = curve != nullptr ? domain(*curve) : extent;
    plots.range = request.frozenRange ? *request.frozenRange : all.empty() ? plots.domain : extent;
    return plots;
}

/// An area of a curve's plane with control points gets a grid to read them by; a picture of curves
/// alone is left to itself.
bool wantsGrid(const drawing::Drawing& drawing) noexcept {
    return std::any_of(drawing.shapes.begin(), drawing.shapes.end(), [](const Shape& shape) {
        return shape.pane == Pane::curve && offers(shape) &&
               kindOfList(shape.path) == TargetKind::point;
    });
}

/// What is lit lies before or behind something, also where it is seen from above and stays so.
bool hasSurface(const drawing::Drawing& drawing) noexcept {
    return std::any_of(drawing.shapes.begin(), drawing.shapes.end(), [](const Shape& shape) {
        return shape.pane == Pane::curve && shape.kind == Kind::triangles;
    });
}

/// The radius of a sphere about the middle that holds the bounds.
double reachOf(const drawing::Bounds& bounds, const Vec3& middle) noexcept {
    const Vec3 low = glm::abs(bounds.min - middle);
    const Vec3 high = glm::abs(bounds.max - middle);
    return bounds.empty ? 1 : std::max(glm::length(glm::max(low, high)), 1e-9);
}

void addGhost(PaneFigure& pane, const FigureRequest& request) {
    if (request.ghost == nullptr) return;
    for (const Shape& shape : *request.ghost) {
        if (pane.plot.shows(shape)) pane.below.push_back(shape);
    }
}

void addValues(PaneFigure& pane, const FigureRequest& request) {
    if (request.values == nullptr) return;
    for (const Shape& shape : *request.values) {
        if (pane.plot.shows(shape)) pane.shapes.push_back(painted(shape, request.emphasis));
    }
}

/// Above and to the right of what is dragged; where there is no room, on the other side.
void addReading(PaneFigure& pane, const Reading& reading, const ui::Theme& colours) {
    const Pixel at = pane.sight.toPixels(reading.at);
    ui::Label label{reading.text, {at.x + 14, at.y - 16}, ui::Align::left, ui::Baseline::middle,
                    12, true, colours.text, true, true};
    if (ui::boxOf(label).right() > pane.plot.box.right()) {
        label.at.x = at.x - 14;
        label.align = ui::Align::right;
    }
    if (label.at.y < pane.plot.box.y + 8) label.at.y = at.y + 18;
    pane.plot.labels.push_back(std::move(label));
}

/// The rim of what a pointer draws a band round.
Shape bandShape(const Box& band, const PaneFigure& pane, const ui::Theme& colours) {
    Shape rim;
    rim.object = -1;
    rim.role = drawing::Role::handle;
    rim.colour = colours.accent;
    rim.width = 1.25F;
    rim.dashed = true;
    const std::array<Pixel, 5> corners{Pixel{band.x, band.y}, Pixel{band.right(), band.y},
                                       Pixel{band.right(), band.bottom()},
                                       Pixel{band.x, band.bottom()}, Pixel{band.x, band.y}};
    for (const Pixel& corner : corners) {
        const Vec3 p = pane.sight.fromPixels(corner, pane.middle);
        rim.positions.insert(rim.positions.end(), {p.x, p.y, p.z});
    }
    return rim;
}

/// The tool at the selected handle, its arrows named.
void addGizmo(PaneFigure& pane, const Gizmo& gizmo, const FigureRequest& request) {
    for (Shape& shape : gizmoShapes(gizmo, pane.sight, request.emphasis.part,
                                    ui::isDark(request.theme))) {
        pane.tools.push_back(std::move(shape));
    }
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    const Pixel at = pane.sight.toPixels(gizmo.at);
    for (int axis = 0; axis < 3; ++axis) {
        const auto tip = arrowTip(gizmo, pane.sight, axis);
        if (!tip) continue;
        const double length = std::hypot(tip->x - at.x, tip->y - at.y);
        const Pixel aside{-(tip->y - at.y) / length, (tip->x - at.x) / length};
        pane.plot.labels.push_back({std::string(names[static_cast<std::size_t>(axis)]),
                                    {tip->x + nameAside * aside.x, tip->y + nameAside * aside.y},
                                    ui::Align::centre, ui::Baseline::middle, 12, true,
                                    axisColour(axis, ui::isDark(request.theme)), false, true});
    }
}

/// The words of a label shape whose place is in the pane, moved so that all of them are.
void addName(PaneFigure& pane, const Shape& shape) {
    constexpr double size = 13;
    constexpr double margin = 4;
    const Box& box = pane.plot.box;
    const Pixel at = pane.sight.toPixels(positionOf(shape, 0));
    Pixel middle{at.x + static_cast<double>(shape.offset[0]),
                 at.y + static_cast<double>(shape.offset[1])};
    const double half = 0.3 * size * static_cast<double>(drawing::lettersIn(shape.text)) + margin;
    const double high = 0.6 * size + margin;
    if (!box.contains(at)) return;
    if (box.width > 2 * half && box.height > 2 * high) {
        middle.x = std::clamp(middle.x, box.x + half, box.right() - half);
        middle.y = std::clamp(middle.y, box.y + high, box.bottom() - high);
    }
    pane.plot.labels.push_back({shape.text, middle, ui::Align::centre, ui::Baseline::middle, size,
                                false, shape.colour});
}

void addCurvePane(Figure& figure, const FigureRequest& request, const Box& box,
                  const Camera& camera, const ui::Theme& colours) {
    PaneFigure pane;
    pane.plot.pane = Pane::curve;
    pane.plot.box = pane.plot.area = box;
    pane.plot.map = camera.map(box);
    pane.sight = camera.sight(box);
    pane.middle = camera.aim().centre;
    if (request.spatial || !pane.sight.flat() || hasSurface(*request.drawing)) {
        pane.reach = reachOf(request.drawing->bounds, pane.middle);
    } else if (wantsGrid(*request.drawing)) {
        ui::addPlaneGrid(pane.plot, colours);
    }
    for (const Shape& shape : request.drawing->shapes) {
        if (shape.pane != Pane::curve) continue;
        if (request.emphasis.quiet && shape.role == drawing::Role::handle) continue;
        if (shape.kind != Kind::label) {
            pane.shapes.push_back(painted(shape, request.emphasis));
        } else if (!shape.positions.empty()) {
            addName(pane, shape);
        }
    }
    addValues(pane, request);
    addGhost(pane, request);
    if (request.band) pane.tools.push_back(bandShape(*request.band, pane, colours));
    if (request.reading && request.reading->pane == Pane::curve) {
        addReading(pane, *request.reading, colours);
    }
    if (request.gizmo) addGizmo(pane, *request.gizmo, request);
    figure.panes.push_back(std::move(pane));
}

/// A bar for each surface that is coloured by its curvature, in the corner of the pane of curves.
void addLegends(Figure& figure, const FigureRequest& request, const Box& box,
                const ui::Theme& colours) {
    std::size_t place = 0;
    for (const Shape& shape : request.drawing->shapes) {
        if (!(shape.range > 0)) continue;
        const scene::Object& object =
            *request.state->objects[static_cast<std::size_t>(shape.object)];
        const bool gaussian = object.style.colouring == scene::Colouring::gaussian;
        PaneFigure pane;
        pane.plot = ui::curvatureLegend(box, place++, (gaussian ? "K  " : "H  ") + object.id,
                                        shape.range, colours);
        pane.sight = Sight(pane.plot.map);
        figure.panes.push_back(std::move(pane));
    }
}

void addPlot(Figure& figure, ui::Plot plot, int object, const FigureRequest& request) {
    PaneFigure pane;
    plot.object = object;
    for (const Shape& shape : request.drawing->shapes) {
        if (shape.kind != Kind::label && plot.shows(shape)) {
            pane.shapes.push_back(painted(shape, request.emphasis));
        }
    }
    pane.sight = Sight(plot.map);
    pane.plot = std::move(plot);
    addValues(pane, request);
    figure.panes.push_back(std::move(pane));
}

/// Smallest and largest curvature; of a curve that bends nowhere 0 alone.
Interval curvatureValues(const std::vector<const Shape*>& shapes) noexcept {
    Interval values{0, 0};
    for (const Shape* shape : shapes) {
        for (std::size_t i = 1; i < shape->positions.size(); i += 3) {
            values.start = std::min(values.start, shape->positions[i]);
            values.end = std::max(values.end, shape->positions[i]);
        }
    }
    return values;
}

/// On the axis of the plots below it where these are of the same object, else on its own.
void addCurvature(Figure& figure, const FigureRequest& request, const Box& box,
                  const ParameterPlots& plots, bool above, const ui::Theme& colours) {
    const int object = plottedObject(*request.drawing, Pane::curvature, plots.object);
    const auto shapes = shapesOf(*request.drawing, Pane::curvature, object);
    const bool shared = object == plots.object;
    ui::CurvatureContent content{curvatureValues(shapes), {}, shared && above};
    if (shared) content.knots = plots.knots;
    for (const Shape* shape : shapes) {
        if (shape->kind == Kind::label) content.labels.push_back(shape);
    }
    const ui::ParameterAxis axis =
        shared ? figure.axis : ui::parameterAxis(box, domain(*curveOf(*request.state, object)));
    addPlot(figure, ui::curvaturePlot(box, axis, content, colours), object, request);
}

void addParameterPanes(Figure& figure, const FigureRequest& request,
                       const ui::FigureLayout& layout, const ui::Theme& colours) {
    if (!layout.basis && !layout.knots && !layout.curvature) return;
    const ParameterPlots plots = parameterPlots(request);
    const Box& column = layout.basis       ? *layout.basis
                        : layout.curvature ? *layout.curvature
                                           : *layout.knots;
    figure.axis = ui::parameterAxis(column, plots.range);
    const bool below = layout.basis || layout.knots;
    if (layout.curvature) addCurvature(figure, request, *layout.curvature, plots, below, colours);
    const bool joined = layout.curvature && !plots.curvature.empty();
    if (layout.basis) {
        const ui::BasisContent content{ui::extentY(plots.basis), plots.knots, joined};
        addPlot(figure,
                ui::basisPlot(*layout.basis, figure.axis, content, !layout.knots, colours),
                plots.object, request);
    }
    if (layout.knots) {
        addPlot(figure,
                ui::knotLine(*layout.knots, figure.axis,
                             {plots.knots, plots.domain, layout.basis || joined}, colours),
                plots.object, request);
    }
}

/// The blend of a curve, to say its Hermite order.
std::array<double, 2> orderOf(const scene::State& state, int object) noexcept {
    const Curve* curve = curveOf(state, object);
    const auto* blend = curve != nullptr ? curve->as<BlendingCurve>() : nullptr;
    return blend != nullptr ? blend->blend().order() : std::array<double, 2>{0, 0};
}

/// A line of the legend for each of the objects.
std::vector<ui::BFunctionEntry> bFunctionEntries(const FigureRequest& request,
                                                 const std::vector<int>& objects) {
    std::vector<ui::BFunctionEntry> entries;
    for (const int object : objects) {
        const std::vector<const Shape*> shapes =
            shapesOf(*request.drawing, Pane::bFunction, object);
        entries.push_back({request.state->objects[static_cast<std::size_t>(object)]->id,
                           shapes.front()->colour, shapes.front()->dashed,
                           orderOf(*request.state, object)});
    }
    return entries;
}

/// The rows of one object, or of several that are compared.
void addBFunction(Figure& figure, const FigureRequest& request, const Box& box,
                  const ui::Theme& colours) {
    const int object = plottedObject(*request.drawing, Pane::bFunction, request.object);
    const std::vector<int> objects = drawing::comparedObjects(*request.drawing, object);
    ui::BFunctionContent content;
    for (int order = 0;; ++order) {
        std::vector<const Shape*> rows;
        for (const int one : objects) {
            for (const Shape* shape : shapesOf(*request.drawing, Pane::bFunction, one)) {
                if (shape->index == order) rows.push_back(shape);
            }
        }
        if (rows.empty()) break;
        content.values.push_back(ui::extentY(rows));
    }
    content.orderWords = request.orderWords;
    content.order = orderOf(*request.state, object);
    if (objects.size() > 1) content.compared = bFunctionEntries(request, objects);
    for (ui::Plot& plot : ui::bFunctionPlots(box, content, colours)) {
        plot.besides = objects;
        addPlot(figure, std::move(plot), object, request);
        PaneFigure& pane = figure.panes.back();
        // What was before the drag goes on belonging to the object whose plot this is.
        if (pane.plot.index == 0) addGhost(pane, request);
        if (pane.plot.index == 0 && request.reading && request.reading->pane == Pane::bFunction) {
            addReading(pane, *request.reading, colours);
        }
    }
}

/// First derivatives about their origin, from where the curve is seen, x and y to one scale.
void addHodograph(Figure& figure, const FigureRequest& request, const Box& box,
                  const Viewpoint& from, const ui::Theme& colours) {
    const int object = plottedObject(*request.drawing, Pane::hodograph, request.object);
    const Orientation orientation = orientationOf(from);
    drawing::Bounds whole;
    drawing::Bounds seen;
    for (const Shape* shape : shapesOf(*request.drawing, Pane::hodograph, object)) {
        for (std::size_t i = 0; i < shape->positions.size() / 3; ++i) {
            whole.add(positionOf(*shape, i));
            seen.add(orientation * positionOf(*shape, i));
        }
    }
    ui::Plot plot;
    plot.pane = Pane::hodograph;
    plot.box = box;
    plot.area = inside(box, {ui::plotMargins.left, ui::plotMargins.top, ui::plotMargins.right, 28});
    const Aim aim = fitAim(seen, plot.area, from);
    plot.map = mapOf(aim, plot.area);
    const bool plane = from == fromAbove && !request.spatial;
    if (plane) ui::addPlaneAxes(plot, colours);
    plot.labels.push_back({"C\u2032", {plot.area.x + 8, plot.area.y + 5}, ui::Align::left,
                           ui::Baseline::top, 13, true, colours.text});
    addPlot(figure, std::move(plot), object, request);
    PaneFigure& pane = figure.panes.back();
    pane.sight = sightOf(aim, pane.plot.area);
    pane.middle = aim.centre;
    if (!plane) pane.reach = reachOf(whole, aim.centre);
}

}  // namespace

const PaneFigure* Figure::paneAt(const Pixel& p) const noexcept {
    for (const PaneFigure& pane : panes) {
        if (pane.plot.box.contains(p)) return &pane;
    }
    return nullptr;
}

const PaneFigure* Figure::find(Pane pane) const noexcept {
    for (const PaneFigure& one : panes) {
        if (one.plot.pane == pane) return &one;
    }
    return nullptr;
}

drawing::Panes panesAsked(const scene::State& state) noexcept {
    const auto asked = [&](Pane pane) { return asksFor(state, drawing::paneName(pane)); };
    return {true, asked(Pane::basis), asked(Pane::knots), asked(Pane::bFunction),
            asked(Pane::hodograph), asked(Pane::curvature)};
}

ui::FigureLayout layoutOf(const FigureRequest& request) {
    const auto has = [&](Pane pane) {
        return asksFor(*request.state, drawing::paneName(pane)) &&
               plottedObject(*request.drawing, pane, request.object) >= 0;
    };
    ui::WantedPanes wanted;
    wanted.basis = has(Pane::basis);
    wanted.knots = has(Pane::knots);
    wanted.bFunction = has(Pane::bFunction);
    wanted.hodograph = has(Pane::hodograph);
    wanted.curvature = has(Pane::curvature);
    const bool plots = wanted.basis || wanted.knots || wanted.bFunction || wanted.hodograph ||
                       wanted.curvature;
    wanted.curve = !plots || asksFor(*request.state, "curve");
    wanted.curveAspect = request.curveAspect;
    if (wanted.knots) wanted.knotRows = ui::tallestPile(parameterPlots(request).knots);
    return ui::layoutFigure(request.box, wanted, request.shares);
}

Figure composeFigure(const FigureRequest& request, const ui::FigureLayout& layout,
                     const Camera& camera) {
    const ui::Theme& colours = ui::theme(request.theme);
    Figure figure;
    if (layout.curve) addCurvePane(figure, request, *layout.curve, camera, colours);
    if (layout.curve) addLegends(figure, request, *layout.curve, colours);
    addParameterPanes(figure, request, layout, colours);
    if (layout.bFunction) addBFunction(figure, request, *layout.bFunction, colours);
    if (layout.hodograph) {
        addHodograph(figure, request, *layout.hodograph, camera.aim().from, colours);
    }
    addEmphasis(figure, request);
    return figure;
}

}  // namespace knotwork::app
