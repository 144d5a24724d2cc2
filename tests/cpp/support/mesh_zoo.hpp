// Meshes of every sort for the schemes of subdivision.
#pragma once

#include "geometry/mesh_subdivision.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace knotwork::test {

struct NamedMesh {
    std::string name;
    Mesh mesh;
};

inline std::vector<MeshScheme> allSchemes() {
    return {MeshScheme::catmullClark, MeshScheme::dooSabin, MeshScheme::loop, MeshScheme::butterfly,
            MeshScheme::sqrt3};
}

inline std::string nameOf(MeshScheme scheme) {
    return std::string(meshSchemeNames[static_cast<std::size_t>(scheme)]);
}

/// With other points than those at which nothing can go wrong; its faces are all alike.
inline Mesh shaken(const Mesh& mesh, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> noise(-0.3, 0.3);
    std::vector<Vec3> points;
    for (const Vec3& p : mesh.points()) {
        points.push_back(p + Vec3{noise(engine), noise(engine), noise(engine)});
    }
    return Mesh::trusted(std::move(points), {mesh.corners().begin(), mesh.corners().end()},
                         mesh.uniformSize());
}

/// Two fans of `blades` triangles each, tip to tip in the vertex 0.
inline Mesh doubleCone(std::uint32_t blades) {
    std::vector<Vec3> points{{0, 0, 0}};
    FaceLists faces;
    for (const double side : {1.0, -1.0}) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (std::uint32_t i = 0; i < blades; ++i) {
            const double angle = 6.28 * i / blades;
            points.emplace_back(std::cos(angle), side * std::sin(angle), side);
            faces.push_back({0, first + i, first + (i + 1) % blades});
        }
    }
    return *meshOf(std::move(points), faces);
}

/// Two triangles back to back: every vertex is inside and has two faces.
inline Mesh pillowMesh() {
    return *meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
}

inline Mesh octahedronMesh() {
    return *meshOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

/// A closed fan of `blades` triangles with another ring of triangles around it: the centre is
/// inside, its neighbours too.
inline Mesh rosette(std::uint32_t blades) {
    std::vector<Vec3> points{{0.1, -0.05, 1.2}};
    FaceLists faces;
    for (const double radius : {1.0, 2.0}) {
        for (std::uint32_t i = 0; i < blades; ++i) {
            const double angle = 6.283185307179586 * (i + (radius - 1) / 2) / blades;
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                1 / radius + 0.1 * std::sin(3 * angle));
        }
    }
    for (std::uint32_t i = 0; i < blades; ++i) {
        const std::uint32_t a = 1 + i;
        const std::uint32_t b = 1 + (i + 1) % blades;
        const std::uint32_t c = blades + a;
        const std::uint32_t d = blades + b;
        faces.insert(faces.end(), {{0, a, b}, {a, c, b}, {b, c, d}});
    }
    return *meshOf(std::move(points), faces);
}

/// An open fan of `blades` triangles around the vertex 0 on the boundary.
inline Mesh openFan(std::uint32_t blades) {
    std::vector<Vec3> points{{0.05, -0.1, 0.1}};
    FaceLists faces;
    for (std::uint32_t i = 0; i <= blades; ++i) {
        const double angle = 0.2 + 2.7 * i / blades;
        points.emplace_back(std::cos(angle), std::sin(angle), 0.2 * std::cos(2 * angle));
        if (i > 0) faces.push_back({0, i, i + 1});
    }
    return *meshOf(std::move(points), faces);
}

/// The fan of quads around the vertex 0: of the triangles 0, a, b the corner at 0.
inline Mesh quadFan(const Mesh& triangles) {
    const Mesh quads = *subdivide(triangles, MeshScheme::catmullClark, 1);
    Corners corners;
    for (std::size_t f = 0; f < quads.faces().count(); ++f) {
        const auto face = quads.faces()[f];
        if (face[0] == 0) corners.insert(corners.end(), face.begin(), face.end());
    }
    std::vector<Vec3> points(quads.points().begin(), quads.points().end());
    return *Mesh::make(std::move(points), std::move(corners), 4);
}

inline std::vector<NamedMesh> triangleZoo() {
    std::vector<NamedMesh> zoo;
    const auto add = [&](std::string name, const Mesh& mesh) {
        zoo.push_back({std::move(name), shaken(mesh, 7)});
    };
    add("tetrahedron", tetrahedronMesh());
    add("octahedron", octahedronMesh());
    add("grid", triangleGrid(5, 4));
    add("one triangle", openFan(1));
    add("cones", doubleCone(4));
    add("scanned", scannedMesh(9, 12, 3));
    for (std::uint32_t n = 3; n <= 12; ++n) {
        add("rosette " + std::to_string(n), rosette(n));
        add("open fan " + std::to_string(n), openFan(n - 1));
    }
    return zoo;
}

inline std::vector<NamedMesh> polygonZoo() {
    std::vector<NamedMesh> zoo;
    zoo.push_back({"cube", shaken(cubeMesh(), 7)});
    zoo.push_back({"grid of quads", shaken(gridMesh(4, 3), 7)});
    zoo.push_back({"house", *meshOf({{0, 0, 0}, {2, 0.1, 0}, {2, 2, 0.3}, {0, 2, 0}, {0, 0, 2},
                                     {2, 0, 2.2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 3}, {1, 2, 3.5}},
                                    {{0, 3, 2, 1}, {0, 1, 5, 8, 4}, {2, 3, 7, 9, 6}, {1, 2, 6, 5},
                                     {3, 0, 4, 7}, {5, 6, 9, 8}, {7, 4, 8}, {7, 8, 9}})});
    zoo.push_back({"open house", *meshOf({{0, 0, 0}, {2, 0.1, 0}, {2, 2, 0.3}, {0, 2, 0}, {0, 0, 2},
                                          {2, 0, 2.2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 3}, {5, 5, 5}},
                                         {{0, 3, 2, 1}, {0, 1, 5, 8, 4}, {1, 2, 6, 5}})});
    zoo.push_back({"pillow", shaken(pillowMesh(), 7)});
    zoo.push_back({"bow tie", *meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {-1, 0, 0}, {0, -1, 0.5},
                                       {-1, -1, 0}},
                                      {{0, 1, 2}, {0, 3, 5, 4}})});
    zoo.push_back({"septagon", *meshOf({{2, 0, 0}, {1, 1, 0}, {0, 2, 1}, {-1, 1, 0}, {-2, 0, 0},
                                        {-1, -2, 1}, {1, -1, 0}},
                                       {{0, 1, 2, 3, 4, 5, 6}})});
    return zoo;
}

/// What the scheme works on.
inline std::vector<NamedMesh> zooFor(MeshScheme scheme) {
    std::vector<NamedMesh> zoo = triangleZoo();
    if (classification(scheme).mesh == "any") {
        for (NamedMesh& mesh : polygonZoo()) zoo.push_back(std::move(mesh));
    }
    return zoo;
}

inline Mesh finer(const Mesh& mesh, MeshScheme scheme, int levels) {
    return *subdivide(mesh, scheme, levels);
}

}  // namespace knotwork::test
