// Questions about blending triangles: their local patches and what each of them counts.
#include "bindings/queries.hpp"

#include <array>

namespace knotwork::bindings {

using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

constexpr std::array cornerFields{
    Field{.name = "corner", .label = "Corner", .kind = FieldKind::integer, .min = 0, .max = 2,
          .required = true}};
constexpr std::array placeFields{
    Field{.name = "u", .label = "u", .kind = FieldKind::number, .min = 0, .max = 1,
          .required = true},
    Field{.name = "v", .label = "v", .kind = FieldKind::number, .min = 0, .max = 1,
          .required = true}};

/// Only the facade of blending triangles asks.
const BlendingTriangle& triangleOf(const Surface& surface) {
    return *surface.as<BlendingTriangle>();
}

Result<Answer> corner(const Surface& surface, const Json& arguments) {
    const auto index = static_cast<std::size_t>(arguments["corner"].get<double>());
    Answer answer;
    answer.surfaces.push_back(triangleOf(surface).local(index));
    return answer;
}

Result<Answer> weights(const Surface& surface, const Json& arguments) {
    const Barycentric found = triangleOf(surface).weights(arguments["u"].get<double>(),
                                                          arguments["v"].get<double>());
    Answer answer;
    answer.json["weights"] = Json::array({found[0], found[1], found[2]});
    return answer;
}

constexpr std::array queries{SurfaceQuery{"corner", cornerFields, corner},
                             SurfaceQuery{"weights", placeFields, weights}};

}  // namespace

std::span<const SurfaceQuery> blendingTriangleQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
