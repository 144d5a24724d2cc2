// The graph of a proposed B-function over its square.
#include "drawing/sketch.hpp"

#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr std::size_t chords = 256;
/// What a formula may leave the square by, in sides of it; beyond that its graph is cut.
constexpr double mostOutside = 3;

void drawSquare(Sketch& sketch, const scene::FunctionGraph& graph) {
    Shape& shape = sketch.add(Role::polygon, Kind::polyline, 1);
    for (const Vec3 corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0),
                              Vec3(0, 0, 0)}) {
        append(shape, graph.at + graph.size * corner);
    }
}

}  // namespace

void drawGraphFigure(Sketch& sketch, const scene::FunctionGraph& graph) {
    if (sketch.show().polygon) drawSquare(sketch, graph);
    if (!sketch.show().curve) return;
    const auto width = static_cast<float>(sketch.object().style.width);
    Shape* line = nullptr;
    for (std::size_t i = 0; i <= chords; ++i) {
        const double t = uniformParameter({0, 1}, i, chords + 1);
        const double value = graph.candidate.value(t);
        if (!(value >= -mostOutside && value <= 1 + mostOutside)) {
            line = nullptr;
            continue;
        }
        if (line == nullptr) line = &sketch.add(Role::curve, Kind::polyline, width);
        append(*line, graph.at + graph.size * Vec3(t, value, 0));
    }
}

}  // namespace knotwork::drawing
