// What App is made of, for the files that implement it: app.cpp has views and their settings,
// app_input.cpp what people do, app_painting.cpp pictures and the panel over them.
#pragma once

#include "app/app.hpp"
#include "app/painter.hpp"
#include "app/view.hpp"
#include "ui/imgui_host.hpp"
#include "ui/panel.hpp"

#include <chrono>
#include <map>
#include <string>

namespace knotwork::app {

inline constexpr double panelWidth = 300;  // CSS pixels
inline constexpr double panelMargin = 10;

/// Seconds since some moment, for durations.
inline double secondsNow() noexcept {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

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

    /// Gives the panel room beside the figure, where there is some.
    void arrange(int id);
    std::string start();

    /// Feeds the panel; whether it takes the event for itself.
    bool panelPointer(int id, const std::string& kind, const Pixel& at, int buttons,
                      const std::string& pointerType);
    void paintPanel(Slot& slot, const Canvas& canvas);
    int heldButtons = 0;
};

}  // namespace knotwork::app
