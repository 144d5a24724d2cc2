// Subdivision of meshes: Catmull–Clark, Doo–Sabin, Loop, the modified Butterfly, √3.
//
//   Catmull–Clark  any mesh → quads; bicubic B-splines where regular. E. Catmull, J. Clark,
//                  Recursively generated B-spline surfaces on arbitrary topological meshes, 1978.
//   Doo–Sabin      any mesh → valence 4; biquadratic B-splines. D. Doo, M. Sabin, Behaviour of
//                  recursive division surfaces near extraordinary points, 1978.
//   Loop           triangles; quartic box splines. C. Loop, Smooth subdivision surfaces based on
//                  triangles, 1987.
//   Butterfly      triangles, interpolating. D. Zorin, P. Schröder, W. Sweldens, Interpolating
//                  subdivision for meshes with arbitrary topology, 1996.
//   √3             triangles, three times as many a level. L. Kobbelt, √3-subdivision, 2000.
//
// Vertices come in the order V | F | E: the old vertices (those of Doo–Sabin do not survive), then
// one for every face where the scheme has such, then one for every edge in the order of
// Mesh::edges(). Corners and faces, per scheme:
//   Catmull–Clark  V | F | E; corner k of a face becomes the quad v_k, e_k, f, e_{k−1}.
//   Loop, Butterfly  V | E; a triangle becomes v_k, e_k, e_{k−1} for k = 0, 1, 2 and e_0, e_1, e_2.
//   √3             V | F; edge k of a triangle f becomes v_k, the centre beyond it, that of f.
//   Doo–Sabin      one vertex a corner, then two for every boundary edge; faces F | E | V.
// (e_k is the edge from corner k to the next one.) So levels done one by one and at once agree to
// the bit, but for √3 on a mesh with a boundary.
//
// Boundaries are curves of their own, and no corner is fixed: uniform cubic B-splines with
// Catmull–Clark, Loop and √3 (whose boundaries are cut in three in every second level of a call, as
// Kobbelt does; until then they wait), four-point curves with Butterfly, and quadratic B-splines
// (Chaikin's curve) with Doo–Sabin, where each boundary edge counts as a face without area.
// Vertices without faces stay where they are (Doo–Sabin drops them). Where several fans of faces
// meet in a vertex, it takes the rule for all their faces together, or on a boundary the mean of
// the fans' rules; Butterfly's edges and Doo–Sabin's faces go by the fan that they belong to.
//
// Catmull–Clark and Loop keep creases sharp (mesh_creases.hpp) and pass what is left of them on.
#pragma once

#include "geometry/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace knotwork {

enum class MeshScheme { catmullClark, dooSabin, loop, butterfly, sqrt3 };

/// Their public names, in the order of MeshScheme.
inline constexpr std::array<std::string_view, 5> meshSchemeNames{"catmull-clark", "doo-sabin",
                                                                 "loop", "butterfly", "sqrt3"};
[[nodiscard]] std::optional<MeshScheme> meshSchemeNamed(std::string_view name) noexcept;

/// How smooth the limit is: `regular` where all valences are, `extraordinary` elsewhere inside.
struct MeshClassification {
    bool approximating = true;
    std::string_view regular;
    std::string_view extraordinary;
    std::string_view mesh;  ///< "any" or "triangles"
};

[[nodiscard]] MeshClassification classification(MeshScheme scheme) noexcept;

/// A mesh `levels` levels finer; for 0 the mesh itself. Refusals: OUT_OF_RANGE `levels` below 0,
/// TOO_LARGE `levels` where the result would have more than 4 million vertices, NOT_SUPPORTED
/// `faces[i]` for the first face that is no triangle where the scheme needs them, or has another
/// with the same vertices on its back, and `scheme` for one that has no rules for the creases that
/// there are. O(size of the result), and less than twice its memory. Error
/// of a level: a few ulp of the largest coordinate; equal coordinates stay equal to the bit.
[[nodiscard]] Result<Mesh> subdivide(const Mesh& mesh, MeshScheme scheme, int levels);

/// Where the vertices of a mesh end up, one entry a vertex. A normal is the zero vector where there
/// is none: at vertices without faces, and where all the faces lie in a line.
struct MeshLimit {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
};

/// By the eigenvectors of the scheme around a vertex; on a boundary that of the boundary's curve
/// and the strongest of those that cross it. Where several fans meet in a vertex, the normal is the
/// mean of theirs. Refusals: NOT_SUPPORTED `scheme` for Doo–Sabin, whose limit points belong to
/// faces, and `creases` where there are any; `faces[i]` as subdivide(); TOO_LARGE at the empty path for
/// a mesh of which one finer level is needed (Catmull–Clark unless all faces are quads; Butterfly)
/// that would be too large. O(n).
[[nodiscard]] Result<MeshLimit> limit(const Mesh& mesh, MeshScheme scheme);

}  // namespace knotwork
