// The little of OpenGL ES 3 that the renderer needs, as values that clean up after themselves.
//
// A GL object is deleted when its handle dies, unless forget() was called first: after a lost
// context its name means nothing, or already means something else. A Device counts what is alive.
// This header names no GL type, so that the renderer runs in tests on a device that only counts.
#pragma once

#include "geometry/result.hpp"
#include "render/projection.hpp"
#include "scene/colour.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace knotwork::render::gl {

struct Counts {
    int programs = 0;
    int buffers = 0;
    int vertexArrays = 0;
    int textures = 0;
    int framebuffers = 0;
    int renderbuffers = 0;
    [[nodiscard]] constexpr int total() const noexcept {
        return programs + buffers + vertexArrays + textures + framebuffers + renderbuffers;
    }
    friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

/// Owner of one GL object; `Traits` say how it is deleted and which count it belongs to.
template <class Traits>
class Handle {
public:
    Handle() = default;
    Handle(unsigned name, Counts& counts) noexcept : name_(name), counts_(&counts) {
        ++Traits::count(counts);
    }
    Handle(Handle&& other) noexcept
        : name_(std::exchange(other.name_, 0U)), counts_(std::exchange(other.counts_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(counts_, other.counts_);
        return *this;
    }
    ~Handle() {
        if (name_ == 0) return;
        Traits::destroy(name_);
        --Traits::count(*counts_);
    }

    void forget() noexcept {
        if (name_ != 0) --Traits::count(*counts_);
        name_ = 0;
    }
    [[nodiscard]] unsigned name() const noexcept { return name_; }
    explicit operator bool() const noexcept { return name_ != 0; }

private:
    unsigned name_ = 0;
    Counts* counts_ = nullptr;
};

struct ProgramTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.programs; }
};
struct BufferTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.buffers; }
};
struct VertexArrayTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.vertexArrays; }
};
struct TextureTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.textures; }
};
struct FramebufferTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.framebuffers; }
};
struct RenderbufferTraits {
    static void destroy(unsigned name) noexcept;
    static int& count(Counts& counts) noexcept { return counts.renderbuffers; }
};

/// What the records of a list look like and how they are drawn.
struct Layout {
    std::size_t stride = 16;  ///< bytes from one record to the next, a multiple of 16
    std::size_t window = 1;   ///< records that a shape reads, from its own on
    int corners = 6;          ///< vertices of a shape: 6 for a quad, 1 for a third of a triangle
};

/// A list of records that is filled anew for each draw.
///
/// It is a texture from which vertex shaders read: attributes of instances would do, but drivers are
/// slow with thousands of instances of four vertices, in software by more than ten times.
struct Records {
    Handle<TextureTraits> texture;
    std::size_t bytes = 0;  ///< of the texture
    std::size_t count = 0;  ///< records in it
    std::size_t rows = 0;

    void forget() noexcept {
        texture.forget();
        bytes = count = rows = 0;
    }
};

/// A program with records to draw from.
struct Pipeline {
    Handle<ProgramTraits> program;
    Records records;
    Layout layout;
    int viewUniform = -1;
    int passUniform = -1;

    void forget() noexcept {
        program.forget();
        records.forget();
    }
};

/// How records are drawn that may be drawn more than once.
struct Pass {
    float strength = 1;  ///< share of their opacity
    float grow = 0;      ///< of lines: pixels that are added to either side
    float push = 0;      ///< of lines: depth by which they are moved back
    float steep = 0;     ///< and how many pixels of their own slope
};

/// One attribute of a vertex of a surface, at `location` = its place in the list of a layout.
struct Attribute {
    /// colour: four bytes read as [0, 1]; direction: 16 bits a component read as [-1, 1]
    enum class Type { floats, colour, direction };
    Type type = Type::floats;
    int components = 1;
    std::size_t offset = 0;  ///< bytes from the start of the vertex
};

struct SurfaceLayout {
    std::span<const Attribute> attributes;
    std::size_t stride = 0;  ///< bytes from one vertex to the next
};

/// The program of lit surfaces, which draws from buffers that are not its own.
struct SurfacePipeline {
    Handle<ProgramTraits> program;
    int clipUniform = -1;
    int orientationUniform = -1;
    int paintUniform = -1;

    void forget() noexcept { program.forget(); }
};

/// What the program of surfaces is told about one of them.
struct SurfaceView {
    std::array<float, 16> clip{};        ///< by columns: positions to clip coordinates
    std::array<float, 9> orientation{};  ///< by columns: normals to right, up and towards the eye
    std::array<float, 4> paint{};        ///< sRGB and opacity
};

/// Vertices and triangles of a surface that stay on the GPU.
struct SurfaceBuffers {
    Handle<BufferTraits> vertices;
    Handle<BufferTraits> indices;
    Handle<VertexArrayTraits> vertexArray;
    std::size_t vertexBytes = 0;
    std::size_t corners = 0;  ///< of triangles, in `indices`

    [[nodiscard]] std::size_t bytes() const noexcept {
        return vertexBytes + corners * sizeof(std::uint32_t);
    }
    void forget() noexcept {
        vertices.forget();
        indices.forget();
        vertexArray.forget();
    }
};

/// A framebuffer with several samples a pixel and a depth for each.
struct Target {
    Handle<FramebufferTraits> framebuffer;
    Handle<RenderbufferTraits> colour;
    Handle<RenderbufferTraits> depth;
    int width = 0;
    int height = 0;
    int samples = 0;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(samples) * 8;
    }
    void forget() noexcept {
        framebuffer.forget();
        colour.forget();
        depth.forget();
        width = height = samples = 0;
    }
};

/// What depth does to what is drawn, and the other way round.
enum class Depth {
    ignored,
    written,      ///< drawn where nothing is nearer, and nearer than the rest from then on
    writtenOnly,  ///< the same without colour
    masked,       ///< the same, by the share of a pixel's samples that its opacity is
    nearer,       ///< drawn where nothing is nearer
    farther,      ///< drawn where something is nearer
};

class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// NOT_SUPPORTED with the driver's log when the program does not compile or link. The vertex
    /// shader stands behind `recordReading` (record_shader.hpp).
    [[nodiscard]] Result<Pipeline> makePipeline(std::string_view vertexShader,
                                                std::string_view fragmentShader,
                                                const Layout& layout);

    /// The state that painting relies on: premultiplied blending, scissor on, depth ignored.
    void prepare() noexcept;
    void setArea(const Rect& area) noexcept;  ///< viewport and scissor
    void clear(const scene::Colour& colour) noexcept;
    /// Records of their own for a pipeline.
    [[nodiscard]] Records makeRecords();
    void send(const Pipeline& pipeline, Records& records,
              std::span<const std::byte> bytes) noexcept;
    /// Draws what was sent. The uniform `view` gets the pane's width and height and the position of
    /// its middle, in pixels.
    void draw(const Pipeline& pipeline, const Records& records, const Rect& pane,
              const Pass& pass = {}) noexcept;

    [[nodiscard]] Result<SurfacePipeline> makeSurfacePipeline(std::string_view vertexShader,
                                                              std::string_view fragmentShader);
    [[nodiscard]] SurfaceBuffers makeSurfaceBuffers(const SurfaceLayout& layout);
    void sendVertices(SurfaceBuffers& buffers, std::span<const std::byte> records) noexcept;
    void sendTriangles(SurfaceBuffers& buffers, std::span<const std::uint32_t> indices) noexcept;
    /// The corners from `first` on, `count` of them.
    void draw(const SurfacePipeline& pipeline, const SurfaceBuffers& buffers,
              const SurfaceView& view, std::size_t first, std::size_t count) noexcept;

    /// Everything is drawn into the target from now on, which has at least this size then; its
    /// colour and depth are undefined. False, and nothing happened, where that cannot be had.
    [[nodiscard]] bool beginTarget(Target& target, int width, int height) noexcept;
    /// Copies an area of the target to where it lies in the canvas, into which everything is drawn
    /// again.
    void endTarget(const Target& target, const Rect& area) noexcept;
    void clearDepth() noexcept;
    void setDepth(Depth depth) noexcept;
    /// Leaves nothing bound.
    void release() noexcept;

    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

private:
    Counts counts_;
};

}  // namespace knotwork::render::gl
