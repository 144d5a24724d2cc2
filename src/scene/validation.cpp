#include "scene/validation.hpp"

#include "geometry/named.hpp"
#include "scene/validation_values.hpp"

#include <algorithm>
#include <optional>

namespace knotwork::scene {

namespace {

Checked checkField(const Json& given, const Field& field, const Json& parent);
Checked checkBFunction(const Json& given);
Checked checkCurve(const Json& given);
Checked checkTyped(const Json& given, std::span<const CurveType> types,
                   std::span<const Field> extra, std::string_view noun);

// --- lists ------------------------------------------------------------------------------------

template <class Check>
Checked checkList(const Json& given, std::string_view wanted, Check checkItem) {
    if (!given.is_array()) return wrongType(wanted, given);
    Checked list{Json::array()};
    for (std::size_t i = 0; i < given.size() && !list.full(); ++i) {
        Checked item = checkItem(given[i]);
        if (list.ok() && item.ok()) {
            list.canonical().push_back(std::move(item.canonical()));
        } else {
            list.add(item.problems(), '[' + std::to_string(i) + ']');
        }
    }
    return list;
}

Checked checkLocals(const Json& given) {
    if (!given.is_array()) return checkGroup(given, localsFields());
    return checkList(given, "a list of curves", checkCurve);
}

Checked checkPair(const Json& given) {
    if (given.is_array() && given.size() != 2) {
        return refuse(Code::wrongLength, "",
                      "Expected two B-functions, got " + std::to_string(given.size()) + ".");
    }
    return checkList(given, "a list of two B-functions", checkBFunction);
}

/// A list of what the field's only element describes.
Checked checkElements(const Json& given, const Field& field, const Json& parent) {
    const Field& element = field.fields.all().front();
    return checkList(given, "a list", [&](const Json& item) {
        return checkField(item, element, parent);
    });
}

/// As many as the field allows, where it says.
Checked checkSomeElements(const Json& given, const Field& field, const Json& parent) {
    const auto count = static_cast<double>(given.is_array() ? given.size() : 0);
    if (given.is_array() && (count < field.min || count > field.max)) {
        const std::string wanted =
            field.min == field.max ? formatNumber(field.min) : describeRange(field);
        return refuse(Code::wrongLength, "",
                      "Expected a list of " + wanted + ", got " + formatNumber(count) + ".");
    }
    return checkElements(given, field, parent);
}

Checked checkDirections(const Json& given, const Field& field, const Json& parent) {
    if (!given.is_array()) return wrongType("a list of two, one for each direction", given);
    if (given.size() != 2) {
        return refuse(Code::wrongLength, "",
                      "Expected two values, one for each direction, got " +
                          std::to_string(given.size()) + ".");
    }
    return checkElements(given, field, parent);
}

// --- fields -----------------------------------------------------------------------------------

constexpr Choice paneChoices[] = {{"curve", "Curve"}, {"basis", "Basis functions"},
                                  {"knots", "Knots"}, {"bFunction", "B-function"},
                                  {"hodograph", "Hodograph"},
                                  {"curvature", "Curvature"}};

/// The parameters of what the parent names; there are none where it names nothing.
Checked checkParameters(const Json& given, const std::optional<std::vector<Field>>& fields) {
    return checkGroup(given, fields ? std::span<const Field>(*fields) : std::span<const Field>());
}

/// `parent` is the group that the field stands in, for the kinds that depend on a sibling.
Checked checkField(const Json& given, const Field& field, const Json& parent) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::integer: return readNumber(given, field);
        case FieldKind::flag:
            return given.is_boolean() ? Checked(given) : wrongType("true or false", given);
        case FieldKind::choice: return readName(given, field.choices);
        case FieldKind::text: return given.is_string() ? Checked(given) : wrongType("a text", given);
        case FieldKind::colour: return readColour(given);
        case FieldKind::point: return checkTuple(given, 2, 3, "[x, y] or [x, y, z]");
        case FieldKind::points: return checkPoints(given);
        case FieldKind::numbers: return checkNumbers(given);
        case FieldKind::poses:
            return checkList(given, "a list of poses",
                             [](const Json& item) { return checkGroup(item, poseFields()); });
        case FieldKind::bFunction: return checkBFunction(given);
        case FieldKind::bFunctions: return checkPair(given);
        case FieldKind::blends: return given.is_array() ? checkPair(given) : checkBFunction(given);
        case FieldKind::curve: return checkCurve(given);
        case FieldKind::locals: return checkLocals(given);
        case FieldKind::curveName: return readName(given, parametricCurveChoices());
        case FieldKind::parameters:
            return checkParameters(given, curveParameterFields(stringOr(parent, "name", "")));
        case FieldKind::namedNumbers: return checkNamedNumbers(given);
        case FieldKind::scale: return checkScale(given);
        case FieldKind::interval: return checkTuple(given, 2, 2, "[start, end]");
        case FieldKind::panes:
            return checkList(given, "a list of names of panes",
                             [](const Json& item) { return readName(item, paneChoices); });
        case FieldKind::group: return checkGroup(given, field.fields.all());
        case FieldKind::pair: return checkDirections(given, field, parent);
        case FieldKind::list: return checkSomeElements(given, field, parent);
        case FieldKind::surface: return checkTyped(given, surfaceTypes(), {}, "surface");
        case FieldKind::surfaceName: return readName(given, parametricSurfaceChoices());
        case FieldKind::surfaceParameters:
            return checkParameters(given, surfaceParameterFields(stringOr(parent, "name", "")));
        case FieldKind::local: return checkLocalIndex(given);
        case FieldKind::mesh: return given.is_object() ? Checked(given) : wrongType("a mesh", given);
    }
    return wrongType("something else", given);
}

// --- groups -----------------------------------------------------------------------------------

std::string listFields(std::span<const Field> fields) {
    std::string names;
    for (const Field& field : fields) {
        if (!names.empty()) names += ", ";
        names += field.name;
    }
    return names;
}

Error unknownField(const std::string& key, std::span<const Field> fields,
                   std::string_view discriminator) {
    return refuse(Code::unknownField, key,
                  "There is no field \"" + key + "\" here; there are " +
                      (discriminator.empty() ? "" : std::string(discriminator) + ", ") +
                      listFields(fields) + ".");
}

/// Tells of the members that none of the fields describes.
void addUnknown(Checked& group, const Json& given, std::span<const Field> fields,
                std::string_view discriminator) {
    for (const auto& item : given.items()) {
        const std::string& key = item.key();
        const bool known = key == discriminator ||
                           std::any_of(fields.begin(), fields.end(),
                                       [&](const Field& field) { return field.name == key; });
        if (!known) group.add(unknownField(key, fields, discriminator));
        if (group.full()) return;
    }
}

std::optional<Json> defaultOf(const Field& field) {
    if (field.defaultNumber) return Json(*field.defaultNumber);
    if (field.defaultJson.empty()) return std::nullopt;
    // An object has twenty flags and more, and a document a thousand objects.
    if (field.kind == FieldKind::flag) return Json(field.defaultJson == "true");
    return *parseJson(field.defaultJson);
}

/// Appends the members of `given` that `fields` describe, and what is wrong with them.
void addMembers(Checked& group, const Json& given, std::span<const Field> fields, bool complete) {
    for (const Field& field : fields) {
        const Json* value = member(given, field.name);
        std::optional<Json> filled;
        if (value == nullptr && complete) {
            filled = defaultOf(field);
            if (filled) value = &*filled;
        }
        if (value != nullptr) {
            Checked read = checkField(*value, field, given);
            if (read.ok()) {
                group.canonical()[std::string(field.name)] = std::move(read.canonical());
            } else {
                group.add(read.problems(), field.name);
            }
        } else if (field.required) {
            group.add(refuse(Code::wrongType, std::string(field.name),
                             "The field \"" + std::string(field.name) + "\" is missing: " +
                                 std::string(field.help)));
        }
    }
}

Checked checkBFunction(const Json& given) {
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
    Checked blend{Json{{"family", *family}}};
    addUnknown(blend, given, fields, "family");
    addMembers(blend, given, fields, true);
    return blend;
}

/// An object that says by `type` which of `types` it is; `noun` is for messages.
Checked checkTyped(const Json& given, std::span<const CurveType> types,
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
    const CurveType& type = *findNamed(types, &CurveType::type, name->get_ref<const std::string&>());
    std::vector<Field> fields(type.fields.begin(), type.fields.end());
    fields.insert(fields.end(), extra.begin(), extra.end());
    Checked typed{Json{{"type", *name}}};
    addUnknown(typed, given, fields, "type");
    addMembers(typed, given, type.fields, true);
    addMembers(typed, given, extra, false);
    return typed;
}

Checked checkCurve(const Json& given) { return checkTyped(given, curveTypes(), {}, "curve"); }

}  // namespace

Checked checkGroup(const Json& given, std::span<const Field> fields) {
    if (!given.is_object()) return wrongType("an object", given);
    Checked group{Json::object()};
    addUnknown(group, given, fields, "");
    addMembers(group, given, fields, true);
    return group;
}

Checked checkObjectSpec(const Json& given) {
    return checkTyped(given, objectTypes(), objectFields(), "object");
}

Result<Json> readGroup(const Json& given, std::span<const Field> fields) {
    return checkGroup(given, fields).result();
}

Result<Json> readBFunction(const Json& given) { return checkBFunction(given).result(); }

Result<Json> readCurve(const Json& given, std::span<const Field> extra) {
    return checkTyped(given, curveTypes(), extra, "curve").result();
}

Result<Json> readSurface(const Json& given, std::span<const Field> extra) {
    return checkTyped(given, surfaceTypes(), extra, "surface").result();
}

Result<Json> readObjectSpec(const Json& given) { return checkObjectSpec(given).result(); }

}  // namespace knotwork::scene
