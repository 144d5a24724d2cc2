// Validation: what was given, checked against the field tables and completed to its canonical
// form: every default filled in, keys in the order of the tables.
//
// Ranges that geometry checks when it makes a value (knots, points) are left to it.
#pragma once

#include "scene/fields.hpp"
#include "scene/json.hpp"

namespace knotwork::scene {

/// An object whose members are described by `fields`. WRONG_TYPE, UNKNOWN_FIELD and what the
/// members themselves refuse, with the path of the place.
[[nodiscard]] Result<Json> readGroup(const Json& given, std::span<const Field> fields);

/// A B-function specification of any family: `family` first, then its parameters.
[[nodiscard]] Result<Json> readBFunction(const Json& given);

/// A curve specification of any type: `type` first, then its fields, and then those of `extra`
/// that were given (an object of a scene has `id`, `style` and `show` besides).
[[nodiscard]] Result<Json> readCurve(const Json& given, std::span<const Field> extra = {});

/// A surface specification of any type, likewise.
[[nodiscard]] Result<Json> readSurface(const Json& given, std::span<const Field> extra = {});

/// An object of a scene of any type, with its `id`, `style` and `show` as far as they were given.
[[nodiscard]] Result<Json> readObjectSpec(const Json& given);

/// [x, y] or [x, y, z], finite numbers.
[[nodiscard]] Result<Json> readPoint(const Json& given);

/// What a person would call this value in a message: `the string "0.5"`, `null`, `a list`.
[[nodiscard]] std::string describeValue(const Json& value);

}  // namespace knotwork::scene
