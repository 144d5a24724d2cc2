#include "render/space_painter.hpp"

#include "render/surface_shaders.hpp"

#include <algorithm>

namespace knotwork::render {
namespace {

/// Of the opacity of what is hidden.
constexpr float faint = 0.28F;
/// CSS pixels on either side of a curve that passes before another line.
constexpr double gap = 1.5;
/// How far, in pixels of depth, a curve stands back when it cuts gaps, so that it does not cut
/// itself; and by how much of its slope over its own width.
constexpr double standBack = 5;
constexpr float ownSlope = 8;
/// Slabs of transparent surfaces that may pass through each other.
constexpr std::size_t manySlabs = 48;

gl::SurfaceView viewOf(const Projection& projection, const Vec3& origin,
                       const scene::Colour& colour) noexcept {
    gl::SurfaceView view;
    const glm::dmat4 clip = projection.clipFrom(origin);
    for (std::size_t i = 0; i < 16; ++i) {
        view.clip[i] = static_cast<float>(clip[static_cast<int>(i / 4)][static_cast<int>(i % 4)]);
    }
    const Mat3& to = projection.orientation();
    for (std::size_t i = 0; i < 9; ++i) {
        view.orientation[i] =
            static_cast<float>(to[static_cast<int>(i / 3)][static_cast<int>(i % 3)]);
    }
    view.paint = {static_cast<float>(colour.red), static_cast<float>(colour.green),
                  static_cast<float>(colour.blue), static_cast<float>(colour.alpha)};
    return view;
}

Vec3 towardsEye(const Projection& projection) noexcept {
    const Mat3& to = projection.orientation();
    return {to[0][2], to[1][2], to[2][2]};
}

}  // namespace

struct SpacePainter::Painting {
    gl::Device& device;
    const SharedPrograms& programs;
    const Projection& projection;
    double pixelRatio = 1;
    PaintCounts counts = {};
};

void SpacePainter::add(const drawing::Shape& shape, const scene::Colour& colour) {
    const bool opaque =
        colour.alpha >= 1 && std::all_of(shape.colours.begin(), shape.colours.end(),
                                         [](const ColourBytes& c) { return c[3] == 255; });
    const bool own = !shape.colours.empty();
    surfaces_.push_back({&shape, own ? scene::Colour{1, 1, 1, colour.alpha} : colour, opaque});
}

bool SpacePainter::start(gl::Device& device, std::string& message) {
    auto made = device.makeSurfacePipeline(surfaceVertexShader, surfaceFragmentShader);
    if (made) pipeline_ = std::move(made).value();
    else message = made.error().message;
    return made.ok();
}

void SpacePainter::forget() noexcept {
    pipeline_.forget();
    target_.forget();
    store_.forget();
    for (gl::Records& records : lineRecords_) records.forget();
    for (gl::Records& records : pointRecords_) records.forget();
    drop();
}

void SpacePainter::drop() noexcept {
    for (LineVertices& lines : lineVertices_) lines.clear();
    for (PointVertices& points : pointVertices_) points.clear();
    surfaces_.clear();
}

/// Records are made when there is first something for them: most pages show nothing in space.
void SpacePainter::send(Painting& painting) {
    const auto send = [&](const gl::Pipeline& pipeline, gl::Records& records,
                          const auto& vertices) {
        if (vertices.empty() && !records.texture) return;
        if (!records.texture) records = painting.device.makeRecords();
        if (vertices.empty() && records.count == 0) return;
        painting.device.send(pipeline, records, std::as_bytes(std::span(vertices.records())));
        painting.counts.vertices += vertices.records().size();
    };
    const SharedPrograms& programs = painting.programs;
    for (std::size_t i = 0; i < lineLayers; ++i) {
        send(programs.lines, lineRecords_[i], lineVertices_[i]);
    }
    for (std::size_t i = 0; i < pointLayers; ++i) {
        pointVertices_[i].sortFarthestFirst();
        send(programs.points, pointRecords_[i], pointVertices_[i]);
    }
}

void SpacePainter::paintLines(Painting& painting, LineLayer layer, const gl::Pass& pass) {
    if (lines(layer).empty()) return;
    painting.device.draw(painting.programs.lines, lineRecords_[static_cast<std::size_t>(layer)],
                         painting.projection.pane(), pass);
    ++painting.counts.drawCalls;
}

void SpacePainter::paintPoints(Painting& painting, Behind behind, const gl::Pass& pass) {
    if (points(behind).empty()) return;
    painting.device.draw(painting.programs.points, pointRecords_[static_cast<std::size_t>(behind)],
                         painting.projection.pane(), pass);
    ++painting.counts.drawCalls;
}

void SpacePainter::paintOpaque(Painting& painting) {
    painting.device.setDepth(gl::Depth::written);
    for (const Surface& surface : surfaces_) {
        if (!surface.opaque) continue;
        const auto& stored =
            store_.inOrder(painting.device, *surface.shape, painting.projection);
        painting.device.draw(pipeline_, stored.buffers,
                             viewOf(painting.projection, stored.origin, surface.colour), 0,
                             stored.buffers.corners);
        ++painting.counts.drawCalls;
    }
}

/// Several surfaces are cut into slabs at equal distances from the eye, each of which is painted of
/// all of them before the next: right also where they pass through each other, but for what lies in
/// one slab.
void SpacePainter::paintTransparent(Painting& painting) {
    std::vector<Surface> transparent;
    DepthRange depths{1e300, -1e300};
    const Vec3 eye = towardsEye(painting.projection);
    for (const Surface& surface : surfaces_) {
        if (surface.opaque) continue;
        const DepthRange own = depthRange(surface.shape->positions, eye);
        depths = {std::min(depths.farthest, own.farthest), std::max(depths.nearest, own.nearest)};
        transparent.push_back(surface);
    }
    const std::size_t slabs = transparent.size() > 1 ? manySlabs : 1;
    const auto paintAll = [&](gl::Depth depth) {
        painting.device.setDepth(depth);
        for (std::size_t s = 0; s < slabs; ++s) {
            for (const Surface& surface : transparent) {
                const auto& stored = store_.farthestFirst(
                    painting.device, *surface.shape, painting.projection, depths, slabs);
                const std::size_t first = stored.slabs[s];
                const std::size_t count = stored.slabs[s + 1] - first;
                if (count == 0) continue;
                painting.device.draw(pipeline_, stored.buffers,
                                     viewOf(painting.projection, stored.origin, surface.colour),
                                     first, count);
                ++painting.counts.drawCalls;
            }
        }
    };
    paintAll(gl::Depth::nearer);
    paintAll(gl::Depth::writtenOnly);
}

void SpacePainter::paintHidden(Painting& painting) {
    const gl::Pass hidden{faint, 0, 0, 0};
    painting.device.setDepth(gl::Depth::farther);
    paintLines(painting, LineLayer::net, hidden);
    paintLines(painting, LineLayer::curve, hidden);
    paintPoints(painting, Behind::fades, hidden);
}

void SpacePainter::paintSeen(Painting& painting) {
    painting.device.setDepth(gl::Depth::nearer);
    paintLines(painting, LineLayer::onSurface);
    paintLines(painting, LineLayer::net);
    paintLines(painting, LineLayer::curve);
    paintPoints(painting, Behind::vanishes);
    paintPoints(painting, Behind::fades);
}

void SpacePainter::cutGaps(Painting& painting) {
    const Projection& projection = painting.projection;
    const double pixel = projection.depthPerUnit() * projection.unitsPerPixel().x;
    painting.device.setDepth(gl::Depth::masked);
    paintLines(painting, LineLayer::curve,
               {1, static_cast<float>(gap * painting.pixelRatio),
                static_cast<float>(standBack * painting.pixelRatio * pixel),
                ownSlope * static_cast<float>(painting.pixelRatio)});
}

PaintCounts SpacePainter::paint(gl::Device& device, const SharedPrograms& programs,
                                const Projection& projection, double pixelRatio,
                                const scene::Colour& background) {
    Painting painting{device, programs, projection, pixelRatio};
    const Rect& pane = projection.pane();
    const bool smooth = device.beginTarget(target_, pane.x + pane.width, pane.y + pane.height);
    device.setArea(pane);
    device.clear(background);
    device.clearDepth();
    send(painting);
    paintOpaque(painting);
    paintHidden(painting);
    if (!std::all_of(surfaces_.begin(), surfaces_.end(),
                     [](const Surface& surface) { return surface.opaque; })) {
        // Once more what is before them, at the end: there it is what nothing veils.
        paintSeen(painting);
        paintTransparent(painting);
    }
    cutGaps(painting);
    paintSeen(painting);
    device.setDepth(gl::Depth::ignored);
    paintLines(painting, LineLayer::over);
    paintPoints(painting, Behind::shows);
    if (smooth) device.endTarget(target_, pane);
    painting.counts.vertices += store_.takeSent();
    drop();
    return painting.counts;
}

std::size_t SpacePainter::bufferBytes() const noexcept {
    std::size_t sum = target_.bytes() + store_.bytes();
    for (const gl::Records& records : lineRecords_) sum += records.bytes;
    for (const gl::Records& records : pointRecords_) sum += records.bytes;
    return sum;
}

}  // namespace knotwork::render
