// The geometry's descriptions of parameters, as fields and as the lists that programs see.
#pragma once

#include "geometry/parameter.hpp"
#include "scene/fields.hpp"
#include "scene/json.hpp"

#include <span>
#include <vector>

namespace knotwork::scene {

[[nodiscard]] Field fieldOf(const ParameterDescription& parameter);

/// The members of an object of numbers, each with its name.
[[nodiscard]] std::vector<NamedValue> namedValues(const Json& group);

/// [{ name, label, min, max, default, minOpen, maxOpen, integer, help }]
[[nodiscard]] Json describeParameters(std::span<const ParameterDescription> parameters);

}  // namespace knotwork::scene
