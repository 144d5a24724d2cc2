// Pictures: when one is due, the figure with the panel over it, and what stands in words over both.
#include "app/app_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knotwork::app {

namespace {

ui::PanelArea panelArea(const View& view) noexcept {
    return {panelMargin, panelMargin, std::min(panelWidth, view.width() - 2 * panelMargin),
            std::max(0.0, view.height() - 2 * panelMargin)};
}

}  // namespace

void App::Parts::paintPanel(Slot& slot, const Canvas& canvas) {
    const double time = secondsNow();
    host.setTheme(canvas.theme);
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
                        view.theme()};
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
