// Specifications of meshes: { solid, parameters }, { vertices, faces } or { obj }.
#pragma once

#include "geometry/mesh.hpp"
#include "scene/json.hpp"
#include "scene/specs.hpp"

namespace knotwork::scene {

/// Any of the three, with its canonical form: the parameters of a solid filled in, vertices with
/// three coordinates, OBJ as vertices and faces. Refusals: WRONG_TYPE, UNKNOWN_FIELD (a mesh is
/// given in one way), and those of makeSolid(), Mesh::make() and readObj().
[[nodiscard]] Result<Made<Mesh>> makeMesh(const Json& spec);

/// { vertices, faces }.
[[nodiscard]] Json specOf(const Mesh& mesh);

/// kw.solids: [{ name, label, parameters: [{ name, label, min, max, default, … }] }].
[[nodiscard]] Json describeSolids();

}  // namespace knotwork::scene
