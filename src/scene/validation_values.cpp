#include "scene/validation_values.hpp"

#include "scene/colour.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knotwork::scene {

Error wrongType(std::string_view wanted, const Json& given) {
    return refuse(Code::wrongType, "",
                  "Expected " + std::string(wanted) + ", got " + describeValue(given) + ".");
}

std::string listNames(std::span<const Choice> choices) {
    std::string names;
    for (const Choice& choice : choices) {
        if (!names.empty()) names += ", ";
        names += choice.value;
    }
    return names;
}

Result<Json> readName(const Json& given, std::span<const Choice> choices) {
    if (!given.is_string()) return wrongType("one of " + listNames(choices), given);
    const auto& name = given.get_ref<const std::string&>();
    const bool known = std::any_of(choices.begin(), choices.end(),
                                   [&](const Choice& choice) { return choice.value == name; });
    if (known) return given;
    return refuse(Code::unknownName, "",
                  "\"" + name + "\" is not known here; choose one of " + listNames(choices) + ".");
}

std::string describeRange(const Field& field) {
    if (std::isinf(field.max)) {
        return (field.minOpen ? "greater than " : "at least ") + formatNumber(field.min);
    }
    if (std::isinf(field.min)) return "at most " + formatNumber(field.max);
    return std::string("in ") + (field.minOpen ? "(" : "[") + formatNumber(field.min) + ", " +
           formatNumber(field.max) + (field.maxOpen ? ")" : "]");
}

namespace {

std::string elementPath(std::size_t i) { return '[' + std::to_string(i) + ']'; }

/// What is wrong with a number, if anything is.
std::optional<Error> amissWithNumber(const Json& given) {
    if (!given.is_number()) return wrongType("a number", given);
    const double value = given.get<double>();
    if (std::isfinite(value)) return std::nullopt;
    return refuse(Code::notFinite, "", "Expected a finite number, got " + formatNumber(value) + ".");
}

/// What is wrong with the numbers of a list; none of a list that is in order is copied.
std::vector<Error> amissWithNumbers(const Json& list) {
    std::vector<Error> problems;
    for (std::size_t i = 0; i < list.size() && problems.size() < maximumProblems; ++i) {
        if (const auto amiss = amissWithNumber(list[i])) {
            problems.push_back(amiss->under(elementPath(i)));
        }
    }
    return problems;
}

std::vector<Error> amissWithTuple(const Json& given, std::size_t least, std::size_t most,
                                  std::string_view wanted) {
    if (!given.is_array()) return {wrongType(wanted, given)};
    if (given.size() >= least && given.size() <= most) return amissWithNumbers(given);
    return {refuse(Code::wrongLength, "",
                   "Expected " + std::string(wanted) + ", got a list of " +
                       std::to_string(given.size()) + ".")};
}

std::vector<Error> amissWithPoint(const Json& given) {
    return amissWithTuple(given, 2, 3, "[x, y] or [x, y, z]");
}

/// `given`, or what is wrong with it.
Checked unless(std::vector<Error> problems, const Json& given) {
    if (problems.empty()) return Json(given);
    Checked checked{Json()};
    checked.add(problems, "");
    return checked;
}

Checked checkFlatPoints(const Json& given) {
    if (given.size() % 3 != 0) {
        return refuse(Code::wrongLength, "",
                      "A flat list of points holds x, y, z triples; " +
                          std::to_string(given.size()) + " is no multiple of 3.");
    }
    auto problems = amissWithNumbers(given);
    if (!problems.empty()) return unless(std::move(problems), given);
    Json points = Json::array();
    for (std::size_t i = 0; i < given.size(); i += 3) {
        points.push_back(Json::array({given[i], given[i + 1], given[i + 2]}));
    }
    return points;
}

}  // namespace

Result<Json> readNumber(const Json& given, const Field& field) {
    if (const auto amiss = amissWithNumber(given)) return *amiss;
    const double value = given.get<double>();
    if (field.kind == FieldKind::integer && value != std::floor(value)) {
        return refuse(Code::notInteger, "",
                      "Expected a whole number, got " + formatNumber(value) + ".");
    }
    const bool tooLow = field.minOpen ? !(value > field.min) : value < field.min;
    const bool tooHigh = field.maxOpen ? !(value < field.max) : value > field.max;
    if (tooLow || tooHigh) {
        return refuse(tooHigh && field.maxIsSize ? Code::tooLarge : Code::outOfRange, "",
                      formatNumber(value) + " is out of range; it must be " +
                          describeRange(field) + ".");
    }
    return Json(value);
}

Checked checkNumbers(const Json& given) {
    if (!given.is_array()) return wrongType("a list of numbers", given);
    return unless(amissWithNumbers(given), given);
}

Checked checkTuple(const Json& given, std::size_t least, std::size_t most,
                   std::string_view wanted) {
    return unless(amissWithTuple(given, least, most, wanted), given);
}

Result<Json> readPoint(const Json& given) {
    const auto problems = amissWithPoint(given);
    if (problems.empty()) return given;
    return problems.front();
}

Checked checkPoints(const Json& given) {
    if (!given.is_array()) return wrongType("a list of points", given);
    if (!given.empty() && given.front().is_number()) return checkFlatPoints(given);
    Checked checked{Json()};
    for (std::size_t i = 0; i < given.size() && !checked.full(); ++i) {
        const auto problems = amissWithPoint(given[i]);
        if (!problems.empty()) checked.add(problems, elementPath(i));
    }
    if (checked.ok()) checked.canonical() = given;
    return checked;
}

Result<Json> readColour(const Json& given) {
    if (!given.is_string()) return wrongType("a colour as #rrggbb", given);
    const auto colour = parseColour(given.get_ref<const std::string&>());
    if (!colour) return colour.error();
    return Json(formatColour(*colour));
}

Checked checkScale(const Json& given) {
    if (!given.is_number()) return checkTuple(given, 2, 3, "a factor, [sx, sy] or [sx, sy, sz]");
    if (const auto amiss = amissWithNumber(given)) return *amiss;
    return Json(given);
}

Checked checkNamedNumbers(const Json& given) {
    if (!given.is_object()) return wrongType("an object of numbers by name", given);
    Checked checked{Json(given)};
    for (const auto& item : given.items()) {
        if (const auto amiss = amissWithNumber(item.value())) {
            checked.add(amiss->under(item.key()));
        }
    }
    return checked;
}

Checked checkLocalIndex(const Json& given) {
    constexpr Field index{.kind = FieldKind::integer, .min = 0, .max = 9999};
    if (!given.is_array()) return readNumber(given, index);
    Checked checked = checkTuple(given, 2, 2, "the index of a local curve, or [i, j] of a patch");
    for (std::size_t i = 0; i < given.size() && checked.ok(); ++i) {
        if (const auto read = readNumber(given[i], index); !read) {
            checked.add(read.error().under(elementPath(i)));
        }
    }
    return checked;
}

std::string describeValue(const Json& value) {
    if (value.is_null()) return "null";
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    if (value.is_number()) return "the number " + formatNumber(value.get<double>());
    if (value.is_array()) return "a list";
    if (value.is_object()) return "an object";
    constexpr std::size_t longest = 40;
    const auto& text = value.get_ref<const std::string&>();
    return "the string \"" + (text.size() > longest ? text.substr(0, longest) + "…" : text) + "\"";
}

}  // namespace knotwork::scene
