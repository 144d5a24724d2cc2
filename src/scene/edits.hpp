// Edits: what `set`, `move`, `insert` and `remove` do to the JSON of one part of a document. The part
// is an object, an effect or the header, `rest` the path inside it; what comes out is validated when
// the part is made anew.
#pragma once

#include "scene/path.hpp"

namespace knotwork::scene {

// Each refuses a place that is not there (UNKNOWN_FIELD, the path inside the part).

[[nodiscard]] Result<Json> setIn(const Json& part, std::span<const PathStep> rest,
                                 const Json& value);

/// `command` has `to` or `by`. Equal knots at the end of a clamped curve move as one.
[[nodiscard]] Result<Json> moveIn(const Json& part, std::span<const PathStep> rest,
                                  const Json& command);

[[nodiscard]] Result<Json> insertIn(const Json& part, std::span<const PathStep> rest,
                                    const Json& value);

[[nodiscard]] Result<Json> removeIn(const Json& part, std::span<const PathStep> rest);

}  // namespace knotwork::scene
