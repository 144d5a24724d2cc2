// What is asked of a fit, but for its points: the same fields in kw.fit() and in a cloud of points.
#pragma once

#include "geometry/knot_vector.hpp"
#include "geometry/least_squares_curve.hpp"
#include "scene/fields.hpp"

#include <array>

namespace knotwork::scene {

inline constexpr std::array parametrisationChoices{Choice{"chord", "Chord length"},
                                                   Choice{"centripetal", "Centripetal"},
                                                   Choice{"uniform", "Uniform"}};
inline constexpr std::array fitFormChoices{Choice{"clamped", "Clamped"}, Choice{"open", "Open"},
                                           Choice{"closed", "Closed"}};

inline constexpr Field fitDegreeField{.name = "degree", .label = "Degree",
                                      .kind = FieldKind::integer,
                                      .help = "Degree of the polynomial pieces.", .min = 1,
                                      .max = maxDegree, .maxIsSize = true, .required = true};
inline constexpr Field fitFormField{
    .name = "form", .label = "Form", .kind = FieldKind::choice,
    .help = "Clamped begins and ends in control points, closed has no ends.",
    .defaultJson = "\"clamped\"", .choices = fitFormChoices};
inline constexpr Field fitParametersField{.name = "parameters", .label = "Parameters",
                                          .kind = FieldKind::choice,
                                          .help = "How parameters are found, or one number a point.",
                                          .defaultJson = "\"chord\"",
                                          .choices = parametrisationChoices};
inline constexpr Field fitCountField{.name = "count", .label = "Control points",
                                     .kind = FieldKind::integer,
                                     .help = "How many control points the curve has.", .min = 2,
                                     .max = maxPointCount, .maxIsSize = true, .required = true};
inline constexpr Field fitKnotsField{
    .name = "knots", .label = "Knots", .kind = FieldKind::numbers,
    .help = "Count + degree + 1 numbers, or count + 1 of one period where closed."};
inline constexpr Field fitEndsField{
    .name = "interpolateEnds", .label = "Interpolate ends", .kind = FieldKind::flag,
    .help = "Whether the curve begins and ends exactly in the first and the last point.",
    .defaultJson = "false"};
inline constexpr Field fitSmoothingField{.name = "smoothing", .label = "Smoothing",
                                         .kind = FieldKind::number,
                                         .help = "How much the bends of the control polygon count.",
                                         .min = 0, .max = maxSmoothing, .defaultJson = "0"};

}  // namespace knotwork::scene
