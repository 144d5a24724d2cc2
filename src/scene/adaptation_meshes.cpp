// Meshes and clouds: faces follow vertices, fits follow points.
#include "geometry/mesh_subdivision.hpp"
#include "geometry/triangulation.hpp"
#include "scene/adaptation_parts.hpp"
#include "scene/mesh_specs.hpp"
#include "scene/mesh_stencils.hpp"

#include <algorithm>
#include <utility>

namespace knotwork::scene {

namespace {

bool isList(const Json* value) { return value != nullptr && value->is_array(); }

/// Whether a face is a list of numbers.
bool namesVertices(const Json& face) {
    return face.is_array() && std::all_of(face.begin(), face.end(), [](const Json& corner) {
        return corner.is_number();
    });
}

bool names(const Json& face, double vertex) {
    return std::any_of(face.begin(), face.end(),
                       [&](const Json& corner) { return corner.get<double>() == vertex; });
}

/// The faces after vertex `place` came or went: numbers behind it move, and faces that had the one
/// that went go with it.
Json renumbered(const Json& faces, double place, bool came) {
    Json kept = Json::array();
    for (const Json& face : faces) {
        if (!came && names(face, place)) continue;
        Json moved = face;
        for (Json& corner : moved) {
            const double number = corner.get<double>();
            if (came ? number >= place : number > place) corner = number + (came ? 1.0 : -1.0);
        }
        kept.push_back(std::move(moved));
    }
    return kept;
}

Json followVertices(const Json& before, Json mesh) {
    const Json* from = member(before, "vertices");
    const Json* to = member(mesh, "vertices");
    Json* faces = member(mesh, "faces");
    if (!isList(from) || !isList(to) || !isList(faces) || differs(before, mesh, "faces")) return mesh;
    if (!std::all_of(faces->begin(), faces->end(), namesVertices)) return mesh;
    const bool came = to->size() == from->size() + 1;
    if (!came && to->size() + 1 != from->size()) return mesh;
    const std::size_t place = came ? changedIndex(*from, *to) : changedIndex(*to, *from);
    *faces = renumbered(*faces, static_cast<double>(place), came);
    return mesh;
}

bool wantsTriangles(const Json& surface) {
    const auto scheme = meshSchemeNamed(stringOr(surface, "scheme", ""));
    return scheme && classification(*scheme).mesh == "triangles";
}

/// The mesh in triangles, where it can be cut into them.
Json inTriangles(const Json& mesh) {
    const auto made = makeMesh(mesh);
    if (!made || made->value.faces().uniformSize == 3) return mesh;
    const auto cut = triangulated(made->value);
    return cut ? specOf(*cut) : mesh;
}

/// The stencil of an element of which the new scheme makes points too: of the vertex with the same
/// number, or of a corner.
void adaptStencil(Json& surface) {
    Json* shown = member(surface, "stencil");
    const auto next = meshSchemeNamed(stringOr(surface, "scheme", ""));
    if (shown == nullptr || !shown->is_object() || !next) return;
    if (hasStencil(*next, meshElementNamed(stringOr(*shown, "of", "")))) return;
    const bool vertices = hasStencil(*next, MeshElement::vertex);
    (*shown)["of"] = meshElementName(vertices ? MeshElement::vertex : MeshElement::corner);
}

}  // namespace

Json adaptSubdivisionSurface(const Json& before, Json after) {
    if (differs(before, after, "scheme")) adaptStencil(after);
    Json* mesh = member(after, "mesh");
    if (mesh == nullptr || !mesh->is_object()) return after;
    const Json& former = *member(before, "mesh");
    if (former != *mesh) {
        if (differs(former, *mesh, "solid") && !differs(former, *mesh, "parameters")) {
            mesh->erase("parameters");
        }
        *mesh = followVertices(former, std::move(*mesh));
    } else if (differs(before, after, "scheme") && wantsTriangles(after)) {
        *mesh = inTriangles(*mesh);
    }
    return after;
}

Json adaptPointCloud(const Json& before, Json after) {
    const Json* points = member(after, "points");
    Json* fit = member(after, "fit");
    if (!isList(points) || fit == nullptr || !fit->is_object()) return after;
    if (points->size() >= member(before, "points")->size() || differs(before, after, "fit")) {
        return after;
    }
    // Fewer data determine fewer control points, and fewer of those a lower degree.
    const auto most = static_cast<double>(points->size());
    if (most < 2 || numberOr(*fit, "count", 0) <= most) return after;
    (*fit)["count"] = most;
    if (numberOr(*fit, "degree", 0) >= most) (*fit)["degree"] = most - 1;
    return after;
}

}  // namespace knotwork::scene
