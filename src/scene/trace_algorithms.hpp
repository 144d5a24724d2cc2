// One function an algorithm, for makeTrace(): arguments are checked but for what is said here.
#pragma once

#include "geometry/blending_curve.hpp"
#include "geometry/blending_surface.hpp"
#include "geometry/bspline_curve.hpp"
#include "geometry/curve_subdivision.hpp"
#include "geometry/mesh.hpp"
#include "scene/trace.hpp"

#include <vector>

namespace knotwork::scene {

// Of a parameter in the domain.
[[nodiscard]] Result<Trace> traceDeBoor(const BsplineCurve& curve, double t);
[[nodiscard]] Result<Trace> traceCoxDeBoor(const BsplineCurve& curve, double t);
[[nodiscard]] Result<Trace> traceFactorMatrices(const BsplineCurve& curve, double t);
[[nodiscard]] Result<Trace> traceBlend(const BlendingCurve& curve, double t);
[[nodiscard]] Result<Trace> traceBlend(const BlendingSurface& surface, const SurfacePlace& at);

/// One knot more; refuses what insertKnot() refuses, at `knot`.
[[nodiscard]] Result<Trace> traceBoehm(const BsplineCurve& curve, double knot);
/// The full refined vector; refuses at `knots` what is no refinement.
[[nodiscard]] Result<Trace> traceOslo(const BsplineCurve& curve, std::vector<double> knots);

// Of a subdivision by the scheme of the name; refuse what checkSubdivision() refuses.
[[nodiscard]] Result<Trace> traceLaneRiesenfeld(const CurveSubdivision& subdivision);
[[nodiscard]] Result<Trace> traceFourPoint(const CurveSubdivision& subdivision);

/// `levels` ≥ 0; refuses at `levels` what makes the mesh too large.
[[nodiscard]] Result<Trace> traceCatmullClark(const Mesh& mesh, int levels);

}  // namespace knotwork::scene
