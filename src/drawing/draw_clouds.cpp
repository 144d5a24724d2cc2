// What clouds of points consist of: the data, the curve that was fitted to them, and how far it is
// from each.
#include "drawing/measures.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

void drawResiduals(Sketch& sketch, const scene::PointCloud& cloud, const Fit& fit) {
    Shape& shape = sketch.add(Role::residual, Kind::polyline, 1.25F);
    const Curve curve(fit.curve);
    const std::size_t count = std::min(cloud.points.size(), fit.parameters.size());
    for (std::size_t i = 0; i < count; ++i) {
        appendSegment(shape, cloud.points[i], pointAt(curve, fit.parameters[i]));
    }
}

void drawFit(Sketch& sketch, const scene::PointCloud& cloud, const Fit& fit) {
    const scene::Show& show = sketch.show();
    const Curve curve(fit.curve);
    drawCurveMeasures(sketch, curve, {});
    if (show.residuals) drawResiduals(sketch, cloud, fit);
    if (show.polygon) drawPolygon(sketch, fit.curve.points(), fit.curve.closed());
    if (show.curve) {
        sketch.addCurve(Role::curve, static_cast<float>(sketch.object().style.width), curve,
                        domain(curve));
    }
    if (show.knots) drawKnotsOnCurve(sketch, curve, fit.curve.knotVector().knots());
}

}  // namespace

void drawCloudFigure(Sketch& sketch, const scene::PointCloud& cloud) {
    if (sketch.show().hull) drawHull(sketch, cloud.points);
    if (sketch.show().sphere) drawSphere(sketch, cloud.points);
    if (cloud.fit) drawFit(sketch, cloud, *cloud.fit);
    if (!sketch.show().points) return;
    Shape& shape = sketch.add(Role::points, Kind::points, 7);
    shape.path = sketch.path("points");
    append(shape, cloud.points);
}

}  // namespace knotwork::drawing
