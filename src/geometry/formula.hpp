// Formulas in t that a person types, as programs that numbers and jets are put through.
//
//   sum     = product { ("+" | "−") product }
//   product = signed { ("*" | "/") signed }
//   signed  = { "+" | "−" } power                 so −t^2 is −(t²) …
//   power   = atom [ "^" signed ]                 … 2^−1 is 1/2 and 2^3^2 is 2⁹
//   atom    = number | t | pi | e | parameter | function "(" sum ")" | "(" sum ")"
//
// with sin cos tan asin acos atan sinh cosh tanh exp log sqrt abs; numbers as 2, .5, 1e-3; 0^0 is 1.
//
// It is written here because no library in Debian does it: libmuparser and exprtk throw exceptions
// and fix their scalar when they are compiled, tinyexpr knows nothing but double (as libmatheval and
// the compiled part of libfparser), and their messages have a position at best. A formula is read
// by the shunting-yard algorithm (Dijkstra 1961), which keeps its own stack and not the machine's.
#pragma once

#include "geometry/jet.hpp"
#include "geometry/parameter.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork {

namespace formula {

/// What one instruction does with the top of the stack: push, replace it, or join it with the one
/// below it. `x` is the top, `c` the instruction's number.
enum class Op : std::uint8_t {
    variable, number,                                   // push t, c
    add, subtract, multiply, divide, power,             // join
    addNumber, subtractFrom, multiplyNumber,            // x + c, c − x, c x
    divideNumber, divideInto,                           // x / c, c / x
    integerPower, realPower, exponential,               // x^c, x^c, c^x
    negate, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt, abs,
};

struct Instruction {
    Op op = Op::number;
    double number = 0;
};

}  // namespace formula

/// A formula that has been read. Copies are independent; evaluation takes no memory and is total
/// (where a formula has no value, the answer is not finite).
class Formula {
public:
    static constexpr std::size_t longestText = 10'000;
    static constexpr std::size_t deepest = 64;  // numbers on the stack at once

    /// Reads `text`, in which the names of `parameters` stand for their values; what does not
    /// depend on t is computed at once. Refusals, all at `path` and all but TOO_LARGE with the
    /// column, counted in characters from 1: SYNTAX; UNKNOWN_NAME; NOT_FINITE for a number beyond
    /// 1.8e308; TOO_LARGE for a text that is too long or nested too deeply. O(length) time.
    static Result<Formula> make(std::string_view text, std::string_view path,
                                std::span<const NamedValue> parameters = {});

    [[nodiscard]] double value(double t) const noexcept;
    /// Of order up to that of `t`; the side matters at a kink of abs and at a zero below a root.
    [[nodiscard]] Jet jet(const Jet& t, Side side = Side::right) const noexcept;
    /// The number, where the formula does not depend on t.
    [[nodiscard]] std::optional<double> constant() const noexcept;

    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] std::span<const formula::Instruction> program() const noexcept {
        return program_;
    }

private:
    std::string text_;
    std::vector<formula::Instruction> program_;
    bool shallow_ = true;  // few numbers on the stack at once
};

/// Refuses parameters that no formula can name: SYNTAX for what is no identifier, OUT_OF_RANGE for
/// t, pi, e and the functions, NOT_FINITE for a value, TOO_LARGE for more than 1000 of them; at
/// `parent.name`.
[[nodiscard]] std::optional<Error> checkFormulaParameters(std::span<const NamedValue> parameters,
                                                          std::string_view parent);

}  // namespace knotwork
