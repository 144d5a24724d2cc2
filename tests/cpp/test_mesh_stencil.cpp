#include "geometry/mesh_stencil.hpp"
#include "support/mesh_gates.hpp"
#include "support/mesh_zoo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::finer;
using test::nameOf;

constexpr MeshElement elements[] = {MeshElement::vertex, MeshElement::edge, MeshElement::face,
                                    MeshElement::corner};

/// Where the points of these elements begin in the finer mesh: V | F | E.
std::size_t firstOf(const Mesh& mesh, MeshScheme scheme, MeshElement element) {
    if (element == MeshElement::vertex || element == MeshElement::corner) return 0;
    const bool faces = scheme == MeshScheme::catmullClark;
    if (element == MeshElement::face || !faces) return mesh.points().size();
    return mesh.points().size() + mesh.faces().count();
}

Vec3 combined(const MeshStencil& stencil, const Mesh& mesh) {
    Vec3 sum{0};
    for (const StencilWeight& part : stencil.weights) {
        sum += part.weight * mesh.points()[part.vertex];
    }
    return sum;
}

void expectMakes(const MeshStencil& made, const Mesh& mesh, const Vec3& point) {
    EXPECT_EQ(made.point, point);
    EXPECT_LE(glm::length(combined(made, mesh) - point), test::gates::subdivided);
    double sum = 0;
    for (const StencilWeight& part : made.weights) sum += part.weight;
    EXPECT_NEAR(sum, 1, test::gates::subdivided);
}

/// Weights at the vertices of a mesh, 0 where there is none.
std::vector<double> weightsOf(const Mesh& mesh, MeshScheme scheme, MeshElement element,
                              std::size_t index) {
    std::vector<double> weights(mesh.points().size(), 0);
    const auto made = stencil(mesh, scheme, element, index);
    EXPECT_TRUE(made.ok());
    if (!made) return weights;
    for (const StencilWeight& part : made->weights) weights[part.vertex] = part.weight;
    return weights;
}

std::size_t edgeOf(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    std::size_t e = 0;
    while (std::minmax(mesh.edges()[e].v0, mesh.edges()[e].v1) != std::minmax(a, b)) ++e;
    return e;
}

std::map<double, int> histogram(const std::vector<double>& weights) {
    std::map<double, int> counts;
    for (const double w : weights) {
        if (w != 0) ++counts[std::round(w * 1e9) / 1e9];
    }
    return counts;
}

TEST(MeshStencil, WeightsMakeEveryPointOfTheFinerMeshFromItsNeighbours) {
    for (const MeshScheme scheme : test::allSchemes()) {
        for (const test::NamedMesh& named : test::zooFor(scheme)) {
            SCOPED_TRACE(nameOf(scheme) + " on " + named.name);
            const Mesh fine = finer(named.mesh, scheme, 1);
            for (const MeshElement element : elements) {
                if (!hasStencil(scheme, element)) continue;
                const std::size_t first = firstOf(named.mesh, scheme, element);
                const std::size_t count = elementCount(named.mesh, element);
                // Of the larger ones every seventh, so that all remainders of rings come up.
                for (std::size_t i = 0; i < count; i += count > 60 ? 7 : 1) {
                    const auto made = stencil(named.mesh, scheme, element, i);
                    ASSERT_TRUE(made.ok()) << made.error().message;
                    expectMakes(*made, named.mesh, fine.points()[first + i]);
                }
            }
        }
    }
}

TEST(MeshStencil, CatmullClarkHasTheWeightsOfTextbooks) {
    const Mesh mesh = test::gridMesh(2, 2);
    const auto scheme = MeshScheme::catmullClark;
    EXPECT_EQ(histogram(weightsOf(mesh, scheme, MeshElement::face, 0)),
              (std::map<double, int>{{0.25, 4}}));
    EXPECT_EQ(histogram(weightsOf(mesh, scheme, MeshElement::edge, edgeOf(mesh, 4, 5))),
              (std::map<double, int>{{0.0625, 4}, {0.375, 2}}));
    EXPECT_EQ(histogram(weightsOf(mesh, scheme, MeshElement::vertex, 4)),
              (std::map<double, int>{{0.015625, 4}, {0.09375, 4}, {0.5625, 1}}));
    EXPECT_EQ(histogram(weightsOf(mesh, scheme, MeshElement::vertex, 1)),
              (std::map<double, int>{{0.125, 2}, {0.75, 1}}));
}

TEST(MeshStencil, LoopAndButterflyHaveTheWeightsOfTextbooks) {
    const Mesh mesh = test::triangleGrid(5, 5);  // the vertex 21 is inside, with valence 6
    const std::size_t edge = edgeOf(mesh, 14, 21);
    EXPECT_EQ(histogram(weightsOf(mesh, MeshScheme::loop, MeshElement::edge, edge)),
              (std::map<double, int>{{0.125, 2}, {0.375, 2}}));
    EXPECT_EQ(histogram(weightsOf(mesh, MeshScheme::loop, MeshElement::vertex, 21)),
              (std::map<double, int>{{0.0625, 6}, {0.625, 1}}));
    EXPECT_EQ(histogram(weightsOf(mesh, MeshScheme::butterfly, MeshElement::edge, edge)),
              (std::map<double, int>{{-0.0625, 4}, {0.125, 2}, {0.5, 2}}));
    EXPECT_EQ(histogram(weightsOf(mesh, MeshScheme::butterfly, MeshElement::vertex, 21)),
              (std::map<double, int>{{1, 1}}));
}

TEST(MeshStencil, CreasesChangeTheWeightsOnThem) {
    const Mesh mesh = test::gridMesh(4, 4);
    const Mesh sharp = *mesh.withCreases({{11, 12, 1}, {12, 13, 1}});
    EXPECT_EQ(histogram(weightsOf(sharp, MeshScheme::catmullClark, MeshElement::vertex, 12)),
              (std::map<double, int>{{0.125, 2}, {0.75, 1}}));
    EXPECT_EQ(histogram(weightsOf(sharp, MeshScheme::catmullClark, MeshElement::edge,
                                  edgeOf(sharp, 11, 12))),
              (std::map<double, int>{{0.5, 2}}));
}

TEST(MeshStencil, LeavesVerticesWithoutFacesAlone) {
    const Mesh mesh = *test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}});
    const auto made = stencil(mesh, MeshScheme::loop, MeshElement::vertex, 3);
    ASSERT_TRUE(made.ok());
    expectMakes(*made, mesh, {5, 5, 5});
}

TEST(MeshStencil, RefusesWhatThereIsNot) {
    const Mesh cube = test::cubeMesh();
    const auto code = [](const Result<MeshStencil>& made) {
        return std::string(codeName(made.error().code)) + " " + made.error().path;
    };
    EXPECT_EQ(code(stencil(cube, MeshScheme::dooSabin, MeshElement::vertex, 0)), "NOT_SUPPORTED of");
    EXPECT_EQ(code(stencil(cube, MeshScheme::catmullClark, MeshElement::corner, 0)),
              "NOT_SUPPORTED of");
    EXPECT_EQ(code(stencil(cube, MeshScheme::catmullClark, MeshElement::edge, 12)),
              "OUT_OF_RANGE index");
    EXPECT_EQ(code(stencil(cube, MeshScheme::loop, MeshElement::edge, 0)), "NOT_SUPPORTED faces[0]");
    EXPECT_EQ(code(stencil(test::fanMesh(500), MeshScheme::loop, MeshElement::vertex, 0)),
              "TOO_LARGE index");
}

}  // namespace
}  // namespace knotwork
