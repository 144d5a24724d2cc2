// The normals that meshes are lit by.
#include "drawing/normals.hpp"
#include "geometry/mesh_subdivision.hpp"
#include "geometry/solids.hpp"
#include "support/gates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::drawing {
namespace {

Mesh refined(const char* name, MeshScheme scheme) {
    return subdivide(makeSolid(name, {}).value(), scheme, 3).value();
}

Mesh withPoints(const Mesh& mesh, std::vector<Vec3> points) {
    const auto corners = mesh.corners();
    return Mesh::trusted(std::move(points), {corners.begin(), corners.end()}, mesh.uniformSize());
}

/// The same faces between points of a sphere with this centre and radius.
Mesh onSphere(const Mesh& mesh, const Vec3& centre, double radius) {
    std::vector<Vec3> points;
    for (const Vec3& p : mesh.points()) points.push_back(centre + radius * glm::normalize(p));
    return withPoints(mesh, std::move(points));
}

Vec3 at(const std::vector<double>& xyz, std::size_t i) {
    return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

TEST(ShadingNormals, AreExactOnASphereWhereverAndHoweverLargeItIs) {
    for (const Mesh& mesh : {refined("cube", MeshScheme::catmullClark),
                             refined("icosahedron", MeshScheme::loop)}) {
        for (const double radius : {1e-100, 1.0, 1e9}) {
            const std::vector<double> normals =
                shadingNormals(onSphere(mesh, Vec3(0), radius));
            for (std::size_t i = 0; i < mesh.points().size(); ++i) {
                const Vec3 outward = glm::normalize(mesh.points()[i]);
                EXPECT_LT(glm::length(at(normals, i) - outward), 1e-13) << i << " " << radius;
            }
        }
    }
}

TEST(ShadingNormals, ComeNearThoseByAnglesOnASmoothMesh) {
    const Mesh mesh = refined("cube", MeshScheme::catmullClark);
    const std::vector<double> normals = shadingNormals(mesh);
    std::vector<double> byAngles(normals.size());
    vertexNormals(mesh, byAngles);
    for (std::size_t i = 0; i < mesh.points().size(); ++i) {
        EXPECT_GT(glm::dot(at(normals, i), at(byAngles, i)), 0.999) << i;
    }
}

TEST(ShadingNormals, OfFacesOfManySizesAreThoseByAngles) {
    const Mesh mesh = makeSolid("prism", {}).value();
    ASSERT_EQ(mesh.uniformSize(), 0U);
    std::vector<double> byAngles(3 * mesh.points().size());
    vertexNormals(mesh, byAngles);
    EXPECT_EQ(shadingNormals(mesh), byAngles);
}

TEST(ShadingNormals, StandWhereThereIsNone) {
    // A face that is a point, beside a vertex without faces.
    const Mesh mesh = Mesh::trusted({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 0, 0}}, {0, 1, 2}, 3);
    EXPECT_EQ(shadingNormals(mesh), (std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

}  // namespace
}  // namespace knotwork::drawing
