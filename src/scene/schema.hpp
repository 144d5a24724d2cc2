// The JSON Schema of documents, made from the field tables: for editors, and as dist/schema.json.
#pragma once

#include "scene/json.hpp"

namespace knotwork::scene {

/// Draft 2020-12. What a schema can say: names, types, ranges, choices and defaults; knots and
/// lengths that depend on each other are checked when a document is opened.
[[nodiscard]] Json documentSchema();

}  // namespace knotwork::scene
