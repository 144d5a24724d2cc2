#include "app/app_parts.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace knotwork::app {

namespace {

constexpr double leastBesidePanel = 560;  // a narrower figure is covered rather than squeezed

}  // namespace

void App::Parts::arrange(int id) {
    Slot* slot = find(id);
    if (slot == nullptr) return;
    const bool beside = hasPanel(id) && slot->view.width() >= leastBesidePanel + panelWidth;
    slot->view.setInset(beside ? panelWidth + panelMargin : 0);
}

std::string App::Parts::start() {
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
    if (View* view = parts_->view(id)) view->setTheme(ui::themeNamed(theme));
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

std::string App::panes(int id) {
    View* view = parts_->view(id);
    return view != nullptr ? view->panes() : "null";
}

bool App::moveSeam(int id, const std::string& name, double share) {
    View* view = parts_->view(id);
    if (view == nullptr) return false;
    return view->moveSeam(name, std::isnan(share) ? std::nullopt : std::optional(share));
}

}  // namespace knotwork::app
