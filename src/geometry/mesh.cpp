#include "geometry/mesh.hpp"

#include "geometry/checks.hpp"
#include "geometry/mesh_edges.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

struct Mesh::Data {
    std::span<const Vec3> points;
    std::span<const std::uint32_t> corners;
    std::vector<std::uint32_t> starts;
    std::uint32_t uniformSize = 0;
    /// Absent until somebody asks.
    mutable std::optional<MatchedEdges> matched{};

    // What the spans show: one of the two each.
    std::vector<Vec3> givenPoints{};
    std::vector<std::uint32_t> givenCorners{};
    RawArray<Vec3> madePoints{};
    RawArray<std::uint32_t> madeCorners{};

    [[nodiscard]] FaceRows faces() const noexcept { return {corners, starts, uniformSize}; }
};

namespace {

MatchedEdges matchEdges(const FaceRows& faces, std::size_t vertices) {
    NoTally tally;
    return EdgeMatcher<>(faces, vertices, tally).match();
}

/// The size of every face, or 0 where they differ.
std::uint32_t commonSize(std::span<const std::uint32_t> starts) noexcept {
    if (starts.size() < 2) return 0;
    const std::uint32_t size = starts[1] - starts[0];
    for (std::size_t face = 1; face + 1 < starts.size(); ++face) {
        if (starts[face + 1] - starts[face] != size) return 0;
    }
    return size;
}

// ---- What is refused ---------------------------------------------------------------------------

Error wrongCount(Code code, std::string path, std::size_t given, const std::string& allowed) {
    std::string message = std::to_string(given) + " " + path + "; " + allowed;
    return refuse(code, std::move(path), std::move(message));
}

std::optional<Error> checkCounts(std::size_t vertices, std::size_t corners, std::size_t faces) {
    if (vertices == 0) {
        return wrongCount(Code::wrongLength, "vertices", 0, "a mesh has at least 3.");
    }
    if (vertices > maxMeshVertices) {
        return wrongCount(Code::tooLarge, "vertices", vertices,
                          "a mesh has at most " + std::to_string(maxMeshVertices) + ".");
    }
    if (faces == 0) return wrongCount(Code::wrongLength, "faces", 0, "a mesh has at least one.");
    if (corners > maxMeshCorners) {
        return refuse(Code::tooLarge, "faces",
                      "The faces have " + std::to_string(corners) +
                          " corners in all; they can have " + std::to_string(maxMeshCorners) + ".");
    }
    return std::nullopt;
}

bool validStarts(std::span<const std::uint32_t> starts, std::size_t corners) noexcept {
    return starts.empty() || (starts.front() == 0 && starts.back() == corners &&
                              std::is_sorted(starts.begin(), starts.end()));
}

std::optional<Error> checkPoints(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (allowedCoordinates(points[i])) continue;
        return checkCoordinates(points[i], indexed("vertices", i));
    }
    return std::nullopt;
}

Error noSuchVertex(std::size_t face, std::size_t corner, std::uint32_t vertex, std::size_t count) {
    return refuse(Code::outOfRange, indexed(indexed("faces", face), corner),
                  "There is no vertex " + std::to_string(vertex) + "; there are 0 to " +
                      std::to_string(count - 1) + ".");
}

std::optional<Error> checkFaces(const FaceRows& faces, std::size_t vertices) {
    // The last face that a vertex was seen in.
    std::vector<std::uint32_t> seen(vertices, noFace);
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto face = faces[f];
        if (face.size() < 3) {
            return refuse(Code::wrongLength, indexed("faces", f),
                          "The face has " + std::to_string(face.size()) +
                              " vertices; a face has at least 3.");
        }
        for (std::size_t j = 0; j < face.size(); ++j) {
            const std::uint32_t vertex = face[j];
            if (vertex >= vertices) return noSuchVertex(f, j, vertex, vertices);
            if (std::exchange(seen[vertex], static_cast<std::uint32_t>(f)) != f) continue;
            return refuse(Code::outOfRange, indexed("faces", f),
                          "The vertex " + std::to_string(vertex) +
                              " comes twice in this face; name each of its vertices once.");
        }
    }
    return std::nullopt;
}

std::size_t faceOfCorner(const FaceRows& faces, std::size_t corner) noexcept {
    if (faces.uniformSize != 0) return corner / faces.uniformSize;
    const auto after = std::upper_bound(faces.starts.begin(), faces.starts.end(), corner);
    return static_cast<std::size_t>(after - faces.starts.begin()) - 1;
}

/// How many faces have the edge.
std::size_t facesWith(const FaceRows& faces, const EdgeClash& clash) noexcept {
    std::size_t found = 0;
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto face = faces[f];
        for (std::size_t j = 0; j < face.size(); ++j) {
            const auto ends = std::minmax(face[j], face[j + 1 < face.size() ? j + 1 : 0]);
            if (ends.first == clash.v0 && ends.second == clash.v1) ++found;
        }
    }
    return found;
}

Error notManifold(const FaceRows& faces, const EdgeClash& clash) {
    const std::string ends = std::to_string(clash.v0) + " and " + std::to_string(clash.v1);
    const std::string both = std::to_string(faceOfCorner(faces, clash.firstCorner)) + " and " +
                             std::to_string(faceOfCorner(faces, clash.secondCorner));
    const std::size_t count = facesWith(faces, clash);
    std::string message =
        count > 2 ? "The edge between the vertices " + ends + " has " + std::to_string(count) +
                        " faces, " + both + " among them; an edge has one or two."
                  : "The faces " + both + " go along the edge between the vertices " + ends +
                        " in the same direction; turn one of them round.";
    return refuse(Code::notManifold,
                  "edges[" + std::to_string(clash.v0) + "," + std::to_string(clash.v1) + "]",
                  std::move(message));
}

}  // namespace

// ---- Making ------------------------------------------------------------------------------------

Mesh::Mesh(std::shared_ptr<const Data> data) noexcept : data_(std::move(data)) {}

Mesh Mesh::of(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
              std::vector<std::uint32_t> starts, std::uint32_t size) {
    auto data = std::make_shared<Data>();
    data->givenPoints = std::move(points);
    data->givenCorners = std::move(corners);
    data->points = data->givenPoints;
    data->corners = data->givenCorners;
    data->starts = std::move(starts);
    data->uniformSize = size;
    return Mesh(std::move(data));
}

Mesh Mesh::trusted(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                   std::vector<std::uint32_t> starts) {
    const std::uint32_t size = commonSize(starts);
    if (size != 0) starts = {};
    return of(std::move(points), std::move(corners), std::move(starts), size);
}

Mesh Mesh::trusted(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                   std::uint32_t size) {
    return of(std::move(points), std::move(corners), {}, size);
}

Mesh Mesh::trusted(RawArray<Vec3> points, RawArray<std::uint32_t> corners, std::uint32_t size) {
    auto data = std::make_shared<Data>();
    data->madePoints = std::move(points);
    data->madeCorners = std::move(corners);
    data->points = data->madePoints;
    data->corners = data->madeCorners;
    data->uniformSize = size;
    return Mesh(std::move(data));
}

Result<Mesh> Mesh::checked(Mesh mesh) {
    const Data& data = *mesh.data_;
    if (auto problem = checkPoints(data.points)) return std::move(*problem);
    if (auto problem = checkFaces(data.faces(), data.points.size())) return std::move(*problem);
    MatchedEdges matched = matchEdges(data.faces(), data.points.size());
    if (matched.clash) return notManifold(data.faces(), *matched.clash);
    data.matched.emplace(std::move(matched));
    return mesh;
}

Result<Mesh> Mesh::make(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                        std::vector<std::uint32_t> starts) {
    const std::size_t faces = starts.empty() ? 0 : starts.size() - 1;
    auto problem = checkCounts(points.size(), corners.size(), faces);
    if (problem) return std::move(*problem);
    if (!validStarts(starts, corners.size())) {
        return refuse(Code::wrongLength, "faces", "The faces do not add up to the given corners.");
    }
    return checked(trusted(std::move(points), std::move(corners), std::move(starts)));
}

Result<Mesh> Mesh::make(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                        std::uint32_t size) {
    const std::size_t faces = size == 0 ? 0 : corners.size() / size;
    auto problem = checkCounts(points.size(), corners.size(), faces);
    if (problem) return std::move(*problem);
    if (corners.size() % size != 0) {
        return refuse(Code::wrongLength, "faces", "The faces do not add up to the given corners.");
    }
    return checked(trusted(std::move(points), std::move(corners), size));
}

// ---- Asking ------------------------------------------------------------------------------------

std::span<const Vec3> Mesh::points() const noexcept { return data_->points; }
FaceRows Mesh::faces() const noexcept { return data_->faces(); }
std::span<const std::uint32_t> Mesh::corners() const noexcept { return data_->corners; }
std::span<const std::uint32_t> Mesh::faceStarts() const noexcept { return data_->starts; }
std::uint32_t Mesh::uniformSize() const noexcept { return data_->uniformSize; }

const Mesh::Data& Mesh::withEdges() const {
    if (!data_->matched) data_->matched.emplace(matchEdges(data_->faces(), data_->points.size()));
    return *data_;
}

std::span<const MeshEdge> Mesh::edges() const { return withEdges().matched->edges; }
std::span<const std::uint32_t> Mesh::cornerEdges() const {
    return withEdges().matched->cornerEdges;
}

MeshCounts Mesh::counts() const {
    const auto all = edges();
    const auto open = std::count_if(all.begin(), all.end(),
                                    [](const MeshEdge& edge) { return edge.onBoundary(); });
    return {points().size(), all.size(), faces().count(), static_cast<std::size_t>(open)};
}

std::ptrdiff_t eulerCharacteristic(const MeshCounts& counts) noexcept {
    return static_cast<std::ptrdiff_t>(counts.vertices + counts.faces) -
           static_cast<std::ptrdiff_t>(counts.edges);
}

}  // namespace knotwork
