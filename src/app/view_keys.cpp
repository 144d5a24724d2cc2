// A view's keys. What is not taken here is the page's: Tab above all.
#include "app/view.hpp"

#include <cmath>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr double nudgePixels = 10;
constexpr double zoomStep = 1.25;

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

Json moveBy(const std::string& path, Json by) {
    Json command = Json::object();
    command["move"] = path;
    command["by"] = std::move(by);
    return command;
}

Json poseBy(const scene::Object& object, std::size_t local, const Vec3& by) {
    Json pose = Json::object();
    pose["object"] = object.id;
    pose["local"] = local;
    const auto* blend = object.body.as<BlendingCurve>();
    const Vec3 was = blend != nullptr && local < blend->locals().size()
                         ? blend->locals()[local].pose().translate
                         : Vec3{0.0};
    const Vec3 to = was + by;
    pose["translate"] = Json::array({to.x, to.y, to.z});
    Json command = Json::object();
    command["pose"] = std::move(pose);
    return command;
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
    if (const auto direction = arrow(name)) return nudge(*direction, modifiers);
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
    const double times = (modifiers & shiftKey) != 0 ? 10 : 1;
    const Vec3 by = direction * (times * nudgeStep(pane->plot.map.scaleX));
    if (!editor_.inGesture()) editor_.beginGesture(gesturePrefix());
    if (target->kind == TargetKind::knot) {
        if (by.x != 0) editor_.run(moveBy(target->path(), by.x), "key");
    } else if (target->kind == TargetKind::pose) {
        const auto& objects = scene()->state().objects;
        editor_.run(poseBy(*objects[static_cast<std::size_t>(target->object)], target->index, by),
                    "key");
    } else {
        const Json* was = valueAt(scene()->state(), target->path());
        Json step = Json::array({by.x, by.y});
        if (was != nullptr && was->size() > 2) step.push_back(0.0);
        editor_.run(moveBy(target->path(), std::move(step)), "key");
    }
    touch();
    return true;
}

bool View::selectNeighbour(int step) {
    if (!emphasis_.selected || figure() == nullptr) return false;
    const Target& target = *emphasis_.selected;
    const std::size_t count = listLength(drawing(), target.list);
    if (count == 0) return false;
    const std::size_t next = (target.index + count + static_cast<std::size_t>(step + 1) - 1) % count;
    select(indexed(target.list, next));
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
