// Walking from corner to corner: along a face, across an edge, around a vertex.
//
// A corner stands for the half-edge from it to the next corner of its face. The faces around a
// vertex form fans: closed ones inside, open ones on a boundary, counter-clockwise from the corner
// whose half-edge lies on the boundary.
#pragma once

#include "geometry/mesh.hpp"
#include "geometry/steps.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork {

inline constexpr std::uint32_t noCorner = 0xffffffffU;

/// The corners of a mesh and how they lie together. O(corners); 4 to 8 bytes a corner.
class CornerWalk {
public:
    /// With the edges' numbers in the order of Mesh::edges().
    CornerWalk(const FaceRows& faces, std::span<const std::uint32_t> cornerEdges,
               std::size_t edges);

    [[nodiscard]] std::size_t face(std::size_t corner) const noexcept {
        step();
        if (faces_.uniformSize == 3) return corner / 3;
        if (faces_.uniformSize == 4) return corner / 4;
        return faces_.uniformSize != 0 ? corner / faces_.uniformSize : faceOf_[corner];
    }
    [[nodiscard]] std::uint32_t next(std::size_t corner) const noexcept {
        const std::size_t f = face(corner);
        return narrow(corner + 1 < faces_.begin(f + 1) ? corner + 1 : faces_.begin(f));
    }
    [[nodiscard]] std::uint32_t previous(std::size_t corner) const noexcept {
        const std::size_t f = face(corner);
        return narrow(corner > faces_.begin(f) ? corner - 1 : faces_.begin(f + 1) - 1);
    }
    /// The corner whose half-edge runs back, or noCorner on a boundary.
    [[nodiscard]] std::uint32_t twin(std::size_t corner) const noexcept {
        step();
        return twins_[corner];
    }
    /// The corner at the same vertex one face further counter-clockwise, or noCorner after the
    /// last.
    [[nodiscard]] std::uint32_t turned(std::size_t corner) const noexcept {
        return twins_[previous(corner)];
    }
    [[nodiscard]] std::uint32_t vertex(std::size_t corner) const noexcept {
        step();
        return faces_.corners[corner];
    }
    /// Where the half-edge ends.
    [[nodiscard]] std::uint32_t neighbour(std::size_t corner) const noexcept {
        return faces_.corners[next(corner)];
    }
    [[nodiscard]] std::size_t corners() const noexcept { return twins_.size(); }

private:
    static std::uint32_t narrow(std::size_t index) noexcept {
        return static_cast<std::uint32_t>(index);
    }

    FaceRows faces_;
    std::vector<std::uint32_t> twins_;
    std::vector<std::uint32_t> faceOf_;  ///< empty where all faces have the same size
};

/// The corners of one fan at one vertex, counter-clockwise.
struct Fan {
    std::uint32_t vertex = 0;
    bool closed = true;
    std::span<const std::uint32_t> corners;
};

/// Fills `corners` with those of the fan that begins at `first`; answers whether it is closed.
bool walkFan(const CornerWalk& walk, std::uint32_t first, std::vector<std::uint32_t>& corners);

/// Calls visit(const Fan&) for every fan: open ones in the order of their boundary corners, then
/// the closed ones in the order of their first corners. O(corners).
template <class Visit>
void forEachFan(const CornerWalk& walk, Visit visit) {
    std::vector<bool> seen(walk.corners(), false);
    std::vector<std::uint32_t> corners;
    const auto go = [&](std::size_t first) {
        const bool closed = walkFan(walk, static_cast<std::uint32_t>(first), corners);
        for (const std::uint32_t corner : corners) seen[corner] = true;
        visit(Fan{walk.vertex(first), closed, corners});
    };
    for (std::size_t c = 0; c < walk.corners(); ++c) {
        if (walk.twin(c) == noCorner) go(c);
    }
    for (std::size_t c = 0; c < walk.corners(); ++c) {
        if (!seen[c]) go(c);
    }
}

}  // namespace knotwork
