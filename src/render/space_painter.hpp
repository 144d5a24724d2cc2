// Panes in space: what is nearer hides what is behind it.
//
// All of such a pane is gathered first and then painted into a framebuffer of several samples a
// pixel, in this order: opaque surfaces; of lines and points that fade, what is hidden, faintly;
// what is seen through transparent surfaces; those, from the farthest to the nearest; lines and
// points that nothing hides; what shows over everything. Where a curve passes before other lines it
// cuts a small gap into them, as a drawing by hand does.
#pragma once

#include "render/gl/device.hpp"
#include "render/line_vertices.hpp"
#include "render/point_vertices.hpp"
#include "render/surface_store.hpp"
#include "render/triangle_vertices.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace knotwork::render {

/// What a line or a point does behind a surface.
enum class Behind {
    vanishes,
    fades,  ///< stays faintly visible
    shows,  ///< is painted over everything
};

/// Lines by how they meet what is before and behind them.
enum class LineLayer { onSurface, net, curve, over };
inline constexpr std::size_t lineLayers = 4;
inline constexpr std::size_t pointLayers = 3;  ///< one a Behind

/// The programs that flat panes have as well.
struct SharedPrograms {
    const gl::Pipeline& lines;
    const gl::Pipeline& points;
};

struct PaintCounts {
    int drawCalls = 0;
    std::size_t vertices = 0;
};

class SpacePainter {
public:
    /// Compiles the program; false with the reason in `message` when that is impossible.
    [[nodiscard]] bool start(gl::Device& device, std::string& message);
    void forget() noexcept;

    [[nodiscard]] LineVertices& lines(LineLayer layer) noexcept {
        return lineVertices_[static_cast<std::size_t>(layer)];
    }
    [[nodiscard]] PointVertices& points(Behind behind) noexcept {
        return pointVertices_[static_cast<std::size_t>(behind)];
    }
    /// A shape of triangles with indices that lives until paint().
    void add(const drawing::Shape& shape, const scene::Colour& colour);

    /// Paints what was gathered into a cleared pane of the canvas, and forgets it.
    PaintCounts paint(gl::Device& device, const SharedPrograms& programs,
                      const Projection& projection, double pixelRatio,
                      const scene::Colour& background);

    /// Frees the surfaces that no shape has any more.
    void sweep() { store_.sweep(); }
    [[nodiscard]] std::size_t bufferBytes() const noexcept;

private:
    struct Surface {
        const drawing::Shape* shape = nullptr;
        scene::Colour colour;
        bool opaque = true;
    };
    struct Painting;

    void send(Painting& painting);
    void paintOpaque(Painting& painting);
    void paintTransparent(Painting& painting);
    void paintHidden(Painting& painting);
    void paintSeen(Painting& painting);
    void cutGaps(Painting& painting);
    void paintLines(Painting& painting, LineLayer layer, const gl::Pass& pass = {});
    void paintPoints(Painting& painting, Behind behind, const gl::Pass& pass = {});
    void drop() noexcept;

    gl::SurfacePipeline pipeline_;
    gl::Target target_;
    SurfaceStore store_;
    std::array<gl::Records, lineLayers> lineRecords_;
    std::array<gl::Records, pointLayers> pointRecords_;
    std::array<LineVertices, lineLayers> lineVertices_;
    std::array<PointVertices, pointLayers> pointVertices_;
    std::vector<Surface> surfaces_;
};

}  // namespace knotwork::render
