#include "geometry/mesh_stencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

/// Sums of a few products that cancel leave less than this; the smallest weight of a mask of
/// mostAround vertices is above 1e-7.
constexpr double noWeight = 1e-13;

const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

constexpr std::array<std::string_view, 4> elementNames{"vertices", "edges", "faces", "corners"};

std::size_t faceOfCorner(const FaceRows& faces, std::size_t corner) {
    std::size_t first = 0;
    std::size_t last = faces.count();
    while (last - first > 1) {
        const std::size_t middle = (first + last) / 2;
        (faces.begin(middle) <= corner ? first : last) = middle;
    }
    return first;
}

/// The vertices from which the element is made.
std::vector<std::uint32_t> verticesOf(const Mesh& mesh, MeshElement element, std::size_t index) {
    const auto face = [&](std::size_t f) {
        const auto corners = mesh.faces()[f];
        return std::vector<std::uint32_t>(corners.begin(), corners.end());
    };
    switch (element) {
        case MeshElement::vertex: return {static_cast<std::uint32_t>(index)};
        case MeshElement::edge: return {mesh.edges()[index].v0, mesh.edges()[index].v1};
        case MeshElement::face: return face(index);
        case MeshElement::corner: break;
    }
    return face(faceOfCorner(mesh.faces(), index));
}

// ---- The part of a mesh around an element ------------------------------------------------------

/// Some of the faces of a mesh, in their order, with their vertices numbered anew.
struct Surroundings {
    std::vector<std::uint32_t> vertices;  ///< their numbers in the whole mesh, ascending
    std::vector<std::uint32_t> faces;     ///< likewise
    std::vector<std::uint32_t> inner;     ///< vertices of the element, all of whose faces are here

    [[nodiscard]] std::uint32_t number(std::uint32_t vertex) const noexcept {
        const auto at = std::lower_bound(vertices.begin(), vertices.end(), vertex);
        return static_cast<std::uint32_t>(at - vertices.begin());
    }
    [[nodiscard]] bool isInner(std::uint32_t vertex) const noexcept {
        return std::find(inner.begin(), inner.end(), vertex) != inner.end();
    }
};

std::vector<std::uint32_t> facesAt(const Mesh& mesh, const std::vector<bool>& wanted) {
    std::vector<std::uint32_t> found;
    const FaceRows faces = mesh.faces();
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto corners = faces[f];
        const bool here = std::any_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t v) { return wanted[v]; });
        if (here) found.push_back(static_cast<std::uint32_t>(f));
    }
    return found;
}

/// The faces at the element's vertices: the rules look no farther, not even those of Butterfly, which
/// ask for the valences of an edge's ends and for boundaries next to them.
Surroundings around(const Mesh& mesh, std::vector<std::uint32_t> vertices) {
    std::vector<bool> wanted(mesh.points().size(), false);
    for (const std::uint32_t v : vertices) wanted[v] = true;
    Surroundings part;
    part.inner = std::move(vertices);
    part.faces = facesAt(mesh, wanted);
    for (const std::uint32_t f : part.faces) {
        for (const std::uint32_t v : mesh.faces()[f]) wanted[v] = true;
    }
    for (std::size_t v = 0; v < wanted.size(); ++v) {
        if (wanted[v]) part.vertices.push_back(static_cast<std::uint32_t>(v));
    }
    return part;
}

/// The mesh of the surroundings with other points.
Mesh partWith(const Mesh& mesh, const Surroundings& part, std::vector<Vec3> points) {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> starts{0};
    for (const std::uint32_t f : part.faces) {
        for (const std::uint32_t v : mesh.faces()[f]) corners.push_back(part.number(v));
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    std::vector<MeshCrease> creases;
    for (const MeshCrease& crease : mesh.creases()) {
        if (!part.isInner(crease.v0) && !part.isInner(crease.v1)) continue;
        creases.push_back({part.number(crease.v0), part.number(crease.v1), crease.sharpness});
    }
    const Mesh made = Mesh::trusted(std::move(points), std::move(corners), std::move(starts));
    return creases.empty() ? made : made.withTrustedCreases(std::move(creases));
}

// ---- Where the new point is among those of the finer mesh ---------------------------------------

std::size_t edgeBetween(const Mesh& part, std::uint32_t v0, std::uint32_t v1) {
    const auto edges = part.edges();
    const auto found = std::find_if(edges.begin(), edges.end(), [&](const MeshEdge& edge) {
        return edge.v0 == v0 && edge.v1 == v1;
    });
    return static_cast<std::size_t>(found - edges.begin());
}

std::size_t placeIn(const std::vector<std::uint32_t>& list, std::size_t number) {
    const auto at = std::lower_bound(list.begin(), list.end(), number);
    return static_cast<std::size_t>(at - list.begin());
}

/// In the order V | F | E of finer meshes, and of Doo–Sabin's corners.
std::size_t finerNumber(const Mesh& mesh, const Mesh& part, const Surroundings& surroundings,
                        MeshScheme scheme, MeshElement element, std::size_t index) {
    const std::size_t vertices = part.points().size();
    const std::size_t facePoints = scheme == MeshScheme::catmullClark ? part.faces().count() : 0;
    if (element == MeshElement::vertex) return placeIn(surroundings.vertices, index);
    if (element == MeshElement::face) return vertices + placeIn(surroundings.faces, index);
    if (element == MeshElement::edge) {
        const MeshEdge& edge = mesh.edges()[index];
        return vertices + facePoints + edgeBetween(part, surroundings.number(edge.v0),
                                                   surroundings.number(edge.v1));
    }
    const std::size_t face = faceOfCorner(mesh.faces(), index);
    return part.faces().begin(placeIn(surroundings.faces, face)) +
           (index - mesh.faces().begin(face));
}

std::optional<Error> checkElement(const Mesh& mesh, MeshScheme scheme, MeshElement element,
                                  std::size_t index) {
    const std::string name(elementNames[static_cast<std::size_t>(element)]);
    if (!hasStencil(scheme, element)) {
        std::string others;
        for (const MeshElement other : {MeshElement::vertex, MeshElement::edge, MeshElement::face,
                                        MeshElement::corner}) {
            if (!hasStencil(scheme, other)) continue;
            others += (others.empty() ? "" : " and ") +
                      std::string(elementNames[static_cast<std::size_t>(other)]);
        }
        return refuse(Code::notSupported, "of",
                      std::string(meshSchemeNames[static_cast<std::size_t>(scheme)]) +
                          " makes no points of " + name + "; it makes them of " + others + ".");
    }
    const std::size_t count = elementCount(mesh, element);
    if (index < count) return std::nullopt;
    return refuse(Code::outOfRange, "index",
                  "There is no " + std::to_string(index) + " among the " + std::to_string(count) +
                      " " + name + " of this mesh.");
}

}  // namespace

bool hasStencil(MeshScheme scheme, MeshElement element) noexcept {
    switch (scheme) {
        case MeshScheme::catmullClark: return element != MeshElement::corner;
        case MeshScheme::dooSabin: return element == MeshElement::corner;
        case MeshScheme::loop:
        case MeshScheme::butterfly:
            return element == MeshElement::vertex || element == MeshElement::edge;
        case MeshScheme::sqrt3: break;
    }
    return element == MeshElement::vertex || element == MeshElement::face;
}

std::size_t elementCount(const Mesh& mesh, MeshElement element) {
    switch (element) {
        case MeshElement::vertex: return mesh.points().size();
        case MeshElement::edge: return mesh.edges().size();
        case MeshElement::face: return mesh.faces().count();
        case MeshElement::corner: break;
    }
    return mesh.corners().size();
}

Result<MeshStencil> stencil(const Mesh& mesh, MeshScheme scheme, MeshElement element,
                            std::size_t index) {
    if (auto wrong = checkElement(mesh, scheme, element, index)) return *std::move(wrong);
    const Surroundings part = around(mesh, verticesOf(mesh, element, index));
    const std::size_t count = part.vertices.size();
    if (count > mostAround) {
        return refuse(Code::tooLarge, "index",
                      std::to_string(count) + " vertices lie around this element; up to " +
                          std::to_string(mostAround) + " can be shown.");
    }
    std::vector<Vec3> points;
    for (const std::uint32_t v : part.vertices) points.push_back(mesh.points()[v]);
    if (part.faces.empty()) return MeshStencil{points[0], {{part.vertices[0], 1}}};
    const Mesh own = partWith(mesh, part, std::move(points));
    const auto finer = subdivide(own, scheme, 1);
    if (!finer) return finer.error();
    const std::size_t place = finerNumber(mesh, own, part, scheme, element, index);
    MeshStencil made{finer->points()[place], {}};
    for (std::size_t first = 0; first < count; first += 3) {  // three unknowns a point
        std::vector<Vec3> units(count, Vec3{0});
        const std::size_t last = std::min(first + 3, count);
        for (std::size_t i = first; i < last; ++i) units[i] = axes[i - first];
        const auto image = subdivide(partWith(mesh, part, std::move(units)), scheme, 1);
        for (std::size_t i = first; i < last; ++i) {
            const double weight = image->points()[place][static_cast<int>(i - first)];
            if (std::abs(weight) > noWeight) made.weights.push_back({part.vertices[i], weight});
        }
    }
    return made;
}

}  // namespace knotwork
