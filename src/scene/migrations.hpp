// Documents of older versions become documents of this one, step by step, before anything in them is
// checked. A version that was released is read for ever.
#pragma once

#include "scene/json.hpp"

#include <span>

namespace knotwork::scene {

/// From the version `from` to the next one. What comes in has not been checked: whatever is not as
/// it should be is left as it is, for validation to name.
struct Migration {
    int from = 0;
    Json (*apply)(Json document) = nullptr;
};

/// Of all versions that were released; the first of them is 1.
[[nodiscard]] std::span<const Migration> migrations() noexcept;

/// Whether any of `table` is for this document.
[[nodiscard]] bool isOutdated(const Json& document, std::span<const Migration> table) noexcept;

/// The document in the version to which `table` leads, its `knotwork` with it; unchanged where there
/// is no migration for it.
[[nodiscard]] Json migrated(Json document, std::span<const Migration> table);

}  // namespace knotwork::scene
