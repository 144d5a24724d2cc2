// Keys by their names in the DOM (KeyboardEvent.key).
#pragma once

#include <imgui.h>

#include <string_view>

namespace knotwork::ui {

/// ImGuiKey_None for a key that no widget uses.
[[nodiscard]] ImGuiKey imguiKeyNamed(std::string_view name) noexcept;

}  // namespace knotwork::ui
