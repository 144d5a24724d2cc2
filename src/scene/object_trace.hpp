// The parameter of an object, at which it is measured, and the trace that is shown on it.
#pragma once

#include "scene/body.hpp"
#include "scene/trace.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace knotwork::scene {

/// The curve whose parameter it is: the object's own, or the one that was fitted to a cloud.
[[nodiscard]] std::optional<Curve> measuredCurve(const Body& body);

/// `t` of a canonical object, else the middle of the domain; 0 where there is no curve. OUT_OF_RANGE
/// `t` outside the domain of an open one; a closed one wraps.
[[nodiscard]] Result<double> parameterOf(const Json& spec, const Body& body);

struct ObjectTrace {
    std::shared_ptr<const Trace> trace;  ///< null where none is asked for
    std::size_t frame = 0;               ///< the last one where a later one is asked for
};

/// What `trace` of a canonical object asks for: `{ algorithm, t, u, v, knot, knots, levels, frame }`,
/// of which every algorithm takes its own. Left out, t and `knot` are the object's parameter, u and v
/// the middle, `levels` the object's own, and `knots` one more in the middle of every span.
/// Refusals as makeTrace(), at `trace.t` …; NOT_SUPPORTED `trace.algorithm` for one that does not
/// work on such an object.
[[nodiscard]] Result<ObjectTrace> traceOf(const Json& spec, const Body& body, double parameter);

}  // namespace knotwork::scene
