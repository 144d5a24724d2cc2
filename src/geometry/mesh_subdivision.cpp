#include "geometry/mesh_subdivision.hpp"

#include "geometry/mesh_schemes.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

// ---- How large a finer mesh is -----------------------------------------------------------------

struct Sizes {
    std::uint64_t vertices = 0;
    std::uint64_t edges = 0;
    std::uint64_t faces = 0;
    std::uint64_t corners = 0;
    std::uint64_t boundary = 0;
};

Sizes sizesOf(const Mesh& mesh) {
    const MeshCounts counts = mesh.counts();
    return {counts.vertices, counts.edges, counts.faces, mesh.corners().size(),
            counts.boundaryEdges};
}

/// The laws of the schemes, for level 1, 2, …. Of Doo–Sabin's faces only the sum of their corners
/// matters.
Sizes finer(const Sizes& s, MeshScheme scheme, int level) noexcept {
    switch (scheme) {
        case MeshScheme::catmullClark:
            return {s.vertices + s.edges + s.faces, 2 * s.edges + s.corners, s.corners,
                    4 * s.corners, 2 * s.boundary};
        case MeshScheme::dooSabin:
            return {s.corners + 2 * s.boundary, 2 * s.corners + 3 * s.boundary,
                    s.faces + s.edges + s.vertices, 4 * (s.corners + s.boundary), 2 * s.boundary};
        case MeshScheme::loop:
        case MeshScheme::butterfly:
            return {s.vertices + s.edges, 2 * s.edges + 3 * s.faces, 4 * s.faces, 4 * s.corners,
                    2 * s.boundary};
        case MeshScheme::sqrt3: break;
    }
    const bool cuts = level % 2 == 0;
    const std::uint64_t boundary = cuts ? 3 * s.boundary : s.boundary;
    return {s.vertices + s.faces + (cuts ? s.boundary : 0), (9 * s.faces + boundary) / 2,
            3 * s.faces, 3 * s.corners, boundary};
}

std::optional<Error> checkSize(const Mesh& mesh, MeshScheme scheme, int levels) {
    Sizes sizes = sizesOf(mesh);
    for (int level = 1; level <= levels; ++level) {
        sizes = finer(sizes, scheme, level);
        if (sizes.vertices <= maxMeshVertices && sizes.corners <= maxMeshCorners) continue;
        return refuse(Code::tooLarge, "levels",
                      "After " + std::to_string(level) + " of " + std::to_string(levels) +
                          " levels the mesh would have " + std::to_string(sizes.vertices) +
                          " vertices; it can have " + std::to_string(maxMeshVertices) +
                          ". Take fewer levels.");
    }
    return std::nullopt;
}

// ---- Which meshes ------------------------------------------------------------------------------

Error notATriangle(const FaceRows& faces, MeshScheme scheme) {
    std::size_t f = 0;
    while (faces[f].size() == 3) ++f;
    return refuse(Code::notSupported, indexed("faces", f),
                  "The face has " + std::to_string(faces[f].size()) + " vertices; " +
                      std::string(meshSchemeNames[static_cast<std::size_t>(scheme)]) +
                      " works on triangles. Cut it into triangles, or take catmull-clark or "
                      "doo-sabin.");
}

/// Two triangles back to back would have three edges between the same two vertices one level finer.
std::optional<Error> checkBacks(const Mesh& mesh) {
    const auto edges = mesh.edges();
    const auto numbers = mesh.cornerEdges();
    const auto beyond = [&](std::size_t f, std::size_t k) {
        const MeshEdge& edge = edges[numbers[3 * f + k]];
        return edge.f0 == f ? edge.f1 : edge.f0;
    };
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        const std::uint32_t other = beyond(f, 0);
        if (other == noFace || beyond(f, 1) != other) continue;
        return refuse(Code::notSupported, indexed("faces", f),
                      "The triangles " + std::to_string(f) + " and " + std::to_string(other) +
                          " have the same vertices; leave out one of them.");
    }
    return std::nullopt;
}

std::optional<Error> checkCreases(const Mesh& mesh, MeshScheme scheme) {
    const bool knows = scheme == MeshScheme::catmullClark || scheme == MeshScheme::loop;
    if (knows || mesh.creases().empty()) return std::nullopt;
    return refuse(Code::notSupported, "scheme",
                  std::string(meshSchemeNames[static_cast<std::size_t>(scheme)]) +
                      " has no rules for creases. Take catmull-clark or loop, or a mesh without "
                      "creases.");
}

std::optional<Error> checkFaces(const Mesh& mesh, MeshScheme scheme) {
    if (classification(scheme).mesh == "any") return std::nullopt;
    if (mesh.uniformSize() != 3) return notATriangle(mesh.faces(), scheme);
    return checkBacks(mesh);
}

}  // namespace

std::optional<MeshScheme> meshSchemeNamed(std::string_view name) noexcept {
    const auto found = std::find(meshSchemeNames.begin(), meshSchemeNames.end(), name);
    if (found == meshSchemeNames.end()) return std::nullopt;
    return static_cast<MeshScheme>(found - meshSchemeNames.begin());
}

MeshClassification classification(MeshScheme scheme) noexcept {
    switch (scheme) {
        case MeshScheme::catmullClark: return {true, "C2", "C1", "any"};
        case MeshScheme::dooSabin: return {true, "C1", "C1", "any"};
        case MeshScheme::loop: return {true, "C2", "C1", "triangles"};
        case MeshScheme::butterfly: return {false, "C1", "C1", "triangles"};
        case MeshScheme::sqrt3: break;
    }
    return {true, "C2", "C1", "triangles"};
}

std::optional<Error> checkMeshFor(const Mesh& mesh, MeshScheme scheme, int levels) {
    if (auto wrong = checkFaces(mesh, scheme)) return wrong;
    return checkSize(mesh, scheme, levels);
}

Result<Mesh> subdivide(const Mesh& mesh, MeshScheme scheme, int levels) {
    if (levels < 0) {
        return refuse(Code::outOfRange, "levels",
                      std::to_string(levels) + " levels; there are 0 or more.");
    }
    if (auto wrong = checkMeshFor(mesh, scheme, levels)) return *std::move(wrong);
    if (auto wrong = checkCreases(mesh, scheme)) return *std::move(wrong);
    if (levels == 0) return mesh;
    switch (scheme) {
        case MeshScheme::catmullClark: return subdivideCatmullClark(mesh, levels);
        case MeshScheme::dooSabin: return subdivideDooSabin(mesh, levels);
        case MeshScheme::loop: return subdivideLoop(mesh, levels);
        case MeshScheme::butterfly: return subdivideButterfly(mesh, levels);
        case MeshScheme::sqrt3: break;
    }
    return subdivideSqrt3(mesh, levels);
}

}  // namespace knotwork
