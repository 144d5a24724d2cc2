#include "app/app.hpp"

#include "app/painter.hpp"
#include "app/view.hpp"
#include "ui/imgui_host.hpp"
#include "ui/panel.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

namespace knotwork::app {

namespace {

constexpr double panelWidth = 300;      // CSS pixels
constexpr double panelMargin = 10;
constexpr double leastBesidePanel = 560;  // a narrower figure is covered rather than squeezed

double now() noexcept {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

ui::PanelArea panelArea(const View& view) noexcept {
    return {panelMargin, panelMargin, std::min(panelWidth, view.width() - 2 * panelMargin),
            std::max(0.0, view.height() - 2 * panelMargin)};
}

}  // namespace

struct App::Parts {
    struct Slot {
        explicit Slot(int id) : view(id) {}
        View view;
        ui::PanelState panel;
        int followedObject = -1;  ///< whose selection brought the panel to its object
        bool wantsPanel = false;
        double lastFrame = 0;
    };

    render::Renderer renderer;
    ui::ImGuiHost host;
    std::map<int, Slot> views;
    int nextView = 1;
    int focused = 0;
    unsigned frames = 0;
    bool lost = true;

    Slot* find(int id) noexcept {
        const auto found = views.find(id);
        return found == views.end() ? nullptr : &found->second;
    }
    View* view(int id) noexcept {
        Slot* slot = find(id);
        return slot != nullptr ? &slot->view : nullptr;
    }

    /// The panel follows the focus: of all views that want it, the focused one has it.
    [[nodiscard]] bool hasPanel(int id) noexcept {
        Slot* slot = find(id);
        return slot != nullptr && slot->wantsPanel && id == focused && !lost && host.started() &&
               slot->view.editor().scene() != nullptr;
    }

    void arrange(int id) {
        Slot* slot = find(id);
        if (slot == nullptr) return;
        const bool beside = hasPanel(id) && slot->view.width() >= leastBesidePanel + panelWidth;
        slot->view.setInset(beside ? panelWidth + panelMargin : 0);
    }

    std::string start() {
        lost = true;
        if (!renderer.start()) return renderer.message();
        if (!host.start()) return host.message();
        lost = false;
        for (auto& [id, slot] : views) {
            arrange(id);
            slot.view.touch();
        }
        return "";
    }

    /// Feeds the panel; whether it takes the event for itself.
    bool panelPointer(int id, const std::string& kind, const Pixel& at, int buttons,
                      const std::string& pointerType);
    void paintPanel(Slot& slot, const Canvas& canvas);
    int heldButtons = 0;
};

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

void App::Parts::paintPanel(Slot& slot, const Canvas& canvas) {
    const double time = now();
    host.setTheme(canvas.dark ? ui::ThemeName::dark : ui::ThemeName::light);
    const double seconds = time - slot.lastFrame;
    slot.lastFrame = time;
    if (!host.beginFrame({canvas.width, canvas.height, canvas.pixelRatio, seconds})) return;
    const auto& selected = slot.view.selected();
    const int followed = selected ? selected->object : -1;
    if (selected && followed != slot.followedObject) slot.panel.object = followed;
    slot.followedObject = followed;
    if (ui::panel(*slot.view.editor().scene(), slot.panel, panelArea(slot.view), host.colours())) {
        slot.view.touch();
    }
    host.render();
    for (ui::PanelEvent& event : slot.panel.events) {
        slot.view.editor().report(event.final, event.history ? "history" : "field", event.path,
                                  std::move(event.command));
    }
    slot.panel.events.clear();
}

App::App() : parts_(std::make_unique<Parts>()) {}
App::~App() = default;

std::string App::start() { return parts_->start(); }

void App::contextLost() {
    parts_->lost = true;
    parts_->renderer.forget();
    parts_->host.forget();
}

std::string App::contextRestored() { return parts_->start(); }

int App::addView() {
    const int id = parts_->nextView++;
    parts_->views.emplace(id, id);
    return id;
}

void App::removeView(int id) {
    parts_->views.erase(id);
    if (parts_->focused == id) parts_->focused = 0;
}

void App::resize(int id, double width, double height, double pixelRatio) {
    if (View* view = parts_->view(id)) view->resize(width, height, pixelRatio);
    parts_->arrange(id);
}

void App::attach(int id, std::shared_ptr<scene::Scene> scene) {
    Parts::Slot* slot = parts_->find(id);
    if (slot == nullptr) return;
    slot->view.attach(std::move(scene));
    ui::PanelWords words = std::move(slot->panel.words);
    slot->panel = {};
    slot->panel.words = std::move(words);
    parts_->arrange(id);
}

void App::setTheme(int id, const std::string& theme) {
    if (View* view = parts_->view(id)) view->setDark(ui::themeNamed(theme) == ui::ThemeName::dark);
}

void App::setPanel(int id, bool shown) {
    Parts::Slot* slot = parts_->find(id);
    if (slot == nullptr) return;
    slot->wantsPanel = shown;
    parts_->arrange(id);
    slot->view.touch();
}

void App::setWords(int id, const std::string& json) {
    Parts::Slot* slot = parts_->find(id);
    const auto words = scene::parseJson(json);
    if (slot == nullptr || !words) return;
    const auto take = [&](std::string_view name, std::string& word) {
        word = scene::stringOr(*words, name, word);
    };
    Words picture;
    take("order", picture.order);
    take("decimalPoint", picture.decimalPoint);
    slot->view.setWords(std::move(picture));
    ui::PanelWords& panel = slot->panel.words;
    take("undo", panel.undo);
    take("redo", panel.redo);
    take("add", panel.add);
    take("remove", panel.remove);
    take("local", panel.local);
}

void App::setReadOnly(int id, bool readOnly) {
    if (View* view = parts_->view(id)) view->setReadOnly(readOnly);
}

void App::setReducedMotion(int id, bool reduced) {
    if (View* view = parts_->view(id)) view->setReducedMotion(reduced);
}

void App::focus(int id) {
    if (id == parts_->focused) return;
    const int before = parts_->focused;
    parts_->focused = id;
    parts_->host.blur();
    parts_->heldButtons = 0;
    for (const int changed : {before, id}) {
        parts_->arrange(changed);
        if (View* view = parts_->view(changed)) {
            view->blur();
            view->touch();
        }
    }
}

void App::fit(int id) {
    if (View* view = parts_->view(id)) view->fit();
}

bool App::pointer(int id, const std::string& kind, double x, double y, int buttons, int modifiers,
                  const std::string& pointerType) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    if (parts_->panelPointer(id, kind, {x, y}, buttons, pointerType)) {
        view->pointer({"leave", {x, y}, buttons, modifiers, pointerType, now()});
        view->touch();
        return true;
    }
    return view->pointer({kind, {x, y}, buttons, modifiers, pointerType, now()});
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

void App::setPlaying(int id, bool playing) {
    View* view = parts_->view(id);
    if (view == nullptr) return;
    view->clock().setPlaying(playing);
    view->touch();
}

bool App::playing(int id) const {
    View* view = parts_->view(id);
    return view != nullptr && view->clock().playing();
}

void App::setPhase(int id, double phase) {
    View* view = parts_->view(id);
    if (view == nullptr) return;
    view->clock().setPhase(phase);
    view->touch();
}

double App::phase(int id) const {
    View* view = parts_->view(id);
    return view != nullptr ? view->clock().phase() : 0;
}

double App::period(int id) const {
    View* view = parts_->view(id);
    return view != nullptr ? view->clock().period() : 0;
}

void App::tick(int id, double seconds) {
    if (View* view = parts_->view(id)) view->tick(seconds);
}

bool App::needsFrame(int id) const {
    View* view = parts_->view(id);
    if (view == nullptr || parts_->lost) return false;
    return view->needsFrame() || (parts_->hasPanel(id) && parts_->host.animating());
}

void App::render(int id) {
    Parts::Slot* slot = parts_->find(id);
    if (slot == nullptr || parts_->lost) return;
    View& view = slot->view;
    const auto device = [&](double css) {
        return static_cast<int>(std::lround(css * view.pixelRatio()));
    };
    const Canvas canvas{device(view.width()), device(view.height()), view.pixelRatio(),
                        view.dark()};
    if (canvas.width < 1 || canvas.height < 1) return;
    const Figure* figure = view.figure();
    view.painted();
    paintFigure(parts_->renderer, figure, canvas);
    if (parts_->hasPanel(id)) parts_->paintPanel(*slot, canvas);
    ++parts_->frames;
}

std::string App::labels(int id) const {
    View* view = parts_->view(id);
    if (view == nullptr) return "[]";
    const bool panel = parts_->hasPanel(id);
    return view->labels([&](const ui::Box& box) {
        return panel && parts_->host.covers(box.x, box.y, box.right(), box.bottom());
    });
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

std::string App::stats() const {
    const render::Stats stats = parts_->renderer.stats();
    scene::Json json = scene::Json::object();
    json["views"] = parts_->views.size();
    json["frames"] = parts_->frames;
    json["glObjects"] = stats.live.total();
    json["drawCalls"] = stats.drawCalls;
    json["vertices"] = stats.vertices;
    json["bufferBytes"] = stats.bufferBytes;
    return scene::dumpJson(json);
}

}  // namespace knotwork::app
