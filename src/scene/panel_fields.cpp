// What panels show: the fields of one object with nested ones resolved.
#include "scene/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace knotwork::scene {

namespace {

constexpr std::array<std::pair<FieldKind, std::string_view>, 29> kindNames{{
    {FieldKind::number, "number"},
    {FieldKind::integer, "integer"},
    {FieldKind::flag, "flag"},
    {FieldKind::choice, "choice"},
    {FieldKind::text, "text"},
    {FieldKind::colour, "colour"},
    {FieldKind::point, "point"},
    {FieldKind::points, "points"},
    {FieldKind::numbers, "numbers"},
    {FieldKind::poses, "poses"},
    {FieldKind::bFunction, "bFunction"},
    {FieldKind::bFunctions, "bFunctions"},
    {FieldKind::blends, "blends"},
    {FieldKind::curve, "curve"},
    {FieldKind::locals, "locals"},
    {FieldKind::curveName, "choice"},
    {FieldKind::parameters, "parameters"},
    {FieldKind::namedNumbers, "namedNumbers"},
    {FieldKind::scale, "scale"},
    {FieldKind::interval, "interval"},
    {FieldKind::panes, "panes"},
    {FieldKind::group, "group"},
    {FieldKind::pair, "pair"},
    {FieldKind::list, "list"},
    {FieldKind::surface, "surface"},
    {FieldKind::surfaceName, "choice"},
    {FieldKind::surfaceParameters, "parameters"},
    {FieldKind::local, "local"},
    {FieldKind::mesh, "mesh"},
}};

/// Walks an object along its tables and collects the fields that can be edited as one value.
class Collector {
public:
    void object(const Json& spec) {
        const ObjectType* type = findObjectType(stringOr(spec, "type", ""));
        if (type != nullptr) members(spec, type->fields, "", "");
        members(spec, objectFields(), "", "");
    }

    void curve(const Json& spec, const std::string& path, const std::string& group) {
        const CurveType* type = findCurveType(stringOr(spec, "type", ""));
        if (type != nullptr) members(spec, type->fields, path, group);
    }

    void members(const Json& spec, std::span<const Field> fields, const std::string& path,
                 const std::string& group) {
        for (const Field& field : fields) {
            if (const Json* value = member(spec, field.name)) {
                one(spec, field, *value, joinPath(path, field.name), group);
            }
        }
    }

    [[nodiscard]] std::vector<PanelField> take() { return std::move(collected_); }

private:
    void one(const Json& parent, const Field& field, const Json& value, const std::string& path,
             const std::string& group) {
        const std::string inside = group.empty() ? std::string(field.label)
                                                 : group + " · " + std::string(field.label);
        switch (field.kind) {
            case FieldKind::group: members(value, field.fields.all(), path, inside); break;
            case FieldKind::curve: curve(value, path, inside); break;
            case FieldKind::surface: surface(value, path, inside); break;
            case FieldKind::blends: blends(value, path, inside); break;
            case FieldKind::pair: pair(parent, field, value, path, group); break;
            case FieldKind::list: list(parent, field, value, path, group); break;
            case FieldKind::bFunction: bFunction(value, path, inside); break;
            case FieldKind::bFunctions: blends(value, path, inside); break;
            case FieldKind::parameters: parameters(parent, value, path, group); break;
            case FieldKind::namedNumbers: namedNumbers(value, path, inside); break;
            case FieldKind::locals: locals(value, path, inside); break;
            case FieldKind::curveName: leaf(field, value, path, group, parametricCurveChoices()); break;
            case FieldKind::surfaceParameters: surfaceParameters(parent, value, path, group); break;
            case FieldKind::surfaceName:
                leaf(field, value, path, group, parametricSurfaceChoices());
                break;
            default: leaf(field, value, path, group, field.choices); break;
        }
    }

    void bFunction(const Json& spec, const std::string& path, const std::string& group) {
        constexpr Field family{.name = "family", .label = "Family", .kind = FieldKind::choice,
                               .help = "The formula of the B-function."};
        const std::string name = stringOr(spec, "family", "");
        leaf(family, name, joinPath(path, "family"), group, bFunctionChoices());
        if (const auto fields = bFunctionFields(name)) members(spec, *fields, path, group);
    }

    /// One B-function, or a list of them.
    void blends(const Json& value, const std::string& path, const std::string& group) {
        if (!value.is_array()) return bFunction(value, path, group);
        for (std::size_t i = 0; i < value.size(); ++i) {
            bFunction(value[i], indexed(path, i), group + " " + std::to_string(i + 1));
        }
    }

    void surface(const Json& spec, const std::string& path, const std::string& group) {
        const SurfaceType* type = findSurfaceType(stringOr(spec, "type", ""));
        if (type != nullptr) members(spec, type->fields, path, group);
    }

    /// One field a direction, `locals[0]` and `locals[1]`.
    void pair(const Json& parent, const Field& field, const Json& value, const std::string& path,
              const std::string& group) {
        constexpr std::array<std::string_view, 2> directions{"u", "v"};
        for (std::size_t i = 0; i < value.size() && i < directions.size(); ++i) {
            Field along = field.fields.all().front();
            const std::string label = std::string(field.label) + " " + std::string(directions[i]);
            along.label = label;
            if (along.help.empty()) along.help = field.help;
            one(parent, along, value[i], indexed(path, i), group);
        }
    }

    /// Points, rows of points or of numbers and surfaces one by one; a list of anything else is one
    /// value.
    void list(const Json& parent, const Field& field, const Json& value, const std::string& path,
              const std::string& group) {
        const Field& element = field.fields.all().front();
        constexpr std::array single{FieldKind::point, FieldKind::points, FieldKind::numbers,
                                    FieldKind::surface};
        if (std::find(single.begin(), single.end(), element.kind) == single.end()) {
            return leaf(field, value, path, group, {});
        }
        if (field.fields.all().size() > 1) return named(parent, field, value, path, group);
        for (std::size_t i = 0; i < value.size(); ++i) {
            Field row = element;
            const std::string label = std::string(field.label) + " " + std::to_string(i);
            row.label = label;
            if (row.help.empty()) row.help = field.help;
            one(parent, row, value[i], indexed(path, i), group);
        }
    }

    /// Elements that have a field each.
    void named(const Json& parent, const Field& field, const Json& value, const std::string& path,
               const std::string& group) {
        const std::span<const Field> fields = field.fields.all();
        const std::string inside = group.empty() ? std::string(field.label)
                                                 : group + " · " + std::string(field.label);
        for (std::size_t i = 0; i < std::min(value.size(), fields.size()); ++i) {
            one(parent, fields[i], value[i], indexed(path, i), inside);
        }
    }

    void surfaceParameters(const Json& parent, const Json& value, const std::string& path,
                           const std::string& group) {
        if (const auto fields = surfaceParameterFields(stringOr(parent, "name", ""))) {
            members(value, *fields, path, group);
        }
    }

    void parameters(const Json& parent, const Json& value, const std::string& path,
                    const std::string& group) {
        if (const auto fields = curveParameterFields(stringOr(parent, "name", ""))) {
            members(value, *fields, path, group);
        }
    }

    void namedNumbers(const Json& value, const std::string& path, const std::string& group) {
        for (const auto& item : value.items()) {
            const Field field{.name = item.key(), .label = item.key(), .kind = FieldKind::number,
                              .help = "A number of the formula."};
            leaf(field, item.value(), joinPath(path, item.key()), group, {});
        }
    }

    void locals(const Json& value, const std::string& path, const std::string& group) {
        if (!value.is_array()) {
            members(value, localsFields(), path, group);
            return;
        }
        for (std::size_t j = 0; j < value.size(); ++j) {
            curve(value[j], indexed(path, j), group + " " + std::to_string(j));
        }
    }

    void leaf(const Field& field, const Json& value, const std::string& path,
              const std::string& group, std::span<const Choice> choices) {
        PanelField shown;
        shown.path = path;
        shown.label = field.label;
        const bool name =
            field.kind == FieldKind::curveName || field.kind == FieldKind::surfaceName;
        shown.kind = name ? FieldKind::choice : field.kind;
        shown.help = field.help;
        shown.min = field.min;
        shown.max = field.max;
        shown.minOpen = field.minOpen;
        shown.maxOpen = field.maxOpen;
        const auto slider = field.slider.value_or(std::pair{field.min, field.max});
        shown.low = slider.first;
        shown.high = slider.second;
        shown.slider = std::isfinite(slider.first) && std::isfinite(slider.second);
        for (const Choice& choice : choices) shown.choices.emplace_back(choice.value, choice.label);
        shown.group = group;
        shown.value = value;
        collected_.push_back(std::move(shown));
    }

    std::vector<PanelField> collected_;
};

}  // namespace

std::string_view fieldKindName(FieldKind kind) noexcept {
    const auto found = std::find_if(kindNames.begin(), kindNames.end(),
                                    [&](const auto& entry) { return entry.first == kind; });
    return found->second;
}

std::vector<PanelField> panelFields(const Json& object) {
    Collector collector;
    collector.object(object);
    std::vector<PanelField> fields = collector.take();
    const std::string type = stringOr(object, "type", "");
    std::erase_if(fields, [&](const PanelField& field) {
        const bool ofSurfaces = field.path == "style.opacity" || field.path == "style.colourBy";
        if (ofSurfaces && !showApplies(type, "surface")) return true;
        if (field.path == "style.dashed" && !showApplies(type, "curve")) return true;
        constexpr std::string_view show = "show.";
        return field.path.starts_with(show) && !showApplies(type, field.path.substr(show.size()));
    });
    return fields;
}

Json panelFieldsJson(const Json& object) {
    Json list = Json::array();
    for (PanelField& field : panelFields(object)) {
        Json shown{{"path", field.path},
                   {"name", field.path.substr(field.path.rfind('.') + 1)},
                   {"label", field.label},
                   {"kind", fieldKindName(field.kind)},
                   {"group", field.group},
                   {"help", field.help}};
        if (std::isfinite(field.min)) shown["min"] = field.min;
        if (std::isfinite(field.max)) shown["max"] = field.max;
        if (field.minOpen) shown["minOpen"] = true;
        if (field.maxOpen) shown["maxOpen"] = true;
        if (field.slider) {
            shown["low"] = field.low;
            shown["high"] = field.high;
        }
        if (!field.choices.empty()) {
            Json choices = Json::array();
            for (const auto& [value, label] : field.choices) {
                choices.push_back({{"value", value}, {"label", label}});
            }
            shown["choices"] = std::move(choices);
        }
        shown["range"] = Json::array({shown.value("min", Json()), shown.value("max", Json())});
        shown["value"] = std::move(field.value);
        list.push_back(std::move(shown));
    }
    return list;
}

}  // namespace knotwork::scene
