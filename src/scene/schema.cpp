// References: JSON Schema, draft 2020-12 (json-schema.org).
#include "scene/schema.hpp"

#include "geometry/mesh.hpp"
#include "scene/fields.hpp"

#include <cmath>

namespace knotwork::scene {

namespace {

Json objectSchema(std::span<const Field> fields);

Json reference(std::string_view name) { return {{"$ref", "#/$defs/" + std::string(name)}}; }

Json listOf(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json pairOf(Json item) {
    Json pair = listOf(std::move(item));
    pair["minItems"] = 2;
    pair["maxItems"] = 2;
    return pair;
}

/// As many as the field allows, where it says.
Json someOf(Json item, const Field& field) {
    Json list = listOf(std::move(item));
    if (std::isfinite(field.min)) list["minItems"] = field.min;
    if (std::isfinite(field.max)) list["maxItems"] = field.max;
    return list;
}

Json tuple(std::size_t least, std::size_t most) {
    return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", least},
            {"maxItems", most}};
}

Json names(std::span<const Choice> choices) {
    Json values = Json::array();
    for (const Choice& choice : choices) values.push_back(choice.value);
    return {{"enum", std::move(values)}};
}

Json numberSchema(const Field& field) {
    Json schema{{"type", field.kind == FieldKind::integer ? "integer" : "number"}};
    if (std::isfinite(field.min)) schema[field.minOpen ? "exclusiveMinimum" : "minimum"] = field.min;
    if (std::isfinite(field.max)) schema[field.maxOpen ? "exclusiveMaximum" : "maximum"] = field.max;
    return schema;
}

Json kindSchema(const Field& field) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::integer: return numberSchema(field);
        case FieldKind::flag: return {{"type", "boolean"}};
        case FieldKind::choice: return names(field.choices);
        case FieldKind::text: return {{"type", "string"}};
        case FieldKind::colour: return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
        case FieldKind::point: return tuple(2, 3);
        case FieldKind::points: return {{"anyOf", {listOf(tuple(2, 3)), listOf({{"type", "number"}})}}};
        case FieldKind::numbers: return listOf({{"type", "number"}});
        case FieldKind::poses: return listOf(reference("pose"));
        case FieldKind::bFunction: return reference("bFunction");
        case FieldKind::bFunctions: return pairOf(reference("bFunction"));
        case FieldKind::blends:
            return {{"anyOf", {reference("bFunction"), pairOf(reference("bFunction"))}}};
        case FieldKind::curve: return reference("curve");
        case FieldKind::locals:
            return {{"anyOf", {objectSchema(localsFields()), listOf(reference("curve"))}}};
        case FieldKind::curveName: return names(parametricCurveChoices());
        case FieldKind::parameters: return {{"type", "object"}};
        case FieldKind::namedNumbers:
            return {{"type", "object"}, {"additionalProperties", {{"type", "number"}}}};
        case FieldKind::scale: return {{"anyOf", {Json{{"type", "number"}}, tuple(2, 3)}}};
        case FieldKind::interval: return tuple(2, 2);
        case FieldKind::panes:
            return listOf({{"enum", {"curve", "basis", "knots", "bFunction", "hodograph",
                                     "curvature"}}});
        case FieldKind::group: return objectSchema(field.fields.all());
        case FieldKind::pair: return pairOf(kindSchema(field.fields.all().front()));
        case FieldKind::list: return someOf(kindSchema(field.fields.all().front()), field);
        case FieldKind::surface: return reference("surface");
        case FieldKind::surfaceName: return names(parametricSurfaceChoices());
        case FieldKind::surfaceParameters: return {{"type", "object"}};
        case FieldKind::local: {
            const Json index{{"type", "integer"}, {"minimum", 0}};
            return {{"anyOf", {index, pairOf(index)}}};
        }
        case FieldKind::mesh: return reference("mesh");
    }
    return Json::object();
}

Json fieldSchema(const Field& field) {
    Json schema{{"title", field.label}};
    if (!field.help.empty()) schema["description"] = field.help;
    const Json kind = kindSchema(field);
    for (const auto& item : kind.items()) schema[item.key()] = item.value();
    if (field.defaultNumber) schema["default"] = *field.defaultNumber;
    if (!field.defaultJson.empty()) {
        if (auto value = parseJson(field.defaultJson)) schema["default"] = std::move(*value);
    }
    return schema;
}

void addFields(Json& schema, std::span<const Field> fields) {
    for (const Field& field : fields) {
        schema["properties"][std::string(field.name)] = fieldSchema(field);
        if (field.required) schema["required"].push_back(field.name);
    }
}

Json emptyObject() {
    return {{"type", "object"}, {"properties", Json::object()}, {"required", Json::array()},
            {"additionalProperties", false}};
}

Json objectSchema(std::span<const Field> fields) {
    Json schema = emptyObject();
    addFields(schema, fields);
    return schema;
}

/// An object that says by `key` which of several it is.
Json variantSchema(std::string_view key, std::string_view value, std::string_view label,
                   std::span<const Field> fields) {
    Json schema = emptyObject();
    schema["title"] = label;
    schema["properties"][std::string(key)] = Json{{"const", value}};
    schema["required"].push_back(key);
    addFields(schema, fields);
    return schema;
}

Json bFunctionSchema() {
    Json variants = Json::array();
    for (const Choice& family : bFunctionChoices()) {
        const auto fields = bFunctionFields(family.value);
        variants.push_back(variantSchema("family", family.value, family.label, *fields));
    }
    return {{"oneOf", std::move(variants)}};
}

/// Which parameters there are depends on the name of the parametric curve or surface.
template <class FieldsOf>
Json parametersByName(std::span<const Choice> names, FieldsOf fieldsOf) {
    Json rules = Json::array();
    for (const Choice& name : names) {
        const auto fields = fieldsOf(name.value);
        rules.push_back({{"if", {{"properties", {{"name", {{"const", name.value}}}}}}},
                         {"then", {{"properties", {{"parameters", objectSchema(*fields)}}}}}});
    }
    return rules;
}

/// Any of these types; objects of a scene have fields besides.
Json typesSchema(std::span<const ObjectType> types, std::span<const Field> extra) {
    Json variants = Json::array();
    for (const ObjectType& type : types) {
        Json schema = variantSchema("type", type.type, type.label, type.fields);
        addFields(schema, extra);
        if (type.type == "parametric-curve") {
            schema["allOf"] = parametersByName(parametricCurveChoices(), curveParameterFields);
        } else if (type.type == "parametric-surface") {
            schema["allOf"] = parametersByName(parametricSurfaceChoices(), surfaceParameterFields);
        }
        variants.push_back(std::move(schema));
    }
    return {{"oneOf", std::move(variants)}};
}

/// A mesh in each of the ways in which one is given.
Json meshSchema() {
    const auto only = [](Json properties, Json required) {
        return Json{{"type", "object"}, {"properties", std::move(properties)},
                    {"required", std::move(required)}, {"additionalProperties", false}};
    };
    const auto described = [](std::string_view title, std::string_view help, Json kind) {
        Json schema{{"title", title}, {"description", help}};
        schema.update(kind);
        return schema;
    };
    const Json text{{"type", "string"}};
    const Json numbers{{"type", "object"}, {"additionalProperties", {{"type", "number"}}}};
    const Json index{{"type", "integer"}, {"minimum", 0}};
    const Json sharpness{
        {"anyOf",
         {Json{{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", maxSharpness}},
          Json{{"const", "infinite"}}}}};
    Json edge = listOf(index);
    edge["minItems"] = edge["maxItems"] = 2;
    const Json creases = described(
        "Creases", "Edges that stay sharp for so many levels, or for ever.",
        listOf(only({{"edge", described("Edge", "The two vertices that it joins.", edge)},
                     {"sharpness", described("Sharpness", "For how many levels.", sharpness)}},
                    Json::array({"edge", "sharpness"}))));
    return {{"anyOf",
             {only({{"solid", described("Solid", "The name of a solid such as \"cube\".", text)},
                    {"parameters", described("Parameters", "The numbers of its faces.", numbers)},
                    {"creases", creases}},
                   Json::array({"solid"})),
              only({{"vertices", described("Vertices", "The points of the mesh.",
                                           listOf(tuple(2, 3)))},
                    {"faces", described("Faces", "The vertices of each, counted from 0.",
                                        listOf(listOf(index)))},
                    {"creases", creases}},
                   Json::array({"vertices", "faces"})),
              only({{"obj", described("OBJ", "The text of an OBJ file.", text)}},
                   Json::array({"obj"}))}}};
}

Json effectSchema() {
    Json variants = Json::array();
    for (const EffectType& type : effectTypes()) {
        variants.push_back(variantSchema("kind", type.kind, type.label, type.fields));
    }
    return {{"oneOf", std::move(variants)}};
}

}  // namespace

Json documentSchema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "Knotwork document"}};
    const Json document = objectSchema(headerFields());
    for (const auto& item : document.items()) schema[item.key()] = item.value();
    schema["properties"]["objects"] = listOf(reference("object"));
    schema["properties"]["effects"] = listOf(reference("effect"));
    schema["$defs"] = Json{{"object", typesSchema(objectTypes(), objectFields())},
                           {"curve", typesSchema(curveTypes(), {})},
                           {"surface", typesSchema(surfaceTypes(), {})},
                           {"mesh", meshSchema()},
                           {"bFunction", bFunctionSchema()},
                           {"pose", objectSchema(poseFields())},
                           {"effect", effectSchema()}};
    return schema;
}

}  // namespace knotwork::scene
