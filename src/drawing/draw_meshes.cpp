// What subdivision surfaces consist of: the refined mesh as triangles and as wires, and the control
// mesh around it.
#include "drawing/measures.hpp"
#include "drawing/normals.hpp"
#include "geometry/triangulation.hpp"
#include "scene/json_values.hpp"

namespace knotwork::drawing {

namespace {

void drawMesh(Sketch& sketch, const Mesh& mesh) {
    std::vector<double> positions;
    positions.reserve(3 * mesh.points().size());
    for (const Vec3& p : mesh.points()) positions.insert(positions.end(), {p.x, p.y, p.z});
    drawTriangles(sketch, std::move(positions), shadingNormals(mesh), triangleIndices(mesh));
}

void drawEdges(Sketch& sketch, const Mesh& mesh, Role role, float width) {
    Shape& shape = sketch.add(role, Kind::polyline, width);
    append(shape, mesh.points());
    shape.indices.reserve(2 * mesh.edges().size());
    for (const MeshEdge& edge : mesh.edges()) {
        shape.indices.insert(shape.indices.end(), {edge.v0, edge.v1});
    }
}

}  // namespace

void drawMeshFigure(Sketch& sketch, const scene::SubdivisionSurface& surface) {
    const scene::Show& show = sketch.show();
    if (show.sphere) drawSphere(sketch, surface.refined.points());
    if (show.surface) drawMesh(sketch, surface.refined);
    if (show.wireframe) drawEdges(sketch, surface.refined, Role::wireframe, 0.75F);
    if (show.polygon) drawEdges(sketch, surface.control, Role::polygon, 1.25F);
    if (!show.points) return;
    Shape& shape = sketch.add(Role::points, Kind::points, 9);
    // A solid that stands in the document by its name has no list of vertices to take hold of.
    const scene::Json* mesh = scene::member(sketch.object().spec, "mesh");
    if (mesh != nullptr && scene::member(*mesh, "vertices") != nullptr) {
        shape.path = sketch.path("mesh.vertices");
    }
    append(shape, surface.control.points());
}

}  // namespace knotwork::drawing
