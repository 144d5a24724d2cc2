// JSON values as text that people read: short lists and objects on one line, long lists filled up to
// the width of a page, numbers with the fewest digits that read back.
#pragma once

#include "scene/json.hpp"

#include <span>
#include <string>
#include <string_view>

namespace knotwork::scene {

/// How keys and strings are written.
enum class Notation { json, javaScript };

/// As JSON, or as an expression of JavaScript whose keys are bare words where they can be.
[[nodiscard]] std::string readableText(const Json& value, Notation notation);

/// `text` as a string of JavaScript, in single quotes where that needs no escapes.
[[nodiscard]] std::string javaScriptString(std::string_view text);

/// Whether it can stand for a property in JavaScript: letters of ASCII, digits, _ and $, not a digit
/// first.
[[nodiscard]] bool isBareWord(std::string_view text) noexcept;

/// Appends numbers in rows, each after the text that stands before it in its column: { "\nv ", " ",
/// " " } for the vertices of OBJ.
void appendRows(std::string& text, std::span<const double> numbers,
                std::span<const std::string_view> before);

}  // namespace knotwork::scene
