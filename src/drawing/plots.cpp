#include "drawing/plots.hpp"

#include "drawing/palette.hpp"
#include "geometry/bspline_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

/// Chords a span and function: the error of a cubic bump stays below a third of a pixel at 300.
constexpr std::size_t chordsPerSpan = 24;
/// Chords of a B-function: steep ones have their whole rise within a hundredth of the interval.
constexpr std::size_t blendChords = 512;
constexpr int blendDerivatives = 2;

void append(Shape& shape, double x, double y) {
    shape.positions.insert(shape.positions.end(), {x, y, 0.0});
}

Shape plotShape(int object, Role role, Pane pane, std::size_t index, const Colour& colour) {
    Shape shape;
    shape.object = object;
    shape.role = role;
    shape.kind = Kind::polyline;
    shape.pane = pane;
    shape.colour = colour;
    shape.index = static_cast<int>(index);
    return shape;
}

/// Collects, span by span, the pieces of each function; a function that vanishes on the span before
/// begins a polyline of its own.
class BasisCollector {
public:
    BasisCollector(std::size_t count, int object, bool dark)
        : object_(object), dark_(dark), running_(count, none), seen_(count, none) {}

    void add(std::size_t function, std::size_t span, double t, double value) {
        const bool continues = running_[function] != none &&
                               (seen_[function] == span || seen_[function] + 1 == span);
        if (!continues) {
            running_[function] = shapes_.size();
            shapes_.push_back(plotShape(object_, Role::basis, Pane::basis, function,
                                        cycleColour(function, dark_)));
        }
        seen_[function] = span;
        append(shapes_[running_[function]], t, value);
    }

    [[nodiscard]] std::vector<Shape> take() { return std::move(shapes_); }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    int object_;
    bool dark_;
    std::vector<std::size_t> running_;
    std::vector<std::size_t> seen_;
    std::vector<Shape> shapes_;
};

double chordPoint(double start, double end, std::size_t i) {
    return uniformParameter({start, end}, i, chordsPerSpan + 1);
}

std::vector<Shape> splineBasis(const BsplineCurve& curve, int object, bool dark) {
    const KnotVector& knots = curve.knotVector();
    const auto count = static_cast<std::size_t>(knots.pointCount());
    if (count > maximumBasisFunctions) return {};
    const auto order = static_cast<std::size_t>(knots.degree()) + 1;
    const Interval domain = knots.domain();
    const std::span<const double> t = knots.extended();
    BasisCollector collector(count, object, dark);
    std::vector<double> values(order);
    std::size_t visited = 0;
    for (std::size_t span = order - 1; span + order < t.size(); ++span) {
        if (t[span] == t[span + 1] || t[span] < domain.start || t[span + 1] > domain.end) continue;
        for (std::size_t i = 0; i <= chordsPerSpan; ++i) {
            const double x = chordPoint(t[span], t[span + 1], i);
            basisFunctions(knots, span, x, values);
            for (std::size_t j = 0; j < order; ++j) {
                collector.add(knots.pointIndex(span, j), visited, x, values[j]);
            }
        }
        ++visited;
    }
    return collector.take();
}

std::vector<Shape> blendBasis(const BlendingCurve& curve, int object, bool dark) {
    const std::size_t count = curve.locals().size();
    if (count > maximumBasisFunctions) return {};
    const std::vector<double>& t = curve.knots();
    BasisCollector collector(count, object, dark);
    std::size_t visited = 0;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        if (t[i] == t[i + 1]) {
            ++visited;  // at a break no blending function continues
            continue;
        }
        for (std::size_t k = 0; k <= chordsPerSpan; ++k) {
            const double w = chordPoint(0, 1, k);
            const double value = curve.blend().value(w);
            const double x = chordPoint(t[i], t[i + 1], k);
            collector.add(i, visited, x, 1 - value);
            collector.add((i + 1) % count, visited, x, value);
        }
        ++visited;
    }
    return collector.take();
}

}  // namespace

std::vector<Shape> basisPlot(const Curve& curve, int object, bool dark) {
    if (const auto* spline = curve.as<BsplineCurve>()) return splineBasis(*spline, object, dark);
    if (const auto* blend = curve.as<BlendingCurve>()) return blendBasis(*blend, object, dark);
    return {};
}

std::vector<Shape> bFunctionPlot(const BFunction& blend, int object, const Pen& pen) {
    std::vector<Shape> shapes;
    for (std::size_t order = 0; order <= blendDerivatives; ++order) {
        shapes.push_back(plotShape(object, Role::bFunction, Pane::bFunction, order, pen.colour));
        shapes.back().dashed = pen.dashed;
    }
    std::array<double, blendDerivatives + 1> rows{};
    for (std::size_t i = 0; i <= blendChords; ++i) {
        const double t = uniformParameter({0, 1}, i, blendChords + 1);
        blend.derivatives(t, rows);
        for (std::size_t order = 0; order < shapes.size(); ++order) {
            append(shapes[order], t, rows[order]);
        }
    }
    return shapes;
}

std::vector<int> comparedObjects(const Drawing& drawing, int object) {
    std::vector<const Shape*> different;
    const auto isAlike = [&](const Shape& shape) {
        return std::any_of(different.begin(), different.end(), [&](const Shape* other) {
            return other->object == shape.object || other->positions == shape.positions;
        });
    };
    const auto isFunction = [](const Shape& shape) {
        return shape.pane == Pane::bFunction && shape.index == 0;
    };
    for (const Shape& shape : drawing.shapes) {
        if (isFunction(shape) && shape.object == object && different.empty()) {
            different.push_back(&shape);
        }
    }
    for (const Shape& shape : drawing.shapes) {
        if (isFunction(shape) && !isAlike(shape)) different.push_back(&shape);
    }
    if (different.size() > mostCompared) return {object};
    std::vector<int> objects;
    for (const Shape* shape : different) objects.push_back(shape->object);
    std::sort(objects.begin(), objects.end());
    return objects;
}

Shape knotLine(std::span<const double> knots, int object, std::string path, bool dark) {
    Shape shape;
    shape.object = object;
    shape.role = Role::knots;
    shape.kind = Kind::points;
    shape.pane = Pane::knots;
    shape.colour = roleColour(Role::knots, dark);
    shape.width = 10;
    shape.path = std::move(path);
    double row = 0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        row = i > 0 && knots[i] == knots[i - 1] ? row + 1 : 0;
        append(shape, knots[i], row);
    }
    return shape;
}

}  // namespace knotwork::drawing
