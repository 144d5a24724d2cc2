// What a double click in a view adds: a knot on the knot line, a point on the control polygon.
#include "app/hit.hpp"
#include "app/view.hpp"

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double clickSeconds = 0.45;

const Shape* editablePoints(const drawing::Drawing& drawing, const std::optional<Target>& chosen) {
    const Shape* first = nullptr;
    for (const Shape& shape : drawing.shapes) {
        if (!offers(shape) || kindOfList(shape.path) != TargetKind::point) continue;
        // A net has whole rows, and a mesh's vertices belong to faces.
        if (shape.path.back() == ']' || shape.path.ends_with("vertices")) continue;
        if (chosen && chosen->list == shape.path) return &shape;
        if (first == nullptr) first = &shape;
    }
    return first;
}

/// Where in a polygon a new point lengthens it least: before the point of this index. An open
/// polygon may be continued at either end.
std::size_t cheapestPlace(const Shape& polygon, const Vec3& p, bool closed) {
    const std::size_t count = polygon.positions.size() / 3;
    const auto at = [&](std::size_t k) { return positionOf(polygon, k % count); };
    if (count == 0) return 0;
    std::size_t best = count;
    double least = glm::distance(at(count - 1), p);
    if (closed) least += glm::distance(p, at(0)) - glm::distance(at(count - 1), at(0));
    if (!closed && glm::distance(at(0), p) < least) {
        best = 0;
        least = glm::distance(at(0), p);
    }
    for (std::size_t k = 1; k < count; ++k) {
        const double detour = glm::distance(at(k - 1), p) + glm::distance(p, at(k)) -
                              glm::distance(at(k - 1), at(k));
        if (detour >= least) continue;
        least = detour;
        best = k;
    }
    return best;
}

Vec3 nearestTo(const Shape& points, const Sight& sight, const Pixel& at) noexcept {
    Vec3 best{0.0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.positions.size() / 3; ++k) {
        const Pixel seen = sight.toPixels(positionOf(points, k));
        const double away = std::hypot(seen.x - at.x, seen.y - at.y);
        if (away >= least) continue;
        least = away;
        best = positionOf(points, k);
    }
    return best;
}

}  // namespace

bool View::doubleClick(const PointerInput& input, const std::optional<Target>& target) {
    const double near = input.pointerType == "touch" ? 24 : 6;
    const bool second = lastClickTime_ >= 0 && input.time - lastClickTime_ <= clickSeconds &&
                        std::hypot(input.at.x - lastClickAt_.x, input.at.y - lastClickAt_.y) <= near;
    if (!second || readOnly_) return false;
    const PaneFigure* pane = figure_.paneAt(input.at);
    if (pane == nullptr) return false;
    lastClickTime_ = -1;
    if (pane->plot.pane == Pane::knots) return insertKnotAt(*pane, input.at, target);
    if (pane->plot.pane != Pane::curve || target) return false;
    if (addPointAt(input.at)) return true;
    fit();
    return true;
}

bool View::insertKnotAt(const PaneFigure& pane, const Pixel& at,
                        const std::optional<Target>& target) {
    const auto& objects = scene()->state().objects;
    const auto object = static_cast<std::size_t>(pane.plot.object);
    const auto parameter = parameterAt(pane, at);
    if (object >= objects.size() || !parameter) return false;
    // On a knot the very same number: it becomes one more of its pile.
    const double t = target ? target->at.x : roundedTo(*parameter, 1 / pane.plot.map.scaleX);
    Json insertion = Json::object();
    insertion["object"] = objects[object]->id;
    insertion["at"] = t;
    Json command = Json::object();
    command["insertKnot"] = std::move(insertion);
    if (!editor_.run(std::move(command), "pointer")) return false;
    touch();
    return true;
}

bool View::addPointAt(const Pixel& at) {
    const PaneFigure* pane = figure_.find(Pane::curve);
    const Shape* points = editablePoints(drawing(), emphasis_.selected);
    if (pane == nullptr || points == nullptr) return false;
    const auto object = static_cast<std::size_t>(points->object);
    // As deep as the point that is seen nearest to it.
    const Vec3 world = pane->sight.fromPixels(at, nearestTo(*points, pane->sight, at));
    const Curve* curve = scene()->state().objects[object]->body.curve();
    const bool closed = curve != nullptr && isClosed(*curve);
    const std::size_t place = cheapestPlace(*points, world, closed);
    const Affine placement = placementOf(points->object);
    const Vec3 own = glm::inverse(placement.linear) * (world - placement.offset);
    const double pixel = pane->sight.unitsPerPixel();
    const Json* sample = valueAt(scene()->state(), indexed(points->path, 0));
    Json value = Json::array({roundedTo(own.x, pixel), roundedTo(own.y, pixel)});
    if (sample != nullptr && sample->size() > 2) value.push_back(spatial_ ? roundedTo(own.z, pixel) : own.z);
    const std::string path = indexed(points->path, place);
    Json command = Json::object();
    command["insert"] = path;
    command["value"] = std::move(value);
    if (!editor_.run(std::move(command), "pointer")) return true;
    touch();
    select(path);
    return true;
}

}  // namespace knotwork::app
