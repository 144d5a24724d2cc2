// The surfaces that lie on the GPU: each is sent once, and again when it has changed.
//
// A surface is known by the identity of its shape. Buffers of one whose shape is gone are taken over
// by the next that comes (a surface that is dragged leaves its former self behind in every frame)
// and freed at the end of the view otherwise. Triangles that are the same in number and order are
// not sent again.
#pragma once

#include "render/gl/device.hpp"
#include "render/projection.hpp"
#include "render/surface_vertices.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace knotwork::render {

class SurfaceStore {
public:
    struct Surface {
        std::weak_ptr<const void> identity;
        gl::SurfaceBuffers buffers;
        Vec3 origin{0.0};   ///< of its vertices
        double reach = 0;   ///< from there to the farthest of them that counts, about
        /// The fingerprint of the triangles that were sent, where they are in the shape's order.
        std::optional<std::uint64_t> triangles;
        /// The slabs of triangles that are in order of depth, and for which eye they are.
        std::vector<std::size_t> slabs;
        Vec3 sortedFor{0.0};
        DepthRange sortedOver;
    };

    /// The surface of a shape of triangles with indices, sent where that is necessary: its vertices
    /// to a quarter of a pixel in the projection, its triangles in the shape's order.
    Surface& inOrder(gl::Device& device, const drawing::Shape& shape,
                     const Projection& projection);
    /// The same with triangles from the farthest to the nearest, cut at equal distances.
    Surface& farthestFirst(gl::Device& device, const drawing::Shape& shape,
                           const Projection& projection, const DepthRange& depths,
                           std::size_t slabs);

    /// Frees what no shape has any more.
    void sweep();
    /// After a lost context.
    void forget() noexcept;

    /// Vertices sent since the last call.
    [[nodiscard]] std::size_t takeSent() noexcept { return std::exchange(sent_, 0U); }
    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    Surface& withVertices(gl::Device& device, const drawing::Shape& shape,
                          const Projection& projection);
    Surface& slotFor(gl::Device& device, const drawing::Shape& shape);

    std::vector<std::unique_ptr<Surface>> surfaces_;
    std::vector<SurfaceVertex> vertices_;
    DepthOrder order_;
    std::size_t sent_ = 0;
};

}  // namespace knotwork::render
