// The trace of Catmull–Clark ends with the mesh that the library makes.
#include "support/traces.hpp"

#include "geometry/mesh_subdivision.hpp"
#include "scene/mesh_specs.hpp"
#include "support/mesh_zoo.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

Json argumentsFor(const Mesh& mesh, int levels) {
    return {{"algorithm", "catmull-clark"}, {"mesh", specOf(mesh)}, {"levels", levels}};
}

TEST(TraceCatmullClark, EndsWithTheFinerMeshAndItsEdges) {
    for (const auto& [name, mesh] : test::zooFor(MeshScheme::catmullClark)) {
        if (name == "scanned") continue;
        const Trace trace = traced(argumentsFor(mesh, 2));
        expectReadable(trace);
        ASSERT_EQ(trace.frames.size(), 9U) << name;
        const Mesh finer = test::finer(mesh, MeshScheme::catmullClark, 2);
        const TraceFrame& last = trace.frames.back();
        EXPECT_TRUE(std::equal(last.points.begin(), last.points.end(), finer.points().begin(),
                               finer.points().end())) << name;
        EXPECT_EQ(last.edges.size(), finer.edges().size()) << name;
    }
}

TEST(TraceCatmullClark, MarksWhatEachStepMakes) {
    const Trace trace = traced(R"({"algorithm":"catmull-clark","mesh":{"solid":"cube"}})");
    const Mesh finer = test::finer(test::cubeMesh(), MeshScheme::catmullClark, 1);
    ASSERT_EQ(trace.frames.size(), 5U);
    const std::vector<std::size_t> made{0, 6, 12, 8, 0};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(trace.frames[i].marked.size(), made[i]) << i;
    EXPECT_EQ(trace.frames[1].points.size(), 14U);
    EXPECT_EQ(trace.frames[2].points.size(), 26U);
    EXPECT_EQ(trace.frames[2].edges.size(), 12U + 24U);
    EXPECT_EQ(trace.frames[3].points.size(), 16U);
    EXPECT_EQ(trace.frames[4].points.size(), finer.points().size());
}

TEST(TraceCatmullClark, HasTheWeightsOfEveryStepAndLevel) {
    const Trace trace = traced(R"({"algorithm":"catmull-clark","mesh":{"solid":"cube"}})");
    EXPECT_EQ(trace.frames[1].weights, (std::vector<double>{0.25, 0.25, 0.25, 0.25}));
    EXPECT_EQ(trace.frames[2].weights, (std::vector<double>{0.25, 0.25, 0.25, 0.25}));
    EXPECT_EQ(trace.frames[3].weights, (std::vector<double>{1.0 / 3, 2.0 / 3, 0}));
    const auto& matrix = trace.frames[4].matrix;
    ASSERT_EQ(matrix.size(), 26U);
    const auto& points = trace.frames[0].points;
    for (std::size_t row = 0; row < matrix.size(); ++row) {
        ASSERT_EQ(matrix[row].size(), 8U);
        Vec3 sum{0};
        for (std::size_t i = 0; i < 8; ++i) sum += matrix[row][i] * points[i];
        EXPECT_LE(distance(sum, trace.frames[4].points[row]), test::gates::exact) << row;
    }
}

TEST(TraceCatmullClark, SaysWhatHappensToTheFirstVertex) {
    const Trace trace = traced(
        R"({"algorithm":"catmull-clark","mesh":{"vertices":)"
        R"([[1,1,1],[1,-1,-1],[-1,1,-1],[-1,-1,1]],)"
        R"("faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]]}})");
    EXPECT_EQ(trace.frames[0].text,
              "The mesh has 4 vertices, 6 edges and 4 faces; every level puts a point on each face "
              "and on each edge, moves the vertices, and joins all of them to quads.");
    EXPECT_EQ(trace.frames[1].text,
              "Face points at level 1: each is the mean of the vertices of its face, which makes 4 "
              "of them; the first one is (0.3333, 0.3333, -0.3333).");
    EXPECT_NE(trace.frames[3].text.find("from (1, 1, 1) to (0.2593, 0.2593, 0.2593)."),
              std::string::npos) << trace.frames[3].text;
    EXPECT_EQ(trace.frames[4].text, "After level 1 of 1 the mesh has 14 vertices, 24 edges and 12 "
                                    "faces, and all of them are quads.");
}

TEST(TraceCatmullClark, RefusesWhatIsNoMeshAndWhatIsTooLarge) {
    expectRefused(R"({"algorithm":"catmull-clark"})", Code::wrongType, "mesh");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":5})", Code::wrongType, "mesh");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":{"solid":"egg"}})", Code::unknownName,
                  "mesh.solid");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":{"solid":"cube"},"level":1})",
                  Code::unknownField, "level");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":{"solid":"cube"},"levels":-1})",
                  Code::outOfRange, "levels");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":{"solid":"cube"},"levels":8})",
                  Code::tooLarge, "levels");
    expectRefused(R"({"algorithm":"catmull-clark","mesh":{"vertices":[[0,0],[1,0],[0,1]],)"
                  R"("faces":[[0,1,5]]}})",
                  Code::outOfRange, "mesh.faces[0][2]");
}

}  // namespace
}  // namespace knotwork::scene
