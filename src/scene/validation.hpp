// Validation: what was given, checked against the field tables and completed to its canonical
// form: every default filled in, keys in the order of the tables.
//
// Everything that is wrong is found, not only the first of it. Ranges that geometry checks when it
// makes a value (knots, points) are left to it.
#pragma once

#include "scene/fields.hpp"
#include "scene/json.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace knotwork::scene {

/// No more are told of one value.
constexpr std::size_t maximumProblems = 100;

/// What was read, or all that is wrong with it.
class Checked {
public:
    Checked(Json canonical) : canonical_(std::move(canonical)) {}
    Checked(Error problem) { problems_.push_back(std::move(problem)); }
    Checked(Result<Json> read) {
        if (read) {
            canonical_ = std::move(*read);
        } else {
            problems_.push_back(read.error());
        }
    }

    [[nodiscard]] bool ok() const noexcept { return problems_.empty(); }
    [[nodiscard]] const std::vector<Error>& problems() const noexcept { return problems_; }
    /// Whether there are as many as are told.
    [[nodiscard]] bool full() const noexcept { return problems_.size() >= maximumProblems; }
    /// The canonical form, or the first problem.
    [[nodiscard]] Result<Json> result() && {
        if (ok()) return std::move(canonical_);
        return std::move(problems_.front());
    }

    [[nodiscard]] Json& canonical() noexcept { return canonical_; }
    /// Takes over what is wrong with a part that stands at `path`.
    void add(const std::vector<Error>& problems, std::string_view path) {
        for (std::size_t i = 0; i < problems.size() && !full(); ++i) {
            problems_.push_back(problems[i].under(path));
        }
    }
    void add(Error problem) {
        if (!full()) problems_.push_back(std::move(problem));
    }

private:
    Json canonical_;
    std::vector<Error> problems_;
};

/// An object whose members are described by `fields`. WRONG_TYPE, UNKNOWN_FIELD and what the
/// members themselves refuse, with the path of the place; first the fields that do not belong, then
/// the members in the order of the table.
[[nodiscard]] Checked checkGroup(const Json& given, std::span<const Field> fields);

/// An object of a scene of any type, with its `id`, `style` and `show` as far as they were given.
[[nodiscard]] Checked checkObjectSpec(const Json& given);

// The same where one problem is enough.

[[nodiscard]] Result<Json> readGroup(const Json& given, std::span<const Field> fields);

/// A B-function specification of any family: `family` first, then its parameters.
[[nodiscard]] Result<Json> readBFunction(const Json& given);

/// A curve specification of any type: `type` first, then its fields, and then those of `extra`
/// that were given (an object of a scene has `id`, `style` and `show` besides).
[[nodiscard]] Result<Json> readCurve(const Json& given, std::span<const Field> extra = {});

/// A surface specification of any type, likewise.
[[nodiscard]] Result<Json> readSurface(const Json& given, std::span<const Field> extra = {});

[[nodiscard]] Result<Json> readObjectSpec(const Json& given);

/// [x, y] or [x, y, z], finite numbers.
[[nodiscard]] Result<Json> readPoint(const Json& given);

/// What a person would call this value in a message: `the string "0.5"`, `null`, `a list`.
[[nodiscard]] std::string describeValue(const Json& value);

}  // namespace knotwork::scene
