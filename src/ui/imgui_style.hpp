// Our looks as a Dear ImGui style: flat, rounded, calm; sizes are CSS pixels.
#pragma once

#include "ui/theme.hpp"

#include <imgui.h>

namespace knotwork::ui {

[[nodiscard]] ImVec4 imguiColour(const scene::Colour& colour) noexcept;
[[nodiscard]] ImGuiStyle imguiStyle(const Theme& colours);

}  // namespace knotwork::ui
