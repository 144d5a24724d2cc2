// The page's one Dear ImGui context, which moves to whichever view has the panel.
//
// The host has no canvas and no clock: input is fed in, time is given, and what it paints goes to
// the lower left corner of the current framebuffer, over what the renderer painted there. Positions
// are CSS pixels from the upper left corner of the view. It keeps no file and no clipboard.
#pragma once

#include "ui/theme.hpp"

#include <string>
#include <string_view>

struct ImGuiContext;

namespace knotwork::ui {

enum class PointerKind { mouse, touch, pen };

/// `mouse`, `touch` or `pen` as PointerEvent.pointerType spells them; anything else is a mouse.
[[nodiscard]] PointerKind pointerKindNamed(std::string_view name) noexcept;

/// Bits of the page's modifiers.
enum Modifier : unsigned { shiftKey = 1, commandKey = 2, altKey = 4 };

class ImGuiHost {
public:
    struct Frame {
        int width = 0;       ///< device pixels
        int height = 0;
        double pixelRatio = 1;
        double seconds = 1.0 / 60;  ///< since the frame before; clamped to [1/1000, 1/10]
    };

    ImGuiHost() = default;
    ~ImGuiHost();
    ImGuiHost(const ImGuiHost&) = delete;
    ImGuiHost& operator=(const ImGuiHost&) = delete;

    /// Makes the context (the first time) and its GL objects in the current GL context. False, with
    /// a message(), when that is impossible. Again after forget(): what is open stays open.
    [[nodiscard]] bool start();
    [[nodiscard]] bool started() const noexcept { return started_; }
    [[nodiscard]] const std::string& message() const noexcept { return message_; }
    /// The GL context was lost: its names are dead.
    void forget() noexcept;

    void setTheme(ThemeName name);
    /// The colours that were last set.
    [[nodiscard]] const Theme& colours() const noexcept { return theme(themeName_); }

    // Input, in the order in which it happened; any time, also between frames.
    void pointerMove(double x, double y, PointerKind kind);
    /// DOM buttons: 0 main, 1 middle, 2 secondary.
    void pointerButton(int button, bool down, PointerKind kind);
    void pointerLeave();
    void wheel(double dx, double dy);  ///< notches, positive to the right and upwards
    /// A key by its DOM name (`Enter`, `ArrowLeft`, `a`, …); unknown ones are ignored.
    void key(std::string_view name, bool down, unsigned modifiers);
    void text(std::string_view utf8);
    /// The view lost focus or another one gets the panel: releases all keys and buttons.
    void blur();

    /// Whether a frame has begun: without a living context there is none, and nothing may be put
    /// into it.
    [[nodiscard]] bool beginFrame(const Frame& frame);
    /// Ends the frame and paints it.
    void render();

    /// Whether the pointer is over a window or holds one of its widgets (of the last frame).
    [[nodiscard]] bool wantsPointer() const noexcept;
    [[nodiscard]] bool wantsKeyboard() const noexcept;
    [[nodiscard]] bool wantsText() const noexcept;
    /// Whether (x, y) lies in a window of the last frame; for touch, where nothing hovers.
    [[nodiscard]] bool hits(double x, double y) const noexcept;
    /// Whether a window of the last frame covers any of the box: for what stands over the picture.
    [[nodiscard]] bool covers(double left, double top, double right, double bottom) const noexcept;
    /// Whether further frames are due without further input: queued input that is still to be
    /// seen, a blinking caret, a scroll that settles.
    [[nodiscard]] bool animating() const noexcept;
    /// A CSS cursor name.
    [[nodiscard]] std::string_view cursor() const noexcept;

private:
    void touched() noexcept;
    void buildFonts(double pixelRatio);
    void applyTheme();

    ImGuiContext* context_ = nullptr;
    bool backend_ = false;   ///< whether Dear ImGui's own GL part has been set up
    bool started_ = false;
    bool inFrame_ = false;
    int framesDue_ = 0;      ///< frames that ImGui needs to settle after input
    double pixelRatio_ = 0;  ///< for which the fonts were built
    ThemeName themeName_ = ThemeName::light;
    std::string message_;
};

}  // namespace knotwork::ui
