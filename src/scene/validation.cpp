#include "scene/validation.hpp"

#include "scene/colour.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

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

Result<double> readFinite(const Json& given) {
    if (!given.is_number()) return wrongType("a number", given);
    const double value = given.get<double>();
    if (std::isfinite(value)) return value;
    return refuse(Code::notFinite, "", "Expected a finite number, got " + formatNumber(value) + ".");
}

Result<Json> readNumber(const Json& given, const Field& field) {
    const auto value = readFinite(given);
    if (!value) return value.error();
    if (field.kind == FieldKind::integer && *value != std::floor(*value)) {
        return refuse(Code::notInteger, "",
                      "Expected a whole number, got " + formatNumber(*value) + ".");
    }
    const bool tooLow = field.minOpen ? !(*value > field.min) : *value < field.min;
    const bool tooHigh = field.maxOpen ? !(*value < field.max) : *value > field.max;
    if (tooLow || tooHigh) {
        return refuse(tooHigh && field.maxIsSize ? Code::tooLarge : Code::outOfRange, "",
                      formatNumber(*value) + " is out of range; it must be " +
                          describeRange(field) + ".");
    }
    return Json(*value);
}

Result<Json> readNumbers(const Json& given) {
    if (!given.is_array()) return wrongType("a list of numbers", given);
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (const auto value = readFinite(given[i]); !value) {
            return value.error().under("[" + std::to_string(i) + "]");
        }
    }
    return given;
}

Result<Json> readTuple(const Json& given, std::size_t least, std::size_t most,
                       std::string_view wanted) {
    if (!given.is_array()) return wrongType(wanted, given);
    if (given.size() < least || given.size() > most) {
        return refuse(Code::wrongLength, "",
                      "Expected " + std::string(wanted) + ", got a list of " +
                          std::to_string(given.size()) + ".");
    }
    return readNumbers(given);
}

}  // namespace

Result<Json> readPoint(const Json& given) { return readTuple(given, 2, 3, "[x, y] or [x, y, z]"); }

namespace {

/// Flat triples become a list of points; a list of points stays as it is.
Result<Json> readPoints(const Json& given) {
    if (!given.is_array()) return wrongType("a list of points", given);
    const bool flat = !given.empty() && given.front().is_number();
    if (!flat) {
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (const auto point = readPoint(given[i]); !point) {
                return point.error().under("[" + std::to_string(i) + "]");
            }
        }
        return given;
    }
    if (given.size() % 3 != 0) {
        return refuse(Code::wrongLength, "",
                      "A flat list of points holds x, y, z triples; " +
                          std::to_string(given.size()) + " is no multiple of 3.");
    }
    if (const auto numbers = readNumbers(given); !numbers) return numbers.error();
    Json points = Json::array();
    for (std::size_t i = 0; i < given.size(); i += 3) {
        points.push_back(Json::array({given[i], given[i + 1], given[i + 2]}));
    }
    return points;
}

Result<Json> readColour(const Json& given) {
    if (!given.is_string()) return wrongType("a colour as #rrggbb", given);
    const auto colour = parseColour(given.get_ref<const std::string&>());
    if (!colour) return colour.error();
    return Json(formatColour(*colour));
}

Result<Json> readScale(const Json& given) {
    if (given.is_number()) {
        const auto factor = readFinite(given);
        return factor ? Result<Json>(given) : factor.error();
    }
    return readTuple(given, 2, 3, "a factor, [sx, sy] or [sx, sy, sz]");
}

template <class Read>
Result<Json> readList(const Json& given, std::string_view wanted, Read readItem) {
    if (!given.is_array()) return wrongType(wanted, given);
    Json list = Json::array();
    for (std::size_t i = 0; i < given.size(); ++i) {
        auto item = readItem(given[i]);
        if (!item) return item.error().under("[" + std::to_string(i) + "]");
        list.push_back(std::move(*item));
    }
    return list;
}

Result<Json> readLocals(const Json& given) {
    if (!given.is_array()) return readGroup(given, localsFields());
    return readList(given, "a list of curves", [](const Json& item) { return readCurve(item); });
}

constexpr Choice paneChoices[] = {{"curve", "Curve"}, {"basis", "Basis functions"},
                                  {"knots", "Knots"}, {"bFunction", "B-function"}};

Result<Json> readPair(const Json& given) {
    if (given.is_array() && given.size() != 2) {
        return refuse(Code::wrongLength, "",
                      "Expected two B-functions, got " + std::to_string(given.size()) + ".");
    }
    return readList(given, "a list of two B-functions", readBFunction);
}

Result<Json> readNamedNumbers(const Json& given) {
    if (!given.is_object()) return wrongType("an object of numbers by name", given);
    for (const auto& item : given.items()) {
        if (const auto value = readFinite(item.value()); !value) {
            return value.error().under(item.key());
        }
    }
    return given;
}

/// The parameters of the parametric curve that `parent` names.
Result<Json> readParameters(const Json& given, const Json& parent) {
    const auto fields = curveParameterFields(stringOr(parent, "name", ""));
    return readGroup(given, fields ? std::span<const Field>(*fields) : std::span<const Field>());
}

/// The parameters of the parametric surface that `parent` names.
Result<Json> readSurfaceParameters(const Json& given, const Json& parent) {
    const auto fields = surfaceParameterFields(stringOr(parent, "name", ""));
    return readGroup(given, fields ? std::span<const Field>(*fields) : std::span<const Field>());
}

/// j of a local curve, [i, j] of a local patch.
Result<Json> readLocalIndex(const Json& given) {
    constexpr Field index{.kind = FieldKind::integer, .min = 0, .max = 9999};
    if (!given.is_array()) return readNumber(given, index);
    const auto pair = readTuple(given, 2, 2, "the index of a local curve, or [i, j] of a patch");
    if (!pair) return pair.error();
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (const auto read = readNumber(given[i], index); !read) {
            return read.error().under("[" + std::to_string(i) + "]");
        }
    }
    return given;
}

Result<Json> readField(const Json& given, const Field& field, const Json& parent);

/// A list of what the field's only element describes.
Result<Json> readElements(const Json& given, const Field& field, const Json& parent) {
    const Field& element = field.fields.all().front();
    return readList(given, "a list", [&](const Json& item) {
        return readField(item, element, parent);
    });
}

/// As many as the field allows, where it says.
Result<Json> readSomeElements(const Json& given, const Field& field, const Json& parent) {
    if (given.is_array()) {
        const auto count = static_cast<double>(given.size());
        if (count < field.min || count > field.max) {
            const std::string wanted =
                field.min == field.max ? formatNumber(field.min) : describeRange(field);
            return refuse(Code::wrongLength, "",
                          "Expected a list of " + wanted + ", got " + formatNumber(count) + ".");
        }
    }
    return readElements(given, field, parent);
}

Result<Json> readDirections(const Json& given, const Field& field, const Json& parent) {
    if (!given.is_array()) return wrongType("a list of two, one for each direction", given);
    if (given.size() != 2) {
        return refuse(Code::wrongLength, "",
                      "Expected two values, one for each direction, got " +
                          std::to_string(given.size()) + ".");
    }
    return readElements(given, field, parent);
}

/// `parent` is the group that the field stands in, for the one kind that depends on its sibling.
Result<Json> readField(const Json& given, const Field& field, const Json& parent) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::integer: return readNumber(given, field);
        case FieldKind::flag:
            return given.is_boolean() ? Result<Json>(given) : wrongType("true or false", given);
        case FieldKind::choice: return readName(given, field.choices);
        case FieldKind::text:
            return given.is_string() ? Result<Json>(given) : wrongType("a text", given);
        case FieldKind::colour: return readColour(given);
        case FieldKind::point: return readPoint(given);
        case FieldKind::points: return readPoints(given);
        case FieldKind::numbers: return readNumbers(given);
        case FieldKind::poses:
            return readList(given, "a list of poses",
                            [](const Json& item) { return readGroup(item, poseFields()); });
        case FieldKind::bFunction: return readBFunction(given);
        case FieldKind::bFunctions: return readPair(given);
        case FieldKind::blends: return given.is_array() ? readPair(given) : readBFunction(given);
        case FieldKind::curve: return readCurve(given);
        case FieldKind::locals: return readLocals(given);
        case FieldKind::curveName: return readName(given, parametricCurveChoices());
        case FieldKind::parameters: return readParameters(given, parent);
        case FieldKind::namedNumbers: return readNamedNumbers(given);
        case FieldKind::scale: return readScale(given);
        case FieldKind::interval: return readTuple(given, 2, 2, "[start, end]");
        case FieldKind::panes:
            return readList(given, "a list of names of panes",
                            [](const Json& item) { return readName(item, paneChoices); });
        case FieldKind::group: return readGroup(given, field.fields.all());
        case FieldKind::pair: return readDirections(given, field, parent);
        case FieldKind::list: return readSomeElements(given, field, parent);
        case FieldKind::surface: return readSurface(given);
        case FieldKind::surfaceName: return readName(given, parametricSurfaceChoices());
        case FieldKind::surfaceParameters: return readSurfaceParameters(given, parent);
        case FieldKind::local: return readLocalIndex(given);
        case FieldKind::mesh:
            return given.is_object() ? Result<Json>(given) : wrongType("a mesh", given);
    }
    return wrongType("something else", given);
}

std::string listFields(std::span<const Field> fields) {
    std::string names;
    for (const Field& field : fields) {
        if (!names.empty()) names += ", ";
        names += field.name;
    }
    return names;
}

Result<Done> refuseUnknown(const Json& given, std::span<const Field> fields,
                           std::string_view discriminator) {
    for (const auto& item : given.items()) {
        const std::string& key = item.key();
        const bool known = key == discriminator ||
                           std::any_of(fields.begin(), fields.end(),
                                       [&](const Field& field) { return field.name == key; });
        if (!known) {
            return refuse(Code::unknownField, key,
                          "There is no field \"" + key + "\" here; there are " +
                              (discriminator.empty() ? "" : std::string(discriminator) + ", ") +
                              listFields(fields) + ".");
        }
    }
    return Done{};
}

std::optional<Json> defaultOf(const Field& field) {
    if (field.defaultNumber) return Json(*field.defaultNumber);
    if (field.defaultJson.empty()) return std::nullopt;
    return *parseJson(field.defaultJson);
}

/// Appends the members of `given` that `fields` describe to `canonical`.
Result<Done> readMembers(const Json& given, std::span<const Field> fields, bool complete,
                         Json& canonical) {
    for (const Field& field : fields) {
        const Json* value = member(given, field.name);
        std::optional<Json> filled;
        if (value == nullptr && complete) {
            filled = defaultOf(field);
            if (filled) value = &*filled;
        }
        if (value == nullptr) {
            if (!field.required) continue;
            return refuse(Code::wrongType, std::string(field.name),
                          "The field \"" + std::string(field.name) + "\" is missing: " +
                              std::string(field.help));
        }
        auto read = readField(*value, field, given);
        if (!read) return read.error().under(field.name);
        canonical[std::string(field.name)] = std::move(*read);
    }
    return Done{};
}

}  // namespace

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

Result<Json> readGroup(const Json& given, std::span<const Field> fields) {
    if (!given.is_object()) return wrongType("an object", given);
    if (const auto known = refuseUnknown(given, fields, ""); !known) return known.error();
    Json canonical = Json::object();
    if (const auto read = readMembers(given, fields, true, canonical); !read) return read.error();
    return canonical;
}

Result<Json> readBFunction(const Json& given) {
    if (!given.is_object()) {
        return wrongType("a B-function such as { \"family\": \"linear\" }", given);
    }
    const std::vector<Choice> families = bFunctionChoices();
    const Json* family = member(given, "family");
    if (family == nullptr) {
        return refuse(Code::wrongType, "family",
                      "A B-function needs its family, one of " + listNames(families) + ".");
    }
    if (const auto name = readName(*family, families); !name) return name.error().under("family");
    const auto fields = *bFunctionFields(family->get_ref<const std::string&>());
    if (const auto known = refuseUnknown(given, fields, "family"); !known) return known.error();
    Json canonical{{"family", *family}};
    if (const auto read = readMembers(given, fields, true, canonical); !read) return read.error();
    return canonical;
}

namespace {

/// An object that says by `type` which of `types` it is; `noun` is for messages.
Result<Json> readTyped(const Json& given, std::span<const CurveType> types,
                       std::span<const Field> extra, std::string_view noun) {
    if (!given.is_object()) {
        return wrongType("a " + std::string(noun) + " such as { \"type\": \"" +
                             std::string(types.front().type) + "\", … }",
                         given);
    }
    std::vector<Choice> choices;
    for (const CurveType& type : types) choices.push_back({type.type, type.label});
    const Json* name = member(given, "type");
    if (name == nullptr) {
        return refuse(Code::wrongType, "type",
                      "A " + std::string(noun) + " needs its type, one of " + listNames(choices) +
                          ".");
    }
    if (const auto known = readName(*name, choices); !known) return known.error().under("type");
    const CurveType& type =
        *std::find_if(types.begin(), types.end(),
                      [&](const CurveType& t) { return t.type == name->get_ref<const std::string&>(); });
    std::vector<Field> fields(type.fields.begin(), type.fields.end());
    fields.insert(fields.end(), extra.begin(), extra.end());
    if (const auto known = refuseUnknown(given, fields, "type"); !known) return known.error();
    Json canonical{{"type", *name}};
    if (const auto read = readMembers(given, type.fields, true, canonical); !read) {
        return read.error();
    }
    if (const auto read = readMembers(given, extra, false, canonical); !read) return read.error();
    return canonical;
}

}  // namespace

Result<Json> readCurve(const Json& given, std::span<const Field> extra) {
    return readTyped(given, curveTypes(), extra, "curve");
}

Result<Json> readSurface(const Json& given, std::span<const Field> extra) {
    return readTyped(given, surfaceTypes(), extra, "surface");
}

Result<Json> readObjectSpec(const Json& given) {
    return readTyped(given, objectTypes(), objectFields(), "object");
}

}  // namespace knotwork::scene
