// Traces: an algorithm step by step, in frames that a figure, a formula and a voice read alike.
//
// The first frame shows where the algorithm begins, the last one its result; between them stands
// every step with its numbers. Where the result is a point, it is the last point of the last frame;
// where it is a polygon, it is all of them.
#pragma once

#include "geometry/result.hpp"
#include "geometry/vec.hpp"
#include "scene/json.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knotwork::scene {

struct TraceFrame {
    /// Which sentence this is and what was put into it, for whoever says it in another language.
    std::string_view key;
    std::vector<std::pair<std::string_view, std::string>> values{};
    std::string title{};
    std::string text{};  ///< one sentence, in words and numbers that can be spoken
    std::vector<Vec3> points{};
    std::vector<std::array<std::size_t, 2>> edges{};  ///< between points, by index
    std::vector<std::size_t> marked{};  ///< the points that this step is about: active, or new
    std::vector<double> weights{};
    std::vector<std::vector<double>> matrix{};  ///< by rows
    std::string formula{};                      ///< MathML with the numbers of this step
};

struct Trace {
    std::string_view algorithm;
    std::vector<TraceFrame> frames{};
};

/// `{ algorithm, … }` with the arguments of the algorithm:
///   de-boor, cox-de-boor, factor-matrices { curve, t }   boehm { curve, knot }
///   oslo { curve, knots }   lane-riesenfeld { points, closed, degree, levels }
///   blend { curve, t } or { surface, u, v }   four-point { points, closed, tension, levels }
///   catmull-clark { mesh, levels }
/// Refusals: WRONG_TYPE and UNKNOWN_NAME `algorithm`; UNKNOWN_FIELD and what the fields refuse, at
/// their paths; NOT_SUPPORTED `curve.type`, `surface.type`; OUT_OF_RANGE `t`, `u`, `v`; as
/// insertKnot() does, `knot`; and TOO_LARGE where there is more than anybody can look at: 2 000
/// frames, 20 000 points or 500 000 weights and entries of matrices in all.
[[nodiscard]] Result<Trace> makeTrace(const Json& given);

/// `{ algorithm, frames: [{ title, text, points, edges, marked, weights?, matrix?, formula?, key,
/// values }] }`.
[[nodiscard]] Json traceJson(const Trace& trace);

}  // namespace knotwork::scene
