#include "ui/panel_editor.hpp"

#include <algorithm>
#include <utility>

namespace knotwork::ui {
namespace {

std::string addressIn(const scene::Json& command) {
    for (const char* verb : {"set", "insert", "remove"}) {
        if (const scene::Json* path = scene::member(command, verb); path && path->is_string()) {
            return path->get_ref<const std::string&>();
        }
    }
    return "";
}

}  // namespace

const scene::Object& PanelEditor::object() const noexcept {
    const auto& objects = scene_.state().objects;
    const auto last = static_cast<int>(objects.size()) - 1;
    return *objects[static_cast<std::size_t>(std::clamp(state_.object, 0, last))];
}

const std::vector<scene::PanelField>& PanelEditor::fields() {
    const scene::Object* shown = &object();
    if (state_.described.get() != shown) {
        const auto& objects = scene_.state().objects;
        state_.described = *std::find_if(objects.begin(), objects.end(),
                                         [=](const auto& each) { return each.get() == shown; });
        state_.fields = scene::panelFields(shown->spec);
    }
    return state_.fields;
}

std::string PanelEditor::address(const std::string& path) const {
    return joinPath(indexed("objects", static_cast<std::size_t>(state_.object)), path);
}

bool PanelEditor::execute(const std::string& field, const scene::Json& command) {
    const auto change = scene_.execute(command);
    if (change) {
        state_.refusedField.clear();
        changed_ = true;
        return true;
    }
    state_.refusedField = field;
    state_.refusal = change.error().message;
    return false;
}

void PanelEditor::hold(const std::string& field, const std::string& path, scene::Json value) {
    if (state_.heldField != field) {
        finish(false);
        state_.heldField = field;
        state_.gestures += 1;
    }
    const scene::Json command{{"set", address(path)}, {"value", std::move(value)}};
    scene::Json gesture = command;
    gesture["gesture"] = "panel-" + std::to_string(state_.gestures);
    if (!execute(field, gesture)) return;
    state_.heldCommand = command;
    state_.events.push_back({false, address(path), command, false});
}

void PanelEditor::once(const std::string& field, scene::Json command) {
    finish(false);
    if (!execute(field, command)) return;
    std::string address = addressIn(command);
    state_.events.push_back({true, std::move(address), std::move(command), false});
}

void PanelEditor::set(const std::string& field, scene::Json value) {
    once(field, {{"set", address(field)}, {"value", std::move(value)}});
}

void PanelEditor::undo() {
    finish(false);
    step(scene_.undo(), "undo");
}

void PanelEditor::redo() {
    finish(false);
    step(scene_.redo(), "redo");
}

/// After a step through the history.
void PanelEditor::step(bool moved, const char* verb) {
    state_.refusedField.clear();
    if (!moved) return;
    changed_ = true;
    state_.events.push_back({true, "", scene::Json{{verb, true}}, true});
}

void PanelEditor::finish(bool anythingHeld) {
    if (anythingHeld || state_.heldField.empty()) return;
    if (!state_.heldCommand.is_null()) {
        state_.events.push_back(
            {true, addressIn(state_.heldCommand), state_.heldCommand, false});
    }
    state_.heldField.clear();
    state_.heldCommand = nullptr;
}

std::string_view PanelEditor::refusalOf(const std::string& field) const noexcept {
    return field == state_.refusedField ? std::string_view(state_.refusal) : std::string_view();
}

}  // namespace knotwork::ui
