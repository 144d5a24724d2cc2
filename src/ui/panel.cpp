#include "ui/panel.hpp"

#include "ui/panel_editor.hpp"
#include "ui/panel_widgets.hpp"

#include <imgui.h>

#include <algorithm>

namespace knotwork::ui {
namespace {

using scene::FieldKind;
using scene::PanelField;

bool arrowButton(const char* arrow, const std::string& tip, bool enabled) {
    const float size = ImGui::GetFrameHeight();
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(arrow, {size, size});
    ImGui::EndDisabled();
    ImGui::SetItemTooltip("%s", tip.c_str());
    return pressed;
}

std::string titleOf(const scene::Object& object) {
    const scene::CurveType* type = scene::findCurveType(scene::stringOr(object.spec, "type", ""));
    return std::string(type ? type->label : "") + "  " + object.id;
}

/// Which object is shown; a plain title where there is only one.
void objectChoice(PanelEditor& editor, float width) {
    const auto& objects = editor.sceneState().objects;
    const std::string title = titleOf(editor.object());
    if (objects.size() < 2) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(title.c_str());
        return;
    }
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("##object", title.c_str())) return;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto index = static_cast<int>(i);
        ImGui::PushID(index);
        if (ImGui::Selectable(titleOf(*objects[i]).c_str(), index == editor.shown())) {
            editor.shown() = index;
        }
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void header(PanelEditor& editor) {
    const float button = ImGui::GetFrameHeight();
    const float gap = 4;
    const float right = ImGui::GetContentRegionMax().x;
    objectChoice(editor, right - ImGui::GetCursorPosX() - 2 * (button + gap) - gap);
    ImGui::SameLine(right - 2 * button - gap);
    if (arrowButton("\xe2\x86\xb6", editor.words().undo, editor.canUndo())) editor.undo();
    ImGui::SameLine(right - button);
    if (arrowButton("\xe2\x86\xb7", editor.words().redo, editor.canRedo())) editor.redo();
    ImGui::Separator();
}

/// Lists under a heading that is closed at first, other fields as rows.
void field(PanelEditor& editor, const PanelField& shown) {
    if (!isList(shown.kind)) return fieldRow(editor, shown);
    const std::string title = shown.label + "  " + std::to_string(shown.value.size());
    const std::string heading = title + "###list " + shown.path;
    if (!editor.refusalOf(shown.path).empty()) ImGui::SetNextItemOpen(true);
    if (ImGui::CollapsingHeader(heading.c_str())) listRows(editor, shown);
}

/// Neighbouring fields with the same heading are a group.
void groups(PanelEditor& editor) {
    const std::vector<PanelField>& fields = editor.fields();
    const std::string* group = nullptr;
    bool open = true;
    for (const PanelField& each : fields) {
        if (!group || *group != each.group) {
            const std::string heading = each.group + "###group " + each.group;
            open = each.group.empty() ||
                   ImGui::CollapsingHeader(heading.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
            group = &each.group;
        }
        if (open) field(editor, each);
    }
}

}  // namespace

bool panel(scene::Scene& scene, PanelState& state, const PanelArea& area, const Theme& colours) {
    const auto count = static_cast<int>(scene.state().objects.size());
    if (count == 0) return false;
    state.object = std::clamp(state.object, 0, count - 1);
    PanelEditor editor(scene, state, colours);
    const ImVec2 most(static_cast<float>(area.width), static_cast<float>(area.height));
    ImGui::SetNextWindowPos({static_cast<float>(area.x), static_cast<float>(area.y)});
    ImGui::SetNextWindowSizeConstraints({most.x, 0}, most);
    constexpr ImGuiWindowFlags kind = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("panel", nullptr, kind)) {
        header(editor);
        groups(editor);
    }
    ImGui::End();
    editor.finish(ImGui::IsAnyItemActive());
    return editor.changed();
}

}  // namespace knotwork::ui
