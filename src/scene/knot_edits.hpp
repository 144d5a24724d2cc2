// Knots put in and taken out by commands. The numbers of a knot vector do not stand alone: points
// (or local curves) come and go with them.
#pragma once

#include "scene/path.hpp"

namespace knotwork::scene {

/// Whether `rest` leads from `part` to the knots of a curve or of one direction of a surface, or to one
/// of them: `knots`, `knots[3]`, `model.knots[3]`; `knots[1]`, `knots[1][3]`.
[[nodiscard]] bool leadsToKnots(const Json& part, std::span<const PathStep> rest);

/// Whether `rest` leads from `part` to one knot of a curve or of one direction of a surface.
[[nodiscard]] bool namesKnot(const Json& part, std::span<const PathStep> rest);

struct MovedKnot {
    Json part;
    std::size_t index = 0;  ///< of the knot that moved
};

/// `part` with the knot at `rest` moved as `command` says: `to` or `by`, and onto the nearest other
/// knot within `snap`, if that is given. Equal knots of a B-spline are alike: of those the last is
/// pulled off to the right, the first to the left; at the end of a clamped one they move as one.
/// Refusals are those of movedValue(), UNKNOWN_FIELD at the path, and what is wrong with `snap`.
[[nodiscard]] Result<MovedKnot> moveKnotIn(const Json& part, std::span<const PathStep> rest,
                                           const Json& command);

/// `part` with the knot at `rest` set to a value, together with its equals at a clamped end.
[[nodiscard]] Result<Json> withKnotAt(Json part, std::span<const PathStep> rest, const Json& value);

/// The specification of a curve with the knot `at` in it. A B-spline curve does not move; a blending
/// curve that is cut from a model gets a local curve there. Refusals at `t`, as those of
/// knotwork::insertKnot(), and NOT_SUPPORTED for curves without a model or without knots.
[[nodiscard]] Result<Json> withKnot(const Json& curve, double at);

/// `part` with the knot `value` in the curve or surface that `rest` leads to, wherever in the list it
/// belongs. WRONG_TYPE for what is no number; refusals are those of withKnot() and withKnotAlong() at
/// the path of the list.
[[nodiscard]] Result<Json> insertKnotIn(const Json& part, std::span<const PathStep> rest,
                                        const Json& value);

/// `part` without the knot that `rest` names: of a B-spline curve or surface, that with one knot less
/// which comes nearest; of a blending one, with its local curve or patches. Refusals at that path:
/// UNKNOWN_FIELD for a knot that is not there; OUT_OF_RANGE for one that ends the domain or period, or
/// without which a rational curve would have a weight that is not positive; KNOTS_COUNT.
[[nodiscard]] Result<Json> removeKnotIn(const Json& part, std::span<const PathStep> rest);

}  // namespace knotwork::scene
