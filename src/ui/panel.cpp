#include "ui/panel.hpp"

#include "scene/object_builders.hpp"
#include "ui/panel_editor.hpp"
#include "ui/panel_widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <span>

namespace knotwork::ui {
namespace {

using scene::FieldKind;
using scene::PanelField;

/// An arrow that turns back to the left (undo), or mirrored to the right (redo), in the last item.
void drawTurningArrow(bool toLeft, ImU32 colour) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const float size = ImGui::GetItemRectSize().x;
    const auto at = [=](float x, float y) {
        return ImVec2(low.x + size * (toLeft ? x : 1 - x), low.y + size * y);
    };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float width = 0.075F * size;
    draw.PathLineTo(at(0.40F, 0.24F));
    draw.PathLineTo(at(0.26F, 0.40F));
    draw.PathLineTo(at(0.40F, 0.56F));
    draw.PathStroke(colour, ImDrawFlags_None, width);
    draw.PathLineTo(at(0.26F, 0.40F));
    draw.PathLineTo(at(0.57F, 0.40F));
    draw.PathBezierCubicCurveTo(at(0.80F, 0.40F), at(0.80F, 0.74F), at(0.57F, 0.74F));
    draw.PathLineTo(at(0.42F, 0.74F));
    draw.PathStroke(colour, ImDrawFlags_None, width);
}

bool arrowButton(const std::string& name, bool toLeft, bool enabled) {
    const float size = ImGui::GetFrameHeight();
    ImGui::PushID(name.c_str());
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button("##arrow", {size, size});
    drawTurningArrow(toLeft, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::EndDisabled();
    ImGui::SetItemTooltip("%s", name.c_str());
    ImGui::PopID();
    return pressed;
}

std::string titleOf(const scene::Object& object) {
    return std::string(scene::objectTypeLabel(object.spec)) + "  " + object.id;
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
    const bool open = ImGui::BeginCombo("##object", title.c_str(), ImGuiComboFlags_NoArrowButton);
    if (!open) return drawChevron();
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
    if (arrowButton(editor.words().undo, true, editor.canUndo())) editor.undo();
    ImGui::SameLine(right - button);
    if (arrowButton(editor.words().redo, false, editor.canRedo())) editor.redo();
    ImGui::Separator();
}

/// A line that can be opened: its arrow stands where the labels of fields begin.
bool heading(const std::string& title, const std::string& id, bool openAtFirst) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, ImGui::GetStyle().FramePadding.y});
    const bool open = ImGui::CollapsingHeader(
        (title + "###" + id).c_str(), openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopStyleVar();
    return open;
}

/// Lists under a heading that is closed at first, other fields as rows.
void field(PanelEditor& editor, const PanelField& shown) {
    if (!isList(shown.kind)) return fieldRow(editor, shown);
    if (!editor.refusalOf(shown.path).empty()) ImGui::SetNextItemOpen(true);
    const std::string title = shown.label + "  " + std::to_string(shown.value.size());
    if (!heading(title, "list " + shown.path, false)) return;
    ImGui::Indent();
    listRows(editor, shown);
    ImGui::Unindent();
}

/// Fields from `first` on that stand under the same heading; returns where the next group begins.
std::size_t group(PanelEditor& editor, std::span<const PanelField> fields, std::size_t first) {
    const std::string& name = fields[first].group;
    std::size_t end = first;
    while (end < fields.size() && fields[end].group == name) ++end;
    if (first > 0) ImGui::Separator();
    if (!name.empty() && !heading(name, "group " + name, true)) return end;
    const auto members = fields.subspan(first, end - first);
    const bool onlyFlags = std::all_of(members.begin(), members.end(), [](const PanelField& each) {
        return each.kind == FieldKind::flag;
    });
    if (onlyFlags) {
        flagGrid(editor, members);
    } else {
        for (const PanelField& each : members) field(editor, each);
    }
    return end;
}

void groups(PanelEditor& editor) {
    const std::span<const PanelField> fields(editor.fields());
    for (std::size_t next = 0; next < fields.size();) next = group(editor, fields, next);
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
