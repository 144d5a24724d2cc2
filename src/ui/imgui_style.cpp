#include "ui/imgui_style.hpp"

namespace knotwork::ui {
namespace {

using scene::Colour;

Colour translucent(Colour colour, double alpha) {
    colour.alpha = alpha;
    return colour;
}

void shape(ImGuiStyle& style) {
    style.WindowPadding = {14, 12};
    style.WindowRounding = 10;
    style.WindowBorderSize = 1;
    style.ChildRounding = 6;
    style.ChildBorderSize = 0;
    style.PopupRounding = 8;
    style.PopupBorderSize = 1;
    style.FramePadding = {8, 4};
    style.FrameRounding = 6;
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {0, 3};
    style.IndentSpacing = 12;
    style.ScrollbarSize = 10;
    style.ScrollbarRounding = 5;
    style.GrabMinSize = 12;
    style.GrabRounding = 6;
    style.HoverStationaryDelay = 0.2F;
    style.HoverDelayNormal = 0.5F;
}

/// One line a colour: what it is for, and which of ours it is.
void paint(ImGuiStyle& style, const Theme& c) {
    const auto set = [&style](ImGuiCol target, const Colour& colour) {
        style.Colors[target] = imguiColour(colour);
    };
    const Colour nothing{0, 0, 0, 0};
    for (int i = 0; i < ImGuiCol_COUNT; ++i) set(i, c.field);
    set(ImGuiCol_Text, c.text);
    set(ImGuiCol_TextDisabled, c.mutedText);
    set(ImGuiCol_WindowBg, c.panel);
    set(ImGuiCol_ChildBg, nothing);
    set(ImGuiCol_PopupBg, translucent(c.panel, 1));
    set(ImGuiCol_Border, c.panelBorder);
    set(ImGuiCol_BorderShadow, nothing);
    set(ImGuiCol_FrameBgHovered, c.fieldHovered);
    set(ImGuiCol_FrameBgActive, c.fieldActive);
    set(ImGuiCol_ScrollbarBg, nothing);
    set(ImGuiCol_ScrollbarGrab, c.fieldActive);
    set(ImGuiCol_ScrollbarGrabHovered, c.axis);
    set(ImGuiCol_ScrollbarGrabActive, c.axis);
    set(ImGuiCol_CheckMark, c.accent);
    set(ImGuiCol_SliderGrab, c.accent);
    set(ImGuiCol_SliderGrabActive, c.accent);
    set(ImGuiCol_ButtonHovered, c.fieldHovered);
    set(ImGuiCol_ButtonActive, c.fieldActive);
    set(ImGuiCol_Header, nothing);
    set(ImGuiCol_HeaderHovered, c.fieldHovered);
    set(ImGuiCol_HeaderActive, c.fieldActive);
    set(ImGuiCol_Separator, c.panelBorder);
    set(ImGuiCol_SeparatorHovered, c.panelBorder);
    set(ImGuiCol_SeparatorActive, c.panelBorder);
    set(ImGuiCol_ResizeGrip, nothing);
    set(ImGuiCol_TextSelectedBg, translucent(c.accent, 0.3));
    set(ImGuiCol_NavHighlight, c.accent);
    set(ImGuiCol_ModalWindowDimBg, translucent(c.text, 0.2));
}

}  // namespace

ImVec4 imguiColour(const scene::Colour& colour) noexcept {
    return {static_cast<float>(colour.red), static_cast<float>(colour.green),
            static_cast<float>(colour.blue), static_cast<float>(colour.alpha)};
}

ImGuiStyle imguiStyle(const Theme& colours) {
    ImGuiStyle style;
    shape(style);
    paint(style, colours);
    return style;
}

}  // namespace knotwork::ui
