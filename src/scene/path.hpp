// Paths into a document: `objects[0].points[2]`.
#pragma once

#include "scene/json.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace knotwork::scene {

/// One step: a key, or an index where `key` is empty.
struct PathStep {
    std::string key;
    std::size_t index = 0;
    [[nodiscard]] bool isIndex() const noexcept { return key.empty(); }
    friend bool operator==(const PathStep&, const PathStep&) = default;
};

using Path = std::vector<PathStep>;

/// SYNTAX with the position of the first character that does not fit; at least one step.
[[nodiscard]] Result<Path> parsePath(std::string_view text);
[[nodiscard]] std::string formatPath(const Path& path);

/// The place that `path` names in `root`, or null where it does not exist.
[[nodiscard]] Json* find(Json& root, std::span<const PathStep> path) noexcept;
[[nodiscard]] const Json* find(const Json& root, std::span<const PathStep> path) noexcept;

}  // namespace knotwork::scene
