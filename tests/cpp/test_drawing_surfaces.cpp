#include "drawing/drawing_cache.hpp"

#include "support/drawings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace knotwork::drawing {
namespace {

using namespace test;

const char* const torus = R"({"type": "parametric-surface", "name": "torus",
    "parameters": {"R": 2, "r": 1}, "show": {"wireframe": true}})";

Vec3 normalAt(const Shape& shape, std::size_t i) {
    return {shape.normals[3 * i], shape.normals[3 * i + 1], shape.normals[3 * i + 2]};
}

/// The distance from a point to the torus with radii 2 and 1.
double fromTorus(const Vec3& p) {
    return std::abs(std::hypot(std::hypot(p.x, p.y) - 2, p.z) - 1);
}

void expectSoundTriangles(const Shape& shape) {
    ASSERT_EQ(shape.kind, Kind::triangles);
    ASSERT_EQ(shape.positions.size(), shape.normals.size());
    ASSERT_EQ(shape.indices.size() % 3, 0U);
    for (const std::uint32_t i : shape.indices) ASSERT_LT(i, shape.positions.size() / 3);
    for (std::size_t i = 0; i < shape.positions.size() / 3; ++i) {
        EXPECT_NEAR(glm::length(normalAt(shape, i)), 1, 1e-12);
    }
}

/// How many triangles turn away from the mean of their normals.
std::size_t turnedAway(const Shape& shape) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const auto* corner = &shape.indices[i];
        const Vec3 a = positionIn(shape, corner[0]);
        const Vec3 area =
            glm::cross(positionIn(shape, corner[1]) - a, positionIn(shape, corner[2]) - a);
        const Vec3 mean =
            normalAt(shape, corner[0]) + normalAt(shape, corner[1]) + normalAt(shape, corner[2]);
        if (glm::dot(area, mean) < -1e-15) ++count;
    }
    return count;
}

TEST(DrawnSurfaces, TrianglesStayWithinTheToleranceWhereTheGridMayBeFineEnough) {
    std::size_t former = 0;
    for (const double tolerance : {1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-6}) {
        const Drawing drawing = drawn({torus}, tolerance);
        const Shape& shape = *withRole(drawing, Role::surface).at(0);
        expectSoundTriangles(shape);
        EXPECT_EQ(turnedAway(shape), 0U);
        EXPECT_GE(shape.indices.size(), former);
        EXPECT_LE(shape.indices.size(), 6 * 60'000U);
        former = shape.indices.size();
        if (tolerance < 1e-3) continue;
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const Vec3 middle = (positionIn(shape, shape.indices[i]) +
                                 positionIn(shape, shape.indices[i + 1]) +
                                 positionIn(shape, shape.indices[i + 2])) / 3.0;
            ASSERT_LE(fromTorus(middle), tolerance);
        }
    }
}

TEST(DrawnSurfaces, NormalsPointOutwardAndGoAlongWithWhatPlacesThem) {
    const auto expectOutward = [](const Drawing& drawing) {
        const Shape& shape = *withRole(drawing, Role::surface).at(0);
        const Vec3 centre = (drawing.bounds.min + drawing.bounds.max) * 0.5;
        expectSoundTriangles(shape);
        EXPECT_EQ(turnedAway(shape), 0U);
        for (std::size_t i = 0; i < shape.positions.size() / 3; ++i) {
            ASSERT_GT(glm::dot(normalAt(shape, i), positionIn(shape, i) - centre), 0);
        }
    };
    const char* const sphere =
        R"({"type": "parametric-surface", "name": "sphere", "show": {"isolines": false}})";
    expectOutward(drawn({sphere}, 0.01));
    expectOutward(drawn({sphere}, 0.01,
                        R"({"target": "c1", "kind": "rotate", "axis": [1, 2, 3], "angle": 2})", 0.5));
}

TEST(DrawnSurfaces, ATurnedSurfaceIsTheSurfaceTurned) {
    const char* const turn =
        R"({"target": "c1", "kind": "rotate", "axis": [0, 0, 1], "angle": 1.5707963267948966})";
    const Drawing rest = drawn({torus}, 0.05);
    const Drawing turned = drawn({torus}, 0.05, turn, 0.5);
    ASSERT_EQ(rest.shapes.size(), turned.shapes.size());
    const Shape& a = *withRole(rest, Role::surface).at(0);
    const Shape& b = *withRole(turned, Role::surface).at(0);
    for (std::size_t i = 0; i < a.positions.size() / 3; ++i) {
        const Vec3 p = positionIn(a, i);
        EXPECT_LT(glm::length(positionIn(b, i) - Vec3(-p.y, p.x, p.z)), 1e-12);
        const Vec3 n = normalAt(a, i);
        EXPECT_LT(glm::length(normalAt(b, i) - Vec3(-n.y, n.x, n.z)), 1e-12);
    }
}

TEST(DrawnSurfaces, IsolinesLieOnTheSurfaceAtItsKnots) {
    const char* const uneven = R"({"type": "bspline-surface", "degree": [2, 3],
        "form": ["clamped", "clamped"], "points": [
          [[0,0,0],[0,1,1],[0,2,0],[0,3,1]], [[1,0,1],[1,1,0],[1,2,2],[1,3,0]],
          [[2,0,0],[2,1,1],[2,2,0],[2,3,1]], [[3,0,1],[3,1,0],[3,2,1],[3,3,0]]],
        "knots": [[0,0,0,0.3,1,1,1], [0,0,0,0,1,1,1,1]]})";
    const scene::Scene scene = sceneOf({uneven});
    const Surface& surface = *scene.state().objects[0]->body.surface();
    const Drawing drawing = draw(scene.state(), {.moment = {}, .tolerance = 1e-3});
    const auto lines = withRole(drawing, Role::isoline);
    ASSERT_EQ(lines.size(), 3U + 9U);  // knots 0, 0.3, 1 of u, and nine of v, which has none inside
    std::size_t atKnot = 0;
    for (const Shape* line : lines) {
        for (std::size_t i = 0; i < line->positions.size() / 3; ++i) {
            const Vec3 p = positionIn(*line, i);
            // x = 2u runs with u alone, y = 3v with v alone: both give the parameters away.
            double u = 0.5;
            for (int step = 0; step < 60; ++step) {
                const double f = pointAt(surface, {u, 0.5}).x - p.x;
                std::array<Vec3, 2> rows{};
                derivatives(surface, {u, 0.5}, {1, 0}, rows);
                u = std::clamp(u - f / rows[1].x, 0.0, 1.0);
            }
            const Vec3 there = pointAt(surface, {u, p.y / 3});
            ASSERT_LT(glm::length(there - p), 1e-9);
            if (std::abs(u - 0.3) < 1e-9) ++atKnot;
        }
    }
    EXPECT_GT(atKnot, 8U);
    for (std::size_t k = 0; k < 9; ++k) {  // those of constant v, in order
        for (std::size_t i = 0; i < lines[3 + k]->positions.size() / 3; ++i) {
            EXPECT_NEAR(positionIn(*lines[3 + k], i).y, 3.0 * static_cast<double>(k) / 8, 1e-9);
        }
    }
}

TEST(DrawnSurfaces, ASurfaceWithAnEdgeWhereNoGridHasALineKeepsItsEdge) {
    const char* const roof = R"({"type": "bspline-surface", "degree": [1, 1],
        "points": [[[0,0,0],[0,1,0]],[[1,0,1],[1,1,1]],[[4,0,0],[4,1,0]]],
        "knots": [[0,0,0.31,1,1], [0,0,1,1]]})";
    const Drawing drawing = drawn({roof}, 0.01);
    const Shape& shape = *withRole(drawing, Role::surface).at(0);
    expectSoundTriangles(shape);
    EXPECT_NEAR(drawing.bounds.max.z, 1, 1e-12);
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        bool before = false;
        bool after = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = positionIn(shape, shape.indices[i + k]).x;
            before = before || x < 1 - 1e-9;
            after = after || x > 1 + 1e-9;
        }
        EXPECT_FALSE(before && after);  // no triangle goes across the edge
    }
}

TEST(DrawnSurfaces, AWireframeOfAGridHasItsLinesAndNoDiagonals) {
    const Drawing drawing = drawn({torus}, 0.05);
    const Shape& wires = *withRole(drawing, Role::wireframe).at(0);
    const Shape& surface = *withRole(drawing, Role::surface).at(0);
    // Of a torus every cell has two edges of its own, and two triangles.
    EXPECT_EQ(wires.indices.size() / 2, surface.indices.size() / 3);
    for (std::size_t i = 0; i < wires.indices.size(); i += 2) {
        const Vec3 a = positionIn(wires, wires.indices[i]);
        const Vec3 b = positionIn(wires, wires.indices[i + 1]);
        const double turn = std::abs(std::remainder(std::atan2(a.y, a.x) - std::atan2(b.y, b.x), 2 * 3.141592653589793));
        const double tilt = std::abs(a.z - b.z) + std::abs(std::hypot(a.x, a.y) - std::hypot(b.x, b.y));
        EXPECT_LT(std::min(turn, tilt), 1e-9);  // along one parameter only
    }
}

TEST(DrawnSurfaces, TheNetOfASplineIsItsPointsRowByRow) {
    const char* const spline = R"({"type": "bspline-surface", "degree": [1, 1],
        "form": ["closed", "clamped"], "points": [
          [[0,0,0],[0,0,1]], [[1,0,0],[1,0,1]], [[0,1,0],[0,1,1]]]})";
    const Drawing drawing = drawn({spline}, 0.1);
    const auto rows = withRole(drawing, Role::points);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1]->path, "objects[0].points[1]");
    EXPECT_EQ(positionIn(*rows[1], 1), Vec3(1, 0, 1));
    const Shape& net = *withRole(drawing, Role::polygon).at(0);
    EXPECT_EQ(net.indices.size() / 2, 3U + 6U);  // three across, and two closed triangles
}

TEST(DrawnSurfaces, ABlendingSurfaceHasAHandleAndAnOutlineForEveryPatch) {
    const char* const blend = R"({"type": "blending-surface", "model": {"type": "parametric-surface",
        "name": "cylinder"}, "locals": [4, 3], "kind": "bezier", "form": ["closed", "open"],
        "bFunction": {"family": "expo-rational"},
        "poses": [{"local": [1, 2], "translate": [0, 0, 2]}], "show": {"locals": true}})";
    const Drawing drawing = drawn({blend}, 0.01);
    const Shape& handles = *withRole(drawing, Role::handle).at(0);
    EXPECT_TRUE(handles.square);
    EXPECT_EQ(handles.path, "objects[0].poses");
    ASSERT_EQ(handles.positions.size() / 3, 12U);
    EXPECT_LT(glm::length(positionIn(handles, 5) - Vec3(0, 1, 3)), 1e-12);
    EXPECT_EQ(withRole(drawing, Role::local).size(), 12U);
    EXPECT_EQ(withRole(drawing, Role::bFunction, Pane::bFunction).size(), 3U);
    const Shape& surface = *withRole(drawing, Role::surface).at(0);
    expectSoundTriangles(surface);
    EXPECT_GT(drawing.bounds.max.z, 2.9);
}

TEST(DrawnMeshes, WiresAreTheEdgesOfTheRefinedMesh) {
    const char* const solid = R"({"type": "subdivision-surface", "scheme": "catmull-clark",
        "levels": 2, "mesh": {"solid": "cube"}, "show": {"wireframe": true}})";
    const scene::Scene scene = sceneOf({solid});
    const auto& body = *scene.state().objects[0]->body.subdivision();
    const Drawing drawing = draw(scene.state(), {});
    const Shape& wires = *withRole(drawing, Role::wireframe).at(0);
    ASSERT_EQ(wires.indices.size() / 2, body.refined.edges().size());
    for (std::size_t e = 0; e < body.refined.edges().size(); ++e) {
        EXPECT_EQ(positionIn(wires, wires.indices[2 * e]),
                  body.refined.points()[body.refined.edges()[e].v0]);
        EXPECT_EQ(positionIn(wires, wires.indices[2 * e + 1]),
                  body.refined.points()[body.refined.edges()[e].v1]);
    }
    EXPECT_EQ(withRole(drawing, Role::polygon).at(0)->indices.size() / 2, 12U);
    const Shape& points = *withRole(drawing, Role::points).at(0);
    EXPECT_EQ(points.positions.size() / 3, 8U);
    EXPECT_EQ(points.path, "");  // a cube by its name has no list of vertices
    const Shape& surface = *withRole(drawing, Role::surface).at(0);
    expectSoundTriangles(surface);
    EXPECT_EQ(surface.indices.size() / 3, 2 * body.refined.faces().count());
    EXPECT_EQ(turnedAway(surface), 0U);
    for (std::size_t i = 0; i < surface.positions.size() / 3; ++i) {
        EXPECT_GT(glm::dot(normalAt(surface, i), positionIn(surface, i)), 0.8);
    }
}

TEST(DrawnMeshes, AnOpenMeshKeepsItsBoundaryAndItsLonelyVertex) {
    const char* const sheet = R"({"type": "subdivision-surface", "scheme": "catmull-clark",
        "levels": 0, "mesh": {"vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[5,5,5]],
        "faces": [[0,1,2,3]]}})";
    const Drawing drawing = drawn({sheet}, 0.1);
    EXPECT_EQ(withRole(drawing, Role::polygon).at(0)->indices.size() / 2, 4U);
    const Shape& points = *withRole(drawing, Role::points).at(0);
    EXPECT_EQ(points.path, "objects[0].mesh.vertices");
    EXPECT_EQ(points.positions.size() / 3, 5U);
    expectSoundTriangles(*withRole(drawing, Role::surface).at(0));
}

TEST(DrawnClouds, ResidualsEndOnTheFit) {
    const char* const cloud = R"({"type": "point-cloud", "points":
        [[0,0],[1,1],[2,0.5],[3,1.5],[4,0],[5,1],[6,0.2],[7,1.1]],
        "fit": {"degree": 3, "count": 5}})";
    const scene::Scene scene = sceneOf({cloud});
    const auto& body = *scene.state().objects[0]->body.cloud();
    const Drawing drawing = draw(scene.state(), {});
    const Shape& residuals = *withRole(drawing, Role::residual).at(0);
    ASSERT_EQ(residuals.positions.size() / 3, 16U);
    const Curve fit(body.fit->curve);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(positionIn(residuals, 2 * i), body.points[i]);
        EXPECT_EQ(positionIn(residuals, 2 * i + 1), pointAt(fit, body.fit->parameters[i]));
    }
    EXPECT_EQ(withRole(drawing, Role::points).at(0)->path, "objects[0].points");
    EXPECT_EQ(withRole(drawing, Role::curve).size(), 1U);
    EXPECT_EQ(withRole(drawing, Role::polygon).at(0)->positions.size() / 3, 5U);
    EXPECT_EQ(withRole(drawing, Role::basis, Pane::basis).size(), 5U);
    EXPECT_EQ(withRole(drawing, Role::knots, Pane::knots).at(0)->path, "");  // made by the fit
}

TEST(DrawingCache, AnObjectThatStaysGivesItsFormerShapes) {
    scene::Scene scene = sceneOf({
        R"({"id": "a", "type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[2,0],[3,1]]})",
        R"({"id": "b", "type": "parametric-surface", "name": "torus"})"});
    DrawingCache cache;
    cache.draw(scene.state(), {});
    EXPECT_EQ(cache.made(), (DrawingCache::Made{2, 2, 0}));
    const double* kept = withRole(cache.drawing(), Role::surface).at(0)->positions.data();
    ASSERT_TRUE(scene.execute({{"move", "objects[0].points[1]"}, {"by", {0, 1}}}).ok());
    cache.draw(scene.state(), {});
    EXPECT_EQ(cache.made(), (DrawingCache::Made{3, 2, 0}));  // the basis does not depend on points
    EXPECT_EQ(withRole(cache.drawing(), Role::surface).at(0)->positions.data(), kept);
    expectSame(cache.drawing(), draw(scene.state(), {}));
    ASSERT_TRUE(scene.execute({{"move", "objects[0].knots[3]"}, {"to", 0.7}}).ok());
    cache.draw(scene.state(), {});
    EXPECT_EQ(cache.made(), (DrawingCache::Made{4, 3, 0}));
    ASSERT_TRUE(scene.undo());
    ASSERT_TRUE(scene.undo());
    cache.draw(scene.state(), {});
    expectSame(cache.drawing(), draw(scene.state(), {}));
    cache.draw(scene.state(), {.moment = {}, .tolerance = 1e-2});
    EXPECT_EQ(cache.made().figures, 7U);
    expectSame(cache.drawing(), draw(scene.state(), {.moment = {}, .tolerance = 1e-2}));
}

TEST(DrawingCache, WhatIsOnlyCarriedOrColouredIsNotSampledAnew) {
    const scene::Scene scene = sceneOf(
        {R"({"type": "parametric-surface", "name": "torus"})"},
        R"({"target": "c1", "kind": "rotate", "axis": [0, 1, 0], "angle": 2},
           {"target": "c1", "kind": "colour", "to": "#ff0000"})");
    DrawingCache cache;
    for (const double phase : {0.0, 0.1, 0.2, 0.3, 0.5, 1.0}) {
        const Options options{.moment = {.phase = phase, .time = {}}, .tolerance = 1e-2};
        cache.draw(scene.state(), options);
        expectSame(cache.drawing(), draw(scene.state(), options));
    }
    EXPECT_EQ(cache.made(), (DrawingCache::Made{2, 1, 4}));
}

TEST(DrawingCache, ObjectsThatComeAndGoAreDrawnAtTheirNumbers) {
    scene::Scene scene = sceneOf({R"({"id": "a", "type": "line-curve", "from": [0,0], "to": [1,1]})",
                                  R"({"id": "b", "type": "line-curve", "from": [0,0], "to": [2,1]})"});
    DrawingCache cache;
    cache.draw(scene.state(), {});
    ASSERT_TRUE(scene.execute({{"remove", "objects[0]"}}).ok());
    cache.draw(scene.state(), {});
    expectSame(cache.drawing(), draw(scene.state(), {}));
    ASSERT_TRUE(scene.undo());
    cache.draw(scene.state(), {});
    expectSame(cache.drawing(), draw(scene.state(), {}));
}

}  // namespace
}  // namespace knotwork::drawing
