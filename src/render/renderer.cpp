#include "render/renderer.hpp"

#include "render/shaders.hpp"

#include <algorithm>

namespace knotwork::render {
namespace {

using drawing::toBytes;
const gl::Layout lineLayout{sizeof(LineVertex), 4, 6};
const gl::Layout pointLayout{sizeof(PointVertex), 1, 6};
const gl::Layout triangleLayout{sizeof(TriangleVertex), 1, 1};

template <class Record>
std::span<const std::byte> bytesOf(const std::vector<Record>& records) {
    return std::as_bytes(std::span(records));
}

Colour faded(Colour colour, double opacity) {
    colour.alpha *= opacity;
    return colour;
}

Behind usualBehind(drawing::Role role) noexcept {
    const bool onSurface =
        role == drawing::Role::isoline || role == drawing::Role::wireframe;
    return onSurface ? Behind::vanishes : Behind::fades;
}

double strengthAt(std::span<const Highlight> highlights, std::size_t index) {
    double strength = 0;
    for (const Highlight& h : highlights) {
        if (h.index == index) strength = std::max(strength, h.strength);
    }
    return strength;
}

}  // namespace

bool Renderer::start() {
    const auto make = [this](gl::Pipeline& pipeline, std::string_view vertexShader,
                             std::string_view fragmentShader, const gl::Layout& layout) {
        auto made = device_.makePipeline(vertexShader, fragmentShader, layout);
        if (made) pipeline = std::move(made).value();
        else message_ = made.error().message;
        return made.ok();
    };
    message_.clear();
    started_ = make(lines_, lineVertexShader, lineFragmentShader, lineLayout) &&
               make(points_, pointVertexShader, pointFragmentShader, pointLayout) &&
               make(triangles_, triangleVertexShader, triangleFragmentShader, triangleLayout) &&
               space_.start(device_, message_);
    return started_;
}

void Renderer::forget() noexcept {
    lines_.forget();
    points_.forget();
    triangles_.forget();
    space_.forget();
    lineVertices_.clear();
    pointVertices_.clear();
    triangleVertices_.clear();
    batch_ = Batch::none;
    started_ = false;
    projection_.reset();
}

void Renderer::beginView(int width, int height, const Colour& background) {
    stats_ = {};
    if (!started_) return;
    device_.prepare();
    device_.setArea({0, 0, width, height});
    device_.clear(background);
    background_ = background;
}

void Renderer::beginPane(const Rect& pane, const Projection& projection, double pixelRatio,
                         const std::optional<Colour>& background) {
    if (!started_ || pane.width <= 0 || pane.height <= 0) return;
    projection_ = projection;
    pixelRatio_ = pixelRatio;
    device_.setArea(pane);
    if (background && !projection.deep()) device_.clear(*background);
    if (background) background_ = *background;
}

void Renderer::endPane() {
    if (started_ && deep()) flushSpace();
    flush();
    projection_.reset();
}

void Renderer::endView() {
    if (!started_) return;
    space_.sweep();
    device_.release();
}

void Renderer::switchTo(Batch batch) {
    if (batch == batch_) return;
    flush();
    batch_ = batch;
}

void Renderer::flush() {
    const auto send = [this](gl::Pipeline& pipeline, auto& vertices) {
        if (vertices.empty()) return;
        device_.send(pipeline, pipeline.records, bytesOf(vertices.records()));
        device_.draw(pipeline, pipeline.records, projection_->pane());
        stats_.drawCalls += 1;
        stats_.vertices += vertices.records().size();
        vertices.clear();
    };
    if (started_ && projection_) {
        send(lines_, lineVertices_);
        send(points_, pointVertices_);
        send(triangles_, triangleVertices_);
    }
    batch_ = Batch::none;
}

void Renderer::flushSpace() {
    const SharedPrograms programs{lines_, points_};
    const PaintCounts counts =
        space_.paint(device_, programs, *projection_, pixelRatio_, background_);
    stats_.drawCalls += counts.drawCalls;
    stats_.vertices += counts.vertices;
}

LineVertices& Renderer::linesFor(const Stroke& stroke) {
    if (!deep()) {
        switchTo(Batch::lines);
        return lineVertices_;
    }
    switch (stroke.behind) {
        case Behind::vanishes: return space_.lines(LineLayer::onSurface);
        case Behind::shows: return space_.lines(LineLayer::over);
        default: return space_.lines(stroke.cuts ? LineLayer::curve : LineLayer::net);
    }
}

PointVertices& Renderer::pointsFor(const Dots& dots) {
    if (deep()) return space_.points(dots.behind);
    switchTo(Batch::points);
    return pointVertices_;
}

double Renderer::nearerBy(double pixels) const noexcept {
    return deep() ? pixels * projection_->unitsPerPixel().x * projection_->depthPerUnit() : 0;
}

void Renderer::polyline(std::span<const double> positions, const Stroke& stroke) {
    if (!projection_) return;
    LineVertices& lines = linesFor(stroke);
    const double width = stroke.width * pixelRatio_;
    const double period = stroke.dashed ? dashPeriod(stroke.width, pixelRatio_) : 0;
    const double nearer = nearerBy(0.5 * width + 1);
    if (stroke.halo > 0) {
        lines.polyline(*projection_, positions,
                       {width + 2 * stroke.halo * pixelRatio_, 0, toBytes(stroke.haloColour),
                        nearer});
    }
    lines.polyline(*projection_, positions, {width, period, toBytes(stroke.colour), nearer});
}

void Renderer::segments(std::span<const double> positions, const Stroke& stroke) {
    if (!projection_) return;
    const double width = stroke.width * pixelRatio_;
    const double period = stroke.dashed ? dashPeriod(stroke.width, pixelRatio_) : 0;
    linesFor(stroke).segments(*projection_, positions,
                              {width, period, toBytes(stroke.colour), nearerBy(0.5 * width + 1),
                               stroke.crisp});
}

void Renderer::edges(const drawing::Shape& shape, const Stroke& stroke) {
    scratch_.clear();
    for (const std::uint32_t end : shape.indices) {
        const auto from = shape.positions.begin() + 3 * static_cast<std::ptrdiff_t>(end);
        scratch_.insert(scratch_.end(), from, from + 3);
    }
    segments(scratch_, stroke);
}

void Renderer::points(std::span<const double> positions, const Dots& dots) {
    if (!projection_) return;
    PointVertices& vertices = pointsFor(dots);
    PointVertex looks;
    looks.z = static_cast<float>(
        nearerBy((1.5 * dots.diameter + dots.border) * pixelRatio_));
    looks.radius = static_cast<float>(0.5 * dots.diameter * pixelRatio_);
    looks.border = static_cast<float>(dots.border * pixelRatio_);
    looks.square = dots.square ? 1.0F : 0.0F;
    looks.fill = toBytes(dots.colour);
    looks.borderColour = toBytes(dots.borderColour);
    looks.haloColour = toBytes(dots.haloColour);
    for (std::size_t i = 0; i < positions.size() / 3; ++i) {
        const double halo = dots.halo * strengthAt(dots.highlights, i);
        looks.halo = static_cast<float>(halo * pixelRatio_);
        vertices.add(*projection_,
                     {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}, looks);
    }
}

void Renderer::triangles(std::span<const double> positions, const Colour& colour) {
    if (!projection_) return;
    switchTo(Batch::triangles);
    triangleVertices_.add(*projection_, positions, toBytes(colour));
}

void Renderer::areaUnder(std::span<const double> graph, double base, const Colour& colour) {
    scratch_.clear();
    appendAreaUnder(graph, base, scratch_);
    triangles(scratch_, colour);
}

void Renderer::stroke(const drawing::Shape& shape, Stroke stroke) {
    stroke.dashed = shape.dashed;
    stroke.cuts = shape.role == drawing::Role::curve;
    if (shape.indices.empty()) return polyline(shape.positions, stroke);
    stroke.halo = 0;
    edges(shape, stroke);
}

void Renderer::paint(const drawing::Shape& shape, const PaintOptions& options) {
    const Colour colour = faded(options.colour.value_or(shape.colour), options.opacity);
    const Colour halo = options.haloColour.value_or(faded(colour, 0.25));
    const double size = static_cast<double>(shape.width) + options.extraWidth;
    const Behind behind = options.behind.value_or(usualBehind(shape.role));
    switch (shape.kind) {
        case drawing::Kind::polyline:
            stroke(shape, {colour, size, false, false, options.halo, halo, behind, false});
            break;
        case drawing::Kind::points:
            points(shape.positions,
                   {colour, size, shape.square, options.border,
                    faded(options.borderColour, options.opacity), Dots{}.halo, halo,
                    options.highlights, behind});
            break;
        case drawing::Kind::triangles:
            // Lit surfaces need an eye in space; in a plane their lines stand for them.
            if (shape.indices.empty()) triangles(shape.positions, colour);
            else if (started_ && deep()) space_.add(shape, colour);
            break;
        case drawing::Kind::label: break;
    }
}

Stats Renderer::stats() const noexcept {
    Stats stats = stats_;
    stats.live = device_.counts();
    stats.bufferBytes = lines_.records.bytes + points_.records.bytes + triangles_.records.bytes +
                        space_.bufferBytes();
    return stats;
}

}  // namespace knotwork::render
