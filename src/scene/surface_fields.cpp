// The tables of surfaces.
#include "geometry/named.hpp"
#include "geometry/parametric_surface_descriptions.hpp"
#include "scene/fields.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/rotation_fields.hpp"

#include <array>

namespace knotwork::scene {

namespace {

constexpr std::array formChoices{
    Choice{"clamped", "Clamped"}, Choice{"open", "Open"}, Choice{"closed", "Closed"}};

constexpr std::array oneDegree{Field{.name = "degree", .label = "Degree",
                                     .kind = FieldKind::integer, .help = "Degree in one direction.",
                                     .min = 1, .max = 25, .maxIsSize = true}};
constexpr std::array oneForm{
    Field{.name = "form", .label = "Form", .kind = FieldKind::choice,
          .help = "Clamped, open or closed in one direction.", .choices = formChoices}};
constexpr std::array rowOfPoints{
    Field{.name = "row", .label = "Row", .kind = FieldKind::points,
          .help = "The points for one place along u."}};
constexpr std::array rowOfNumbers{
    Field{.name = "row", .label = "Row", .kind = FieldKind::numbers,
          .help = "The weights for one place along u."}};
constexpr std::array oneKnots{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "The knots of one direction, as of a curve."}};

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

constexpr std::array blendFormChoices{Choice{"open", "Open"}, Choice{"closed", "Closed"}};
constexpr std::array patchKindChoices{Choice{"sub-surface", "Sub-surface"},
                                      Choice{"plane", "Tangent plane"},
                                      Choice{"bezier", "Bézier patch"}};

constexpr std::array oneCount{Field{.name = "count", .label = "Number",
                                    .kind = FieldKind::integer,
                                    .help = "How many in one direction.", .min = 2,
                                    .max = 10'000, .maxIsSize = true}};
constexpr std::array oneBlendForm{Field{.name = "form", .label = "Form",
                                        .kind = FieldKind::choice,
                                        .help = "Open or closed in one direction.",
                                        .choices = blendFormChoices}};
constexpr std::array onePlace{Field{.name = "index", .label = "Index",
                                    .kind = FieldKind::integer,
                                    .help = "Place in one direction, counted from 0.",
                                    .min = 0, .max = 9999}};

constexpr std::array patchPoseTable{
    Field{.name = "local", .label = "Local patch", .kind = FieldKind::pair,
          .help = "Which local patch, [i, j] counted from 0 along u and along v.",
          .required = true, .fields = onePlace},
    Field{.name = "translate", .label = "Move", .kind = FieldKind::point,
          .help = "Moves the local patch.", .defaultJson = "[0,0,0]"},
    Field{.name = "rotate", .label = "Turn", .kind = FieldKind::group,
          .help = "Turns it about its point at its knots.", .defaultJson = "{}",
          .fields = rotateFields},
    Field{.name = "scale", .label = "Scale", .kind = FieldKind::scale,
          .help = "Scales it about its point at its knots.", .defaultJson = "1"},
};
constexpr std::array onePose{Field{.name = "pose", .label = "Pose", .kind = FieldKind::group,
                                   .fields = patchPoseTable}};

constexpr std::array blendingFields{
    Field{.name = "bFunction", .label = "B-function", .kind = FieldKind::blends,
          .help = "Blends each local patch into its neighbours; or one along u and one along v.",
          .required = true},
    Field{.name = "model", .label = "Model", .kind = FieldKind::surface,
          .help = "The surface that the local patches are cut from.", .required = true},
    Field{.name = "locals", .label = "Local patches", .kind = FieldKind::pair,
          .help = "How many are cut along u and along v, at most 10000 in all.", .required = true,
          .fields = oneCount},
    Field{.name = "kind", .label = "Kind", .kind = FieldKind::choice,
          .help = "What is cut from the model.", .defaultJson = "\"sub-surface\"",
          .choices = patchKindChoices},
    Field{.name = "degree", .label = "Degrees", .kind = FieldKind::pair,
          .help = "Of Bézier patches, along u and along v; 3 and 3 if left out.",
          .fields = oneDegree},
    Field{.name = "form", .label = "Forms", .kind = FieldKind::pair,
          .help = "Open or closed, along u and along v; those of the model if left out.",
          .fields = oneBlendForm},
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::pair,
          .help = "Where the local patches are centred, along u and along v; a closed direction "
                  "has one more, the period after the first.",
          .fields = oneKnots},
    Field{.name = "poses", .label = "Poses", .kind = FieldKind::list,
          .help = "How local patches are scaled, turned and moved.", .defaultJson = "[]",
          .fields = onePose},
};

constexpr std::array oneLocal{
    Field{.name = "local", .label = "Local patch", .kind = FieldKind::surface,
          .help = "The surface that alone counts in one corner."}};

constexpr std::array triangleFields{
    Field{.name = "locals", .label = "Local patches", .kind = FieldKind::list,
          .help = "Three surfaces. Those of the corners (0, 0), (1, 0) and (0, 1) of the triangle, "
                  "which is half of the rectangle that each is defined over.",
          .min = 3, .max = 3, .required = true, .fields = oneLocal},
    Field{.name = "order", .label = "Order", .kind = FieldKind::integer,
          .help = "Up to which order each patch alone counts in its corner; 1 if left out.",
          .min = 1, .max = 2},
    Field{.name = "bFunction", .label = "B-function", .kind = FieldKind::bFunction,
          .help = "Weights B/sum in place of the polynomial ones of an order."},
};

constexpr std::array types{
    SurfaceType{"bspline-surface", "B-spline surface", bsplineFields},
    SurfaceType{"parametric-surface", "Parametric surface", parametricFields},
    SurfaceType{"blending-surface", "Blending surface", blendingFields},
    SurfaceType{"blending-triangle", "Blending triangle", triangleFields},
};

}  // namespace

std::span<const SurfaceType> surfaceTypes() noexcept { return types; }

const SurfaceType* findSurfaceType(std::string_view type) noexcept {
    return findNamed(types, &SurfaceType::type, type);
}

std::span<const Field> patchPoseFields() noexcept { return patchPoseTable; }

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
