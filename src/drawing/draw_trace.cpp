// A frame of a trace on its object: points, edges, the points that it is about, and its title.
#include "drawing/annotations.hpp"

#include "scene/trace.hpp"

#include <algorithm>

namespace knotwork::drawing {

namespace {

/// The frame that is shown, if there is one with anything to see.
const scene::TraceFrame* shownFrame(const scene::Object& object) noexcept {
    if (object.trace == nullptr || object.traceFrame >= object.trace->frames.size()) return nullptr;
    const scene::TraceFrame& frame = object.trace->frames[object.traceFrame];
    return frame.points.empty() ? nullptr : &frame;
}

}  // namespace

void drawTrace(Sketch& sketch) {
    const scene::TraceFrame* shown = shownFrame(sketch.object());
    if (shown == nullptr) return;
    const scene::TraceFrame& frame = *shown;
    Shape& edges = sketch.add(Role::trace, Kind::polyline, 1.75F);
    append(edges, frame.points);
    for (const auto& edge : frame.edges) {
        for (const std::size_t end : edge) edges.indices.push_back(static_cast<std::uint32_t>(end));
    }
    Shape& points = sketch.add(Role::trace, Kind::points, 6);
    append(points, frame.points);
    if (frame.marked.empty()) return;
    Shape& marked = sketch.add(Role::trace, Kind::points, 9);
    marked.index = 1;
    for (const std::size_t i : frame.marked) append(marked, frame.points[i]);
}

std::vector<Wanted> traceLabels(const scene::Object& object) {
    const scene::TraceFrame* frame = shownFrame(object);
    if (frame == nullptr) return {};
    const std::size_t at = frame->marked.empty() ? frame->points.size() - 1 : frame->marked.back();
    return {{frame->title, frame->points[at], Role::trace}};
}

}  // namespace knotwork::drawing
