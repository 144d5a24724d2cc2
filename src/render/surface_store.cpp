#include "render/surface_store.hpp"

#include <algorithm>
#include <array>

namespace knotwork::render {
namespace {

using gl::Attribute;

constexpr std::array surfaceAttributes{
    Attribute{Attribute::Type::floats, 3, 0},
    Attribute{Attribute::Type::direction, 3, offsetof(SurfaceVertex, normal)},
    Attribute{Attribute::Type::colour, 4, offsetof(SurfaceVertex, colour)},
};

/// Half a unit in the last place of a float of size 1.
constexpr double floatRounding = 6e-8;
constexpr double visibleError = 0.25;  // device pixels

bool isSame(const std::weak_ptr<const void>& a, const std::shared_ptr<const void>& b) noexcept {
    return b != nullptr && !a.owner_before(b) && !b.owner_before(a);
}

/// The error of the vertices in the picture, or of the origin itself once that is far away.
double errorAt(const SurfaceStore::Surface& surface, const Projection& projection) noexcept {
    const double far = std::max(surface.reach, glm::length(projection.centre() - surface.origin));
    return floatRounding * far / projection.unitsPerPixel().x;
}

}  // namespace

SurfaceStore::Surface& SurfaceStore::slotFor(gl::Device& device, const drawing::Shape& shape) {
    for (const auto& surface : surfaces_) {
        if (isSame(surface->identity, shape.identity)) return *surface;
    }
    Surface* slot = nullptr;
    for (const auto& surface : surfaces_) {
        if (!surface->identity.expired()) continue;
        if (slot == nullptr || surface->buffers.corners == shape.indices.size()) {
            slot = surface.get();
        }
    }
    if (slot == nullptr) {
        surfaces_.push_back(std::make_unique<Surface>());
        slot = surfaces_.back().get();
        slot->buffers =
            device.makeSurfaceBuffers({surfaceAttributes, sizeof(SurfaceVertex)});
    }
    slot->identity.reset();
    return *slot;
}

SurfaceStore::Surface& SurfaceStore::withVertices(gl::Device& device, const drawing::Shape& shape,
                                                  const Projection& projection) {
    Surface& surface = slotFor(device, shape);
    const bool known = isSame(surface.identity, shape.identity);
    if (known && errorAt(surface, projection) <= visibleError) return surface;
    const Extent extent = extentOf(shape.positions);
    surface.origin = extent.centre;
    surface.reach = extent.radius;
    if (errorAt(surface, projection) > visibleError) {
        // So near that only what surrounds the middle of the pane can be seen.
        surface.origin = projection.centre();
        surface.reach = 0;
    }
    packSurface(shape, surface.origin, vertices_);
    device.sendVertices(surface.buffers, std::as_bytes(std::span(vertices_)));
    sent_ += vertices_.size();
    surface.identity = shape.identity;
    if (!known) surface.slabs.clear();
    return surface;
}

SurfaceStore::Surface& SurfaceStore::inOrder(gl::Device& device, const drawing::Shape& shape,
                                             const Projection& projection) {
    const std::size_t before = sent_;
    Surface& surface = withVertices(device, shape, projection);
    if (sent_ == before && surface.triangles) return surface;
    const std::uint64_t wanted = fingerprint(shape.indices);
    if (surface.triangles != wanted) device.sendTriangles(surface.buffers, shape.indices);
    surface.triangles = wanted;
    surface.slabs.clear();
    return surface;
}

SurfaceStore::Surface& SurfaceStore::farthestFirst(gl::Device& device,
                                                   const drawing::Shape& shape,
                                                   const Projection& projection,
                                                   const DepthRange& depths, std::size_t slabs) {
    Surface& surface = withVertices(device, shape, projection);
    const Mat3& orientation = projection.orientation();
    const Vec3 towardsEye(orientation[0][2], orientation[1][2], orientation[2][2]);
    if (surface.slabs.size() == slabs + 1 && surface.sortedFor == towardsEye &&
        surface.sortedOver == depths) {
        return surface;
    }
    order_.sort(shape, towardsEye, depths, slabs);
    device.sendTriangles(surface.buffers, order_.indices());
    surface.slabs.assign(order_.starts().begin(), order_.starts().end());
    surface.sortedFor = towardsEye;
    surface.sortedOver = depths;
    surface.triangles.reset();
    return surface;
}

void SurfaceStore::sweep() {
    std::erase_if(surfaces_, [](const auto& surface) { return surface->identity.expired(); });
}

void SurfaceStore::forget() noexcept {
    for (const auto& surface : surfaces_) surface->buffers.forget();
    surfaces_.clear();
}

std::size_t SurfaceStore::bytes() const noexcept {
    std::size_t sum = 0;
    for (const auto& surface : surfaces_) sum += surface->buffers.bytes();
    return sum;
}

}  // namespace knotwork::render
