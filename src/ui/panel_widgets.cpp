#include "ui/panel_widgets.hpp"

#include "ui/imgui_style.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork::ui {
namespace {

using scene::FieldKind;
using scene::Json;
using scene::PanelField;

constexpr float labelShare = 0.42F;  // of the panel's width
constexpr int mostSteps = 100;       // beyond this many values an integer is dragged, not slid

double numberOf(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// The ends of a slider; an end that is itself excluded is kept a thousandth away.
std::pair<double, double> sliderEnds(const PanelField& field) {
    const double margin = 1e-3 * (field.high - field.low);
    return {field.minOpen && field.low <= field.min ? field.low + margin : field.low,
            field.maxOpen && field.high >= field.max ? field.high - margin : field.high};
}

void number(PanelEditor& editor, const PanelField& field) {
    double value = numberOf(field.value);
    const auto [low, high] = sliderEnds(field);
    const bool edited =
        field.slider ? ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &low, &high, "%.4g")
                     : dragNumbers({&value, 1}, dragSpeed(value));
    if (edited) editor.hold(field.path, field.path, value);
}

void integer(PanelEditor& editor, const PanelField& field) {
    int value = static_cast<int>(std::lround(std::clamp(numberOf(field.value), -2e9, 2e9)));
    const bool few = field.slider && field.high - field.low <= mostSteps;
    const bool edited = few ? ImGui::SliderInt("##value", &value, static_cast<int>(field.low),
                                               static_cast<int>(field.high))
                            : ImGui::DragInt("##value", &value, 0.2F);
    if (edited) editor.hold(field.path, field.path, value);
}

void choice(PanelEditor& editor, const PanelField& field) {
    const std::string current = field.value.is_string() ? field.value.get<std::string>() : "";
    const auto shown = std::find_if(field.choices.begin(), field.choices.end(),
                                    [&](const auto& each) { return each.first == current; });
    const std::string& label = shown == field.choices.end() ? current : shown->second;
    if (!ImGui::BeginCombo("##value", label.c_str(), ImGuiComboFlags_HeightLarge)) return;
    for (const auto& [value, name] : field.choices) {
        if (ImGui::Selectable(name.c_str(), value == current) && value != current) {
            editor.set(field.path, value);
        }
    }
    ImGui::EndCombo();
}

void flag(PanelEditor& editor, const PanelField& field) {
    bool value = field.value.is_boolean() && field.value.get<bool>();
    if (ImGui::Checkbox("##value", &value)) editor.set(field.path, value);
}

// What is typed counts once it is finished: half a name is not a name.
void text(PanelEditor& editor, const PanelField& field) {
    std::array<char, 256> typed{};
    const std::string current = field.value.is_string() ? field.value.get<std::string>() : "";
    current.copy(typed.data(), typed.size() - 1);
    ImGui::InputText("##value", typed.data(), typed.size());
    if (ImGui::IsItemDeactivatedAfterEdit() && current != typed.data()) {
        editor.set(field.path, typed.data());
    }
}

void colour(PanelEditor& editor, const PanelField& field) {
    const auto parsed = scene::parseColour(field.value.is_string() ? field.value.get<std::string>()
                                                                   : std::string());
    const scene::Colour current = parsed ? *parsed : scene::Colour{};
    std::array<float, 3> value{static_cast<float>(current.red), static_cast<float>(current.green),
                               static_cast<float>(current.blue)};
    constexpr ImGuiColorEditFlags looks = ImGuiColorEditFlags_NoInputs |
                                          ImGuiColorEditFlags_NoLabel |
                                          ImGuiColorEditFlags_NoOptions |
                                          ImGuiColorEditFlags_NoDragDrop;
    if (!ImGui::ColorEdit3("##value", value.data(), looks)) return;
    const scene::Colour chosen{static_cast<double>(value[0]), static_cast<double>(value[1]),
                               static_cast<double>(value[2])};
    editor.hold(field.path, field.path, scene::formatColour(chosen));
}

void numbersInRow(PanelEditor& editor, const PanelField& field) {
    std::vector<double> values;
    if (field.value.is_array()) {
        for (const Json& each : field.value) values.push_back(numberOf(each));
    } else {
        values.push_back(numberOf(field.value));
    }
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    if (!dragNumbers(values, dragSpeed(largest))) return;
    editor.hold(field.path, field.path, field.value.is_array() ? Json(values) : Json(values[0]));
}

void widget(PanelEditor& editor, const PanelField& field) {
    switch (field.kind) {
        case FieldKind::number: return number(editor, field);
        case FieldKind::integer: return integer(editor, field);
        case FieldKind::flag: return flag(editor, field);
        case FieldKind::choice: return choice(editor, field);
        case FieldKind::text: return text(editor, field);
        case FieldKind::colour: return colour(editor, field);
        case FieldKind::point:
        case FieldKind::scale:
        case FieldKind::interval: return numbersInRow(editor, field);
        default: ImGui::TextDisabled("%s", scene::dumpJson(field.value).c_str());
    }
}

}  // namespace

double dragSpeed(double value) noexcept { return 0.005 * std::max(1.0, std::abs(value)); }

bool dragNumbers(std::span<double> values, double speed) {
    return ImGui::DragScalarN("##value", ImGuiDataType_Double, values.data(),
                              static_cast<int>(values.size()), static_cast<float>(speed), nullptr,
                              nullptr, "%.4g");
}

void rowLabel(std::string_view label, std::string_view help) {
    const float start = ImGui::GetCursorPosX();
    const float width = labelShare * ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 end(corner.x + width - 6, corner.y + ImGui::GetFrameHeight());
    ImGui::Dummy({width - 6, ImGui::GetFrameHeight()});
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_DelayNormal);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(),
                              {corner.x, corner.y + ImGui::GetStyle().FramePadding.y}, end, end.x,
                              end.x, label.data(), label.data() + label.size(), nullptr);
    if (hovered && !help.empty() && ImGui::BeginTooltip()) {
        ImGui::PushTextWrapPos(240);
        ImGui::TextUnformatted(help.data(), help.data() + help.size());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    ImGui::SameLine(start + width);
    ImGui::SetNextItemWidth(-FLT_MIN);
}

void refusalText(std::string_view reason, const Theme& colours) {
    if (reason.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, imguiColour(colours.error));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(reason.data(), reason.data() + reason.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void fieldRow(PanelEditor& editor, const PanelField& field) {
    ImGui::PushID(field.path.c_str());
    rowLabel(field.label, field.help);
    widget(editor, field);
    refusalText(editor.refusalOf(field.path), editor.colours());
    ImGui::PopID();
}

}  // namespace knotwork::ui
