// Single values as validation reads them: those whose field says all about them. For validation.cpp.
#pragma once

#include "scene/validation.hpp"

namespace knotwork::scene {

[[nodiscard]] Error wrongType(std::string_view wanted, const Json& given);
/// `a, b, c`.
[[nodiscard]] std::string listNames(std::span<const Choice> choices);
/// `in (0, 4]`, `at least 2`.
[[nodiscard]] std::string describeRange(const Field& field);

// Each refuses with an empty path, or that of the element.

[[nodiscard]] Result<Json> readName(const Json& given, std::span<const Choice> choices);
/// A number, or a whole one, in the range of the field.
[[nodiscard]] Result<Json> readNumber(const Json& given, const Field& field);
[[nodiscard]] Result<Json> readColour(const Json& given);

[[nodiscard]] Checked checkNumbers(const Json& given);
/// `least` to `most` numbers.
[[nodiscard]] Checked checkTuple(const Json& given, std::size_t least, std::size_t most,
                                 std::string_view wanted);
/// Flat triples become a list of points; a list of points stays as it is.
[[nodiscard]] Checked checkPoints(const Json& given);
[[nodiscard]] Checked checkNamedNumbers(const Json& given);
/// A factor, or two or three of them.
[[nodiscard]] Checked checkScale(const Json& given);
/// j of a local curve, [i, j] of a local patch.
[[nodiscard]] Checked checkLocalIndex(const Json& given);

}  // namespace knotwork::scene
