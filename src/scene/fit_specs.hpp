// What is asked of a fit, from checked fields (fit_fields.hpp).
#pragma once

#include "geometry/fitting.hpp"
#include "scene/json.hpp"

#include <optional>
#include <string_view>

namespace knotwork::scene {

/// `chord`, `centripetal` or `uniform`.
[[nodiscard]] std::optional<Parametrisation> parametrisationNamed(std::string_view name) noexcept;

/// The request of fields that are checked and filled in, those that their table does not have left
/// as FitRequest has them. Parameters that are given as numbers are left to whoever keeps them.
[[nodiscard]] FitRequest fitRequestOf(const Json& fields);

}  // namespace knotwork::scene
