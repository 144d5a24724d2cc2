// The lists of the panel: control points, knots and other numbers, poses of local curves.
#include "geometry/blending_curve.hpp"
#include "ui/panel_widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace knotwork::ui {
namespace {

using scene::FieldKind;
using scene::Json;
using scene::PanelField;

constexpr int rowsBeforeScrolling = 8;

/// The numbers of an element: of a point its coordinates, of a number itself.
std::vector<double> numbersOf(const Json& element) {
    std::vector<double> values;
    if (element.is_number()) values.push_back(element.get<double>());
    if (!element.is_array()) return values;
    for (const Json& each : element) values.push_back(each.is_number() ? each.get<double>() : 0);
    return values;
}

Json elementOf(const std::vector<double>& values, bool single) {
    return single ? Json(values[0]) : Json(values);
}

/// A small button at the right end of a row that removes it.
bool removeButton(const std::string& tip) {
    const float width = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    const bool pressed = ImGui::Button("\xc3\x97", {width, 0});
    ImGui::SetItemTooltip("%s", tip.c_str());
    return pressed;
}

/// Whether the user asks to remove the element.
bool elementRow(PanelEditor& editor, const PanelField& field, std::size_t i) {
    const Json& element = field.value[i];
    std::vector<double> values = numbersOf(element);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%d", static_cast<int>(i) + 1);
    ImGui::SameLine(34);
    const float rest = ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX();
    ImGui::SetNextItemWidth(rest - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.x);
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    if (!values.empty() && dragNumbers(values, dragSpeed(largest))) {
        editor.hold(field.path, indexed(field.path, i), elementOf(values, element.is_number()));
    }
    const bool removed = removeButton(editor.words().remove);
    ImGui::PopID();
    return removed;
}

/// A point that continues the polygon by half of its last leg.
Json nextPoint(const Json& points) {
    const std::vector<double> last = numbersOf(points.back());
    const std::vector<double> former = numbersOf(points[points.size() < 2 ? 0 : points.size() - 2]);
    std::vector<double> next = last;
    for (std::size_t k = 0; k < std::min(last.size(), former.size()); ++k) {
        next[k] += points.size() < 2 ? 1.0 : 0.5 * (last[k] - former[k]);
    }
    return next;
}

/// The middle of the widest span: where a knot is missed most.
double widestSpan(const std::vector<double>& knots) {
    std::size_t widest = 0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        if (knots[i + 1] - knots[i] > knots[widest + 1] - knots[widest]) widest = i;
    }
    return 0.5 * (knots[widest] + knots[widest + 1]);
}

/// The command that adds an element, or null where the list's length follows from something else.
Json addCommand(const PanelEditor& editor, const PanelField& field) {
    const Json& list = field.value;
    if (!list.is_array() || list.empty()) return nullptr;
    const std::string end = editor.address(indexed(field.path, list.size()));
    if (field.kind == FieldKind::points) return {{"insert", end}, {"value", nextPoint(list)}};
    if (field.path == "knots" && list.size() > 1) {
        const double at = widestSpan(numbersOf(list));
        return {{"insertKnot", {{"object", editor.object().id}, {"at", at}}}};
    }
    return nullptr;
}

void elements(PanelEditor& editor, const PanelField& field) {
    const int count = static_cast<int>(field.value.size());
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float height = row * static_cast<float>(std::min(count, rowsBeforeScrolling));
    int removed = -1;
    if (ImGui::BeginChild("rows", {0, height})) {
        ImGuiListClipper clipper;
        clipper.Begin(count, row);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                if (elementRow(editor, field, static_cast<std::size_t>(i))) removed = i;
            }
        }
    }
    ImGui::EndChild();
    if (removed >= 0) {
        const std::string path = indexed(field.path, static_cast<std::size_t>(removed));
        editor.once(field.path, {{"remove", editor.address(path)}});
    }
    Json add = addCommand(editor, field);
    if (!add.is_null() && ImGui::Button(editor.words().add.c_str(), {-FLT_MIN, 0})) {
        editor.once(field.path, std::move(add));
    }
}

// --- poses ------------------------------------------------------------------------------------

void poseNumbers(PanelEditor& editor, const PanelField& field, const std::string& path,
                 std::string_view label, const Json* value) {
    if (value == nullptr) return;
    std::vector<double> values = numbersOf(*value);
    if (values.empty()) return;
    ImGui::PushID(path.c_str());
    rowLabel(label, "");
    if (dragNumbers(values, 0.01)) {
        editor.hold(field.path, path, elementOf(values, value->is_number()));
    }
    ImGui::PopID();
}

void pose(PanelEditor& editor, const PanelField& field, std::size_t k) {
    const Json& spec = field.value[k];
    const std::string path = indexed(field.path, k);
    const std::string title = editor.words().local + " " +
                              formatNumber(scene::numberOr(spec, "local", 0)) + "###" + path;
    if (!ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth)) return;
    for (const scene::Field& part : scene::poseFields()) {
        if (part.name == "local") continue;
        const Json* value = scene::member(spec, part.name);
        if (value != nullptr && value->is_object()) {
            poseNumbers(editor, field, path + ".rotate.angle", part.label,
                        scene::member(*value, "angle"));
        } else {
            poseNumbers(editor, field, joinPath(path, part.name), part.label, value);
        }
    }
    ImGui::TreePop();
}

/// The first local curve that has no pose yet, or -1.
int firstWithoutPose(const PanelEditor& editor, const Json& poses) {
    const auto* blend = editor.object().body.as<BlendingCurve>();
    if (blend == nullptr) return -1;
    for (int local = 0; local < static_cast<int>(blend->locals().size()); ++local) {
        const bool posed = std::any_of(poses.begin(), poses.end(), [local](const Json& each) {
            return scene::numberOr(each, "local", -1) == local;
        });
        if (!posed) return local;
    }
    return -1;
}

void poses(PanelEditor& editor, const PanelField& field) {
    for (std::size_t k = 0; k < field.value.size(); ++k) pose(editor, field, k);
    const int free = firstWithoutPose(editor, field.value);
    if (free < 0 || !ImGui::Button(editor.words().add.c_str(), {-FLT_MIN, 0})) return;
    editor.once(field.path, {{"pose", {{"object", editor.object().id}, {"local", free}}}});
}

}  // namespace

bool isList(FieldKind kind) noexcept {
    return kind == FieldKind::points || kind == FieldKind::numbers || kind == FieldKind::poses;
}

void listRows(PanelEditor& editor, const PanelField& field) {
    ImGui::PushID(field.path.c_str());
    if (field.kind == FieldKind::poses) poses(editor, field);
    else if (field.value.is_array()) elements(editor, field);
    refusalText(editor.refusalOf(field.path), editor.colours());
    ImGui::PopID();
}

}  // namespace knotwork::ui
