// The part of the session that holds meshes.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "geometry/mesh_subdivision.hpp"
#include "geometry/triangulation.hpp"
#include "scene/mesh_specs.hpp"
#include "scene/obj.hpp"

#include <cstring>
#include <string>
#include <utility>

namespace knotwork::bindings {

using scene::Made;

namespace {

template <class T>
double addressOf(const T* data) noexcept {
    return static_cast<double>(reinterpret_cast<Session::Address>(data));
}

/// More text than any engine's strings hold.
constexpr std::size_t longestText = std::size_t{1} << 28;

/// About how long the OBJ of a mesh is: at most 24 characters a coordinate and 8 a corner.
std::size_t objLength(const Mesh& mesh) noexcept {
    return 74 * mesh.points().size() + 8 * mesh.corners().size() + 2 * mesh.faces().count();
}

}  // namespace

int Session::holdMesh(Result<Mesh> mesh) {
    if (!mesh) return refuse(mesh.error());
    return hold(std::make_unique<MeshValue>(MeshValue{std::move(*mesh), std::nullopt}));
}

bool Session::meshRoom(unsigned vertices, unsigned faces, unsigned corners) {
    if (vertices > maxMeshVertices || corners > maxMeshCorners || faces > maxMeshCorners) {
        return refuse({Code::tooLarge, vertices > maxMeshVertices ? "vertices" : "faces",
                       "A mesh has at most " + std::to_string(maxMeshVertices) +
                           " vertices, and its faces " + std::to_string(maxMeshCorners) +
                           " corners in all."});
    }
    meshRoom_.points.resize(vertices);
    meshRoom_.starts.resize(std::size_t{faces} + 1);
    meshRoom_.corners.resize(corners);
    block_[0] = addressOf(meshRoom_.points.data());
    block_[1] = addressOf(meshRoom_.starts.data());
    block_[2] = addressOf(meshRoom_.corners.data());
    return true;
}

int Session::meshFromRoom() {
    MeshRoom room = std::exchange(meshRoom_, {});
    return holdMesh(
        Mesh::make(std::move(room.points), std::move(room.corners), std::move(room.starts)));
}

Session::Address Session::textRoom(unsigned bytes) {
    text_.resize(bytes);
    return reinterpret_cast<Address>(text_.data());
}

int Session::meshFromText() {
    const std::string text = std::exchange(text_, {});
    return holdMesh(scene::readObj(text));
}

int Session::mesh(unsigned bytes) {
    const auto spec = input(bytes);
    if (!spec) return refuse(spec.error());
    auto made = scene::makeMesh(*spec);
    if (!made) return refuse(made.error());
    MeshValue value{std::move(made->value), std::move(made->spec)};
    return hold(std::make_unique<MeshValue>(std::move(value)));
}

std::string Session::meshSpec(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return {};
    return held->spec ? scene::dumpJson(*held->spec) : "null";
}

bool Session::meshParts(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return false;
    const Mesh& mesh = held->mesh;
    block_[0] = static_cast<double>(mesh.points().size());
    block_[1] = static_cast<double>(mesh.faces().count());
    block_[2] = static_cast<double>(mesh.corners().size());
    block_[3] = mesh.uniformSize();
    block_[4] = addressOf(mesh.points().data());
    block_[5] = addressOf(mesh.corners().data());
    block_[6] = addressOf(mesh.faceStarts().data());
    return true;
}

bool Session::meshCounts(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return false;
    const MeshCounts counts = held->mesh.counts();
    block_[0] = static_cast<double>(counts.vertices);
    block_[1] = static_cast<double>(counts.edges);
    block_[2] = static_cast<double>(counts.faces);
    block_[3] = static_cast<double>(counts.boundaryEdges);
    block_[4] = addressOf(held->mesh.edges().data());
    return true;
}

int Session::meshNormals(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return -1;
    std::vector<double> normals(3 * held->mesh.points().size());
    vertexNormals(held->mesh, normals);
    return leave(std::move(normals), held->mesh.points().size());
}

int Session::meshTriangles(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return -1;
    bulkIndices_ = triangleIndices(held->mesh);
    return static_cast<int>(bulkIndices_.size() / 3);
}

Session::Address Session::bulkIndices() const {
    return reinterpret_cast<Address>(bulkIndices_.data());
}

int Session::meshTriangulated(int handle) {
    const auto* held = find<MeshValue>(handle);
    return held ? holdMesh(triangulated(held->mesh)) : 0;
}

std::string Session::meshObj(int handle) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return {};
    if (objLength(held->mesh) > longestText) {
        refuse({Code::tooLarge, "",
                "The text of this mesh would have more than " + std::to_string(longestText) +
                    " characters; write fewer levels of it."});
        return {};
    }
    return scene::writeObj(held->mesh);
}

int Session::meshCreased(int handle, unsigned bytes) {
    const auto given = input(bytes);
    if (!given) return refuse(given.error());
    const auto* held = find<MeshValue>(handle);
    return held ? holdMesh(scene::withCreases(held->mesh, given->value("creases", scene::Json())))
                : 0;
}

std::string Session::meshCreases(int handle) {
    const auto* held = find<MeshValue>(handle);
    return held ? scene::dumpJson(scene::describeCreases(held->mesh)) : std::string();
}

int Session::meshSubdivided(int handle, int scheme, int levels) {
    const auto* held = find<MeshValue>(handle);
    return held ? holdMesh(subdivide(held->mesh, static_cast<MeshScheme>(scheme), levels)) : 0;
}

int Session::meshLimit(int handle, int scheme) {
    const auto* held = find<MeshValue>(handle);
    if (!held) return -1;
    const auto found = limit(held->mesh, static_cast<MeshScheme>(scheme));
    if (!found) {
        refuse(found.error());
        return -1;
    }
    const std::size_t count = found->positions.size();
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    std::vector<double> numbers(6 * count);
    std::memcpy(numbers.data(), found->positions.data(), count * sizeof(Vec3));
    std::memcpy(numbers.data() + 3 * count, found->normals.data(), count * sizeof(Vec3));
    return leave(std::move(numbers), count);
}

std::string Session::meshClassification(int scheme) const {
    const MeshClassification known = classification(static_cast<MeshScheme>(scheme));
    return scene::dumpJson({{"approximating", known.approximating},
                            {"regular", known.regular},
                            {"extraordinary", known.extraordinary},
                            {"mesh", known.mesh}});
}

std::string Session::solids() const { return scene::dumpJson(scene::describeSolids()); }

}  // namespace knotwork::bindings
