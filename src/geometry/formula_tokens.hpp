// The words of a formula, and what is said about the wrong ones.
#pragma once

#include "geometry/formula.hpp"

namespace knotwork::formula {

struct Token {
    enum class Kind { number, name, symbol, end };
    Kind kind = Kind::end;
    std::size_t at = 0;       ///< byte of the text
    std::string_view text{};  ///< a symbol that is none of the language's is one character
    double number = 0;

    [[nodiscard]] bool is(char symbol) const noexcept {
        return kind == Kind::symbol && text.size() == 1 && text.front() == symbol;
    }
};

/// The token that begins at or after byte `from`, blanks skipped.
[[nodiscard]] Token nextToken(std::string_view text, std::size_t from);

/// `column 3`: the place of a byte, in characters from 1.
[[nodiscard]] std::string columnOf(std::string_view text, std::size_t at);

/// `the number 2.5`, `"sin"`, `the end of the formula`, `the character U+0007`.
[[nodiscard]] std::string describe(const Token& token);

/// SYNTAX: what was found where `expected` should stand, with a hint where it is a usual mistake.
[[nodiscard]] Error unexpected(std::string_view text, std::string_view path, const Token& found,
                               std::string_view expected);

}  // namespace knotwork::formula
