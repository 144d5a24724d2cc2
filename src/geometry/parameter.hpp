// What a named real parameter may be: the one source for checks, field descriptions and panels.
#pragma once

#include "geometry/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knotwork {

struct ParameterDescription {
    std::string_view name;
    std::string_view label;
    double min = 0;  ///< allowed range …
    double max = 1;
    double defaultValue = 0;
    double low = 0;  ///< … and the part of it that a slider offers
    double high = 1;
    std::string_view help;
    bool minOpen = false;  ///< min itself is not allowed
    bool maxOpen = false;
    bool integer = false;
};

using NamedValue = std::pair<std::string, double>;

/// Nothing when the value is allowed, else a refusal at `path`: NOT_FINITE, NOT_INTEGER or
/// OUT_OF_RANGE, with the value and the range in the message.
[[nodiscard]] std::optional<Error> checkParameter(const ParameterDescription& description,
                                                  double value, std::string path);

/// The values in the order of the descriptions, defaults filled in, each checked. A name that is
/// not described is UNKNOWN_FIELD. Paths are `parent.name` (`name` when the parent is empty).
[[nodiscard]] Result<std::vector<double>> readParameters(
    std::span<const ParameterDescription> descriptions, std::span<const NamedValue> given,
    std::string_view parent);

}  // namespace knotwork
