// The tables of surfaces.
#include "geometry/parametric_surface_descriptions.hpp"
#include "scene/fields.hpp"
#include "scene/parameter_fields.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

constexpr std::array formChoices{
    Choice{"clamped", "Clamped"}, Choice{"open", "Open"}, Choice{"closed", "Closed"}};

constexpr std::array oneDegree{Field{.name = "degree", .label = "Degree",
                                     .kind = FieldKind::integer, .min = 1, .max = 25,
                                     .maxIsSize = true}};
constexpr std::array oneForm{
    Field{.name = "form", .label = "Form", .kind = FieldKind::choice, .choices = formChoices}};
constexpr std::array rowOfPoints{
    Field{.name = "row", .label = "Row", .kind = FieldKind::points}};
constexpr std::array rowOfNumbers{
    Field{.name = "row", .label = "Row", .kind = FieldKind::numbers}};
constexpr std::array oneKnots{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers}};

constexpr std::array bsplineFields{
    Field{.name = "degree", .label = "Degrees", .kind = FieldKind::pair,
          .help = "Degree along u and degree along v.", .required = true, .fields = oneDegree},
    Field{.name = "form", .label = "Forms", .kind = FieldKind::pair,
          .help = "Clamped, open or closed, along u and along v.",
          .defaultJson = "[\"clamped\",\"clamped\"]", .fields = oneForm},
    Field{.name = "points", .label = "Control points", .kind = FieldKind::list,
          .help = "The control net, a row of points for each place along u.", .required = true,
          .fields = rowOfPoints},
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::pair,
          .help = "The knots along u and those along v, each as of a curve.", .fields = oneKnots},
    Field{.name = "weights", .label = "Weights", .kind = FieldKind::list,
          .help = "One positive number a point, in rows, makes the surface rational.",
          .fields = rowOfNumbers},
};

constexpr std::array parametricFields{
    Field{.name = "name", .label = "Surface", .kind = FieldKind::surfaceName,
          .help = "The formula of the surface.", .required = true},
    Field{.name = "parameters", .label = "Parameters", .kind = FieldKind::surfaceParameters,
          .help = "The numbers of its formula.", .defaultJson = "{}"},
};

constexpr std::array types{
    SurfaceType{"bspline-surface", "B-spline surface", bsplineFields},
    SurfaceType{"parametric-surface", "Parametric surface", parametricFields},
};

}  // namespace

std::span<const SurfaceType> surfaceTypes() noexcept { return types; }

const SurfaceType* findSurfaceType(std::string_view type) noexcept {
    const auto found = std::find_if(types.begin(), types.end(),
                                    [&](const SurfaceType& t) { return t.type == type; });
    return found == types.end() ? nullptr : &*found;
}

std::optional<std::vector<Field>> surfaceParameterFields(std::string_view name) {
    const SurfaceModelDescription* model = findSurfaceModel(name);
    if (model == nullptr) return std::nullopt;
    std::vector<Field> fields;
    for (const auto& parameter : model->parameters) fields.push_back(fieldOf(parameter));
    return fields;
}

std::vector<Choice> parametricSurfaceChoices() {
    std::vector<Choice> choices;
    for (const auto& model : surfaceModels()) choices.push_back({model.name, model.label});
    return choices;
}

}  // namespace knotwork::scene
