// Faces of any vertices, OBJ of any bytes, and solids with dents and holes: refused with a place
// and a reason, or a mesh whose edges lie in their faces, whose counts add up, which reads back
// from its own OBJ and whose finer meshes have the counts of their scheme. Creases of any edges and
// sharpness likewise: refused, or passed on to where the finer mesh has edges.
#include "fuzz/input.hpp"

#include "geometry/mesh.hpp"
#include "geometry/mesh_subdivision.hpp"
#include "geometry/solids.hpp"
#include "geometry/triangulation.hpp"
#include "scene/obj.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

using namespace knotwork;

namespace {

constexpr double rounding = 1e-12;

/// Whether the face goes from one vertex to the other.
bool goes(std::span<const std::uint32_t> face, std::uint32_t from, std::uint32_t to) {
    for (std::size_t j = 0; j < face.size(); ++j) {
        if (face[j] == from && face[j + 1 < face.size() ? j + 1 : 0] == to) return true;
    }
    return false;
}

void checkEdges(const Mesh& mesh) {
    const MeshCounts counts = mesh.counts();
    const auto faces = mesh.faces();
    for (const MeshEdge& edge : mesh.edges()) {
        fuzz::check(goes(faces[edge.f0], edge.v0, edge.v1), "the first face has the edge");
        fuzz::check(edge.onBoundary() || goes(faces[edge.f1], edge.v1, edge.v0),
                    "the second face has the edge, backwards");
    }
    fuzz::check(2 * counts.edges == mesh.corners().size() + counts.boundaryEdges,
                "every corner begins an edge");
    for (const std::uint32_t edge : mesh.cornerEdges()) {
        fuzz::check(edge < counts.edges, "every corner has an edge");
    }
}

void checkUnit(const Vec3& normal) {
    const double length = glm::length(normal);
    fuzz::check(length == 0 || std::abs(length - 1) <= rounding, "normals are unit or zero",
                length);
}

void checkNormals(const Mesh& mesh) {
    std::vector<double> xyz(3 * mesh.points().size());
    vertexNormals(mesh, xyz);
    for (std::size_t i = 0; i < xyz.size(); i += 3) checkUnit({xyz[i], xyz[i + 1], xyz[i + 2]});
}

void checkObj(const Mesh& mesh) {
    const auto again = scene::readObj(scene::writeObj(mesh));
    fuzz::check(again.ok(), "what was written is read");
    const auto same = [](auto a, auto b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    };
    fuzz::check(same(again->points(), mesh.points()), "vertices read back exactly");
    fuzz::check(same(again->corners(), mesh.corners()), "faces read back exactly");
    fuzz::check(same(again->faceStarts(), mesh.faceStarts()), "faces keep their sizes");
}

/// Of one level. Vertices and faces of Doo–Sabin depend on what the boundary is like.
void checkCounts(const Mesh& mesh, const Mesh& finer, MeshScheme scheme) {
    const MeshCounts before = mesh.counts();
    const MeshCounts after = finer.counts();
    std::size_t vertices = before.vertices;
    std::size_t faces = 0;
    switch (scheme) {
        case MeshScheme::catmullClark:
            vertices += before.edges + before.faces;
            faces = mesh.corners().size();
            break;
        case MeshScheme::loop:
        case MeshScheme::butterfly:
            vertices += before.edges;
            faces = 4 * before.faces;
            break;
        case MeshScheme::sqrt3:
            vertices += before.faces;
            faces = 3 * before.faces;
            break;
        case MeshScheme::dooSabin:
            return;
    }
    fuzz::check(after.vertices == vertices, "vertices of a level");
    fuzz::check(after.faces == faces, "faces of a level");
    fuzz::check(eulerCharacteristic(after) == eulerCharacteristic(before), "the characteristic");
}

void checkFiner(const Mesh& mesh, MeshScheme scheme) {
    const auto finer = subdivide(mesh, scheme, 1);
    if (!finer) {
        // Other faces than triangles, or triangles back to back.
        fuzz::check(finer.error().code == Code::notSupported &&
                        finer.error().path.starts_with("faces["),
                    "what is not subdivided is a face's fault");
        fuzz::check(scheme != MeshScheme::catmullClark && scheme != MeshScheme::dooSabin,
                    "two schemes take every mesh");
        return;
    }
    checkCounts(mesh, *finer, scheme);
    for (const Vec3& p : finer->points()) fuzz::check(isFinite(p), "finer points are finite");
    // What a scheme has made is a mesh by the checks that strangers' meshes undergo.
    std::vector<std::uint32_t> starts{0};
    for (std::size_t f = 0; f < finer->faces().count(); ++f) {
        starts.push_back(starts.back() + static_cast<std::uint32_t>(finer->faces()[f].size()));
    }
    const auto again = Mesh::make({finer->points().begin(), finer->points().end()},
                                  {finer->corners().begin(), finer->corners().end()}, starts);
    const bool farOut = !again && again.error().code == Code::outOfRange &&
                        again.error().path.starts_with("vertices");
    fuzz::check(again.ok() || farOut, "a finer mesh is a mesh");
    if (const auto found = limit(mesh, scheme)) {
        for (const Vec3& p : found->positions) fuzz::check(isFinite(p), "limits are finite");
        for (const Vec3& normal : found->normals) checkUnit(normal);
    }
}

void checkMesh(const Mesh& mesh) {
    checkEdges(mesh);
    checkNormals(mesh);
    checkObj(mesh);
    for (int scheme = 0; scheme < static_cast<int>(meshSchemeNames.size()); ++scheme) {
        checkFiner(mesh, static_cast<MeshScheme>(scheme));
    }
    if (const auto cut = triangulated(mesh)) {
        checkEdges(*cut);
        checkFiner(*cut, MeshScheme::loop);
        checkFiner(*cut, MeshScheme::butterfly);
        checkFiner(*cut, MeshScheme::sqrt3);
    }
}

// ---- Creases -----------------------------------------------------------------------------------

double anySharpness(fuzz::Input& input) {
    switch (input.whole(0, 7)) {
        case 0: return input.anyNumber();
        case 1:
        case 2: return std::numeric_limits<double>::infinity();
        case 3: return input.whole(0, 4);
        default: return 4 * input.share();
    }
}

/// Of edges that there are, at times twice, and at times of others.
std::vector<MeshCrease> anyCreases(fuzz::Input& input, const Mesh& mesh) {
    std::vector<MeshCrease> creases;
    const auto edges = mesh.edges();
    if (edges.empty()) return creases;
    for (int k = input.whole(0, 15); k > 0; --k) {
        const double place = input.share() * static_cast<double>(edges.size() - 1);
        const MeshEdge& edge = edges[static_cast<std::size_t>(place)];
        const int kind = input.whole(0, 31);
        MeshCrease crease{edge.v0, edge.v1, anySharpness(input)};
        if (kind % 2 == 0) std::swap(crease.v0, crease.v1);
        if (kind == 31) crease.v1 = static_cast<std::uint32_t>(input.byte());
        creases.push_back(crease);
    }
    return creases;
}

/// Two halves of every crease that is still sharp one level finer; on a boundary there are none.
std::size_t halvesLeft(const Mesh& mesh) {
    std::size_t halves = 0;
    for (const MeshCrease& crease : mesh.creases()) {
        const auto edge = std::find_if(
            mesh.edges().begin(), mesh.edges().end(), [&crease](const MeshEdge& one) {
                return std::minmax(one.v0, one.v1) == std::minmax(crease.v0, crease.v1);
            });
        if (crease.sharpness > 1 && !edge->onBoundary()) halves += 2;
    }
    return halves;
}

void checkCreased(const Mesh& mesh, MeshScheme scheme) {
    const bool rules = scheme == MeshScheme::catmullClark || scheme == MeshScheme::loop;
    const auto finer = subdivide(mesh, scheme, 1);
    if (!finer) {
        const std::string& path = finer.error().path;
        fuzz::check(path.starts_with("faces[") || (path == "scheme" && !rules),
                    "creases are refused by schemes without rules for them");
        return;
    }
    fuzz::check(rules, "schemes without rules for creases refuse them");
    checkCounts(mesh, *finer, scheme);
    for (const Vec3& p : finer->points()) fuzz::check(isFinite(p), "creased points are finite");
    fuzz::check(finer->creases().size() == halvesLeft(mesh), "creases are halved");
    const auto left = finer->creases();
    fuzz::check(finer->withCreases({left.begin(), left.end()}).ok(),
                "what is left of creases lies on edges of the finer mesh");
    const auto twice = subdivide(*finer, scheme, 1);
    const auto atOnce = subdivide(mesh, scheme, 2);
    fuzz::check(twice.ok() && atOnce.ok() &&
                    std::equal(twice->points().begin(), twice->points().end(),
                               atOnce->points().begin(), atOnce->points().end()),
                "two levels with creases are one and another");
}

void checkCreases(const Mesh& mesh, std::vector<MeshCrease> creases) {
    if (creases.empty()) return;
    const auto made = mesh.withCreases(std::move(creases));
    if (!made) {
        fuzz::check(made.error().path.starts_with("creases["), "a refused crease is named");
        return;
    }
    for (int scheme = 0; scheme < static_cast<int>(meshSchemeNames.size()); ++scheme) {
        checkCreased(*made, static_cast<MeshScheme>(scheme));
    }
}

void checkMade(const Result<Mesh>& made) {
    if (made) return checkMesh(*made);
    const bool placed = !made.error().path.empty() && made.error().message.size() > 10;
    fuzz::check(placed, "a refusal says where and why");
}

Vec3 anyPoint(fuzz::Input& input) {
    if (input.whole(0, 31) == 0) {
        const double x = input.anyNumber();
        const double y = input.anyNumber();
        return {x, y, input.anyNumber()};
    }
    const double x = input.real();
    const double y = input.real();
    return {x, y, input.whole(0, 3) == 0 ? 0 : input.real()};
}

/// Few vertices and many faces, so that edges meet; at times the next face begins where the last
/// one ended, the other way round.
void anyFaces(fuzz::Input& input) {
    const int vertices = input.whole(0, 30);
    std::vector<Vec3> points;
    for (int i = 0; i < vertices; ++i) points.push_back(anyPoint(input));
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> starts{0};
    const int faces = input.whole(0, 40);
    for (int f = 0; f < faces; ++f) {
        const bool joined = corners.size() > 1 && input.whole(0, 3) > 0;
        if (joined) {
            const std::uint32_t last = corners.back();
            corners.push_back(last);
            corners.push_back(corners[corners.size() - 3]);
        }
        for (int j = input.whole(joined ? 1 : 2, 5); j > 0; --j) {
            corners.push_back(static_cast<std::uint32_t>(input.whole(0, std::max(vertices, 1))));
        }
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const auto made = Mesh::make(std::move(points), std::move(corners), std::move(starts));
    checkMade(made);
    if (made) checkCreases(*made, anyCreases(input, *made));
}

/// A solid with its vertices moved and some of its faces missing: always a mesh.
void dentedSolid(fuzz::Input& input) {
    const auto& description = solids()[input.byte() % solids().size()];
    std::vector<NamedValue> parameters;
    for (const ParameterDescription& one : description.parameters) {
        if (!one.integer) continue;
        parameters.emplace_back(one.name, input.whole(static_cast<int>(one.min), 9));
    }
    const Mesh whole = *makeSolid(description.name, parameters);
    std::vector<Vec3> points(whole.points().begin(), whole.points().end());
    for (Vec3& p : points) p += Vec3(input.real(), input.real(), 0);
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> starts{0};
    for (std::size_t f = 0; f < whole.faces().count(); ++f) {
        if (f > 0 && input.whole(0, 4) == 1) continue;
        corners.insert(corners.end(), whole.faces()[f].begin(), whole.faces()[f].end());
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const auto made = Mesh::make(std::move(points), std::move(corners), std::move(starts));
    fuzz::check(made.ok(), "faces of a mesh are a mesh");
    checkMesh(*made);
    checkCreases(*made, anyCreases(input, *made));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    switch (input.whole(0, 2)) {
        case 0:
            anyFaces(input);
            break;
        case 1:
            dentedSolid(input);
            break;
        default:
            checkMade(scene::readObj({reinterpret_cast<const char*>(data + 1), size - 1}));
    }
    return 0;
}
