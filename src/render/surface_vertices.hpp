// Surfaces as the program of lit surfaces reads them, and the order in which transparent triangles
// are painted. These loops run over a hundred thousand vertices in a frame of a drag.
#pragma once

#include "drawing/colour_bytes.hpp"

#include "geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork::render {

using drawing::ColourBytes;

struct SurfaceVertex {
    std::array<float, 3> position{};        ///< from an origin near the surface
    std::array<std::int16_t, 4> normal{};   ///< 32767 for 1; the fourth fills up
    ColourBytes colour{255, 255, 255, 255}; ///< by which the colour of the surface is multiplied
};
static_assert(sizeof(SurfaceVertex) == 24);

/// The vertices of x,y,z triples and their unit normals, of which there are as many, or none: then
/// all look along z. `colours` has one a position, or none. O(positions).
void packSurface(const drawing::Shape& shape, const Vec3& origin,
                 std::vector<SurfaceVertex>& vertices);

/// The middle of the box round x,y,z triples and the distance from it to a corner. O(positions).
struct Extent {
    Vec3 centre{0.0};
    double radius = 0;
};
[[nodiscard]] Extent extentOf(std::span<const double> positions) noexcept;

/// A number that two lists share only when they are equal (or once in 2^64). O(n), 1 ns for 8 bytes.
[[nodiscard]] std::uint64_t fingerprint(std::span<const std::uint32_t> indices) noexcept;

/// How far x,y,z triples lie along a direction.
struct DepthRange {
    double farthest = 0;
    double nearest = 0;
    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};
[[nodiscard]] DepthRange depthRange(std::span<const double> positions,
                                    const Vec3& towardsEye) noexcept;

/// Triangles from the farthest to the nearest along `towardsEye`, as steps of 1/4096 of `depths`
/// tell them apart; equally far ones keep their order. A counting sort, O(triangles).
class DepthOrder {
public:
    /// The slabs into which `depths` is cut for surfaces that may pass through each other: the
    /// triangles of slab s are the corners from starts()[s] to starts()[s + 1] of indices().
    void sort(const drawing::Shape& shape, const Vec3& towardsEye, const DepthRange& depths,
              std::size_t slabs);
    [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return indices_; }
    [[nodiscard]] std::span<const std::size_t> starts() const noexcept { return starts_; }

private:
    std::vector<float> vertexDepths_;
    std::vector<std::uint16_t> keys_;
    std::vector<std::uint32_t> counts_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::size_t> starts_;
};

}  // namespace knotwork::render
