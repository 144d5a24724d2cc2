// From checked specifications to geometry, one function a type. For specs.cpp and the builders
// themselves, which call each other for nested curves; everyone else calls makeCurve().
//
// A builder trusts the types and ranges of the fields, since validation came first, and fills into
// the specification what it computes (knots, forms, domains).
#pragma once

#include "geometry/curve.hpp"
#include "scene/fields.hpp"
#include "scene/json.hpp"

namespace knotwork::scene {

/// The keys in the order of the tables, `id` and `type` first, `style` and what else an object has
/// last: what was computed stands at the end until then.
[[nodiscard]] Json inOrder(Json spec, std::span<const Field> fields);

[[nodiscard]] Result<BFunction> buildBFunction(const Json& spec);

/// Of any type; the keys are in the order of the field tables afterwards.
[[nodiscard]] Result<Curve> buildCurve(Json& spec);

[[nodiscard]] Result<Curve> buildBspline(Json& spec);
[[nodiscard]] Result<Curve> buildParametric(Json& spec);
[[nodiscard]] Result<Curve> buildBlending(Json& spec);
[[nodiscard]] Result<Curve> buildBezier(Json& spec);
[[nodiscard]] Result<Curve> buildLine(Json& spec);
[[nodiscard]] Result<Curve> buildArc(Json& spec);
[[nodiscard]] Result<Curve> buildSubdivision(Json& spec);

/// What a checked specification says, with the fields filled in that belong to its scheme.
[[nodiscard]] Result<CurveSubdivision> buildCurveSubdivision(Json& spec);
[[nodiscard]] Result<Curve> buildFormula(Json& spec);

// And back again, for what is computed.
[[nodiscard]] Json specOf(const BFunction& blend);
[[nodiscard]] Json specOf(const BsplineCurve& curve);
[[nodiscard]] Json specOf(const BezierCurve& curve);
[[nodiscard]] Json specOf(const LineCurve& curve);
[[nodiscard]] Json specOf(const ArcCurve& curve);
[[nodiscard]] Json specOf(const SubdivisionCurve& curve);

}  // namespace knotwork::scene
