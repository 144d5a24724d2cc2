// Specifications: checked, completed to their canonical form, and turned into geometry.
#pragma once

#include "geometry/curve.hpp"
#include "scene/fields.hpp"
#include "scene/json.hpp"

namespace knotwork::scene {

/// A geometry value with the canonical specification it was made from (defaults filled in, keys in
/// the order of the field tables).
template <class T>
struct Made {
    Json spec;
    T value;
};

[[nodiscard]] Result<Made<BFunction>> makeBFunction(const Json& spec);

/// A curve specification. What an object of a scene has besides (`id`, `style`, `show`) may stand
/// in it, is checked, and does not come back.
[[nodiscard]] Result<Made<Curve>> makeCurve(const Json& spec);

/// What kw.subdivide() takes: the fields of a `subdivision-curve`, its type or none.
[[nodiscard]] Result<CurveSubdivision> makeSubdivision(const Json& spec);

/// The canonical specification of a curve that has been computed; makeCurve() makes it again, equal
/// to rounding. For the kinds that are ever computed.
[[nodiscard]] Json specOf(const Curve& curve);

/// kw.bFunctions: [{ family, label, formula, parameters: [{ name, label, min, max, default, … }] }].
[[nodiscard]] Json describeBFunctions();
/// kw.parametricCurves: [{ name, label, dimension, parameters: […] }].
[[nodiscard]] Json describeParametricCurves();

}  // namespace knotwork::scene
