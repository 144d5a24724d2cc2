// Named meshes to begin with: the five regular solids, and what else one subdivides.
//
// All are inscribed in the unit sphere (their outermost vertices lie on it), but for the cube with
// the corners (±1, ±1, ±1), the tetrahedron with (1, 1, 1), (1, −1, −1), (−1, 1, −1), (−1, −1, 1),
// and the octahedron with the unit vectors. Faces run counter-clockwise seen from outside; those of
// the grid, which is open and lies in the plane z = 0, seen from above.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/parameter.hpp"

#include <span>
#include <string_view>

namespace knotwork {

struct SolidDescription {
    std::string_view name;   ///< as in documents
    std::string_view label;  ///< for people
    std::span<const ParameterDescription> parameters;
};

/// In the order in which they are offered.
[[nodiscard]] std::span<const SolidDescription> solids() noexcept;
/// Null for an unknown name.
[[nodiscard]] const SolidDescription* findSolid(std::string_view name) noexcept;

/// The solid with these parameters, defaults for the others. Refusals: UNKNOWN_NAME at `solid`;
/// UNKNOWN_FIELD, NOT_FINITE, NOT_INTEGER, OUT_OF_RANGE at `parameters.<name>`. O(faces).
[[nodiscard]] Result<Mesh> makeSolid(std::string_view name,
                                     std::span<const NamedValue> parameters = {});

}  // namespace knotwork
