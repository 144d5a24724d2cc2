// The tables of documents and B-functions; those of objects stand in object_fields.cpp,
// curve_fields.cpp and surface_fields.cpp, those of effects in effect_fields.cpp.
#include "geometry/b_function.hpp"
#include "geometry/parametric_curve.hpp"
#include "scene/fields.hpp"
#include "scene/parameter_fields.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

constexpr std::array modeChoices{Choice{"2d", "2D"}, Choice{"3d", "3D"}};

constexpr std::array cameraFields{
    Field{.name = "center", .label = "Centre", .kind = FieldKind::point,
          .help = "The point in the middle of the view; without it all is fitted."},
    Field{.name = "height", .label = "Height", .kind = FieldKind::number,
          .help = "Height of the view in units of the curve.", .min = 1e-9, .max = 1e12},
    Field{.name = "azimuth", .label = "Azimuth", .kind = FieldKind::number,
          .help = "Radians that the eye of a 3D view stands round the z-axis, from the x-axis.",
          .min = -1000, .max = 1000},
    Field{.name = "elevation", .label = "Elevation", .kind = FieldKind::number,
          .help = "Radians that it stands above the plane z = 0.", .min = -1.5707963267948966,
          .max = 1.5707963267948966},
};

constexpr std::array viewFields{
    Field{.name = "mode", .label = "Mode", .kind = FieldKind::choice, .help = "Kind of view.",
          .defaultJson = "\"2d\"", .choices = modeChoices},
    Field{.name = "panes", .label = "Panes", .kind = FieldKind::panes,
          .help = "Which linked views are shown.",
          .defaultJson = "[\"curve\",\"basis\",\"knots\",\"bFunction\"]"},
    Field{.name = "camera", .label = "Camera", .kind = FieldKind::group,
          .help = "What the view looks at.", .defaultJson = "{}", .fields = cameraFields},
};

constexpr std::array headerTable{
    Field{.name = "knotwork", .label = "Version", .kind = FieldKind::integer,
          .help = "Version of the document format.", .min = 1, .required = true},
    Field{.name = "title", .label = "Title", .kind = FieldKind::text, .help = "Title of the scene.",
          .defaultJson = "\"\""},
    Field{.name = "description", .label = "Description", .kind = FieldKind::text,
          .help = "What there is to see.", .defaultJson = "\"\""},
    Field{.name = "view", .label = "View", .kind = FieldKind::group, .help = "How it is shown.",
          .defaultJson = "{}", .fields = viewFields},
};

Field fieldOf(const OperandDescription& operand) {
    return {.name = operand.name, .label = operand.label,
            .kind = operand.count == 1 ? FieldKind::bFunction : FieldKind::bFunctions,
            .help = "The B-function that this one is made of.", .required = true};
}

}  // namespace

std::optional<std::vector<Field>> bFunctionFields(std::string_view family) {
    const BFamilyDescription* description = findBFamily(family);
    if (description == nullptr) return std::nullopt;
    std::vector<Field> fields;
    for (const auto& operand : description->operands) fields.push_back(fieldOf(operand));
    for (const auto& parameter : description->parameters) fields.push_back(fieldOf(parameter));
    if (description->tabulated) {
        fields.push_back({.name = "values", .label = "Values", .kind = FieldKind::numbers,
                          .help = "B at uniform parameters, the first 0, the last 1.",
                          .required = true});
    }
    if (description->expression) {
        fields.push_back({.name = "expression", .label = "B(t)", .kind = FieldKind::text,
                          .help = "A formula in t that rises from 0 at 0 to 1 at 1.",
                          .required = true});
    }
    return fields;
}

std::optional<std::vector<Field>> curveParameterFields(std::string_view name) {
    const ParametricModelDescription* model = findParametricModel(name);
    if (model == nullptr) return std::nullopt;
    std::vector<Field> fields;
    for (const auto& parameter : model->parameters) fields.push_back(fieldOf(parameter));
    return fields;
}

std::vector<Choice> bFunctionChoices() {
    std::vector<Choice> choices;
    for (const auto& family : bFunctionFamilies()) choices.push_back({family.name, family.label});
    return choices;
}

std::vector<Choice> parametricCurveChoices() {
    std::vector<Choice> choices;
    for (const auto& model : parametricCurveModels()) choices.push_back({model.name, model.label});
    return choices;
}

std::span<const Field> headerFields() noexcept { return headerTable; }

}  // namespace knotwork::scene
