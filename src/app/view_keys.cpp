// A view's keys. What is not taken here is the page's: Tab above all.
#include "app/view.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double nudgePixels = 10;
constexpr double zoomStep = 1.25;
constexpr double turnPixels = 35;  // about 15 degrees

std::optional<Vec3> arrow(std::string_view name) noexcept {
    if (name == "ArrowLeft") return Vec3{-1, 0, 0};
    if (name == "ArrowRight") return Vec3{1, 0, 0};
    if (name == "ArrowUp") return Vec3{0, 1, 0};
    if (name == "ArrowDown") return Vec3{0, -1, 0};
    return std::nullopt;
}

/// The power of ten that is at most ten pixels.
double nudgeStep(double pixelsPerUnit) noexcept {
    return std::pow(10.0, std::floor(std::log10(nudgePixels / pixelsPerUnit)));
}

/// Absolute, as a drag says it, and as decimal as the step.
Json moveTo(const std::string& path, const Json& was, const Vec3& by) {
    const auto moved = [](const Json& number, double step) {
        const double from = number.get<double>();
        return step == 0 ? from : roundedTo(from + step, std::abs(step) / 1e6);
    };
    Json command = Json::object();
    command["move"] = path;
    if (was.is_number()) {
        command["to"] = moved(was, by.x);
        return command;
    }
    Json& to = command["to"] = Json::array();
    for (std::size_t k = 0; k < std::min<std::size_t>(was.size(), 3); ++k) {
        to.push_back(moved(was[k], by[static_cast<glm::length_t>(k)]));
    }
    return command;
}

std::optional<Viewpoint> standardViewpoint(std::string_view name) noexcept {
    if (name == "1") return fromFront;
    if (name == "3") return fromSide;
    if (name == "7") return fromAbove;
    if (name == "5") return fromCorner;
    return std::nullopt;
}

}  // namespace

bool View::key(std::string_view name, bool down, int modifiers) {
    if (scene() == nullptr) return false;
    if (!down) {
        const bool ends = arrow(name).has_value() && hold_ == Hold::nothing && editor_.inGesture();
        if (ends) editor_.endGesture("key");
        return ends;
    }
    if (name == "Escape") return escape();
    const bool command = (modifiers & commandKey) != 0;
    if (command && (name == "z" || name == "Z" || name == "y")) {
        const bool redo = name == "y" || (modifiers & shiftKey) != 0;
        if (readOnly_ || hold_ != Hold::nothing) return false;
        if (editor_.inGesture()) editor_.endGesture("key");
        touch();
        return redo ? editor_.redo("key") : editor_.undo("key");
    }
    if (command || (modifiers & altKey) != 0) return false;
    if (name == "Delete" || name == "Backspace") return removeSelected();
    if (name == "PageDown") return selectNeighbour(1);
    if (name == "PageUp") return selectNeighbour(-1);
    if (const auto direction = arrow(name)) {
        return emphasis_.selected ? nudge(*direction, modifiers) : turn(*direction);
    }
    if (const auto from = standardViewpoint(name)) return lookFrom(*from);
    if (name == "+" || name == "=") return zoomKey(zoomStep);
    if (name == "-") return zoomKey(1 / zoomStep);
    if (name == "0") {
        fit();
        return true;
    }
    return false;
}

bool View::escape() {
    if (hold_ != Hold::nothing) {
        letGo();
        return true;
    }
    if (!emphasis_.selected) return false;
    emphasis_.selected.reset();
    touch();
    return true;
}

bool View::removeSelected() {
    const auto& target = emphasis_.selected;
    if (readOnly_ || !target || target->kind == TargetKind::pose || hold_ != Hold::nothing) {
        return false;
    }
    Json command = Json::object();
    command["remove"] = target->path();
    if (editor_.run(std::move(command), "key")) emphasis_.selected.reset();
    touch();
    return true;
}

bool View::nudge(const Vec3& direction, int modifiers) {
    const Figure* now = figure();
    const auto& target = emphasis_.selected;
    const PaneFigure* pane = now != nullptr && target ? now->find(target->pane) : nullptr;
    if (pane == nullptr || readOnly_ || hold_ != Hold::nothing) return false;
    const double step = stepIn(*pane);
    const double times = (modifiers & shiftKey) != 0 ? 10 : 1;
    const bool knot = target->kind == TargetKind::knot;
    if (knot && direction.x == 0) return true;
    // Directions on the screen need not be round in the world.
    const Vec3 steps = glm::transpose(pane->sight.orientation()) * direction * times;
    const auto by = [&](double coordinate) { return roundedTo(coordinate * step, step / 1000); };
    return shift({by(steps.x), by(steps.y), by(steps.z)});
}

double View::stepIn(const PaneFigure& pane) const noexcept {
    return step_ > 0 ? step_ : nudgeStep(1 / pane.sight.unitsPerPixel());
}

bool View::shift(const Vec3& by) {
    if (!emphasis_.selected || readOnly_ || hold_ != Hold::nothing) return false;
    if (!editor_.inGesture()) editor_.beginGesture(gesturePrefix());
    moveBy(Target(*emphasis_.selected), by);
    touch();
    return true;
}

/// A knot along its line, a point or a local along the axes of its object.
void View::moveBy(const Target& target, const Vec3& by) {
    const scene::Object& object =
        *scene()->state().objects[static_cast<std::size_t>(target.object)];
    if (target.kind == TargetKind::pose) {
        const auto local = posedLocal(object.body, target.index);
        if (!local) return;
        Pose pose = local->pose;
        pose.translate += by;
        editor_.run(poseCommand(object.id, local->name, pose), "key");
        return;
    }
    const Json* was = valueAt(scene()->state(), target.path());
    if (was != nullptr) editor_.run(moveTo(target.path(), *was, by), "key");
}

bool View::turn(const Vec3& direction) {
    if (!spatial_ || hold_ != Hold::nothing) return false;
    camera_.orbit({direction.x * turnPixels, -direction.y * turnPixels}, !reducedMotion_);
    atHome_ = false;
    touch();
    return true;
}

bool View::selectNeighbour(int step) {
    if (!emphasis_.selected || figure() == nullptr) return false;
    const Target& target = *emphasis_.selected;
    const std::vector<std::string> all = siblingsOf(drawing(), target);
    const auto found = std::find(all.begin(), all.end(), target.path());
    if (found == all.end()) return false;
    const auto place = static_cast<std::size_t>(found - all.begin());
    select(all[(place + all.size() + static_cast<std::size_t>(step + 1) - 1) % all.size()]);
    return true;
}

bool View::zoomKey(double factor) {
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->find(Pane::curve) : nullptr;
    if (pane == nullptr) return false;
    camera_.zoom(pane->plot.box, pane->plot.box.centre(), factor, !reducedMotion_);
    atHome_ = false;
    touch();
    return true;
}

}  // namespace knotwork::app
