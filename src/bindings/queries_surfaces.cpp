// Questions about B-spline surfaces that are asked seldom.
#include "bindings/queries.hpp"
#include "scene/json_values.hpp"

#include <array>

namespace knotwork::bindings {

using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

constexpr std::array oneKnots{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers}};
constexpr std::array knotsField{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::pair,
          .help = "The full refined vectors along u and along v.", .required = true,
          .fields = oneKnots}};

/// Only the facade of B-spline surfaces asks.
const BsplineSurface& splineOf(const Surface& surface) { return *surface.as<BsplineSurface>(); }

Result<Answer> refined(const Surface& surface, const Json& arguments) {
    const Json& knots = arguments["knots"];
    auto finer =
        refine(splineOf(surface), scene::numbersOf(knots[0]), scene::numbersOf(knots[1]));
    if (!finer) return finer.error();
    Answer answer;
    answer.surfaces.emplace_back(std::move(*finer));
    return answer;
}

constexpr std::array queries{SurfaceQuery{"refine", knotsField, refined}};

}  // namespace

std::span<const SurfaceQuery> bsplineSurfaceQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
