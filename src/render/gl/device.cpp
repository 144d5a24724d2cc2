#include "render/gl/device.hpp"

#include "render/gl/record_shader.hpp"

#include <GLES3/gl3.h>

#include <algorithm>
#include <bit>
#include <string>

namespace knotwork::render::gl {
namespace {

/// Of a pixel: more are hard to tell apart and twice as slow in software.
constexpr int samples = 4;

/// A shader object for the time between compiling and linking.
class Shader {
public:
    Shader(GLenum stage, std::string_view prelude, std::string_view source)
        : name_(glCreateShader(stage)) {
        const std::array texts{prelude.data(), source.data()};
        const std::array lengths{static_cast<GLint>(prelude.size()),
                                 static_cast<GLint>(source.size())};
        glShaderSource(name_, 2, texts.data(), lengths.data());
        glCompileShader(name_);
    }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { glDeleteShader(name_); }

    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] bool compiled() const {
        GLint ok = 0;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &ok);
        return ok != 0;
    }
    [[nodiscard]] std::string log() const {
        GLint length = 0;
        glGetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
        glGetShaderInfoLog(name_, length, nullptr, text.data());
        return text.c_str();
    }

private:
    GLuint name_;
};

std::string linkLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, nullptr, text.data());
    return text.c_str();
}

Error refusal(std::string_view stage, const std::string& log) {
    return refuse(Code::notSupported, "",
                  "WebGL 2 would not " + std::string(stage) + ": " +
                      (log.empty() ? "no reason was given (is the context lost?)" : log));
}

Result<Handle<ProgramTraits>> makeProgram(std::string_view prelude, std::string_view vertexSource,
                                          std::string_view fragmentSource, Counts& counts) {
    const Shader vertex(GL_VERTEX_SHADER, prelude, vertexSource);
    if (!vertex.compiled()) return refusal("compile a vertex shader", vertex.log());
    const Shader fragment(GL_FRAGMENT_SHADER, "", fragmentSource);
    if (!fragment.compiled()) return refusal("compile a fragment shader", fragment.log());
    Handle<ProgramTraits> program(glCreateProgram(), counts);
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    glLinkProgram(program.name());
    GLint linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == 0) return refusal("link a program", linkLog(program.name()));
    return program;
}

void enable(GLenum capability, bool on) {
    if (on) glEnable(capability);
    else glDisable(capability);
}

GLenum typeOf(const Attribute& attribute) {
    switch (attribute.type) {
        case Attribute::Type::colour: return GL_UNSIGNED_BYTE;
        case Attribute::Type::direction: return GL_SHORT;
        default: return GL_FLOAT;
    }
}

void describe(const SurfaceLayout& layout) {
    for (std::size_t i = 0; i < layout.attributes.size(); ++i) {
        const Attribute& attribute = layout.attributes[i];
        const bool floats = attribute.type == Attribute::Type::floats;
        const auto location = static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, attribute.components, typeOf(attribute),
                              floats ? GL_FALSE : GL_TRUE, static_cast<GLsizei>(layout.stride),
                              reinterpret_cast<const void*>(attribute.offset));
    }
}

Handle<RenderbufferTraits> makeStorage(GLenum format, const Target& target, Counts& counts) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, target.samples, format, target.width,
                                     target.height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return {name, counts};
}

/// Without a framebuffer where the driver does not complete it.
Target makeTarget(int width, int height, Counts& counts) {
    Target made;
    made.width = width;
    made.height = height;
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    made.samples = std::min<int>(samples, most);
    // The canvas has no opacity, and only what has the same format can be copied there.
    made.colour = makeStorage(GL_RGB8, made, counts);
    made.depth = makeStorage(GL_DEPTH_COMPONENT24, made, counts);
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    made.framebuffer = Handle<FramebufferTraits>(name, counts);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              made.colour.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                              made.depth.name());
    const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!complete) made.framebuffer = {};
    return made;
}

}  // namespace

void ProgramTraits::destroy(unsigned name) noexcept { glDeleteProgram(name); }
void BufferTraits::destroy(unsigned name) noexcept { glDeleteBuffers(1, &name); }
void VertexArrayTraits::destroy(unsigned name) noexcept { glDeleteVertexArrays(1, &name); }
void TextureTraits::destroy(unsigned name) noexcept { glDeleteTextures(1, &name); }
void FramebufferTraits::destroy(unsigned name) noexcept { glDeleteFramebuffers(1, &name); }
void RenderbufferTraits::destroy(unsigned name) noexcept { glDeleteRenderbuffers(1, &name); }

Result<Pipeline> Device::makePipeline(std::string_view vertexShader,
                                      std::string_view fragmentShader, const Layout& layout) {
    auto program = makeProgram(recordReading, vertexShader, fragmentShader, counts_);
    if (!program) return program.error();
    Pipeline made;
    made.program = std::move(program).value();
    made.records = makeRecords();
    made.layout = layout;
    made.viewUniform = glGetUniformLocation(made.program.name(), "view");
    made.passUniform = glGetUniformLocation(made.program.name(), "pass");
    return made;
}

Records Device::makeRecords() {
    GLuint name = 0;
    glGenTextures(1, &name);
    Records made;
    made.texture = Handle<TextureTraits>(name, counts_);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return made;
}

void Device::prepare() noexcept {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    setDepth(Depth::ignored);
}

void Device::setArea(const Rect& area) noexcept {
    const int width = std::max(area.width, 0);
    const int height = std::max(area.height, 0);
    glViewport(area.x, area.y, width, height);
    glScissor(area.x, area.y, width, height);
}

void Device::clear(const scene::Colour& colour) noexcept {
    const auto alpha = static_cast<float>(colour.alpha);
    glClearColor(static_cast<float>(colour.red) * alpha, static_cast<float>(colour.green) * alpha,
                 static_cast<float>(colour.blue) * alpha, alpha);
    glClear(GL_COLOR_BUFFER_BIT);
}

// The texture grows and shrinks by powers of two: it neither creeps upwards nor is made anew for
// every frame of an animation.
void Device::send(const Pipeline& pipeline, Records& records,
                  std::span<const std::byte> bytes) noexcept {
    records.count = bytes.size() / pipeline.layout.stride;
    if (bytes.empty()) return;
    const std::size_t texels = bytes.size() / texelBytes;
    const std::size_t whole = texels / texelsPerRow;
    const std::size_t rest = texels % texelsPerRow;
    const std::size_t rows = std::bit_ceil(whole + (rest > 0 ? 1 : 0));
    glBindTexture(GL_TEXTURE_2D, records.texture.name());
    if (rows > records.rows || 4 * rows <= records.rows) {
        records.rows = rows;
        records.bytes = rows * texelsPerRow * texelBytes;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, static_cast<GLsizei>(texelsPerRow),
                     static_cast<GLsizei>(rows), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    }
    const auto fill = [&](std::size_t row, std::size_t width, std::size_t height) {
        if (width == 0 || height == 0) return;
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(width),
                        static_cast<GLsizei>(height), GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                        bytes.data() + row * texelsPerRow * texelBytes);
    };
    fill(0, texelsPerRow, whole);
    fill(whole, rest, 1);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Device::draw(const Pipeline& pipeline, const Records& records, const Rect& pane,
                  const Pass& pass) noexcept {
    const Layout& layout = pipeline.layout;
    if (records.count < layout.window) return;
    glUseProgram(pipeline.program.name());
    glUniform4f(pipeline.viewUniform, static_cast<float>(pane.width),
                static_cast<float>(pane.height),
                static_cast<float>(pane.x) + 0.5F * static_cast<float>(pane.width),
                static_cast<float>(pane.y) + 0.5F * static_cast<float>(pane.height));
    glUniform4f(pipeline.passUniform, pass.strength, pass.grow, pass.push, pass.steep);
    glBindVertexArray(0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, records.texture.name());
    const auto shapes = static_cast<GLsizei>(records.count - layout.window + 1);
    glDrawArrays(GL_TRIANGLES, 0, layout.corners * shapes);
}

Result<SurfacePipeline> Device::makeSurfacePipeline(std::string_view vertexShader,
                                                    std::string_view fragmentShader) {
    auto program = makeProgram("", vertexShader, fragmentShader, counts_);
    if (!program) return program.error();
    SurfacePipeline made;
    made.program = std::move(program).value();
    made.clipUniform = glGetUniformLocation(made.program.name(), "clip");
    made.orientationUniform = glGetUniformLocation(made.program.name(), "orientation");
    made.paintUniform = glGetUniformLocation(made.program.name(), "paint");
    return made;
}

SurfaceBuffers Device::makeSurfaceBuffers(const SurfaceLayout& layout) {
    std::array<GLuint, 2> buffers{};
    GLuint vertexArray = 0;
    glGenBuffers(2, buffers.data());
    glGenVertexArrays(1, &vertexArray);
    SurfaceBuffers made;
    made.vertices = Handle<BufferTraits>(buffers[0], counts_);
    made.indices = Handle<BufferTraits>(buffers[1], counts_);
    made.vertexArray = Handle<VertexArrayTraits>(vertexArray, counts_);
    glBindVertexArray(vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    describe(layout);
    glBindVertexArray(0);
    return made;
}

void Device::sendVertices(SurfaceBuffers& buffers, std::span<const std::byte> records) noexcept {
    buffers.vertexBytes = records.size();
    glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(records.size()), records.data(),
                 GL_DYNAMIC_DRAW);
}

void Device::sendTriangles(SurfaceBuffers& buffers,
                           std::span<const std::uint32_t> indices) noexcept {
    buffers.corners = indices.size();
    glBindVertexArray(buffers.vertexArray.name());  // which knows the buffer of indices
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
                 indices.data(), GL_DYNAMIC_DRAW);
    glBindVertexArray(0);
}

void Device::draw(const SurfacePipeline& pipeline, const SurfaceBuffers& buffers,
                  const SurfaceView& view, std::size_t first, std::size_t count) noexcept {
    glUseProgram(pipeline.program.name());
    glUniformMatrix4fv(pipeline.clipUniform, 1, GL_FALSE, view.clip.data());
    glUniformMatrix3fv(pipeline.orientationUniform, 1, GL_FALSE, view.orientation.data());
    glUniform4fv(pipeline.paintUniform, 1, view.paint.data());
    glBindVertexArray(buffers.vertexArray.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

bool Device::beginTarget(Target& target, int width, int height) noexcept {
    if (width > target.width || height > target.height) {
        target = makeTarget(std::max(width, target.width), std::max(height, target.height),
                            counts_);
    }
    if (!target.framebuffer) return false;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    return true;
}

void Device::endTarget(const Target& target, const Rect& area) noexcept {
    const GLint right = area.x + area.width;
    const GLint top = area.y + area.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(area.x, area.y, right, top, area.x, area.y, right, top, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    constexpr std::array<GLenum, 2> spent{GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, 2, spent.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Device::clearDepth() noexcept {
    glDepthMask(GL_TRUE);
    glClearDepthf(1.0F);
    glClear(GL_DEPTH_BUFFER_BIT);
}

// Surfaces are moved back by their slope, so that what lies on them is in front of them also where
// they are steep.
void Device::setDepth(Depth depth) noexcept {
    const bool surfaces = depth == Depth::written || depth == Depth::writtenOnly;
    const bool writes = surfaces || depth == Depth::masked;
    const bool colourless = depth == Depth::writtenOnly || depth == Depth::masked;
    const GLboolean colours = colourless ? GL_FALSE : GL_TRUE;
    glColorMask(colours, colours, colours, colours);
    glDepthMask(writes ? GL_TRUE : GL_FALSE);
    glDepthFunc(depth == Depth::farther ? GL_GREATER : GL_LEQUAL);
    glPolygonOffset(1.0F, 1.0F);
    enable(GL_POLYGON_OFFSET_FILL, surfaces);
    enable(GL_SAMPLE_ALPHA_TO_COVERAGE, depth == Depth::masked);
    enable(GL_DEPTH_TEST, depth != Depth::ignored);
}

void Device::release() noexcept {
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
}

}  // namespace knotwork::render::gl
