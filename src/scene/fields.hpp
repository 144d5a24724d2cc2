// Field descriptions: what each type of object, curve and B-function is made of, said once.
//
// Validation, defaults, the canonical form, the schema, both panels and the documentation are made
// from these tables; a new parameter is one line here (those of B-functions and parametric curves
// stand in the geometry's own tables, which are folded in).
#pragma once

#include "scene/json.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::scene {

enum class FieldKind {
    number,
    integer,
    flag,
    choice,
    text,
    colour,      ///< `#rrggbb`
    point,       ///< [x, y] or [x, y, z]
    points,      ///< list of points, or a flat list of triples
    numbers,     ///< list of numbers (knots, weights, tabulated values)
    poses,       ///< list of poses of local curves
    bFunction,   ///< nested B-function specification
    bFunctions,  ///< list of two (mixed)
    curve,       ///< nested curve specification
    locals,      ///< { count, kind } or a list of curve specifications
    parameters,  ///< named parameters of a parametric curve
    interval,    ///< [start, end]
    group,       ///< nested fields of a fixed table
    groups,      ///< list of nested fields
};

[[nodiscard]] std::string_view fieldKindName(FieldKind kind) noexcept;

struct Choice {
    std::string_view value;
    std::string_view label;
};

struct Field {
    std::string_view name;
    std::string_view label;
    FieldKind kind = FieldKind::number;
    std::string_view help;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool minOpen = false;          ///< whether `min` itself is excluded
    std::string_view defaultJson;  ///< empty: see `required`
    bool required = false;
    std::span<const Choice> choices;
    std::span<const Field> fields;  ///< of a group
};

/// The fields of an object, curve or effect of this type, or an empty span for an unknown type.
[[nodiscard]] std::span<const Field> fieldsOfType(std::string_view type) noexcept;
/// Names of the curve types that a `curve` field accepts.
[[nodiscard]] std::vector<std::string> curveTypes();

/// One editable field of one object as a panel shows it: its value and its address.
struct PanelField {
    std::string path;   ///< relative to the object: `bFunction.alpha`, `points[2]`, `knots`
    std::string label;
    FieldKind kind = FieldKind::number;
    std::string help;
    double min = 0;
    double max = 0;
    bool minOpen = false;
    std::vector<std::pair<std::string, std::string>> choices;  ///< value, label
    std::string group;  ///< heading under which the field stands, may be empty
    Json value;
};

/// The fields of one canonical object, nested ones resolved (the parameters of its B-function's
/// family, of its model …), in the order in which a panel shows them.
[[nodiscard]] std::vector<PanelField> panelFields(const Json& object);

/// `panelFields` as JSON: [{ path, name, label, kind, min, max, minOpen, choices, group, help, value }].
[[nodiscard]] Json panelFieldsJson(const Json& object);

}  // namespace knotwork::scene
