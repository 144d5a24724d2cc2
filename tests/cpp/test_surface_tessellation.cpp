#include "geometry/surface_tessellation.hpp"

#include "support/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace knotwork {
namespace {

using test::model;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

Vec3 vertexOf(const std::vector<double>& xyz, std::uint32_t i) {
    return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
}

/// The largest distance of the surface's points from the triangles, at equal parameters. Vertices at
/// a seam count as those of its end where the triangle needs them there.
double farthest(const Surface& surface, const SurfaceTriangles& mesh) {
    const Rectangle whole = domain(surface);
    double largest = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        std::array<double, 3> u;
        std::array<double, 3> v;
        std::array<Vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            u[c] = mesh.parameters[2 * mesh.triangles[k + c]];
            v[c] = mesh.parameters[2 * mesh.triangles[k + c] + 1];
            p[c] = vertexOf(mesh.positions, mesh.triangles[k + c]);
        }
        const auto unwrap = [](std::array<double, 3>& t, const Interval& along, bool closed) {
            const double most = *std::max_element(t.begin(), t.end());
            for (double& one : t) {
                if (closed && most - one > along.length() / 2) one += along.length();
            }
        };
        unwrap(u, whole.u, closedDirections(surface).u);
        unwrap(v, whole.v, closedDirections(surface).v);
        for (const auto& [a, b] : {std::pair{1.0 / 3, 1.0 / 3}, {0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5},
                                   {0.2, 0.3}}) {
            const double c = 1 - a - b;
            const Vec3 flat = a * p[0] + b * p[1] + c * p[2];
            const Vec3 point = pointAt(
                surface, {a * u[0] + b * u[1] + c * u[2], a * v[0] + b * v[1] + c * v[2]});
            largest = std::max(largest, glm::length(point - flat));
        }
    }
    return largest;
}

TEST(SurfaceTessellation, StaysWithinEveryTolerance) {
    std::vector<Surface> surfaces;
    for (const auto& description : surfaceModels()) surfaces.push_back(model(description.name));
    surfaces.push_back(test::someSurface({3, 2, Form::clamped, Form::closed}));
    surfaces.push_back(test::someSurface({5, 4, Form::open, Form::clamped, 9, 9, true}));
    for (const Surface& surface : surfaces) {
        for (const double tolerance : {1.0, 0.1, 0.01}) {
            const auto mesh = trianglesWithin(surface, tolerance);
            ASSERT_TRUE(mesh.ok());
            EXPECT_LE(farthest(surface, *mesh), tolerance * (1 + 1e-9))
                << surface.kind().index() << ' ' << tolerance;
        }
    }
}

TEST(SurfaceTessellation, HasNoCracksAndNoSeams) {
    const Surface bumpy = test::someSurface({3, 3, Form::closed, Form::closed, 8, 8});
    for (const Surface& surface : {bumpy, Surface(model("torus"))}) {
        const auto mesh = trianglesWithin(surface, 0.02);
        std::map<Edge, int> edges;
        for (std::size_t k = 0; k < mesh->triangles.size(); k += 3) {
            for (std::size_t c = 0; c < 3; ++c) {
                ++edges[{mesh->triangles[k + c], mesh->triangles[k + (c + 1) % 3]}];
            }
        }
        for (const auto& [edge, times] : edges) {
            ASSERT_EQ(times, 1);
            ASSERT_TRUE(edges.contains({edge.second, edge.first}));
        }
        const std::size_t vertices = mesh->positions.size() / 3;
        EXPECT_EQ(vertices + mesh->triangles.size() / 3, edges.size() / 2);  // a torus
    }
}

TEST(SurfaceTessellation, IsFinerWhereItIsMoreCurved) {
    const Surface shell = model("seashell", {{"growth", 4}});
    const auto mesh = trianglesWithin(shell, 0.01);
    const double end = domain(shell).u.end;
    std::size_t small = 0;
    std::size_t large = 0;
    for (std::size_t k = 0; k < mesh->parameters.size(); k += 2) {
        ++(mesh->parameters[k] < end / 2 ? small : large);
    }
    EXPECT_GT(large, 3 * small);
}

TEST(SurfaceTessellation, APlaneIsTwoTriangles) {
    EXPECT_EQ(trianglesWithin(model("plane"), 1e-9)->triangles.size(), 6u);
}

TEST(SurfaceTessellation, OfAPrismIsCutAtItsEdges) {
    const Surface prism =
        BsplineSurface::make(KnotVector::uniform(1, 3, Form::closed).value(),
                             KnotVector::uniform(1, 2, Form::clamped).value(),
                             {{1, 0, 0}, {1, 0, 2}, {0, 1, 0}, {0, 1, 2}, {-1, -1, 0}, {-1, -1, 2}})
            .value();
    const auto triangles = trianglesWithin(prism, 1e-9);
    ASSERT_TRUE(triangles.ok());
    EXPECT_LE(farthest(prism, *triangles), 1e-14);
    EXPECT_LE(triangles->triangles.size(), 3 * 64u);
}

TEST(SurfaceTessellation, TakesAsManyTrianglesAsTheToleranceAsksFor) {
    const Surface torus = model("torus");
    const auto coarse = trianglesWithin(torus, 0.01)->triangles.size();
    const auto fine = trianglesWithin(torus, 0.01 / 16)->triangles.size();
    EXPECT_NEAR(static_cast<double>(fine) / static_cast<double>(coarse), 16, 6);
    EXPECT_LT(coarse, 3u * 8000);
}

TEST(SurfaceTessellation, RefusesAToleranceThatNothingFits) {
    const auto mesh = trianglesWithin(model("torus", {{"R", 1e6}}), 1e-9);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().code, Code::tooLarge);
    EXPECT_EQ(mesh.error().path, "tolerance");
}

TEST(SurfaceTessellation, ManyTurnsBeginAsOneCellAndComeOutWell) {
    const Surface helicoid = model("helicoid", {{"turns", 200}, {"pitch", 0.1}});
    const auto mesh = trianglesWithin(helicoid, 0.1);
    ASSERT_TRUE(mesh.ok());
    EXPECT_LE(farthest(helicoid, *mesh), 0.1 * (1 + 1e-9));
}

TEST(SurfaceTessellation, IsolinesLieOnTheSurfaceAndWithinTheTolerance) {
    const Surface torus = model("torus");
    const auto points = isolinePoints(torus, {true, 0}, 9);
    ASSERT_EQ(points.size(), 27u);
    EXPECT_EQ(vertexOf(points, 0), vertexOf(points, 8));
    EXPECT_NEAR(points[6], 0, 1e-15);  // a quarter round
    EXPECT_NEAR(points[7], 3, 1e-15);
    const auto within = isolineWithin(torus, {true, 0}, 0.001);
    const auto count = static_cast<std::uint32_t>(within->size() / 3);
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
        const Vec3 middle = (vertexOf(*within, i) + vertexOf(*within, i + 1)) / 2.0;
        EXPECT_GE(glm::length(middle), 3 - 0.001);
    }
    EXPECT_LE(count, 300u);
    EXPECT_EQ(isolineWithin(model("plane"), {false, 0.5}, 1)->size(), 6u);
}

}  // namespace
}  // namespace knotwork
