#include "render/surface_vertices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace knotwork::render {
namespace {

drawing::Shape threeTriangles() {
    drawing::Shape shape;
    shape.kind = drawing::Kind::triangles;
    for (const double z : {5.0, 1.0, 3.0}) {
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) {
            shape.positions.insert(shape.positions.end(), {x, y, z});
            shape.normals.insert(shape.normals.end(), {0, 0, 1});
        }
    }
    shape.indices.resize(9);
    std::iota(shape.indices.begin(), shape.indices.end(), 0U);
    return shape;
}

TEST(SurfaceVertices, PositionsAreTakenFromTheOriginBeforeTheyAreRounded) {
    drawing::Shape shape = threeTriangles();
    for (double& p : shape.positions) p += 1e9;
    std::vector<SurfaceVertex> vertices;
    packSurface(shape, Vec3(1e9), vertices);
    ASSERT_EQ(vertices.size(), 9U);
    EXPECT_EQ(vertices[1].position, (std::array<float, 3>{1, 0, 5}));
    EXPECT_EQ(vertices[1].normal[2], 32767);
    EXPECT_EQ(vertices[1].colour, (ColourBytes{255, 255, 255, 255}));
}

TEST(SurfaceVertices, ColoursGoAlongWhereThereIsOneForEachPosition) {
    drawing::Shape shape = threeTriangles();
    shape.colours.assign(9, ColourBytes{1, 2, 3, 4});
    std::vector<SurfaceVertex> vertices;
    packSurface(shape, Vec3(0.0), vertices);
    EXPECT_EQ(vertices[8].colour, (ColourBytes{1, 2, 3, 4}));
}

TEST(SurfaceVertices, FarTrianglesComeFirst) {
    const drawing::Shape shape = threeTriangles();
    DepthOrder order;
    order.sort(shape, Vec3(0, 0, 1), depthRange(shape.positions, Vec3(0, 0, 1)), 1);
    const std::vector<std::uint32_t> wanted{3, 4, 5, 6, 7, 8, 0, 1, 2};
    EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), order.indices().begin(),
                           order.indices().end()));
    order.sort(shape, Vec3(0, 0, -1), depthRange(shape.positions, Vec3(0, 0, -1)), 1);
    EXPECT_EQ(order.indices().front(), 0U);
}

TEST(SurfaceVertices, SlabsPartTheTrianglesWithoutLosingOne) {
    const drawing::Shape shape = threeTriangles();
    DepthOrder order;
    order.sort(shape, Vec3(0, 0, 1), {0, 6}, 3);
    EXPECT_EQ((std::vector<std::size_t>(order.starts().begin(), order.starts().end())),
              (std::vector<std::size_t>{0, 3, 6, 9}));
}

TEST(SurfaceVertices, ASurfaceAcrossTheViewIsSortedWithoutDividingByItsDepth) {
    drawing::Shape shape = threeTriangles();
    for (std::size_t i = 2; i < shape.positions.size(); i += 3) shape.positions[i] = 0;
    DepthOrder order;
    order.sort(shape, Vec3(0, 0, 1), depthRange(shape.positions, Vec3(0, 0, 1)), 1);
    EXPECT_TRUE(std::equal(shape.indices.begin(), shape.indices.end(), order.indices().begin()));
}

TEST(SurfaceVertices, AFingerprintTellsAnyChangeOfTriangles) {
    std::vector<std::uint32_t> indices(1003);
    std::iota(indices.begin(), indices.end(), 0U);
    const std::uint64_t before = fingerprint(indices);
    EXPECT_EQ(fingerprint(indices), before);
    for (const std::size_t i : {0U, 7U, 500U, 1002U}) {
        std::vector<std::uint32_t> other = indices;
        other[i] ^= 1U;
        EXPECT_NE(fingerprint(other), before) << i;
    }
    std::swap(indices[4], indices[6]);
    EXPECT_NE(fingerprint(indices), before);
    EXPECT_NE(fingerprint(std::span(indices).first(1002)), fingerprint(indices));
}

}  // namespace
}  // namespace knotwork::render
