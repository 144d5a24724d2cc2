// The public names of the forms of B-splines.
#pragma once

#include "geometry/knot_vector.hpp"

#include <optional>
#include <string_view>

namespace knotwork::scene {

/// `clamped`, `open` or `closed`.
[[nodiscard]] inline std::optional<Form> formNamed(std::string_view name) noexcept {
    if (name == "clamped") return Form::clamped;
    if (name == "open") return Form::open;
    if (name == "closed") return Form::closed;
    return std::nullopt;
}

[[nodiscard]] inline std::string_view formName(Form form) noexcept {
    return form == Form::open ? "open" : form == Form::closed ? "closed" : "clamped";
}

}  // namespace knotwork::scene
