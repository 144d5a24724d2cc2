// All that is wrong with a document.
#pragma once

#include "scene/json.hpp"

#include <vector>

namespace knotwork::scene {

/// What is wrong with a document, in the order in which it is read and at most maximumProblems
/// (validation.hpp): nothing where readDocument() takes it, otherwise its error first. Of an object
/// whose fields are in order, geometry's own refusal is one problem; a document without a version
/// that is known has that one. The cost is that of reading it.
[[nodiscard]] std::vector<Error> findProblems(const Json& document);

}  // namespace knotwork::scene
