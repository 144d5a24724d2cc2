#include "app/emphasis.hpp"

#include "app/support.hpp"
#include "geometry/differential.hpp"
#include "ui/theme.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace knotwork::app {

namespace {

constexpr double hoverStrength = 0.6;
constexpr std::size_t stretchPoints = 129;

/// Whether what is targeted has a basis function of its own.
bool rules(const Target& target) noexcept {
    return target.kind == TargetKind::point || target.kind == TargetKind::pose;
}

/// The element that basis function `index` of this shape belongs to stands out.
bool isPointedAt(const Shape& shape, const Emphasis& emphasis) noexcept {
    if (shape.object == emphasis.basisObject && shape.index == emphasis.basisIndex) return true;
    const auto belongs = [&](const std::optional<Target>& target) noexcept {
        return target && rules(*target) && target->object == shape.object &&
               static_cast<int>(target->index) == shape.index;
    };
    if (emphasis.hovered) return belongs(emphasis.hovered);
    return belongs(emphasis.selected) ||
           std::any_of(emphasis.others.begin(), emphasis.others.end(), belongs);
}

bool anyElement(const Emphasis& emphasis, int object) noexcept {
    const auto of = [object](const std::optional<Target>& target) {
        return target && rules(*target) && target->object == object;
    };
    return emphasis.basisObject == object || of(emphasis.hovered) || of(emphasis.selected);
}

void markElements(Painted& result, const Emphasis& emphasis) {
    const Shape& shape = *result.shape;
    const auto kind = kindOfList(shape.path);
    if (!kind || shape.kind != drawing::Kind::points) return;
    if (emphasis.selected && emphasis.selected->list == shape.path) {
        result.marks.push_back({emphasis.selected->index, 1});
    }
    for (const Target& other : emphasis.others) {
        if (other.list == shape.path) result.marks.push_back({other.index, 1});
    }
    if (emphasis.hovered && emphasis.hovered->list == shape.path) {
        result.marks.push_back({emphasis.hovered->index, hoverStrength});
    }
    const bool ofBasis = kind == TargetKind::point || kind == TargetKind::pose;
    if (ofBasis && shape.object == emphasis.basisObject) {
        result.marks.push_back({static_cast<std::size_t>(emphasis.basisIndex), hoverStrength});
    }
}

/// The element whose part of the curve or surface is shown.
struct Ruler {
    int object = -1;
    std::size_t index = 0;
    std::size_t row = 0;  ///< of a net
    bool knot = false;
};

Ruler rulerOf(const Target& target) noexcept {
    return {target.object, target.index, rowOf(target.list), target.kind == TargetKind::knot};
}

/// What is pointed at, or else all that is selected.
std::vector<Ruler> rulers(const Emphasis& emphasis) {
    if (emphasis.basisObject >= 0) {
        return {Ruler{emphasis.basisObject, static_cast<std::size_t>(emphasis.basisIndex)}};
    }
    const auto& target = emphasis.hovered ? emphasis.hovered : emphasis.selected;
    if (!target || target->kind == TargetKind::line || isValue(target->kind)) return {};
    std::vector<Ruler> all{rulerOf(*target)};
    if (emphasis.hovered && !emphasis.groups(*emphasis.hovered)) return all;
    if (emphasis.hovered && emphasis.selected) all.push_back(rulerOf(*emphasis.selected));
    for (const Target& other : emphasis.others) all.push_back(rulerOf(other));
    return all;
}

const scene::Placed* placedOf(const std::vector<scene::Placed>& placed,
                              const scene::State& state, int object) noexcept {
    if (object < 0 || static_cast<std::size_t>(object) >= state.objects.size()) return nullptr;
    const scene::Object* wanted = state.objects[static_cast<std::size_t>(object)].get();
    for (const scene::Placed& one : placed) {
        if (one.object == wanted) return &one;
    }
    return nullptr;
}

Shape dotAt(const Vec3& p, const scene::Colour& colour) {
    Shape dot;
    dot.object = -1;
    dot.role = drawing::Role::trace;
    dot.kind = drawing::Kind::points;
    dot.positions = {p.x, p.y, p.z};
    dot.colour = colour;
    dot.width = 9;
    return dot;
}

const ui::Theme& coloursOf(const FigureRequest& request) noexcept {
    return ui::theme(request.theme);
}

void addParameterLine(PaneFigure& pane, double t, bool named, const ui::Theme& colours) {
    ui::Lines line{{}, colours.accent, 1.25};
    ui::addThrough(line, pane.plot, t);
    pane.plot.over.push_back(std::move(line));
    if (!named) return;
    const bool left = pane.plot.map.pixelX(t) > pane.plot.area.centre().x;
    pane.plot.labels.push_back({"t = " + ui::numberText(t, 3),
                                {pane.plot.map.pixelX(t) + (left ? -6 : 6), pane.plot.area.y - 2},
                                left ? ui::Align::right : ui::Align::left, ui::Baseline::middle,
                                11, true, colours.accent, true});
}

/// A parameter to be shown, and of which object it is.
struct ShownParameter {
    double t = 0;
    bool ofCurve = true;  ///< else of the B-function
    int object = -1;
};

/// The one that is pointed at, or that of the knot that is pointed at or selected.
std::optional<ShownParameter> shownParameter(const Figure& figure,
                                             const Emphasis& emphasis) noexcept {
    if (emphasis.parameter) {
        const PaneFigure* pane = figure.find(emphasis.parameterPane);
        return ShownParameter{*emphasis.parameter, emphasis.parameterPane != Pane::bFunction,
                              pane != nullptr ? pane->plot.object : -1};
    }
    for (const auto* target : {&emphasis.hovered, &emphasis.selected}) {
        if (*target && (*target)->kind == TargetKind::knot) {
            return ShownParameter{(*target)->at.x, true, (*target)->object};
        }
    }
    return std::nullopt;
}

void addParameterLines(Figure& figure, const FigureRequest& request) {
    const auto shown = shownParameter(figure, request.emphasis);
    if (!shown) return;
    bool named = false;
    for (PaneFigure& pane : figure.panes) {
        const Pane kind = pane.plot.pane;
        if (kind == Pane::curve || kind == Pane::hodograph) continue;
        const bool other = (kind == Pane::bFunction) == shown->ofCurve;
        if (other || pane.plot.object != shown->object) continue;
        addParameterLine(pane, shown->t, !named, coloursOf(request));
        named = true;
    }
}

/// What the rulers rule of a curve, wide and faint, each part once.
void addRuledStretches(PaneFigure& pane, const scene::Placed& placed,
                       const std::vector<Ruler>& ruling, bool dark) {
    const Curve& curve = *placed.body.curve();
    std::vector<Interval> parts;
    for (const Ruler& one : ruling) {
        const auto part = one.knot ? ruledByKnot(curve, one.index)
                                   : ruledInterval(curve, one.index);
        if (part) parts.push_back(*part);
    }
    for (const Interval& part : joined(std::move(parts), domain(curve).length())) {
        Shape stretch = stretchOf(placed, part, stretchPoints);
        stretch.width = static_cast<float>(placed.object->style.width + 9);
        stretch.colour.alpha = dark ? 0.34 : 0.22;
        pane.below.push_back(std::move(stretch));
    }
}

void addRuled(PaneFigure& pane, const FigureRequest& request, const scene::Placed* placed,
              const Ruler& ruling) {
    std::optional<Shape> lines;
    if (const Surface* surface = placed->body.surface()) {
        if (const auto part = ruledRectangle(*surface, ruling.row, ruling.index)) {
            lines = gridOf(*placed, *part);
        }
    } else if (placed->body.subdivision() != nullptr) {
        lines = starOf(*placed, ruling.index);
    }
    if (!lines) return;
    lines->colour = coloursOf(request).accent;
    lines->width = lines->role == drawing::Role::isoline ? 2.0F : 3.5F;
    pane.below.push_back(std::move(*lines));
}

/// The parts of all objects that are ruled.
void addAllRuled(PaneFigure& pane, const FigureRequest& request,
                 const std::vector<scene::Placed>& all, const std::vector<Ruler>& ruling) {
    std::map<int, std::vector<Ruler>> byObject;
    for (const Ruler& one : ruling) byObject[one.object].push_back(one);
    for (const auto& [object, rulers] : byObject) {
        const scene::Placed* placed = placedOf(all, *request.state, object);
        if (placed == nullptr) continue;
        if (placed->body.curve() != nullptr) {
            addRuledStretches(pane, *placed, rulers, ui::isDark(request.theme));
            continue;
        }
        for (const Ruler& one : rulers) addRuled(pane, request, placed, one);
    }
}

/// The same parameter on the hodograph of the object.
void addDerivativeDot(Figure& figure, const FigureRequest& request, const scene::Placed& placed,
                      int object, double t) {
    const Curve& curve = *placed.body.curve();
    std::array<Vec3, 2> rows{};
    evaluate(curve, t, t < domain(curve).end ? Side::right : Side::left, rows);
    for (PaneFigure& pane : figure.panes) {
        if (pane.plot.pane != Pane::hodograph || pane.plot.object != object) continue;
        pane.above.push_back(dotAt(placed.placement.linear * rows[1], coloursOf(request).accent));
    }
}

/// And on the graph of its curvature, or at the edge where that goes beyond it.
void addCurvatureDot(Figure& figure, const FigureRequest& request, const scene::Placed& placed,
                     int object, double t) {
    const Curve& curve = *placed.body.curve();
    const Side side = t < domain(curve).end ? Side::right : Side::left;
    for (PaneFigure& pane : figure.panes) {
        const ui::Plot& plot = pane.plot;
        if (plot.pane != Pane::curvature || plot.object != object) continue;
        const double value = std::clamp(frameAt(curve, t, side).curvature,
                                        plot.map.unitY(plot.area.bottom()),
                                        plot.map.unitY(plot.area.y));
        pane.above.push_back(dotAt({t, value, 0}, coloursOf(request).accent));
    }
}

void addDot(Figure& figure, const FigureRequest& request, const std::vector<scene::Placed>& all,
            const ShownParameter& shown) {
    const scene::Placed* placed = placedOf(all, *request.state, shown.object);
    const Curve* curve = placed != nullptr ? placed->body.curve() : nullptr;
    if (curve == nullptr) return;
    const auto t = parameterInDomain(*curve, shown.t);
    if (!t) return;
    figure.panes.front().above.push_back(dotAt(
        placed->placement.point(pointAt(*curve, *t)), coloursOf(request).accent));
    addDerivativeDot(figure, request, *placed, shown.object, *t);
    addCurvatureDot(figure, request, *placed, shown.object, *t);
}

}  // namespace

bool Emphasis::groups(const Target& target) const noexcept {
    const auto same = [&](const Target& one) noexcept { return one.same(target); };
    return !others.empty() && selected &&
           (same(*selected) || std::any_of(others.begin(), others.end(), same));
}

Painted painted(const Shape& shape, const Emphasis& emphasis) {
    Painted result{&shape, 1, 0, {}};
    if (shape.pane == Pane::basis && shape.kind == drawing::Kind::polyline) {
        if (isPointedAt(shape, emphasis)) {
            result.extraWidth = 1.5;
        } else if (anyElement(emphasis, shape.object)) {
            result.opacity = 0.35;
        }
    }
    markElements(result, emphasis);
    return result;
}

void addEmphasis(Figure& figure, const FigureRequest& request) {
    addParameterLines(figure, request);
    if (figure.panes.empty() || figure.panes.front().plot.pane != Pane::curve) return;
    const std::vector<Ruler> ruling = rulers(request.emphasis);
    const auto shown = shownParameter(figure, request.emphasis);
    const bool dotted = shown && shown->ofCurve;
    if (ruling.empty() && !dotted) return;
    const auto placed = scene::place(*request.state, request.moment);
    addAllRuled(figure.panes.front(), request, placed, ruling);
    if (dotted) addDot(figure, request, placed, *shown);
}

}  // namespace knotwork::app
