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

constexpr float labelShare = 0.38F;  // of the panel's width
constexpr float numberWidth = 3.4F;  // in font sizes: room for -0.0001 behind a slider
constexpr float pickerWidth = 210;    // CSS pixels
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

/// The track and the knob of the slider that was the last item, at `share` of its length.
void drawSlider(double share) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float radius = 0.28F * (high.y - low.y);
    const float y = 0.5F * (low.y + high.y);
    const float start = low.x + radius;
    const float end = high.x - radius;
    const float knob = start + (end - start) * static_cast<float>(std::clamp(share, 0.0, 1.0));
    const bool lively = ImGui::IsItemActive() || ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 rest = ImGui::GetColorU32(ImGuiCol_FrameBgActive);
    const ImU32 accent = ImGui::GetColorU32(ImGuiCol_SliderGrab);
    draw.AddRectFilled({low.x, y - 2}, {high.x, y + 2}, rest, 2);
    draw.AddRectFilled({low.x, y - 2}, {knob, y + 2}, accent, 2);
    if (lively) {
        draw.AddCircleFilled({knob, y}, radius + 4, ImGui::GetColorU32(ImGuiCol_SliderGrab, 0.25F));
    }
    draw.AddCircleFilled({knob, y}, radius, accent);
}

void number(PanelEditor& editor, const PanelField& field) {
    double value = numberOf(field.value);
    const auto [low, high] = sliderEnds(field);
    const bool edited = field.slider ? slideNumber(value, low, high)
                                     : dragNumbers({&value, 1}, dragSpeed(value));
    if (edited) editor.hold(field.path, field.path, value);
}

void integer(PanelEditor& editor, const PanelField& field) {
    int value = static_cast<int>(std::lround(std::clamp(numberOf(field.value), -2e9, 2e9)));
    const bool few = field.slider && field.high - field.low <= mostSteps;
    double exact = value;
    const bool edited = few ? slideNumber(exact, field.low, field.high)
                            : ImGui::DragInt("##value", &value, 0.2F);
    const int chosen = few ? static_cast<int>(std::lround(exact)) : value;
    if (edited && chosen != numberOf(field.value)) editor.hold(field.path, field.path, chosen);
}

void choice(PanelEditor& editor, const PanelField& field) {
    const std::string current = field.value.is_string() ? field.value.get<std::string>() : "";
    const auto shown = std::find_if(field.choices.begin(), field.choices.end(),
                                    [&](const auto& each) { return each.first == current; });
    const std::string& label = shown == field.choices.end() ? current : shown->second;
    constexpr ImGuiComboFlags looks = ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton;
    const bool open = ImGui::BeginCombo("##value", label.c_str(), looks);
    if (!open) return drawChevron();
    for (const auto& [value, name] : field.choices) {
        if (ImGui::Selectable(name.c_str(), value == current) && value != current) {
            editor.set(field.path, value);
        }
    }
    ImGui::EndCombo();
}

void flag(PanelEditor& editor, const PanelField& field, const std::string& label) {
    bool value = field.value.is_boolean() && field.value.get<bool>();
    if (ImGui::Checkbox((label + "##value").c_str(), &value)) editor.set(field.path, value);
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
    const ImVec4 shown(value[0], value[1], value[2], 1);
    const ImVec2 size(2 * ImGui::GetFrameHeight(), 0);
    if (ImGui::ColorButton("##value", shown, ImGuiColorEditFlags_NoTooltip, size)) {
        ImGui::OpenPopup("picker");
    }
    if (!ImGui::BeginPopup("picker")) return;
    constexpr int looks = ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                          ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoLabel |
                          ImGuiColorEditFlags_DisplayHex;
    ImGui::SetNextItemWidth(pickerWidth);
    const bool edited = ImGui::ColorPicker3("##picker", value.data(), looks);
    ImGui::EndPopup();
    if (!edited) return;
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
        case FieldKind::flag: return flag(editor, field, "");
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

void drawChevron() {
    const ImVec2 high = ImGui::GetItemRectMax();
    const float unit = 0.22F * ImGui::GetFontSize();
    const ImVec2 middle(high.x - 4 * unit,
                        0.5F * (ImGui::GetItemRectMin().y + high.y) + 0.5F * unit);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PathLineTo({middle.x - unit, middle.y - unit});
    draw.PathLineTo(middle);
    draw.PathLineTo({middle.x + unit, middle.y - unit});
    draw.PathStroke(ImGui::GetColorU32(ImGuiCol_Text), ImDrawFlags_None, 1.5F);
}

void flagGrid(PanelEditor& editor, std::span<const PanelField> flags) {
    const float second = 0.56F * ImGui::GetContentRegionMax().x;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine(second);
        ImGui::PushID(flags[i].path.c_str());
        flag(editor, flags[i], flags[i].label);
        if (!flags[i].help.empty()) ImGui::SetItemTooltip("%s", flags[i].help.c_str());
        refusalText(editor.refusalOf(flags[i].path), editor.colours());
        ImGui::PopID();
    }
}

double dragSpeed(double value) noexcept { return 0.005 * std::max(1.0, std::abs(value)); }

bool dragNumbers(std::span<double> values, double speed) {
    return ImGui::DragScalarN("##value", ImGuiDataType_Double, values.data(),
                              static_cast<int>(values.size()), static_cast<float>(speed), nullptr,
                              nullptr, "%.4g");
}

// Dear ImGui's own slider does the sliding, unseen: its number would stand on top of its knob.
bool slideNumber(double& value, double low, double high) {
    const float total = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float typed = numberWidth * ImGui::GetFontSize();
    constexpr std::array unseen{ImGuiCol_Text,          ImGuiCol_FrameBg,
                                ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                ImGuiCol_SliderGrab,     ImGuiCol_SliderGrabActive};
    for (const ImGuiCol part : unseen) ImGui::PushStyleColor(part, {0, 0, 0, 0});
    ImGui::SetNextItemWidth(total - typed - gap);
    bool edited = ImGui::SliderScalar("##slide", ImGuiDataType_Double, &value, &low, &high, "%.4g",
                                      ImGuiSliderFlags_NoInput);
    ImGui::PopStyleColor(static_cast<int>(unseen.size()));
    drawSlider((value - low) / (high - low));
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(typed);
    const double step = (high - low) / 400;
    edited = ImGui::DragScalar("##value", ImGuiDataType_Double, &value, static_cast<float>(step),
                               nullptr, nullptr, "%.4g") || edited;
    return edited;
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
