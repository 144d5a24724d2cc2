// Refusals as values: a Result<T> holds either what was asked for or the reason why not.
//
// Input is checked once, when a value is made; every function of a made value is total. Nothing in
// the core throws: an Error travels up through Results and becomes a KnotworkError at the border.
#pragma once

#include <cassert>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace knotwork {

/// The codes of the public interface, in its order; codeName() gives their public spelling.
enum class Code {
    wrongType,
    wrongLength,
    notFinite,
    notInteger,
    outOfRange,
    tooLarge,
    unknownName,
    unknownField,
    knotsDecreasing,
    knotsMultiplicity,
    knotsCount,
    rankDeficient,
    notManifold,
    notSupported,
    syntax,
    version,
    disposed,
    outOfMemory,
};

/// `OUT_OF_RANGE` for Code::outOfRange, and so on.
[[nodiscard]] std::string_view codeName(Code code) noexcept;

/// Why something was refused.
struct Error {
    Code code = Code::wrongType;
    std::string path;     ///< where in the input, e.g. `knots[3]`; empty for the whole of it
    std::string message;  ///< what was given, what is allowed, what to do

    /// The same error seen from one level further out: `under("objects[0]")` turns `knots[3]`
    /// into `objects[0].knots[3]`.
    [[nodiscard]] Error under(std::string_view parent) const;

    friend bool operator==(const Error&, const Error&) = default;
};

/// Joins two paths: `joinPath("a", "b")` is `a.b`, `joinPath("a", "[2]")` is `a[2]`.
[[nodiscard]] std::string joinPath(std::string_view parent, std::string_view child);

/// `indexed("knots", 3)` is `knots[3]`.
[[nodiscard]] std::string indexed(std::string_view list, std::size_t index);

/// A number as a person would write it, for messages: shortest of up to 15 digits.
[[nodiscard]] std::string formatNumber(double value);

/// Either a T or an Error. value() of a refusal is a programming mistake (asserted).
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : held_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : held_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool ok() const noexcept { return held_.index() == 0; }
    explicit operator bool() const noexcept { return ok(); }

    [[nodiscard]] const T& value() const& noexcept {
        assert(ok());
        return *std::get_if<0>(&held_);
    }
    [[nodiscard]] T& value() & noexcept {
        assert(ok());
        return *std::get_if<0>(&held_);
    }
    [[nodiscard]] T&& value() && noexcept {
        assert(ok());
        return std::move(*std::get_if<0>(&held_));
    }
    [[nodiscard]] const Error& error() const noexcept {
        assert(!ok());
        return *std::get_if<1>(&held_);
    }

    const T& operator*() const& noexcept { return value(); }
    T& operator*() & noexcept { return value(); }
    T&& operator*() && noexcept { return std::move(*this).value(); }
    const T* operator->() const noexcept { return &value(); }
    T* operator->() noexcept { return &value(); }

private:
    std::variant<T, Error> held_;
};

/// For operations that answer nothing but may refuse.
struct Done {};

/// The refusal itself: `return refuse(Code::notFinite, "knots[3]", "…");`
[[nodiscard]] Error refuse(Code code, std::string path, std::string message);

}  // namespace knotwork
