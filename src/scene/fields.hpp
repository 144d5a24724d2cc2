// Field descriptions: what each type of object, curve and B-function is made of, said once.
//
// Validation, defaults, the canonical form, the schema, both panels and the documentation are made
// from these tables; a new parameter is one line here (those of B-functions and parametric curves
// stand in the geometry's own tables, which are folded in).
#pragma once

#include "scene/json.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
    blends,      ///< one B-function, or a list of two, one for each direction
    curve,       ///< nested curve specification
    locals,      ///< { count, kind } or a list of curve specifications
    curveName,   ///< name of a parametric curve
    parameters,  ///< named parameters of a parametric curve
    namedNumbers,  ///< numbers by names of the user's own (parameters of formulas)
    scale,       ///< one factor, or [sx, sy] or [sx, sy, sz]
    interval,    ///< [start, end]
    panes,       ///< list of names of panes
    group,       ///< nested fields of a fixed table
    pair,        ///< two values, each as the only one of `fields` (a direction each)
    list,        ///< values, each as the only one of `fields`; from `min` to `max` of them
    surface,     ///< nested surface specification
    surfaceName,        ///< name of a parametric surface
    surfaceParameters,  ///< named parameters of a parametric surface
    local,       ///< the index of a local curve, or [i, j] of a local patch
    mesh,        ///< { solid }, { vertices, faces } or { obj }, checked where it is made
};

[[nodiscard]] std::string_view fieldKindName(FieldKind kind) noexcept;

struct Choice {
    std::string_view value;
    std::string_view label;
};

struct Field;

/// A table of fields, as a view that Field itself can hold: a std::span of a type that is not yet
/// complete is not allowed.
class FieldTable {
public:
    constexpr FieldTable() noexcept = default;
    template <std::size_t N>
    constexpr FieldTable(const std::array<Field, N>& table) noexcept
        : first_(table.data()), count_(N) {}

    [[nodiscard]] constexpr std::span<const Field> all() const noexcept;

private:
    const Field* first_ = nullptr;
    std::size_t count_ = 0;
};

struct Field {
    std::string_view name{};
    std::string_view label{};
    FieldKind kind = FieldKind::number;
    std::string_view help{};
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool minOpen = false;          ///< whether `min` itself is excluded
    bool maxOpen = false;          ///< whether `max` itself is excluded
    bool maxIsSize = false;        ///< beyond `max` it is TOO_LARGE rather than OUT_OF_RANGE
    std::string_view defaultJson{};  ///< empty: none, and the field is left out or computed
    bool required = false;
    std::optional<double> defaultNumber{};  ///< in place of defaultJson, from the geometry's tables
    std::optional<std::pair<double, double>> slider{};  ///< the part of the range that a slider offers
    std::span<const Choice> choices{};
    FieldTable fields{};  ///< of a group, a pair or a list
};

constexpr std::span<const Field> FieldTable::all() const noexcept { return {first_, count_}; }

struct CurveType {
    std::string_view type;
    std::string_view label;
    std::span<const Field> fields;  ///< without `type`
};

/// Every type that a `curve` field, kw.curve() and a scene's objects accept.
[[nodiscard]] std::span<const CurveType> curveTypes() noexcept;
[[nodiscard]] const CurveType* findCurveType(std::string_view type) noexcept;

using SurfaceType = CurveType;

/// Every type that a `surface` field and kw.surface() accept.
[[nodiscard]] std::span<const SurfaceType> surfaceTypes() noexcept;
[[nodiscard]] const SurfaceType* findSurfaceType(std::string_view type) noexcept;

/// Every type that an object of a scene can have: curves, surfaces, and what a scene has of its own.
using ObjectType = CurveType;
[[nodiscard]] std::vector<ObjectType> objectTypes();
[[nodiscard]] const ObjectType* findObjectType(std::string_view type) noexcept;

/// `id`, `style` and `show`: what an object of a scene has besides its shape.
[[nodiscard]] std::span<const Field> objectFields() noexcept;
/// Whether an object of this type has anything that the flag of its `show` switches. The others are
/// allowed and change nothing; panels leave them out.
[[nodiscard]] bool showApplies(std::string_view type, std::string_view flag) noexcept;
/// `knotwork`, `title`, `description` and `view`.
[[nodiscard]] std::span<const Field> headerFields() noexcept;

struct EffectType {
    std::string_view kind;
    std::string_view label;
    std::span<const Field> fields;  ///< without `kind`
};
[[nodiscard]] std::span<const EffectType> effectTypes() noexcept;
[[nodiscard]] const EffectType* findEffectType(std::string_view kind) noexcept;

/// The fields of a pose of one local curve.
[[nodiscard]] std::span<const Field> poseFields() noexcept;
/// The fields of a pose of one local patch of a surface.
[[nodiscard]] std::span<const Field> patchPoseFields() noexcept;
/// `count` and `kind` of locals that are cut from a model.
[[nodiscard]] std::span<const Field> localsFields() noexcept;
/// The fields of a B-function of this family without `family`, or nothing for an unknown one.
[[nodiscard]] std::optional<std::vector<Field>> bFunctionFields(std::string_view family);
/// The parameters of a parametric curve, or nothing for an unknown name.
[[nodiscard]] std::optional<std::vector<Field>> curveParameterFields(std::string_view name);
/// The parameters of a parametric surface, or nothing for an unknown name.
[[nodiscard]] std::optional<std::vector<Field>> surfaceParameterFields(std::string_view name);
[[nodiscard]] std::vector<Choice> bFunctionChoices();
[[nodiscard]] std::vector<Choice> parametricCurveChoices();
[[nodiscard]] std::vector<Choice> parametricSurfaceChoices();

// --- panels ---------------------------------------------------------------------------------

/// One editable field of one object as a panel shows it: its value and its address.
struct PanelField {
    std::string path;   ///< relative to the object: `bFunction.alpha`, `points[2]`, `knots`
    std::string label;
    FieldKind kind = FieldKind::number;
    std::string help;
    double min = 0;
    double max = 0;
    bool minOpen = false;
    bool maxOpen = false;
    double low = 0;   ///< the part of the range that a slider offers, finite when `slider`
    double high = 0;
    bool slider = false;
    std::vector<std::pair<std::string, std::string>> choices;  ///< value, label
    std::string group;  ///< heading under which the field stands, may be empty
    Json value;
};

/// The fields of one canonical object, nested ones resolved (the parameters of its B-function's
/// family, of its model …), in the order in which a panel shows them.
[[nodiscard]] std::vector<PanelField> panelFields(const Json& object);

/// `panelFields` as JSON: [{ path, name, label, kind, group, help, value, min?, max?, minOpen?,
/// maxOpen?, low?, high?, choices? }].
[[nodiscard]] Json panelFieldsJson(const Json& object);

}  // namespace knotwork::scene
