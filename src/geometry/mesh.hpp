// Meshes: points, faces that name them counter-clockwise, and the edges between the faces.
//
// Every edge has one face (it lies on a boundary) or two, which go along it in opposite directions.
// Faces of which one runs against its neighbour, or three that share an edge, are not a mesh.
// V − E + F is Euler's characteristic: 2 for whatever is closed and in one piece without handles.
// A vertex may have no face (it is isolated), and several fans of faces may meet in one (a bow tie,
// or cones tip to tip): the faces around a vertex are then all the faces of all of its fans.
//
// A Mesh is an immutable value, cheap to copy. Its edges are found when they are first asked for; a
// mesh and its copies are for one thread at a time.
#pragma once

#include "geometry/raw_array.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace knotwork {

inline constexpr std::size_t maxMeshVertices = 4'000'000;
/// All faces together; twice what quads and 4/3 of what triangles need with most vertices.
inline constexpr std::size_t maxMeshCorners = std::size_t{1} << 25;

/// What stands for the second face of an edge on a boundary: −1, read as signed.
inline constexpr std::uint32_t noFace = 0xffffffffU;

/// An edge runs from v0 to v1 as its face f0 goes along it; f1 goes back, or is noFace.
struct MeshEdge {
    std::uint32_t v0 = 0;
    std::uint32_t v1 = 0;
    std::uint32_t f0 = 0;
    std::uint32_t f1 = noFace;

    [[nodiscard]] bool onBoundary() const noexcept { return f1 == noFace; }
    friend bool operator==(const MeshEdge&, const MeshEdge&) = default;
};

/// An edge that subdivision keeps sharp for so many levels, in part where that is no whole number;
/// for ever where it is infinite.
struct MeshCrease {
    std::uint32_t v0 = 0;
    std::uint32_t v1 = 0;
    double sharpness = 0;

    friend bool operator==(const MeshCrease&, const MeshCrease&) = default;
};

inline constexpr double maxSharpness = 10;

/// Faces as compressed rows: face f has the corners begin(f) … begin(f + 1) − 1.
struct FaceRows {
    std::span<const std::uint32_t> corners;
    std::span<const std::uint32_t> starts;  ///< one more than faces; empty where all are alike
    std::uint32_t uniformSize = 0;          ///< of every face where they are alike, otherwise 0

    [[nodiscard]] std::size_t count() const noexcept {
        return uniformSize != 0 ? corners.size() / uniformSize : starts.size() - 1;
    }
    [[nodiscard]] std::size_t begin(std::size_t face) const noexcept {
        return uniformSize != 0 ? face * uniformSize : starts[face];
    }
    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t face) const noexcept {
        return corners.subspan(begin(face), begin(face + 1) - begin(face));
    }
};

struct MeshCounts {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t faces = 0;
    std::size_t boundaryEdges = 0;

    friend bool operator==(const MeshCounts&, const MeshCounts&) = default;
};

class Mesh {
public:
    /// `starts` has one number more than there are faces, from 0 to corners.size(). O(n).
    /// Refusals: WRONG_LENGTH `vertices` or `faces` for none, TOO_LARGE for more than 4 million
    /// vertices or maxMeshCorners corners; NOT_FINITE and OUT_OF_RANGE `vertices[i]` (±1e12);
    /// WRONG_LENGTH `faces[i]` for fewer than 3 vertices, OUT_OF_RANGE `faces[i][j]` for a vertex
    /// that there is not, OUT_OF_RANGE `faces[i]` where a vertex comes twice; NOT_MANIFOLD
    /// `edges[a,b]`, a < b, where the edge between a and b has three faces or two that go along it
    /// in the same direction.
    [[nodiscard]] static Result<Mesh> make(std::vector<Vec3> points,
                                           std::vector<std::uint32_t> corners,
                                           std::vector<std::uint32_t> starts);
    /// The same for faces of `size` ≥ 3 vertices each.
    [[nodiscard]] static Result<Mesh> make(std::vector<Vec3> points,
                                           std::vector<std::uint32_t> corners, std::uint32_t size);

    /// What make() would accept, unchecked: for meshes that an algorithm has made. O(faces).
    [[nodiscard]] static Mesh trusted(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                                      std::vector<std::uint32_t> starts);
    [[nodiscard]] static Mesh trusted(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                                      std::uint32_t size);
    [[nodiscard]] static Mesh trusted(RawArray<Vec3> points, RawArray<std::uint32_t> corners,
                                      std::uint32_t size);

    [[nodiscard]] std::span<const Vec3> points() const noexcept;
    [[nodiscard]] FaceRows faces() const noexcept;
    [[nodiscard]] std::span<const std::uint32_t> corners() const noexcept;
    /// Empty where all faces have uniformSize() vertices; that is 0 where they differ.
    [[nodiscard]] std::span<const std::uint32_t> faceStarts() const noexcept;
    [[nodiscard]] std::uint32_t uniformSize() const noexcept;

    /// In the order in which one meets them walking along the faces. Made once, in O(n) whatever
    /// the valences: 16 bytes an edge and 4 a corner stay, twice as much more is needed for a
    /// moment.
    [[nodiscard]] std::span<const MeshEdge> edges() const;
    /// For every corner the edge from it to the next corner of its face. Made with the edges.
    [[nodiscard]] std::span<const std::uint32_t> cornerEdges() const;

    [[nodiscard]] MeshCounts counts() const;

    /// Empty for most.
    [[nodiscard]] std::span<const MeshCrease> creases() const noexcept;
    /// The same mesh with these creases and no others. Refusals: OUT_OF_RANGE `creases[i].edge`
    /// where there is no edge between its vertices, or the edge comes twice; NOT_FINITE or
    /// OUT_OF_RANGE `creases[i].sharpness` that is neither positive up to maxSharpness nor infinite.
    /// O(edges · log creases).
    [[nodiscard]] Result<Mesh> withCreases(std::vector<MeshCrease> creases) const;
    /// The same unchecked: for creases that an algorithm has made.
    [[nodiscard]] Mesh withTrustedCreases(std::vector<MeshCrease> creases) const;

private:
    struct Data;
    explicit Mesh(std::shared_ptr<const Data> data) noexcept;
    [[nodiscard]] static Mesh of(std::vector<Vec3> points, std::vector<std::uint32_t> corners,
                                 std::vector<std::uint32_t> starts, std::uint32_t size);
    [[nodiscard]] static Result<Mesh> checked(Mesh mesh);
    const Data& withEdges() const;

    std::shared_ptr<const Data> data_;
    std::shared_ptr<const std::vector<MeshCrease>> creases_;  // null where there are none
};

/// V − E + F; isolated vertices count.
[[nodiscard]] std::ptrdiff_t eulerCharacteristic(const MeshCounts& counts) noexcept;

/// Unit normals as x, y, z triples, xyz.size() == 3 · vertices. The normal of a vertex is the mean
/// of its faces' normals weighted by their angles there, so that it does not depend on how flat
/// parts are cut into faces (G. Thürmer, C. Wüthrich, Computing vertex normals from polygonal
/// facets, 1998); the normal of a face is Newell's. Vertices without a face, or whose faces have no
/// area or cancel, have the zero vector. O(n).
void vertexNormals(const Mesh& mesh, std::span<double> xyz) noexcept;

}  // namespace knotwork
