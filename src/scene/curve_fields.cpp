// The tables of curves, and of the local curves and poses of blending curves.
#include "geometry/curve_subdivision.hpp"
#include "geometry/knot_vector.hpp"
#include "geometry/named.hpp"
#include "scene/fields.hpp"
#include "scene/rotation_fields.hpp"

#include <array>

namespace knotwork::scene {

namespace {

constexpr std::array formChoices{
    Choice{"clamped", "Clamped"}, Choice{"open", "Open"}, Choice{"closed", "Closed"}};
constexpr std::array blendFormChoices{Choice{"open", "Open"}, Choice{"closed", "Closed"}};
constexpr std::array fitChoices{Choice{"affine", "Affine"}};
constexpr std::array spacingChoices{Choice{"parameter", "Parameter"}, Choice{"length", "Length"}};
constexpr std::array localKindChoices{
    Choice{"sub-curve", "Sub-curve"}, Choice{"line", "Line"}, Choice{"arc", "Arc"},
    Choice{"bezier", "Bézier curve"}, Choice{"bspline", "B-spline"}};

constexpr std::array bsplineFields{
    Field{.name = "degree", .label = "Degree", .kind = FieldKind::integer,
          .help = "Degree of the polynomial pieces; the order is one more.",
          .min = 1, .max = 25, .maxIsSize = true, .required = true},
    Field{.name = "form", .label = "Form", .kind = FieldKind::choice,
          .help = "Clamped ends in its end points, open does not, closed has no ends.",
          .defaultJson = "\"clamped\"", .choices = formChoices},
    Field{.name = "points", .label = "Control points", .kind = FieldKind::points,
          .help = "The control polygon.", .required = true},
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "Points + degree + 1 numbers, or points + 1 of one period where closed; they "
                  "must not decrease."},
    Field{.name = "weights", .label = "Weights", .kind = FieldKind::numbers,
          .help = "One positive number a point makes the curve rational."},
};

constexpr std::array parametricFields{
    Field{.name = "name", .label = "Curve", .kind = FieldKind::curveName,
          .help = "The formula of the curve.", .required = true},
    Field{.name = "parameters", .label = "Parameters", .kind = FieldKind::parameters,
          .help = "The numbers of its formula.", .defaultJson = "{}"},
    Field{.name = "domain", .label = "Domain", .kind = FieldKind::interval,
          .help = "Where the parameter runs, [start, end]."},
};

constexpr std::array formulaFields{
    Field{.name = "x", .label = "x(t)", .kind = FieldKind::text,
          .help = "Formula in t and the parameters.", .required = true},
    Field{.name = "y", .label = "y(t)", .kind = FieldKind::text,
          .help = "Formula in t and the parameters.", .required = true},
    Field{.name = "z", .label = "z(t)", .kind = FieldKind::text,
          .help = "Formula in t and the parameters; without it the curve is planar."},
    Field{.name = "parameters", .label = "Parameters", .kind = FieldKind::namedNumbers,
          .help = "The numbers that the formulas name.", .defaultJson = "{}"},
    Field{.name = "domain", .label = "Domain", .kind = FieldKind::interval,
          .help = "Where the parameter runs, [start, end].", .required = true},
    Field{.name = "closed", .label = "Closed", .kind = FieldKind::flag,
          .help = "The curve ends where it begins, and goes on from there.",
          .defaultJson = "false"},
};

constexpr std::array blendingFields{
    Field{.name = "bFunction", .label = "B-function", .kind = FieldKind::bFunction,
          .help = "Blends each local curve into the next.", .required = true},
    Field{.name = "model", .label = "Model", .kind = FieldKind::curve,
          .help = "The curve that the local curves are cut from."},
    Field{.name = "locals", .label = "Local curves", .kind = FieldKind::locals,
          .help = "How many to cut from the model, or the local curves themselves.",
          .required = true},
    Field{.name = "form", .label = "Form", .kind = FieldKind::choice,
          .help = "A closed curve blends its last local curve into its first.",
          .choices = blendFormChoices},
    Field{.name = "fit", .label = "Fit", .kind = FieldKind::choice,
          .help = "Maps each local curve's own domain onto the interval where it takes part.",
          .choices = fitChoices},
    Field{.name = "spacing", .label = "Spacing", .kind = FieldKind::choice,
          .help = "Puts the knots at equal steps of the model's parameter or of its length, where "
                  "they are not given.",
          .choices = spacingChoices},
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "Where each local curve is centred; a closed curve has one more, the period "
                  "after the first."},
    Field{.name = "poses", .label = "Poses", .kind = FieldKind::poses,
          .help = "How local curves are scaled, turned and moved.", .defaultJson = "[]"},
};

constexpr Field segmentDomain{.name = "domain", .label = "Domain", .kind = FieldKind::interval,
                              .help = "Where the parameter runs, [start, end].",
                              .defaultJson = "[0,1]"};

constexpr std::array bezierFields{
    Field{.name = "points", .label = "Control points", .kind = FieldKind::points,
          .help = "The control polygon; the degree is one less than their number.",
          .required = true},
    Field{.name = "weights", .label = "Weights", .kind = FieldKind::numbers,
          .help = "One positive number a point makes the curve rational."},
    segmentDomain,
};

constexpr std::array lineFields{
    Field{.name = "from", .label = "From", .kind = FieldKind::point,
          .help = "The point at the start of the domain.", .required = true},
    Field{.name = "to", .label = "To", .kind = FieldKind::point,
          .help = "The point at the end of the domain.", .required = true},
    segmentDomain,
};

constexpr std::array arcFields{
    Field{.name = "at", .label = "At", .kind = FieldKind::number,
          .help = "The parameter of the given point.", .min = -1e9, .max = 1e9, .required = true},
    Field{.name = "point", .label = "Point", .kind = FieldKind::point,
          .help = "The point at that parameter.", .required = true},
    Field{.name = "first", .label = "First derivative", .kind = FieldKind::point,
          .help = "Direction and speed there; not zero.", .required = true},
    Field{.name = "second", .label = "Second derivative", .kind = FieldKind::point,
          .help = "Gives the curvature; what lies along the first is lost.", .required = true},
    Field{.name = "domain", .label = "Domain", .kind = FieldKind::interval,
          .help = "Where the parameter runs, [start, end].", .required = true},
};

constexpr std::array schemeChoices{Choice{"lane-riesenfeld", "Lane–Riesenfeld"},
                                   Choice{"chaikin", "Chaikin"},
                                   Choice{"four-point", "Four-point"}};

constexpr std::array subdivisionFields{
    Field{.name = "scheme", .label = "Scheme", .kind = FieldKind::choice,
          .help = "How a level makes new points of the old ones.", .required = true,
          .choices = schemeChoices},
    Field{.name = "points", .label = "Points", .kind = FieldKind::points,
          .help = "The polygon that is subdivided.", .required = true},
    Field{.name = "closed", .label = "Closed", .kind = FieldKind::flag,
          .help = "Joins the last point to the first.", .defaultJson = "false"},
    Field{.name = "levels", .label = "Levels", .kind = FieldKind::integer,
          .help = "How often it is subdivided.", .min = 0, .max = maxSubdivisionLevels,
          .maxIsSize = true, .defaultJson = "4", .slider = std::pair{0.0, 8.0}},
    Field{.name = "degree", .label = "Degree", .kind = FieldKind::integer,
          .help = "Of Lane–Riesenfeld: the degree of the B-spline that is its limit.",
          .min = 1, .max = maxDegree, .maxIsSize = true},
    Field{.name = "tension", .label = "Tension", .kind = FieldKind::number,
          .help = "Of the four-point scheme: 1/16 keeps cubics, 0 the polygon.", .min = -1,
          .max = 1, .slider = std::pair{0.0, 0.1875}},
};

constexpr std::array types{
    CurveType{"bspline-curve", "B-spline curve", bsplineFields},
    CurveType{"parametric-curve", "Parametric curve", parametricFields},
    CurveType{"blending-curve", "Blending curve", blendingFields},
    CurveType{"bezier-curve", "Bézier curve", bezierFields},
    CurveType{"line-curve", "Line", lineFields},
    CurveType{"arc-curve", "Arc", arcFields},
    CurveType{"subdivision-curve", "Subdivision curve", subdivisionFields},
    CurveType{"formula-curve", "Formula curve", formulaFields},
};

constexpr std::array poseTable{
    Field{.name = "local", .label = "Local curve", .kind = FieldKind::integer,
          .help = "Which local curve, counted from 0.", .min = 0, .max = 9999, .required = true},
    Field{.name = "translate", .label = "Move", .kind = FieldKind::point,
          .help = "Moves the local curve.", .defaultJson = "[0,0,0]"},
    Field{.name = "rotate", .label = "Turn", .kind = FieldKind::group,
          .help = "Turns it about its point at its knot.", .defaultJson = "{}",
          .fields = rotateFields},
    Field{.name = "scale", .label = "Scale", .kind = FieldKind::scale,
          .help = "Scales it about its point at its knot.", .defaultJson = "1"},
};

constexpr std::array localsTable{
    Field{.name = "count", .label = "Number", .kind = FieldKind::integer,
          .help = "How many local curves are cut from the model.", .min = 2, .max = 10'000,
          .maxIsSize = true, .required = true},
    Field{.name = "kind", .label = "Kind", .kind = FieldKind::choice,
          .help = "What is cut from the model.", .defaultJson = "\"sub-curve\"",
          .choices = localKindChoices},
    Field{.name = "degree", .label = "Degree", .kind = FieldKind::integer,
          .help = "Of Bézier curves (up to 25) and B-splines (up to 7); 3 if left out.", .min = 1,
          .max = 25, .maxIsSize = true},
};

}  // namespace

std::span<const CurveType> curveTypes() noexcept { return types; }
std::span<const Field> poseFields() noexcept { return poseTable; }
std::span<const Field> localsFields() noexcept { return localsTable; }

const CurveType* findCurveType(std::string_view type) noexcept {
    return findNamed(types, &CurveType::type, type);
}

}  // namespace knotwork::scene
