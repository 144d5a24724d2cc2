// Paints shapes with WebGL 2 into the lower left corner of the current framebuffer.
//
// One renderer serves every view of a page: nothing of a view outlives endView() but caches that
// any view may use. A frame is
//
//     renderer.beginView(width, height, background);
//     renderer.beginPane(rect, projection, pixelRatio);
//     renderer.paint(shape, options);      // in painting order
//     renderer.endPane();
//     renderer.endView();
//
// In a pane whose projection is deep, what is nearer hides what is behind it: all of it is painted by
// endPane() (space_painter.hpp), until when the shapes of triangles given to paint() must live, and
// painting order decides among lines only.
//
// Lines and points are antialiased over one device pixel by their distance from the pixel's
// centre; sizes are CSS pixels. Colours are blended premultiplied, so that the canvas may be
// composited over the page.
#pragma once

#include "drawing/drawing.hpp"
#include "render/gl/device.hpp"
#include "render/line_vertices.hpp"
#include "render/point_vertices.hpp"
#include "render/projection.hpp"
#include "render/space_painter.hpp"
#include "render/triangle_vertices.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace knotwork::render {

using scene::Colour;

/// How a line is stroked; lengths in CSS pixels.
struct Stroke {
    Colour colour{};
    double width = 1;
    bool dashed = false;
    bool crisp = false;  ///< of segments: upright and level ones are moved to whole device pixels
    double halo = 0;     ///< width of the halo beyond either edge, 0 for none
    Colour haloColour{};
    Behind behind = Behind::fades;  ///< in a deep pane
    bool cuts = false;              ///< there: cuts a gap into the lines that it passes before
};

/// One element of a list of points that stands out.
struct Highlight {
    std::size_t index = 0;
    double strength = 1;  ///< 0 for none to 1 for full: hovering uses less than selecting
};

/// How points are set; lengths in CSS pixels.
struct Dots {
    Colour colour{};
    double diameter = 8;
    bool square = false;
    double border = 0;
    Colour borderColour{};
    double halo = 9;     ///< width of the halo of a fully highlighted point
    Colour haloColour{};
    std::span<const Highlight> highlights = {};
    Behind behind = Behind::fades;  ///< in a deep pane
};

/// What a view adds to a shape that a drawing describes.
struct PaintOptions {
    std::optional<Colour> colour = {};   ///< in place of the shape's own
    double opacity = 1;
    double extraWidth = 0;       ///< CSS pixels added to the line width or the point diameter
    double halo = 0;             ///< of a line that is emphasised as a whole, CSS pixels
    std::optional<Colour> haloColour = {};   ///< default: the shape's, at a quarter of its opacity
    double border = 1.5;         ///< of points
    Colour borderColour{1, 1, 1, 1};
    std::span<const Highlight> highlights = {};  ///< elements of a list of points
    /// In a deep pane. Default: lines on surfaces vanish behind them, all others fade.
    std::optional<Behind> behind = {};
};

/// What the last frame cost and what is alive now.
struct Stats {
    int drawCalls = 0;          ///< since the last beginView
    std::size_t vertices = 0;   ///< sent to the GPU since the last beginView
    gl::Counts live;            ///< GL objects that exist
    std::size_t bufferBytes = 0;
};

class Renderer {
public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Compiles the programs in the current GL context (also after forget(), in the restored one).
    /// False when that is impossible; message() then holds the driver's reason.
    [[nodiscard]] bool start();
    [[nodiscard]] const std::string& message() const noexcept { return message_; }
    [[nodiscard]] bool started() const noexcept { return started_; }
    /// The context was lost: every GL name is dead, nothing is deleted. Until the next start() all
    /// painting is ignored.
    void forget() noexcept;

    void beginView(int width, int height, const Colour& background);
    /// Painting goes to `pane` and nowhere else until endPane(). A background clears the pane; a
    /// deep one has that of the view where it has none of its own.
    void beginPane(const Rect& pane, const Projection& projection, double pixelRatio,
                   const std::optional<Colour>& background = std::nullopt);
    /// Polylines, points and triangles as their kind says; labels are the page's to write.
    void paint(const drawing::Shape& shape, const PaintOptions& options = {});
    // The same without a shape, for decoration: positions are x,y,z triples of the pane's world.
    void polyline(std::span<const double> positions, const Stroke& stroke);
    /// Independent segments, two points each: ticks, grids, stems.
    void segments(std::span<const double> positions, const Stroke& stroke);
    void points(std::span<const double> positions, const Dots& dots);
    /// Three points a triangle; triangles of one call should not overlap when colour is not opaque.
    void triangles(std::span<const double> positions, const Colour& colour);
    /// The area between a graph and the line y = base, for fills under functions.
    void areaUnder(std::span<const double> graph, double base, const Colour& colour);
    void endPane();
    void endView();

    [[nodiscard]] Stats stats() const noexcept;

private:
    enum class Batch { none, lines, points, triangles };
    void switchTo(Batch batch);
    void edges(const drawing::Shape& shape, const Stroke& stroke);
    void flush();
    void flushSpace();
    [[nodiscard]] bool deep() const noexcept { return projection_ && projection_->deep(); }
    [[nodiscard]] LineVertices& linesFor(const Stroke& stroke);
    [[nodiscard]] PointVertices& pointsFor(const Dots& dots);
    /// Pixels of depth.
    [[nodiscard]] double nearerBy(double pixels) const noexcept;
    void stroke(const drawing::Shape& shape, Stroke stroke);

    gl::Device device_;
    gl::Pipeline lines_;
    gl::Pipeline points_;
    gl::Pipeline triangles_;
    LineVertices lineVertices_;
    PointVertices pointVertices_;
    TriangleVertices triangleVertices_;
    SpacePainter space_;
    Colour background_;      ///< of the pane or the view
    std::vector<double> scratch_;
    Batch batch_ = Batch::none;
    std::optional<Projection> projection_;
    double pixelRatio_ = 1;
    bool started_ = false;
    std::string message_;
    Stats stats_;
};

}  // namespace knotwork::render
