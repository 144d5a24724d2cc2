// About how much memory values take: what the history of a scene is bounded by.
#pragma once

#include "scene/body.hpp"
#include "scene/json.hpp"

#include <cstddef>

namespace knotwork::scene {

/// With all that it holds. O(n).
[[nodiscard]] std::size_t bytesOf(const Json& value) noexcept;

/// What a body holds beyond what its specification says already: the refined mesh. What others are
/// made of is about as large as the specification, and that is counted twice.
[[nodiscard]] std::size_t bytesOf(const Body& body) noexcept;

}  // namespace knotwork::scene
