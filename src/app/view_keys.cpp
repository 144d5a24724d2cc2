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
constexpr double turnStep = 3.141592653589793 / 12;
constexpr double scaleStep = 1.1;
constexpr double factorDigits = 1e-3;  // of a factor that keys have made

std::optional<Vec3> arrow(std::string_view name) noexcept {
    if (name == "ArrowLeft") return Vec3{-1, 0, 0};
    if (name == "ArrowRight") return Vec3{1, 0, 0};
    if (name == "ArrowUp") return Vec3{0, 1, 0};
    if (name == "ArrowDown") return Vec3{0, -1, 0};
    return std::nullopt;
}

/// Keys that are pressed again and again, and then are one step of history.
bool isOfRun(std::string_view name) noexcept {
    return arrow(name).has_value() || name == "r" || name == "R" || name == "s" || name == "S";
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
        const bool ends = isOfRun(name) && hold_ == Hold::nothing && editor_.inGesture();
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
    if (command && (name == "a" || name == "A")) return selectAll();
    if (command || (modifiers & altKey) != 0) return false;
    if (name == "Delete" || name == "Backspace") return removeSelected();
    const bool shifted = (modifiers & shiftKey) != 0;
    if (name == "PageDown") return shifted ? extend(1) : selectNeighbour(1);
    if (name == "PageUp") return shifted ? extend(-1) : selectNeighbour(-1);
    if (name == "k" || name == "K") return selectNextKind();
    if (name == "r" || name == "R") return turnSelected(shifted ? -turnStep : turnStep);
    if (name == "s" || name == "S") return scaleSelected(shifted ? 1 / scaleStep : scaleStep);
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
    choose({});
    touch();
    return true;
}

bool View::removeSelected() {
    const auto& target = emphasis_.selected;
    const bool removable = target && target->kind != TargetKind::pose && !isValue(target->kind);
    if (readOnly_ || !removable || hold_ != Hold::nothing) return false;
    if (editor_.inGesture()) editor_.endGesture("key");
    if (editor_.run(removal(chosen()), "key")) choose({});
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
    const Json* value = isValue(target->kind) ? valueAt(scene()->state(), target->path()) : nullptr;
    if (value != nullptr && value->is_number()) {
        return shift({(direction.x + direction.y) * times * step, 0, 0});
    }
    // Directions on the screen need not be round in the world.
    const Vec3 steps = glm::transpose(pane->sight.orientation()) * direction * times;
    const auto by = [&](double coordinate) { return roundedTo(coordinate * step, step / 1000); };
    return shift({by(steps.x), by(steps.y), by(steps.z)});
}

double View::stepIn(const PaneFigure& pane) const noexcept {
    const auto& target = emphasis_.selected;
    const FunctionHandle* handle = target ? values_.function(target->list) : nullptr;
    if (handle != nullptr && handle->integer) return std::max(1.0, std::round(step_));
    return step_ > 0 ? step_ : nudgeStep(1 / pane.sight.unitsPerPixel());
}

bool View::shift(const Vec3& by) {
    if (!emphasis_.selected || readOnly_ || hold_ != Hold::nothing) return false;
    if (grouped()) {
        runGroup(GizmoKind::move, by, 0, 1);
        return true;
    }
    if (run_ && editor_.inGesture()) editor_.endGesture("key");
    run_.reset();
    if (!editor_.inGesture()) editor_.beginGesture(gesturePrefix());
    moveBy(Target(*emphasis_.selected), by);
    touch();
    return true;
}

/// A knot along its line, a point or a local along the axes of its object.
void View::moveBy(const Target& target, const Vec3& by) {
    if (isValue(target.kind)) return setBy(target, by);
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

/// Presses on a group say together what they have done since the first of them.
void View::runGroup(GizmoKind kind, const Vec3& by, double angle, double factor) {
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    Group now = group(pixel);
    const bool goesOn = run_ && run_->kind == kind && run_->group.paths() == now.paths();
    if (editor_.inGesture() && !goesOn) editor_.endGesture("key");
    if (!editor_.inGesture()) {
        editor_.beginGesture(gesturePrefix());
        run_ = Run{std::move(now), kind, Vec3(0.0), 0, 1};
    }
    for (glm::length_t k = 0; k < 3; ++k) {
        if (by[k] != 0) run_->by[k] = roundedTo(run_->by[k] + by[k], std::abs(by[k]) / 1e6);
    }
    run_->angle += angle;
    run_->factor = roundedTo(run_->factor * factor, run_->factor * factorDigits);
    const auto tool = gizmo();
    const int axis = tool ? facingAxis(*tool, sightOf(camera_.aim(), {})) : 2;
    editor_.runAnew(kind == GizmoKind::move   ? run_->group.moved(run_->by)
                    : kind == GizmoKind::turn ? run_->group.turned(axis, run_->angle)
                                              : run_->group.scaled(run_->factor),
                    "key");
    touch();
}

/// The pose of what is selected, if it is one local curve or patch that may be posed.
std::optional<PosedLocal> View::selectedLocal() const {
    const auto& target = emphasis_.selected;
    if (readOnly_ || hold_ != Hold::nothing || !target || target->kind != TargetKind::pose) {
        return std::nullopt;
    }
    return posedLocal(scene()->state().objects[static_cast<std::size_t>(target->object)]->body,
                      target->index);
}

void View::poseSelected(const Json& local, const Pose& pose) {
    const auto object = static_cast<std::size_t>(emphasis_.selected->object);
    if (!editor_.inGesture()) editor_.beginGesture(gesturePrefix());
    editor_.run(poseCommand(scene()->state().objects[object]->id, local, pose), "key");
    touch();
}

bool View::turnSelected(double angle) {
    if (readOnly_ || hold_ != Hold::nothing || figure() == nullptr) return false;
    if (grouped()) {
        runGroup(GizmoKind::turn, Vec3(0.0), angle, 1);
        return true;
    }
    const auto local = selectedLocal();
    const auto tool = gizmo();
    if (!local || !tool) return false;
    Vec3 axis{0.0};
    axis[facingAxis(*tool, sightOf(camera_.aim(), {}))] = 1;
    poseSelected(local->name, turnedFarther(local->pose, axis, angle));
    return true;
}

bool View::scaleSelected(double factor) {
    if (readOnly_ || hold_ != Hold::nothing || figure() == nullptr) return false;
    if (grouped()) {
        runGroup(GizmoKind::scale, Vec3(0.0), 0, factor);
        return true;
    }
    const auto local = selectedLocal();
    if (!local) return false;
    Pose pose = local->pose;
    for (glm::length_t k = 0; k < 3; ++k) {
        const double to = pose.scale[k] * factor;
        pose.scale[k] = roundedTo(to, std::abs(to) * factorDigits);
    }
    poseSelected(local->name, pose);
    return true;
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
    const std::vector<std::string> all = siblings(target);
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
