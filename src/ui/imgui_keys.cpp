#include "ui/imgui_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace knotwork::ui {
namespace {

constexpr std::array<std::pair<std::string_view, ImGuiKey>, 16> named{{
    {"Tab", ImGuiKey_Tab},
    {"ArrowLeft", ImGuiKey_LeftArrow},
    {"ArrowRight", ImGuiKey_RightArrow},
    {"ArrowUp", ImGuiKey_UpArrow},
    {"ArrowDown", ImGuiKey_DownArrow},
    {"PageUp", ImGuiKey_PageUp},
    {"PageDown", ImGuiKey_PageDown},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Insert", ImGuiKey_Insert},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {" ", ImGuiKey_Space},
    {"Enter", ImGuiKey_Enter},
    {"Escape", ImGuiKey_Escape},
    {"NumpadEnter", ImGuiKey_KeypadEnter},
}};

}  // namespace

ImGuiKey imguiKeyNamed(std::string_view name) noexcept {
    if (name.size() == 1) {
        const char c = name.front();
        if (c >= 'a' && c <= 'z') return static_cast<ImGuiKey>(ImGuiKey_A + (c - 'a'));
        if (c >= 'A' && c <= 'Z') return static_cast<ImGuiKey>(ImGuiKey_A + (c - 'A'));
        if (c >= '0' && c <= '9') return static_cast<ImGuiKey>(ImGuiKey_0 + (c - '0'));
    }
    const auto found = std::find_if(named.begin(), named.end(),
                                    [name](const auto& key) { return key.first == name; });
    return found == named.end() ? ImGuiKey_None : found->second;
}

}  // namespace knotwork::ui
