// The tables of what a scene has besides curves and surfaces, and of what all its objects have.
#include "geometry/mesh_subdivision.hpp"
#include "geometry/named.hpp"
#include "scene/fields.hpp"
#include "scene/fit_fields.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace knotwork::scene {

namespace {

constexpr std::array schemeChoices{Choice{meshSchemeNames[0], "Catmull–Clark"},
                                   Choice{meshSchemeNames[1], "Doo–Sabin"},
                                   Choice{meshSchemeNames[2], "Loop"},
                                   Choice{meshSchemeNames[3], "Butterfly"},
                                   Choice{meshSchemeNames[4], "√3"}};

constexpr std::array elementChoices{Choice{"vertex", "Vertex"}, Choice{"edge", "Edge"},
                                    Choice{"face", "Face"}, Choice{"corner", "Corner"}};

constexpr std::array stencilFields{
    Field{.name = "of", .label = "Of", .kind = FieldKind::choice,
          .help = "What the new point is made for; corners of faces are those of Doo–Sabin.",
          .defaultJson = "\"vertex\"", .choices = elementChoices},
    Field{.name = "index", .label = "Which", .kind = FieldKind::integer,
          .help = "Its number, from 0; the last one beyond the end.", .min = 0, .max = 1e9,
          .defaultJson = "0"},
};

constexpr std::array subdivisionFields{
    Field{.name = "scheme", .label = "Scheme", .kind = FieldKind::choice,
          .help = "How a level makes a finer mesh of the one before.",
          .defaultJson = "\"catmull-clark\"", .choices = schemeChoices},
    Field{.name = "levels", .label = "Levels", .kind = FieldKind::integer,
          .help = "How often it is subdivided.", .min = 0, .max = 20, .maxIsSize = true,
          .defaultJson = "2", .slider = std::pair{0.0, 6.0}},
    Field{.name = "mesh", .label = "Mesh", .kind = FieldKind::mesh,
          .help = "The control mesh: a solid by its name, or vertices and faces.",
          .required = true},
    Field{.name = "stencil", .label = "Stencil", .kind = FieldKind::group,
          .help = "A point of the next level that is shown with the weights of what it is made from.",
          .fields = stencilFields},
};

constexpr std::array fitFields{fitDegreeField, fitCountField,     fitFormField,
                               fitParametersField, fitEndsField, fitSmoothingField};

constexpr std::array cloudFields{
    Field{.name = "points", .label = "Points", .kind = FieldKind::points, .help = "The data.",
          .required = true},
    Field{.name = "fit", .label = "Fit", .kind = FieldKind::group,
          .help = "The B-spline curve that comes closest to the points, if one is wanted.",
          .fields = fitFields},
};

constexpr std::array graphFields{
    Field{.name = "bFunction", .label = "B-function", .kind = FieldKind::bFunction,
          .help = "What is proposed; a formula may break any of the axioms.", .required = true},
    Field{.name = "at", .label = "At", .kind = FieldKind::point,
          .help = "The lower left corner of its picture.", .defaultJson = "[0,0]"},
    Field{.name = "size", .label = "Size", .kind = FieldKind::number,
          .help = "The side of its picture.", .min = 1e-6, .max = 1e9, .defaultJson = "1"},
};

constexpr std::array ownTypes{
    ObjectType{"subdivision-surface", "Subdivision surface", subdivisionFields},
    ObjectType{"point-cloud", "Point cloud", cloudFields},
    ObjectType{"b-function", "B-function", graphFields},
};

constexpr Field flag(std::string_view name, std::string_view label, std::string_view help,
                     std::string_view normally) {
    return {.name = name, .label = label, .kind = FieldKind::flag, .help = help,
            .defaultJson = normally};
}

constexpr std::array colouringChoices{Choice{"colour", "Its colour"},
                                      Choice{"gaussian", "Gaussian curvature"},
                                      Choice{"mean", "Mean curvature"}};

constexpr std::array styleFields{
    Field{.name = "colour", .label = "Colour", .kind = FieldKind::colour,
          .help = "Colour of the curve or surface.", .defaultJson = "\"#2b6cb0\""},
    Field{.name = "width", .label = "Width", .kind = FieldKind::number,
          .help = "Width of the curve in CSS pixels.", .min = 0.5, .max = 12,
          .defaultJson = "2.5"},
    Field{.name = "opacity", .label = "Opacity", .kind = FieldKind::number,
          .help = "Of the curve or surface: 1 hides what is behind it.", .min = 0, .max = 1,
          .defaultJson = "1"},
    Field{.name = "colourBy", .label = "Coloured by", .kind = FieldKind::choice,
          .help = "What the colours of a surface show.", .defaultJson = "\"colour\"",
          .choices = colouringChoices},
    Field{.name = "dashed", .label = "Dashed", .kind = FieldKind::flag,
          .help = "The curve in dashes, and so its B-function.", .defaultJson = "false"},
};

constexpr std::array showFields{
    flag("curve", "Curve", "The curve itself.", "true"),
    flag("surface", "Surface", "The surface itself.", "true"),
    flag("isolines", "Isolines", "Lines of constant parameter on the surface.", "true"),
    flag("wireframe", "Wireframe", "The edges of the mesh.", "false"),
    flag("polygon", "Polygon", "The control polygon, net or mesh.", "true"),
    flag("points", "Points", "The control points.", "true"),
    flag("knots", "Knots", "Knots on the curve.", "true"),
    flag("locals", "Local curves", "The local curves, dashed where they fade.", "false"),
    flag("handles", "Handles", "Handles that move the local curves and patches.", "true"),
    flag("basis", "Basis functions", "The basis functions over the knot line.", "true"),
    flag("bFunction", "B-function", "The B-function with its derivatives.", "true"),
    flag("comb", "Curvature comb", "The curvature, drawn across the curve.", "false"),
    flag("hodograph", "Hodograph", "The first derivative as a curve.", "false"),
    flag("curvature", "Curvature", "The curvature over the parameter.", "false"),
    flag("osculating", "Osculating circle", "The circle that touches best at the parameter.",
         "false"),
    flag("hull", "Convex hull", "The convex hull of the control points.", "false"),
    flag("frames", "Frames", "Tangent, normal and binormal along the curve.", "false"),
    flag("sphere", "Enclosing sphere", "The smallest circle or sphere around it.", "false"),
    flag("crossings", "Line", "A line that counts how often it crosses the curve and its polygon.",
         "false"),
    flag("residuals", "Residuals", "From each datum to its point on the fitted curve.", "true"),
    flag("labels", "Labels", "Names of points and knots.", "false"),
};

constexpr std::array algorithmChoices{Choice{"de-boor", "De Boor"},
                                      Choice{"cox-de-boor", "Cox–de Boor"},
                                      Choice{"factor-matrices", "Factor matrices"},
                                      Choice{"boehm", "Boehm"},
                                      Choice{"oslo", "Oslo"},
                                      Choice{"lane-riesenfeld", "Lane–Riesenfeld"},
                                      Choice{"four-point", "Four-point"},
                                      Choice{"blend", "Blend"},
                                      Choice{"catmull-clark", "Catmull–Clark"}};

constexpr std::array traceFields{
    Field{.name = "algorithm", .label = "Algorithm", .kind = FieldKind::choice,
          .help = "What is shown step by step; it must work on objects of this type.",
          .required = true, .choices = algorithmChoices},
    Field{.name = "t", .label = "Parameter", .kind = FieldKind::number,
          .help = "Where a curve is evaluated; the object's parameter if it is left out."},
    Field{.name = "u", .label = "u", .kind = FieldKind::number,
          .help = "Where a surface is evaluated; the middle if it is left out."},
    Field{.name = "v", .label = "v", .kind = FieldKind::number,
          .help = "Where a surface is evaluated; the middle if it is left out."},
    Field{.name = "knot", .label = "Knot", .kind = FieldKind::number,
          .help = "The knot that is put in; the object's parameter if it is left out."},
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "All knots of the refined curve; every span is halved if they are left out."},
    Field{.name = "levels", .label = "Levels", .kind = FieldKind::integer,
          .help = "How often it is refined; the object's levels if it is left out.", .min = 0,
          .max = 20, .maxIsSize = true},
    Field{.name = "frame", .label = "Step", .kind = FieldKind::integer,
          .help = "The step that is shown, from 0; the last one beyond the end.", .min = 0,
          .max = 1e6, .defaultJson = "0"},
};

constexpr std::array lineParts{
    Field{.name = "point", .label = "Point", .kind = FieldKind::point,
          .help = "A point of the line whose crossings are counted."},
    Field{.name = "direction", .label = "Direction", .kind = FieldKind::point,
          .help = "The direction of that line."},
};

constexpr std::array objectTable{
    Field{.name = "id", .label = "Name", .kind = FieldKind::text,
          .help = "The name by which effects and commands call the object."},
    Field{.name = "style", .label = "Style", .kind = FieldKind::group, .help = "How it looks.",
          .defaultJson = "{}", .fields = styleFields},
    Field{.name = "show", .label = "Show", .kind = FieldKind::group, .help = "What is drawn.",
          .defaultJson = "{}", .fields = showFields},
    Field{.name = "t", .label = "Parameter", .kind = FieldKind::number,
          .help = "Where the curve is measured; the middle of its domain if it is left out."},
    Field{.name = "trace", .label = "Trace", .kind = FieldKind::group,
          .help = "A step of an algorithm that is shown on the object.", .fields = traceFields},
    Field{.name = "line", .label = "Line", .kind = FieldKind::list,
          .help = "A point of the line whose crossings are counted, and its direction.", .min = 2,
          .max = 2, .fields = lineParts},
};

constexpr std::string_view everyCurve = "curve comb hodograph curvature osculating frames sphere";
constexpr std::string_view everySurface = "surface isolines wireframe sphere";

/// The flags that an object of this type has besides those of its kind.
constexpr std::string_view ownFlags(std::string_view type) noexcept {
    if (type == "bspline-curve") return "polygon points knots basis hull crossings labels";
    if (type == "bezier-curve") return "polygon points hull crossings labels";
    if (type == "subdivision-curve") return "polygon points crossings labels";
    if (type == "blending-curve") return "knots locals handles basis bFunction labels";
    if (type == "bspline-surface") return "polygon points labels";
    if (type == "blending-surface") return "locals handles bFunction labels";
    if (type == "subdivision-surface") return "surface wireframe polygon points sphere labels";
    if (type == "b-function") return "curve labels";
    if (type == "point-cloud") return "curve polygon points knots basis residuals hull sphere labels";
    return "";
}

/// Whether `word` is among the words of a list.
constexpr bool among(std::string_view list, std::string_view word) noexcept {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (list.substr(0, end) == word) return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

}  // namespace

bool showApplies(std::string_view type, std::string_view flag) noexcept {
    if (among(ownFlags(type), flag)) return true;
    if (findCurveType(type) != nullptr) return among(everyCurve, flag);
    return findSurfaceType(type) != nullptr && among(everySurface, flag);
}

std::span<const Field> objectFields() noexcept { return objectTable; }

std::vector<ObjectType> objectTypes() {
    std::vector<ObjectType> types(curveTypes().begin(), curveTypes().end());
    types.insert(types.end(), surfaceTypes().begin(), surfaceTypes().end());
    types.insert(types.end(), ownTypes.begin(), ownTypes.end());
    return types;
}

const ObjectType* findObjectType(std::string_view type) noexcept {
    if (const ObjectType* curve = findCurveType(type)) return curve;
    if (const ObjectType* surface = findSurfaceType(type)) return surface;
    return findNamed(ownTypes, &ObjectType::type, type);
}

}  // namespace knotwork::scene
