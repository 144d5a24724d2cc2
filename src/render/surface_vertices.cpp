#include "render/surface_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knotwork::render {
namespace {

constexpr std::size_t depthSteps = 4096;

std::int16_t toShort(double component) noexcept {
    return static_cast<std::int16_t>(component * 32767);
}

std::uint64_t mixed(std::uint64_t state, std::uint64_t word) noexcept {
    const std::uint64_t product = (state ^ word) * 0x9e3779b97f4a7c15U;
    return product ^ (product >> 29U);
}

std::uint64_t pairOf(const std::uint32_t* p) noexcept {
    return static_cast<std::uint64_t>(p[0]) << 32U | p[1];
}

}  // namespace

void packSurface(const drawing::Shape& shape, const Vec3& origin,
                 std::vector<SurfaceVertex>& vertices) {
    const std::size_t count = shape.positions.size() / 3;
    vertices.assign(count, SurfaceVertex{{}, {0, 0, 32767, 0}, {255, 255, 255, 255}});
    const double* p = shape.positions.data();
    for (SurfaceVertex& vertex : vertices) {
        vertex.position = {static_cast<float>(p[0] - origin.x), static_cast<float>(p[1] - origin.y),
                           static_cast<float>(p[2] - origin.z)};
        p += 3;
    }
    if (shape.normals.size() == shape.positions.size()) {
        const double* n = shape.normals.data();
        for (SurfaceVertex& vertex : vertices) {
            vertex.normal = {toShort(n[0]), toShort(n[1]), toShort(n[2]), 0};
            n += 3;
        }
    }
    if (shape.colours.size() != count) return;
    for (std::size_t i = 0; i < count; ++i) vertices[i].colour = shape.colours[i];
}

Extent extentOf(std::span<const double> positions) noexcept {
    if (positions.size() < 3) return {};
    Vec3 low(positions[0], positions[1], positions[2]);
    Vec3 high = low;
    for (std::size_t i = 3; i + 2 < positions.size(); i += 3) {
        const Vec3 p(positions[i], positions[i + 1], positions[i + 2]);
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {0.5 * (low + high), 0.5 * glm::length(high - low)};
}

std::uint64_t fingerprint(std::span<const std::uint32_t> indices) noexcept {
    // Four chains that do not wait for each other.
    std::array<std::uint64_t, 4> state{1, 2, 3, indices.size()};
    std::size_t i = 0;
    for (; i + 8 <= indices.size(); i += 8) {
        for (std::size_t lane = 0; lane < 4; ++lane) {
            state[lane] = mixed(state[lane], pairOf(&indices[i + 2 * lane]));
        }
    }
    for (; i < indices.size(); ++i) state[0] = mixed(state[0], indices[i]);
    return std::accumulate(state.begin(), state.end(), std::uint64_t{0}, mixed);
}

DepthRange depthRange(std::span<const double> positions, const Vec3& towardsEye) noexcept {
    if (positions.size() < 3) return {};
    DepthRange range{1e300, -1e300};
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
        const double depth = glm::dot(
            towardsEye, Vec3(positions[i], positions[i + 1], positions[i + 2]));
        range.farthest = std::min(range.farthest, depth);
        range.nearest = std::max(range.nearest, depth);
    }
    return range;
}

void DepthOrder::sort(const drawing::Shape& shape, const Vec3& towardsEye,
                      const DepthRange& depths, std::size_t slabs) {
    const double length = depths.nearest - depths.farthest;
    // of the sum of three depths
    const double scale = length > 0 ? static_cast<double>(depthSteps) / (3 * length) : 0;
    const std::size_t vertexCount = shape.positions.size() / 3;
    vertexDepths_.resize(vertexCount);
    const double* p = shape.positions.data();
    for (float& depth : vertexDepths_) {
        const double along = towardsEye.x * p[0] + towardsEye.y * p[1] + towardsEye.z * p[2];
        depth = static_cast<float>((along - depths.farthest) * scale);
        p += 3;
    }
    const std::size_t triangles = shape.indices.size() / 3;
    keys_.resize(triangles);
    counts_.assign(depthSteps + 1, 0);
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::uint32_t* corners = &shape.indices[3 * t];
        const float sum = vertexDepths_[corners[0]] + vertexDepths_[corners[1]] +
                          vertexDepths_[corners[2]];
        const float most = static_cast<float>(depthSteps - 1);
        keys_[t] = static_cast<std::uint16_t>(sum > 0 ? std::min(sum, most) : 0);
        ++counts_[keys_[t] + 1U];
    }
    std::partial_sum(counts_.begin(), counts_.end(), counts_.begin());
    starts_.clear();
    for (std::size_t s = 0; s <= slabs; ++s) {
        starts_.push_back(3 * static_cast<std::size_t>(counts_[s * depthSteps / slabs]));
    }
    indices_.resize(3 * triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        std::copy_n(&shape.indices[3 * t], 3,
                    &indices_[3 * static_cast<std::size_t>(counts_[keys_[t]]++)]);
    }
}

}  // namespace knotwork::render
