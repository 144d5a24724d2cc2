#include "ui/imgui_host.hpp"

#include "generated/ui_font.hpp"
#include "ui/imgui_keys.hpp"
#include "ui/imgui_style.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace knotwork::ui {
namespace {

constexpr double fontSize = 15;  // CSS pixels

// Everything of the font's that lies in these blocks; the build decides what the font has
// (cmake/UiFont.cmake).
constexpr std::array<ImWchar, 11> glyphRanges{0x0020, 0x024f, 0x0370, 0x03ff, 0x2000, 0x22ff,
                                              0x23f8, 0x27bf, 0xfffd, 0xfffd, 0};

/// How many frames Dear ImGui takes to settle after an input: one sees it, one lays out what
/// follows, one paints what that has moved.
constexpr int settlingFrames = 3;

ImGuiMouseSource sourceOf(PointerKind kind) {
    switch (kind) {
        case PointerKind::touch: return ImGuiMouseSource_TouchScreen;
        case PointerKind::pen: return ImGuiMouseSource_Pen;
        default: return ImGuiMouseSource_Mouse;
    }
}

/// DOM numbers the middle button 1 and the secondary one 2; Dear ImGui the other way round.
int imguiButton(int button) {
    constexpr std::array order{ImGuiMouseButton_Left, ImGuiMouseButton_Middle,
                               ImGuiMouseButton_Right};
    return button >= 0 && button < 3 ? order[static_cast<std::size_t>(button)] : -1;
}

/// Another host or another module on the page may have a context of its own.
class Current {
public:
    explicit Current(ImGuiContext* context) : former_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
    ~Current() { ImGui::SetCurrentContext(former_); }

private:
    ImGuiContext* former_;
};

void configure(ImGuiIO& io) {
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    io.ConfigInputTextCursorBlink = false;  // a caret that blinks costs frames for ever
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigMacOSXBehaviors = false;
    io.GetClipboardTextFn = [](void*) -> const char* { return ""; };
    io.SetClipboardTextFn = [](void*, const char*) {};
}

}  // namespace

PointerKind pointerKindNamed(std::string_view name) noexcept {
    if (name == "touch") return PointerKind::touch;
    return name == "pen" ? PointerKind::pen : PointerKind::mouse;
}

ImGuiHost::~ImGuiHost() {
    if (!context_) return;
    ImGui::SetCurrentContext(context_);
    if (backend_) ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

bool ImGuiHost::start() {
    if (!context_) {
        context_ = ImGui::CreateContext();
        const Current current(context_);
        configure(ImGui::GetIO());
        applyTheme();
    }
    const Current current(context_);
    if (!backend_) backend_ = ImGui_ImplOpenGL3_Init("#version 300 es");
    if (pixelRatio_ == 0) buildFonts(1);
    started_ = backend_ && ImGui_ImplOpenGL3_CreateDeviceObjects();
    message_ = started_ ? "" : "The panel's shaders could not be compiled.";
    touched();
    return started_;
}

// The back end forgets its names by deleting them, which a lost context ignores.
void ImGuiHost::forget() noexcept {
    if (!started_) return;
    const Current current(context_);
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    started_ = false;
}

void ImGuiHost::applyTheme() { ImGui::GetStyle() = imguiStyle(colours()); }

void ImGuiHost::setTheme(ThemeName name) {
    if (name == themeName_) return;
    themeName_ = name;
    if (!context_) return;
    const Current current(context_);
    applyTheme();
    touched();
}

// Glyphs are rasterised at the size in device pixels at which they are shown.
void ImGuiHost::buildFonts(double pixelRatio) {
    ImGuiIO& io = ImGui::GetIO();
    const double size = std::max(1.0, std::round(fontSize * pixelRatio));
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 2;
    config.PixelSnapH = true;
    io.Fonts->Clear();
    io.Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(uiFont),
                                   static_cast<int>(uiFontSize), static_cast<float>(size), &config,
                                   glyphRanges.data());
    io.FontGlobalScale = static_cast<float>(fontSize / size);
    pixelRatio_ = pixelRatio;
    if (!started_) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void ImGuiHost::touched() noexcept { framesDue_ = settlingFrames; }

void ImGuiHost::pointerMove(double x, double y, PointerKind kind) {
    if (!context_) return;
    const Current current(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.AddMouseSourceEvent(sourceOf(kind));
    io.AddMousePosEvent(static_cast<float>(x), static_cast<float>(y));
    touched();
}

void ImGuiHost::pointerButton(int button, bool down, PointerKind kind) {
    const int number = imguiButton(button);
    if (!context_ || number < 0) return;
    const Current current(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.AddMouseSourceEvent(sourceOf(kind));
    io.AddMouseButtonEvent(number, down);
    // a finger that is lifted hovers over nothing
    if (kind == PointerKind::touch && !down) io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
    touched();
}

void ImGuiHost::pointerLeave() {
    if (!context_) return;
    const Current current(context_);
    ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
    touched();
}

void ImGuiHost::wheel(double dx, double dy) {
    if (!context_) return;
    const Current current(context_);
    ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(dx), static_cast<float>(dy));
    touched();
}

void ImGuiHost::key(std::string_view name, bool down, unsigned modifiers) {
    if (!context_) return;
    const Current current(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.AddKeyEvent(ImGuiMod_Shift, (modifiers & shiftKey) != 0);
    io.AddKeyEvent(ImGuiMod_Ctrl, (modifiers & commandKey) != 0);
    io.AddKeyEvent(ImGuiMod_Alt, (modifiers & altKey) != 0);
    const ImGuiKey number = imguiKeyNamed(name);
    if (number != ImGuiKey_None) io.AddKeyEvent(number, down);
    touched();
}

void ImGuiHost::text(std::string_view utf8) {
    if (!context_) return;
    const Current current(context_);
    ImGui::GetIO().AddInputCharactersUTF8(std::string(utf8).c_str());
    touched();
}

void ImGuiHost::blur() {
    if (!context_) return;
    const Current current(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.ClearInputKeys();
    for (int button = 0; button < 3; ++button) io.AddMouseButtonEvent(button, false);
    io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
    touched();
}

bool ImGuiHost::beginFrame(const Frame& frame) {
    if (!started_ || inFrame_) return false;
    ImGui::SetCurrentContext(context_);
    const double ratio = frame.pixelRatio > 0 ? frame.pixelRatio : 1;
    if (std::abs(ratio - pixelRatio_) > 1e-6) buildFonts(ratio);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(frame.width / ratio),
                      static_cast<float>(frame.height / ratio)};
    io.DisplayFramebufferScale = {static_cast<float>(ratio), static_cast<float>(ratio)};
    io.DeltaTime = static_cast<float>(std::clamp(frame.seconds, 1e-3, 0.1));
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    inFrame_ = true;
    return true;
}

void ImGuiHost::render() {
    if (!inFrame_) return;
    inFrame_ = false;
    ImGui::SetCurrentContext(context_);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    framesDue_ = std::max(0, framesDue_ - 1);
}

bool ImGuiHost::wantsPointer() const noexcept {
    return context_ && context_->IO.WantCaptureMouse;
}

bool ImGuiHost::wantsKeyboard() const noexcept {
    return context_ && context_->IO.WantCaptureKeyboard;
}

bool ImGuiHost::wantsText() const noexcept { return context_ && context_->IO.WantTextInput; }

bool ImGuiHost::hits(double x, double y) const noexcept { return covers(x, y, x, y); }

bool ImGuiHost::covers(double left, double top, double right, double bottom) const noexcept {
    if (!context_) return false;
    const ImRect box(static_cast<float>(left), static_cast<float>(top), static_cast<float>(right),
                     static_cast<float>(bottom));
    constexpr int intangible = ImGuiWindowFlags_NoMouseInputs | ImGuiWindowFlags_Tooltip;
    const auto& windows = context_->Windows;
    return std::any_of(windows.begin(), windows.end(), [&](const ImGuiWindow* window) {
        const ImRect area = window->Rect();
        return window->Active && !window->Hidden && !window->IsFallbackWindow &&
               !(window->Flags & intangible) && box.Min.x < area.Max.x && box.Max.x >= area.Min.x &&
               box.Min.y < area.Max.y && box.Max.y >= area.Min.y;
    });
}

bool ImGuiHost::animating() const noexcept {
    if (!started_) return false;
    const ImGuiContext& g = *context_;
    const bool waitingForTip =
        g.HoverItemDelayId != 0 && g.HoverItemDelayTimer < g.Style.HoverDelayNormal + 0.1F;
    return framesDue_ > 0 || !g.InputEventsQueue.empty() || waitingForTip;
}

std::string_view ImGuiHost::cursor() const noexcept {
    if (!context_) return "default";
    switch (context_->MouseCursor) {
        case ImGuiMouseCursor_TextInput: return "text";
        case ImGuiMouseCursor_ResizeEW: return "ew-resize";
        case ImGuiMouseCursor_ResizeNS: return "ns-resize";
        case ImGuiMouseCursor_Hand: return "pointer";
        case ImGuiMouseCursor_NotAllowed: return "not-allowed";
        default: return "default";
    }
}

}  // namespace knotwork::ui
