// Specifications of meshes: { solid, parameters, creases }, { vertices, faces, creases } or { obj }.
#pragma once

#include "geometry/mesh.hpp"
#include "scene/json.hpp"
#include "scene/specs.hpp"

namespace knotwork::scene {

/// Any of the three, with its canonical form: the parameters of a solid filled in, vertices with
/// three coordinates, OBJ as vertices and faces. Refusals: WRONG_TYPE, UNKNOWN_FIELD (a mesh is
/// given in one way), and those of makeSolid(), Mesh::make() and readObj().
[[nodiscard]] Result<Made<Mesh>> makeMesh(const Json& spec);

/// The mesh with the creases of a list of { edge: [i, j], sharpness }, where a sharpness is a number
/// or "infinite". Refusals: WRONG_TYPE, UNKNOWN_FIELD, NOT_INTEGER under `creases[i]`, and those of
/// Mesh::withCreases().
[[nodiscard]] Result<Mesh> withCreases(const Mesh& mesh, const Json& list);
[[nodiscard]] Json describeCreases(const Mesh& mesh);

/// { vertices, faces }, and creases where there are any.
[[nodiscard]] Json specOf(const Mesh& mesh);

/// kw.solids: [{ name, label, parameters: [{ name, label, min, max, default, … }] }].
[[nodiscard]] Json describeSolids();

}  // namespace knotwork::scene
