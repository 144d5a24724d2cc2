// What people do: pointer, wheel, keys and text to the panel or the view, and hands without a pointer.
#include "app/app_parts.hpp"

#include <utility>

namespace knotwork::app {

bool App::Parts::panelPointer(int id, const std::string& kind, const Pixel& at, int buttons,
                              const std::string& pointerType) {
    if (!hasPanel(id) || find(id)->view.holding()) return false;
    const ui::PointerKind pointer = ui::pointerKindNamed(pointerType);
    const bool over = host.hits(at.x, at.y) || host.wantsPointer();
    if (kind == "leave") {
        host.pointerLeave();
    } else {
        host.pointerMove(at.x, at.y, pointer);
    }
    // DOM's bits are main 1, secondary 2, middle 4; its button numbers 0, 2, 1.
    constexpr std::pair<int, int> buttonOfBit[] = {{1, 0}, {2, 2}, {4, 1}};
    const int pressed = kind == "cancel" ? 0 : buttons;
    for (const auto& [bit, button] : buttonOfBit) {
        if (((pressed ^ heldButtons) & bit) == 0) continue;
        const bool down = (pressed & bit) != 0;
        // What was pressed on the figure is the figure's until it is let go.
        if (down && !over) continue;
        host.pointerButton(button, down, pointer);
        heldButtons ^= bit;
    }
    return over;
}

bool App::pointer(int id, const std::string& kind, double x, double y, int buttons, int modifiers,
                  const std::string& pointerType) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    if (parts_->panelPointer(id, kind, {x, y}, buttons, pointerType)) {
        view->pointer({"leave", {x, y}, buttons, modifiers, pointerType, secondsNow()});
        view->touch();
        return true;
    }
    return view->pointer({kind, {x, y}, buttons, modifiers, pointerType, secondsNow()});
}

bool App::pinch(int id, double x, double y, double dx, double dy, double factor) {
    View* view = parts_->view(id);
    return view != nullptr && view->pinch({x, y}, {dx, dy}, factor);
}

bool App::wheel(int id, double x, double y, double dx, double dy, int modifiers) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    if (parts_->hasPanel(id) && parts_->host.hits(x, y)) {
        constexpr double pixelsPerNotch = 100;
        parts_->host.wheel(-dx / pixelsPerNotch, -dy / pixelsPerNotch);
        view->touch();
        return true;
    }
    return view->wheel({x, y}, dy, modifiers);
}

bool App::key(int id, const std::string& key, bool down, int modifiers) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    if (parts_->hasPanel(id) && parts_->host.wantsKeyboard() && key != "Tab") {
        parts_->host.key(key, down, static_cast<unsigned>(modifiers));
        view->touch();
        return true;
    }
    return view->key(key, down, modifiers);
}

void App::text(int id, const std::string& utf8) {
    View* view = parts_->view(id);
    if (view == nullptr || !parts_->hasPanel(id) || !parts_->host.wantsText()) return;
    parts_->host.text(utf8);
    view->touch();
}

bool App::hits(int id, double x, double y, const std::string& pointerType) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    if (parts_->hasPanel(id) && parts_->host.hits(x, y)) return true;
    return view->hits({x, y}, pointerType);
}

std::string App::cursor(int id) const {
    View* view = parts_->view(id);
    if (view == nullptr) return "default";
    if (parts_->hasPanel(id) && parts_->host.wantsPointer()) {
        return std::string(parts_->host.cursor());
    }
    return view->cursor();
}

bool App::spatial(int id) const {
    View* view = parts_->view(id);
    return view != nullptr && view->spatial();
}

std::string App::takeEvents(int id) {
    View* view = parts_->view(id);
    return view != nullptr ? view->editor().takeEvents() : "[]";
}

std::string App::selection(int id) const {
    View* view = parts_->view(id);
    return view != nullptr ? view->selection() : "null";
}

void App::select(int id, const std::string& path) {
    if (View* view = parts_->view(id)) view->select(path);
}

bool App::selectAll(int id) {
    View* view = parts_->view(id);
    return view != nullptr && view->selectAll();
}

void App::setGathering(int id, bool gathering) {
    if (View* view = parts_->view(id)) view->setGathering(gathering);
}

std::string App::held(int id) {
    View* view = parts_->view(id);
    return view != nullptr ? view->held() : "null";
}

void App::setStep(int id, double step) {
    if (View* view = parts_->view(id)) view->setStep(step);
}

bool App::shift(int id, double dx, double dy, double dz) {
    View* view = parts_->view(id);
    return view != nullptr && view->shift({dx, dy, dz});
}

bool App::place(int id, double x, double y, const std::string& how) {
    View* view = parts_->view(id);
    return view != nullptr && view->place({x, y}, how);
}

}  // namespace knotwork::app
