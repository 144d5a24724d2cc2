// Questions that the session answers by name, for whatever is asked seldom: arguments come as one
// object, checked against a table of fields, and the answer is JSON. What is asked at the rate of a
// picture or about many points has a function of its own in Session.
#pragma once

#include "geometry/curve.hpp"
#include "geometry/surface.hpp"
#include "scene/fields.hpp"
#include "scene/json.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace knotwork::bindings {

/// What goes back over the border. The session holds the curves and surfaces, and adds `curves` and
/// `surfaces` to the JSON: the handle and the traits of each. It leaves the numbers in its list, and
/// adds their number as `count`.
struct Answer {
    scene::Json json = scene::Json::object();
    std::vector<Curve> curves{};
    std::vector<Surface> surfaces{};
    std::vector<double> numbers{};
};

/// A question about a curve. `arguments` are complete: checked, with defaults filled in.
struct CurveQuery {
    std::string_view name;
    std::span<const scene::Field> fields;
    Result<Answer> (*answer)(const Curve& curve, const scene::Json& arguments);
};

/// A question about a surface.
struct SurfaceQuery {
    std::string_view name;
    std::span<const scene::Field> fields;
    Result<Answer> (*answer)(const Surface& surface, const scene::Json& arguments);
};

/// A question about its arguments alone. What `fields` cannot describe has none of them and is
/// checked where it is answered.
struct FreeQuery {
    std::string_view name;
    std::span<const scene::Field> fields;
    bool checked;
    Result<Answer> (*answer)(const scene::Json& arguments);
};

// Each of these stands in a file of its own: queries_<topic>.cpp.
[[nodiscard]] std::span<const CurveQuery> bsplineQueries() noexcept;
[[nodiscard]] std::span<const CurveQuery> subdivisionQueries() noexcept;
[[nodiscard]] std::span<const CurveQuery> crossingQueries() noexcept;
[[nodiscard]] std::span<const SurfaceQuery> bsplineSurfaceQueries() noexcept;
[[nodiscard]] std::span<const SurfaceQuery> blendingSurfaceQueries() noexcept;
[[nodiscard]] std::span<const SurfaceQuery> blendingTriangleQueries() noexcept;
[[nodiscard]] std::span<const FreeQuery> traceQueries() noexcept;
[[nodiscard]] std::span<const FreeQuery> sceneQueries() noexcept;

/// All of them, for the session.
[[nodiscard]] const CurveQuery* findCurveQuery(std::string_view name) noexcept;
[[nodiscard]] const SurfaceQuery* findSurfaceQuery(std::string_view name) noexcept;
[[nodiscard]] const FreeQuery* findFreeQuery(std::string_view name) noexcept;

}  // namespace knotwork::bindings
