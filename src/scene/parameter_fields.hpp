// The geometry's descriptions of parameters, as fields and as the lists that programs see.
#pragma once

#include "geometry/parameter.hpp"
#include "scene/fields.hpp"
#include "scene/json.hpp"

#include <span>

namespace knotwork::scene {

[[nodiscard]] Field fieldOf(const ParameterDescription& parameter);

/// [{ name, label, min, max, default, minOpen, maxOpen, integer, help }]
[[nodiscard]] Json describeParameters(std::span<const ParameterDescription> parameters);

}  // namespace knotwork::scene
