// The panel: every field of an object as a widget, made from the scene's own descriptions.
//
// Each edit is a command of the scene, as a drag or a script would give it; a drag of a slider is
// one gesture and so one step of history. A refused command changes nothing and its reason stands
// under the field until that field is edited again.
#pragma once

#include "scene/fields.hpp"
#include "scene/scene.hpp"
#include "ui/imgui_host.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace knotwork::ui {

/// Where the panel may stand in its view, CSS pixels from the upper left corner.
struct PanelArea {
    double x = 0;
    double y = 0;
    double width = 300;
    double height = 600;
};

/// What an edit in the panel did, for the page's events: `input` while a widget is held, `change`
/// when it is let go.
struct PanelEvent {
    bool final = false;
    std::string path;
    scene::Json command;    ///< { undo: true } or { redo: true } for a step through the history
    bool history = false;
};

/// The words that are the panel's own; those of the fields come with the fields.
struct PanelWords {
    std::string undo = "Undo";
    std::string redo = "Redo";
    std::string add = "Add";
    std::string remove = "Remove";
    std::string local = "Local curve";
};

/// What the panel remembers between frames; one per view.
struct PanelState {
    int object = 0;                  ///< whose fields are shown
    std::vector<PanelEvent> events;  ///< in order; the caller takes them out
    PanelWords words;

    // The panel's own:
    std::string refusedField;        ///< the field whose last edit was refused, empty if none
    std::string refusal;             ///< why
    std::string heldField;           ///< the field that is being dragged
    scene::Json heldCommand;         ///< the last command that this drag gave
    std::uint64_t gestures = 0;
    std::shared_ptr<const scene::Object> described;  ///< what `fields` describes
    std::vector<scene::PanelField> fields;
};

/// Between beginFrame() and render() of the host. Returns whether the scene changed.
bool panel(scene::Scene& scene, PanelState& state, const PanelArea& area, const Theme& colours);

}  // namespace knotwork::ui
