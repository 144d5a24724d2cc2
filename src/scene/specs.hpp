// Specifications: checked, completed to their canonical form, and turned into geometry.
#pragma once

#include "geometry/curve.hpp"
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
[[nodiscard]] Result<Made<Curve>> makeCurve(const Json& spec);

/// The specification of a B-spline curve that has been computed.
[[nodiscard]] Json specOf(const BsplineCurve& curve);

/// kw.bFunctions: [{ family, label, parameters: [{ name, label, min, max, default, … }] }].
[[nodiscard]] Json describeBFunctions();
/// kw.parametricCurves: [{ name, label, parameters: […] }].
[[nodiscard]] Json describeParametricCurves();

}  // namespace knotwork::scene
