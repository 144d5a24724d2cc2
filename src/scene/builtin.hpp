// The built-in scenes: documents, not code (src/scene/builtin/*.json, compiled in at build time).
#pragma once

#include "scene/json.hpp"

#include <span>
#include <string_view>

namespace knotwork::scene {

struct BuiltinScene {
    std::string_view id;
    std::string_view document;  ///< JSON text
};

[[nodiscard]] std::span<const BuiltinScene> builtinScenes() noexcept;

/// kw.scenes: [{ id, title, description, document }].
[[nodiscard]] Json describeScenes();

}  // namespace knotwork::scene
