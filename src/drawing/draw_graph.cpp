// The graph of a proposed B-function over its square, and under it which of the axioms hold.
#include "drawing/sketch.hpp"

#include "geometry/b_function_axioms.hpp"

#include <string>

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

/// D1 ✓  D2 ✓  D3 ✗ …
std::string checklist(const AxiomBreaches& breaches) {
    const auto holds = axiomsThatHold(breaches);
    std::string text;
    for (std::size_t k = 0; k < holds.size(); ++k) {
        text += (k == 0 ? "" : "  ") + std::string(axiomNames[k]) + (holds[k] ? " ✓" : " ✗");
    }
    return text;
}

void drawChecklist(Sketch& sketch, const scene::FunctionGraph& graph) {
    Shape& label = sketch.add(Role::label, Kind::label, 0);
    append(label, graph.at + graph.size * Vec3(0.5, 0, 0));
    constexpr float below = 16;  // CSS pixels
    label.offset = {0, below};
    label.text = checklist(graph.candidate.breaches());
}

}  // namespace

void drawGraphFigure(Sketch& sketch, const scene::FunctionGraph& graph) {
    if (sketch.show().polygon) drawSquare(sketch, graph);
    if (sketch.show().labels) drawChecklist(sketch, graph);
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
