// What the panel's widgets work on: one object's fields, and commands that change them.
#pragma once

#include "scene/fields.hpp"
#include "ui/panel.hpp"

namespace knotwork::ui {

class PanelEditor {
public:
    PanelEditor(scene::Scene& scene, PanelState& state, const Theme& colours) noexcept
        : scene_(scene), state_(state), colours_(colours) {}

    [[nodiscard]] const Theme& colours() const noexcept { return colours_; }
    [[nodiscard]] const PanelWords& words() const noexcept { return state_.words; }
    [[nodiscard]] const scene::Object& object() const noexcept;
    /// The fields of the object, described anew only when the scene has changed.
    [[nodiscard]] const std::vector<scene::PanelField>& fields();
    /// `objects[2].points` for `points`.
    [[nodiscard]] std::string address(const std::string& path) const;

    /// Sets what lies at `path` (relative to the object) while the widget of `field` is held: all
    /// that happens until it is let go is one gesture.
    void hold(const std::string& field, const std::string& path, scene::Json value);
    /// Executes a command that is complete in itself; `field` is where a refusal will stand.
    void once(const std::string& field, scene::Json command);
    void set(const std::string& field, scene::Json value);
    void undo();
    void redo();
    [[nodiscard]] bool canUndo() const noexcept { return scene_.canUndo(); }
    [[nodiscard]] bool canRedo() const noexcept { return scene_.canRedo(); }
    [[nodiscard]] const scene::State& sceneState() const noexcept { return scene_.state(); }
    [[nodiscard]] int& shown() noexcept { return state_.object; }
    /// Ends the gesture when no widget is held any more. Call after the last widget.
    void finish(bool anythingHeld);

    /// Why the last edit of this field was refused; empty when it was not.
    [[nodiscard]] std::string_view refusalOf(const std::string& field) const noexcept;
    [[nodiscard]] bool changed() const noexcept { return changed_; }

private:
    bool execute(const std::string& field, const scene::Json& command);
    void step(bool moved, const char* verb);

    scene::Scene& scene_;
    PanelState& state_;
    const Theme& colours_;
    bool changed_ = false;
};

}  // namespace knotwork::ui
