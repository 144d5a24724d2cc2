// What curves consist of: the curve, its control polygon, knots, local curves and handles.
#include "drawing/measures.hpp"
#include "drawing/sketch.hpp"

namespace knotwork::drawing {

namespace {

/// A local curve over part of its support.
void drawLocalPart(Sketch& sketch, const LocalCurve& local, std::size_t j, const Interval& part,
                   bool dashed) {
    if (!(part.length() > 0)) return;
    const Interval own{local.rate() * part.start + local.shift(),
                       local.rate() * part.end + local.shift()};
    Shape& shape = sketch.addCurve(Role::local, 1.5F, local.source(), own, local.placement());
    shape.dashed = dashed;
    shape.index = static_cast<int>(j);
}

/// Solid where the local curve has the greater weight, dashed where its neighbour has it.
void drawLocals(Sketch& sketch, const BlendingCurve& blend) {
    for (std::size_t j = 0; j < blend.locals().size(); ++j) {
        const Interval support = blend.support(j);
        const double centre = blend.knots()[j];
        const Interval strong{(support.start + centre) / 2, (centre + support.end) / 2};
        const LocalCurve& local = blend.locals()[j];
        drawLocalPart(sketch, local, j, {support.start, strong.start}, true);
        drawLocalPart(sketch, local, j, strong, false);
        drawLocalPart(sketch, local, j, {strong.end, support.end}, true);
    }
}

std::span<const double> knotsOf(const Curve& curve) noexcept {
    if (const auto* spline = curve.as<BsplineCurve>()) return spline->knotVector().knots();
    if (const auto* blend = curve.as<BlendingCurve>()) return blend->knots();
    return {};
}

}  // namespace

ControlPolygon controlPolygon(const Curve& curve) noexcept {
    if (const auto* spline = curve.as<BsplineCurve>()) return {spline->points(), spline->closed()};
    if (const auto* bezier = curve.as<BezierCurve>()) return {bezier->points(), false};
    if (const auto* subdivision = curve.as<SubdivisionCurve>()) {
        return {subdivision->subdivision().points, subdivision->closed()};
    }
    return {};
}

void drawPolygon(Sketch& sketch, std::span<const Vec3> points, bool closed) {
    Shape& shape = sketch.add(Role::polygon, Kind::polyline, 1.5F);
    append(shape, points);
    if (closed) append(shape, points.front());
}

void drawKnotsOnCurve(Sketch& sketch, const Curve& curve, std::span<const double> knots) {
    Shape& shape = sketch.add(Role::knots, Kind::points, 6);
    const Interval whole = domain(curve);
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const bool repeated = i > 0 && knots[i] == knots[i - 1];
        if (repeated || !whole.contains(knots[i])) continue;
        append(shape, pointAt(curve, knots[i]));
    }
}

std::vector<Vec3> handlePoints(const BlendingCurve& blend) {
    std::vector<Vec3> points;
    for (const LocalCurve& local : blend.locals()) {
        points.push_back(local.placement().point(local.origin()));
    }
    return points;
}

void drawHandles(Sketch& sketch, std::span<const Vec3> points) {
    Shape& shape = sketch.add(Role::handle, Kind::points, 10);
    shape.square = true;
    shape.path = sketch.path("poses");
    append(shape, points);
}

void drawCurveFigure(Sketch& sketch, const Curve& curve) {
    const scene::Show& show = sketch.show();
    const auto* blend = curve.as<BlendingCurve>();
    const ControlPolygon control = controlPolygon(curve);
    if (show.sphere) drawSphere(sketch, curve);
    drawCurveMeasures(sketch, curve, control.points);
    if (blend != nullptr && show.locals) drawLocals(sketch, *blend);
    if (!control.points.empty() && show.polygon) {
        drawPolygon(sketch, control.points, control.closed);
    }
    if (show.curve) {
        sketch.addCurve(Role::curve, static_cast<float>(sketch.object().style.width), curve,
                        domain(curve))
            .dashed = sketch.object().style.dashed;
    }
    const std::span<const double> knots = knotsOf(curve);
    if (!knots.empty() && show.knots) drawKnotsOnCurve(sketch, curve, knots);
    if (!control.points.empty() && show.points) {
        Shape& shape = sketch.add(Role::points, Kind::points, 11);
        shape.path = sketch.path("points");
        append(shape, control.points);
    }
    if (show.crossings) drawCrossings(sketch, curve);
    if (blend != nullptr && show.handles) drawHandles(sketch, handlePoints(*blend));
}

}  // namespace knotwork::drawing
