// How values of the core look on the other side of the border.
#pragma once

#include "drawing/drawing.hpp"
#include "geometry/curve.hpp"
#include "geometry/curve_subdivision.hpp"
#include "geometry/result.hpp"
#include "geometry/surface.hpp"
#include "scene/json.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace knotwork::bindings {

/// Highest order of derivative that can be asked for.
inline constexpr int maximumDerivative = 25;

/// The JSON value of CBOR as the facade writes it (marshal_cbor.hpp), NaN and infinities included,
/// so that validation can name them. SYNTAX for anything else.
[[nodiscard]] Result<scene::Json> readCbor(std::span<const std::uint8_t> bytes);

class CborCursor;
struct CborItem;
/// One value: `item`, which the cursor has just left, and what follows of it. False where it is not
/// what the facade writes.
[[nodiscard]] bool readValue(CborCursor& cursor, const CborItem& item, scene::Json& value);

/// The B-spline curve that these bytes specify, as scene::makeCurve() would make it; nothing where
/// they specify something else, or where anything about it is to be refused.
[[nodiscard]] std::optional<Curve> readUsualBspline(std::span<const std::uint8_t> bytes);

/// The B-spline surface that these bytes specify, likewise.
[[nodiscard]] std::optional<Surface> readUsualSurface(std::span<const std::uint8_t> bytes);

/// The subdivision that these bytes specify, as scene::makeSubdivision() would make it; nothing
/// where anything about it is to be refused.
[[nodiscard]] std::optional<CurveSubdivision> readUsualSubdivision(
    std::span<const std::uint8_t> bytes);

/// TOO_LARGE for a document whose text would have more than 1 MiB. Of what came in few bytes no
/// text is made: a number takes nine of them on its way here and at most 25 as text.
[[nodiscard]] Result<Done> checkSize(const scene::Json& document, std::size_t bytes);

/// { code, path, message }.
[[nodiscard]] std::string errorJson(const Error& error);

/// { command, path }.
[[nodiscard]] std::string changeJson(const scene::Change& change);

/// { bounds: { min, max } or null, shapes: [{ object, role, kind, pane, index, colour, opacity,
/// width, dashed, square, path, text, at, count }] }: objects by id, positions as `count` numbers
/// at the address `at`.
[[nodiscard]] std::string drawingJson(const drawing::Drawing& drawing, const scene::State& state);

/// Rows of an answer with so many derivatives: the point is the zeroth.
[[nodiscard]] inline std::size_t rowsOf(int derivatives) noexcept {
    return static_cast<std::size_t>(derivatives) + 1;
}

/// OUT_OF_RANGE at `name` unless 0 ≤ n ≤ 25.
[[nodiscard]] Result<Done> checkDerivative(int n, std::string_view name);
/// NOT_FINITE or OUT_OF_RANGE at `t` unless 0 ≤ t ≤ 1.
[[nodiscard]] Result<Done> checkUnit(double t);
/// NOT_FINITE or OUT_OF_RANGE at `tolerance` unless it is a positive number.
[[nodiscard]] Result<Done> checkTolerance(double tolerance);

/// The specification with the pose of one local curve put in place of the one it had. The pose
/// has no key `local` (UNKNOWN_FIELD) and is otherwise checked where the curve is made.
[[nodiscard]] Result<scene::Json> specWithPose(scene::Json spec, int local, scene::Json pose);

/// `poses[2].rotate.axis` as the caller of withPose() knows it: `rotate.axis`.
[[nodiscard]] Error seenFromPose(Error error);

}  // namespace knotwork::bindings
