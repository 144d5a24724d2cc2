#include "geometry/formula_tokens.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace knotwork::formula {

namespace {

constexpr std::size_t longestQuote = 40;

// Not those of <cctype>: they depend on the locale.
bool isDigit(char c) noexcept { return '0' <= c && c <= '9'; }
bool isLetter(char c) noexcept {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}
bool isBlank(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool continuesCharacter(char c) noexcept { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

template <class Predicate>
std::size_t skip(std::string_view text, std::size_t at, Predicate belongs) {
    while (at < text.size() && belongs(text[at])) ++at;
    return at;
}

char charAt(std::string_view text, std::size_t at) noexcept {
    return at < text.size() ? text[at] : '\0';
}

/// Past the number at `at`; `at` itself where there is none. An e without digits is no exponent.
std::size_t endOfNumber(std::string_view text, std::size_t at) {
    std::size_t end = skip(text, at, isDigit);
    const bool whole = end > at;
    if (charAt(text, end) == '.' && (whole || isDigit(charAt(text, end + 1)))) {
        end = skip(text, end + 1, isDigit);
    }
    if (end == at) return at;
    if (charAt(text, end) == 'e' || charAt(text, end) == 'E') {
        const char sign = charAt(text, end + 1);
        const std::size_t digits = end + (sign == '+' || sign == '-' ? 2 : 1);
        if (isDigit(charAt(text, digits))) return skip(text, digits, isDigit);
    }
    return end;
}

/// The code point of a character of one to four bytes, 0xFFFD for bytes that are none.
unsigned codePoint(std::string_view character) noexcept {
    const auto first = static_cast<unsigned char>(character.front());
    if (first < 0x80U) return first;
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC0U || character.size() != length) return 0xFFFDU;
    unsigned point = first & (0x7FU >> length);
    for (const char c : character.substr(1)) {
        point = (point << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
    }
    return point;
}

struct Hint {
    std::string_view found;
    std::string_view advice;
};
constexpr std::array hints{
    Hint{"×", "write *"},       Hint{"·", "write *"},
    Hint{"÷", "write /"},       Hint{"−", "write -"},
    Hint{"–", "write -"},       Hint{"²", "write ^2"},
    Hint{"³", "write ^3"},      Hint{"π", "write pi"},
    Hint{"√", "write sqrt(…)"}, Hint{"[", "write ("},
    Hint{"]", "write )"},       Hint{"{", "write ("},
    Hint{"}", "write )"},       Hint{"|", "write abs(…)"},
    Hint{",", "decimals have a point, and every function takes one number"},
};

std::string_view adviceFor(std::string_view text, const Token& found, std::string_view expected) {
    if (found.is('*') && found.at > 0 && text[found.at - 1] == '*') return "write ^ for a power";
    const bool operand = found.kind == Token::Kind::number || found.kind == Token::Kind::name ||
                         found.is('(');
    if (operand && expected.starts_with("one of")) return "write * for a product";
    const auto hint = std::find_if(hints.begin(), hints.end(),
                                   [&](const Hint& h) { return h.found == found.text; });
    return hint == hints.end() ? std::string_view() : hint->advice;
}

}  // namespace

Token nextToken(std::string_view text, std::size_t from) {
    const std::size_t at = skip(text, from, isBlank);
    if (at == text.size()) return {Token::Kind::end, at, {}, 0};
    if (const std::size_t end = endOfNumber(text, at); end > at) {
        const std::string_view digits = text.substr(at, end - at);
        return {Token::Kind::number, at, digits, std::strtod(std::string(digits).c_str(), nullptr)};
    }
    if (isLetter(text[at])) {
        const std::size_t end =
            skip(text, at, [](char c) { return isLetter(c) || isDigit(c); });
        return {Token::Kind::name, at, text.substr(at, end - at), 0};
    }
    std::size_t end = at + 1;
    while (end < text.size() && end < at + 4 && continuesCharacter(text[end])) ++end;
    return {Token::Kind::symbol, at, text.substr(at, end - at), 0};
}

std::string columnOf(std::string_view text, std::size_t at) {
    const auto before = text.substr(0, at);
    const auto inside = std::count_if(before.begin(), before.end(), continuesCharacter);
    return "column " + std::to_string(at - static_cast<std::size_t>(inside) + 1);
}

std::string describe(const Token& token) {
    if (token.kind == Token::Kind::end) return "the end of the formula";
    std::string quoted(token.text.substr(0, longestQuote));
    if (token.text.size() > longestQuote) quoted += "…";
    if (token.kind == Token::Kind::number) return "the number " + quoted;
    const unsigned point = codePoint(token.text);
    // Control characters, blanks and what is no text would not be seen between quotes.
    const bool visible = point > 0x20U && point != 0x7FU && !(0x80U <= point && point <= 0xA0U) &&
                         !(0x2000U <= point && point <= 0x200FU) && point != 0xFEFFU &&
                         point != 0xFFFDU;
    if (token.kind == Token::Kind::name || visible) return "\"" + quoted + "\"";
    if (point == 0xFFFDU) return "a byte that is no text";
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), "U+%04X", point);
    return std::string("the character ") + code.data();
}

Error unexpected(std::string_view text, std::string_view path, const Token& found,
                 std::string_view expected) {
    std::string message = "There is " + describe(found) + " at " + columnOf(text, found.at) +
                          ", where " + std::string(expected) + " is expected";
    if (const auto advice = adviceFor(text, found, expected); !advice.empty()) {
        message += "; " + std::string(advice);
    }
    return refuse(Code::syntax, std::string(path), message + ".");
}

}  // namespace knotwork::formula
