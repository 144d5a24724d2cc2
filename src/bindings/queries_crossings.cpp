// The question how often a line crosses a curve and its control polygon.
#include "bindings/queries.hpp"
#include "geometry/line_crossings.hpp"
#include "scene/json_values.hpp"

#include <array>
#include <cmath>

namespace knotwork::bindings {

using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

constexpr std::array lineFields{
    Field{.name = "point", .label = "Point", .kind = FieldKind::point, .required = true},
    Field{.name = "direction", .label = "Direction", .kind = FieldKind::point, .required = true}};

Result<Answer> crossings(const Curve& curve, const Json& arguments) {
    const PlaneLine line{scene::vec3Of(arguments["point"]), scene::vec3Of(arguments["direction"])};
    if (!(std::hypot(line.direction.x, line.direction.y) > 0)) {
        return refuse(Code::outOfRange, "direction",
                      "The direction has no length in the plane; give it an x or a y.");
    }
    const auto found = lineCrossings(curve, line);
    if (!found) {
        return refuse(Code::notSupported, "point",
                      "Crossings are counted of B-spline, Bézier and subdivision curves, which "
                      "have a control polygon.");
    }
    Answer answer;
    answer.json["curve"] = Json::array();
    answer.json["polygon"] = Json::array();
    for (const Crossing& crossing : found->curve) {
        answer.json["curve"].push_back(
            {{"t", crossing.t}, {"point", scene::pointJson(crossing.point, 3)}});
    }
    for (const Vec3& p : found->polygon) {
        answer.json["polygon"].push_back(scene::pointJson(p, 3));
    }
    return answer;
}

constexpr std::array queries{CurveQuery{"crossings", lineFields, crossings}};

}  // namespace

std::span<const CurveQuery> crossingQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
