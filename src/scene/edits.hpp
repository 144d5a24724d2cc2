// Edits: what `set`, `move`, `insert` and `remove` do to the JSON of one part of a document. The part
// is an object, an effect or the header, `rest` the path inside it; what comes out is validated when
// the part is made anew.
#pragma once

#include "scene/path.hpp"

namespace knotwork::scene {

// Each refuses a place that is not there (UNKNOWN_FIELD, the path inside the part).

[[nodiscard]] Result<Json> setIn(Json part, std::span<const PathStep> rest, const Json& value);

/// Where a move leads: `to`, or what stands there `by` an amount. WRONG_TYPE for neither or both, and
/// for amounts that do not fit.
[[nodiscard]] Result<Json> movedValue(const Json& value, const Json& command);

/// `insert` and `remove` of a net's points name rows by `points[i]` and columns by `points[0][j]`; a
/// new column is a list of points, one for each row.
[[nodiscard]] Result<Json> insertIn(Json part, std::span<const PathStep> rest, const Json& value);
[[nodiscard]] Result<Json> removeIn(Json part, std::span<const PathStep> rest);

}  // namespace knotwork::scene
