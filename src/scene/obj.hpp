// Wavefront OBJ, the text in which most programs exchange meshes: vertices and faces of it.
//
// Read are `v` (three coordinates; what may follow, a weight or a colour, is left out) and `f` (the
// vertices of a face, counted from 1 or, negative, back from the last one; `7/2`, `7//3`, `7/2/3`
// name a texture and a normal too, which are left out). All the other words of the format, as
// groups, materials, curves, are passed over, and so are comments from # on; a line that ends in a
// backslash goes on in the next one. (Wavefront, Advanced Visualizer Manual, Appendix B1: Object
// Files.)
#pragma once

#include "geometry/mesh.hpp"

#include <string>
#include <string_view>

namespace knotwork::scene {

/// Refusals: SYNTAX at `obj` for a word that OBJ does not have or what is no number or no index,
/// OUT_OF_RANGE at `obj` for a vertex that there is not (each says the line), TOO_LARGE as soon as
/// there are too many vertices or corners, and those of Mesh::make(). O(n).
[[nodiscard]] Result<Mesh> readObj(std::string_view text);

/// Reads back as the same mesh: every coordinate has as many digits as that needs.
[[nodiscard]] std::string writeObj(const Mesh& mesh);

}  // namespace knotwork::scene
