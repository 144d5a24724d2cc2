// A view's pointer: hover, press, drag, pan, click.
#include "app/hit.hpp"
#include "app/view.hpp"

#include <cmath>

namespace knotwork::app {

namespace {

constexpr int mainButton = 1;
constexpr int secondaryButton = 2;
constexpr int middleButton = 4;
constexpr double basisRadius = 7;
constexpr double middleShare = 0.75;  // of the radius within which a point is hit

/// How far a pressed pointer may wander before the press is a drag.
double slack(std::string_view pointerType) noexcept { return pointerType == "touch" ? 8 : 3; }

double distance(const Pixel& a, const Pixel& b) noexcept { return std::hypot(a.x - b.x, a.y - b.y); }

bool sameTarget(const std::optional<Target>& a, const std::optional<Target>& b) noexcept {
    return a.has_value() == b.has_value() && (!a || a->same(*b));
}

bool sameHover(const Emphasis& a, const Emphasis& b) noexcept {
    return sameTarget(a.hovered, b.hovered) && a.basisObject == b.basisObject &&
           a.basisIndex == b.basisIndex && a.parameter == b.parameter &&
           a.parameterPane == b.parameterPane && a.part == b.part;
}

double wheelFactor(double dy) noexcept {
    // A notch of a wheel is about 100, a pinch on a touchpad comes in steps of a few.
    return std::exp(-std::clamp(dy, -60.0, 60.0) * 0.008);
}

}  // namespace

bool View::pointer(const PointerInput& input) {
    if (scene() == nullptr) return false;
    noteWhereabouts(input);
    if (input.kind == "down") return press(input);
    if (input.kind == "move") return follow(input);
    if (input.kind == "up") return release(input);
    if (input.kind == "cancel") {
        letGo();
        return false;
    }
    if (hold_ == Hold::nothing) point({});
    return false;
}

void View::noteWhereabouts(const PointerInput& input) {
    // A finger leaves whenever it is lifted; what it has tapped stays pointed at.
    const bool lifted = input.kind == "leave" && input.pointerType == "touch";
    const bool over = lifted ? pointedAt_ : input.kind != "leave" && input.kind != "cancel";
    if (over != pointedAt_ && clock_.running()) touch();  // handles come and go
    pointedAt_ = over;
}

bool View::press(const PointerInput& input) {
    const Figure* now = figure();
    if (now == nullptr) return false;
    letGo();
    pressedAt_ = lastAt_ = input.at;
    pressedWith_ = input.modifiers;
    const PaneFigure* pane = now->paneAt(input.at);
    const bool onCurve = pane != nullptr && pane->plot.pane == Pane::curve;
    const int pans = spatial_ ? middleButton | secondaryButton : middleButton;
    if ((input.buttons & pans) != 0 && onCurve) {
        hold_ = Hold::panning;
        return true;
    }
    if ((input.buttons & mainButton) == 0) return false;
    const auto target = targetAt(*now, input.at, hitRadius(input.pointerType));
    const auto part = partUnder(input.at, hitRadius(input.pointerType), target);
    if (part) {
        held_ = emphasis_.selected;
        heldPart_ = part;
        hold_ = Hold::pressedTarget;
        clock_.hold(true);
        touch();
        return true;
    }
    if (doubleClick(input, target)) return true;
    if (target) {
        held_ = target;
        hold_ = Hold::pressedTarget;
        if (!joins() && !isChosen(*target)) choose({*target});
        clock_.hold(true);
        touch();
        return true;
    }
    // A finger on empty space scrolls the page; only its taps are ours, and what it does across a
    // scene in space, where the page lets us have it.
    if (input.pointerType == "touch" && !((spatial_ || gathering_) && onCurve)) return false;
    hold_ = Hold::pressedEmpty;
    return true;
}

bool View::follow(const PointerInput& input) {
    const Pixel by{input.at.x - lastAt_.x, input.at.y - lastAt_.y};
    lastAt_ = input.at;
    const bool wandered = distance(input.at, pressedAt_) > slack(input.pointerType);
    switch (hold_) {
        case Hold::nothing:
            hover(input);
            return false;
        case Hold::pressedTarget:
            if (wandered && !readOnly_ && beginDrag()) dragTo(input);
            return true;
        case Hold::dragging:
            dragTo(input);
            return true;
        case Hold::pressedEmpty:
            if (wandered) wander(input);
            return true;
        case Hold::banding:
            drawBand();
            return true;
        case Hold::panning:
            camera_.pan(by);
            break;
        case Hold::orbiting:
            camera_.orbit(by, false);
            break;
    }
    atHome_ = false;
    touch();
    return true;
}

/// A press beside all handles becomes a movement of the picture, or a band.
void View::wander(const PointerInput& input) {
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->paneAt(pressedAt_) : nullptr;
    if (pane == nullptr || pane->plot.pane != Pane::curve) return;
    if (joins()) return beginBand();
    const Pixel all{input.at.x - pressedAt_.x, input.at.y - pressedAt_.y};
    // A finger that goes down scrolls the page; the browser says so only a little later.
    if (input.pointerType == "touch" && std::abs(all.y) >= std::abs(all.x)) return;
    hold_ = spatial_ ? Hold::orbiting : Hold::panning;
    spatial_ ? camera_.orbit(all, false) : camera_.pan(all);
    atHome_ = false;
    touch();
}

bool View::release(const PointerInput& input) {
    const Hold was = hold_;
    if (was == Hold::dragging) {
        if (distance(input.at, lastAt_) > 0) dragTo(input);
        editor_.endGesture("pointer");
    }
    if (was == Hold::banding) chosenBefore_ = chosen();
    if (was == Hold::pressedTarget && held_ && !heldPart_) take(*held_, joins());
    const bool beside = was == Hold::pressedEmpty ||
                        (was == Hold::nothing && input.pointerType == "touch");
    if (beside && !joins()) {
        choose({});
        touch();
    }
    const bool clicked = was == Hold::pressedTarget || beside;
    if (clicked && !joins()) noteClick(input);
    letGo();
    if (input.pointerType != "touch") hover(input);
    return was != Hold::nothing;
}

/// A part of the tool, which covers other targets unless they are hit in their middle.
std::optional<GizmoPart> View::partUnder(const Pixel& at, double radius,
                                         const std::optional<Target>& target) const {
    const PaneFigure* pane = figure_.paneAt(at);
    const auto tool = gizmo();
    if (!tool || pane == nullptr || pane->plot.pane != Pane::curve) return std::nullopt;
    if (target && distance(at, pane->sight.toPixels(target->at)) <= middleShare * radius) {
        return std::nullopt;
    }
    return partAt(*tool, pane->sight, at, radius);
}

bool View::beginDrag() {
    const Figure* now = figure();
    if (now == nullptr || !held_) return false;
    const PaneFigure* pane = now->find(held_->pane);
    if (pane == nullptr) return false;
    if (!heldPart_ && !isChosen(*held_)) take(*held_, gathering_);
    const bool begun = grouped()              ? beginGroupDrag(*pane)
                       : isValue(held_->kind) ? beginValueDrag(*pane)
                                              : beginSingleDrag(*pane);
    if (!begun) return false;
    rememberShape();
    if (held_->kind == TargetKind::knot) frozenRange_ = now->axis.range;
    if (editor_.inGesture()) editor_.endGesture("key");
    editor_.beginGesture(gesturePrefix());
    hold_ = Hold::dragging;
    point({});
    return true;
}

bool View::beginSingleDrag(const PaneFigure& pane) {
    drag_ = Drag::begin(scene()->state(), *held_, placementOf(held_->object), pressedAt_,
                        pane.sight, spatial_);
    if (!drag_) return false;
    if (const auto tool = gizmo(); heldPart_ && tool) {
        drag_->hold(*tool, *heldPart_, pressedAt_, pane.sight);
    }
    return true;
}

void View::dragTo(const PointerInput& input) {
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->find(held_->pane) : nullptr;
    if (pane == nullptr) return;
    if (groupDrag_) {
        editor_.runAnew(groupDrag_->command(input.at, pane->sight, input.modifiers), "pointer");
        return touch();
    }
    if (valueDrag_) {
        editor_.run(valueDrag_->command(scene()->state(), input.at, pane->sight, input.modifiers),
                    "pointer");
        return touch();
    }
    for (scene::Json& command : drag_->commands(input.at, pane->sight, input.modifiers)) {
        editor_.run(std::move(command), "pointer");
    }
    touch();
}

void View::letGo() {
    if (hold_ == Hold::dragging && editor_.inGesture()) editor_.cancelGesture("pointer");
    if (hold_ == Hold::banding) choose(std::move(chosenBefore_));
    if (hold_ != Hold::nothing) touch();
    clock_.hold(false);
    hold_ = Hold::nothing;
    held_.reset();
    heldPart_.reset();
    drag_.reset();
    groupDrag_.reset();
    valueDrag_.reset();
    chosenBefore_.clear();
    ghost_.clear();
    frozenRange_.reset();
}

void View::blur() {
    letGo();
    if (editor_.inGesture()) editor_.endGesture("key");
    point({});
    if (pointedAt_ && clock_.running()) touch();
    pointedAt_ = false;
}

void View::noteClick(const PointerInput& input) {
    lastClickTime_ = input.time;
    lastClickAt_ = input.at;
}

void View::hover(const PointerInput& input) {
    if (input.pointerType == "touch") return;
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->paneAt(input.at) : nullptr;
    Emphasis at;
    if (pane != nullptr) {
        const double radius = hitRadius(input.pointerType);
        at.hovered = targetAt(*now, input.at, radius);
        at.part = partUnder(input.at, radius, at.hovered);
        if (at.part) at.hovered.reset();
        at.parameter = at.hovered ? std::nullopt : parameterAt(*pane, input.at);
        if (at.parameter) at.parameterPane = pane->plot.pane;
        if (const auto basis = basisAt(*now, input.at, basisRadius); basis && !at.hovered) {
            at.basisObject = basis->object;
            at.basisIndex = basis->index;
        }
    }
    point(at);
}

void View::point(const Emphasis& at) {
    if (sameHover(at, emphasis_)) return;
    Emphasis next = at;
    next.selected = std::move(emphasis_.selected);
    next.others = std::move(emphasis_.others);
    emphasis_ = std::move(next);
    touch();
}

bool View::wheel(const Pixel& at, double dy, int modifiers) {
    if ((modifiers & commandKey) == 0) return false;
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->paneAt(at) : nullptr;
    if (pane == nullptr || pane->plot.pane != Pane::curve) return false;
    camera_.zoom(pane->plot.box, at, wheelFactor(dy), !reducedMotion_);
    atHome_ = false;
    touch();
    return true;
}

bool View::hits(const Pixel& at, std::string_view pointerType) {
    const Figure* now = figure();
    if (now == nullptr) return false;
    const PaneFigure* pane = now->paneAt(at);
    if (gathering_ && pane != nullptr && pane->plot.pane == Pane::curve) return true;
    const auto target = targetAt(*now, at, hitRadius(pointerType));
    return target || partUnder(at, hitRadius(pointerType), target);
}

std::string View::cursor() const {
    if (hold_ == Hold::banding || (hold_ == Hold::nothing && gathering_ && !emphasis_.hovered)) {
        return "crosshair";
    }
    if (hold_ == Hold::panning || hold_ == Hold::orbiting) return "grabbing";
    const bool knot = (held_ && held_->kind == TargetKind::knot) ||
                      (emphasis_.hovered && emphasis_.hovered->kind == TargetKind::knot);
    if (knot) return "ew-resize";
    if (hold_ == Hold::dragging || hold_ == Hold::pressedTarget) return "grabbing";
    if (emphasis_.part) return "grab";
    if (emphasis_.hovered) return readOnly_ ? "pointer" : "grab";
    return emphasis_.parameter ? "crosshair" : "default";
}

}  // namespace knotwork::app
