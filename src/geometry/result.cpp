#include "geometry/result.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace knotwork {

namespace {

constexpr std::array<std::string_view, 18> codeNames{
    "WRONG_TYPE",         "WRONG_LENGTH",  "NOT_FINITE",     "NOT_INTEGER",   "OUT_OF_RANGE",
    "TOO_LARGE",          "UNKNOWN_NAME",  "UNKNOWN_FIELD",  "KNOTS_DECREASING",
    "KNOTS_MULTIPLICITY", "KNOTS_COUNT",   "RANK_DEFICIENT", "NOT_MANIFOLD",  "NOT_SUPPORTED",
    "SYNTAX",             "VERSION",       "DISPOSED",       "OUT_OF_MEMORY",
};

static_assert(codeNames.size() == static_cast<std::size_t>(Code::outOfMemory) + 1);

}  // namespace

std::string_view codeName(Code code) noexcept {
    return codeNames[static_cast<std::size_t>(code)];
}

std::string joinPath(std::string_view parent, std::string_view child) {
    std::string joined(parent);
    if (!parent.empty() && !child.empty() && child.front() != '[') joined += '.';
    joined += child;
    return joined;
}

std::string indexed(std::string_view list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
}

Error Error::under(std::string_view parent) const {
    return {code, joinPath(parent, path), message};
}

std::string formatNumber(double value) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
    std::array<char, 32> text{};
    // The first precision that reads back as the same number; 15 digits are enough for a message.
    for (int digits = 6; digits <= 15; digits += 3) {
        std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        if (std::strtod(text.data(), nullptr) == value) break;
    }
    return text.data();
}

Error refuse(Code code, std::string path, std::string message) {
    return {code, std::move(path), std::move(message)};
}

}  // namespace knotwork
