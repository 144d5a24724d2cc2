// The little of OpenGL ES 3 that the renderer needs, as values that clean up after themselves.
//
// A GL object is deleted when its handle dies, unless forget() was called first: after a lost
// context its name means nothing, or already means something else. A Device counts what is alive.
// This header names no GL type, so that the renderer runs in tests on a device that only counts.
#pragma once

#include "geometry/result.hpp"
#include "render/projection.hpp"
#include "scene/colour.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace knotwork::render::gl {

struct Counts {
    int programs = 0;
    int buffers = 0;
    int vertexArrays = 0;
    [[nodiscard]] constexpr int total() const noexcept { return programs + buffers + vertexArrays; }
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

/// One attribute of a vertex, at `location` = its place in the list of a layout.
struct Attribute {
    enum class Type { floats, colour };  ///< colour: four bytes read as [0, 1]
    Type type = Type::floats;
    int components = 1;
    std::size_t offset = 0;  ///< bytes from the start of the record
};

/// What the records of a buffer look like and how they are drawn.
struct Layout {
    std::span<const Attribute> attributes;
    std::size_t stride = 0;   ///< bytes from one record to the next
    bool instanced = false;   ///< one quad (strip of four vertices) per record, not one vertex
    std::size_t window = 1;   ///< records that an instance reads, from its own on
};

/// A program with the buffer that it draws from, which is filled anew for each draw.
struct Pipeline {
    Handle<ProgramTraits> program;
    Handle<BufferTraits> buffer;
    Handle<VertexArrayTraits> vertexArray;
    int viewUniform = -1;
    std::size_t stride = 0;
    std::size_t window = 1;
    std::size_t bytes = 0;  ///< in the buffer
    bool instanced = false;

    void forget() noexcept {
        program.forget();
        buffer.forget();
        vertexArray.forget();
        bytes = 0;
    }
};

class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// NOT_SUPPORTED with the driver's log when the program does not compile or link.
    [[nodiscard]] Result<Pipeline> makePipeline(std::string_view vertexShader,
                                                std::string_view fragmentShader,
                                                const Layout& layout);

    /// The state that painting relies on: premultiplied blending, scissor on, depth test off.
    void prepare() noexcept;
    void setArea(const Rect& area) noexcept;  ///< viewport and scissor
    void clear(const scene::Colour& colour) noexcept;
    /// Sends whole records and draws them. The uniform `view` gets the pane's width and height and
    /// the position of its middle, in pixels.
    void draw(Pipeline& pipeline, std::span<const std::byte> records, const Rect& pane) noexcept;
    /// Leaves nothing bound.
    void release() noexcept;

    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

private:
    Counts counts_;
};

}  // namespace knotwork::render::gl
