#include "render/gl/device.hpp"

#include <GLES3/gl3.h>

#include <algorithm>
#include <string>

namespace knotwork::render::gl {
namespace {

/// A shader object for the time between compiling and linking.
class Shader {
public:
    Shader(GLenum stage, std::string_view source) : name_(glCreateShader(stage)) {
        const char* text = source.data();
        const auto length = static_cast<GLint>(source.size());
        glShaderSource(name_, 1, &text, &length);
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

Result<Handle<ProgramTraits>> makeProgram(std::string_view vertexSource,
                                          std::string_view fragmentSource, Counts& counts) {
    const Shader vertex(GL_VERTEX_SHADER, vertexSource);
    if (!vertex.compiled()) return refusal("compile a vertex shader", vertex.log());
    const Shader fragment(GL_FRAGMENT_SHADER, fragmentSource);
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

void describe(const Layout& layout) {
    for (std::size_t i = 0; i < layout.attributes.size(); ++i) {
        const Attribute& attribute = layout.attributes[i];
        const bool bytes = attribute.type == Attribute::Type::colour;
        const auto location = static_cast<GLuint>(i);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, attribute.components, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT,
                              bytes ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(layout.stride),
                              reinterpret_cast<const void*>(attribute.offset));
        if (layout.instanced) glVertexAttribDivisor(location, 1);
    }
}

}  // namespace

void ProgramTraits::destroy(unsigned name) noexcept { glDeleteProgram(name); }
void BufferTraits::destroy(unsigned name) noexcept { glDeleteBuffers(1, &name); }
void VertexArrayTraits::destroy(unsigned name) noexcept { glDeleteVertexArrays(1, &name); }

Result<Pipeline> Device::makePipeline(std::string_view vertexShader,
                                      std::string_view fragmentShader, const Layout& layout) {
    auto program = makeProgram(vertexShader, fragmentShader, counts_);
    if (!program) return program.error();
    GLuint buffer = 0;
    GLuint vertexArray = 0;
    glGenBuffers(1, &buffer);
    glGenVertexArrays(1, &vertexArray);
    Pipeline made;
    made.program = std::move(program).value();
    made.buffer = Handle<BufferTraits>(buffer, counts_);
    made.vertexArray = Handle<VertexArrayTraits>(vertexArray, counts_);
    made.viewUniform = glGetUniformLocation(made.program.name(), "view");
    made.stride = layout.stride;
    made.window = layout.window;
    made.instanced = layout.instanced;
    glBindVertexArray(vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    describe(layout);
    release();
    return made;
}

void Device::prepare() noexcept {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
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

// The whole buffer is specified anew for each draw: the driver then gives fresh memory to what it
// still reads from, and never waits. Its size follows the data, so it cannot creep upwards.
void Device::draw(Pipeline& pipeline, std::span<const std::byte> records,
                  const Rect& pane) noexcept {
    const std::size_t count = records.size() / pipeline.stride;
    if (count < pipeline.window) return;
    glUseProgram(pipeline.program.name());
    glUniform4f(pipeline.viewUniform, static_cast<float>(pane.width),
                static_cast<float>(pane.height),
                static_cast<float>(pane.x) + 0.5F * static_cast<float>(pane.width),
                static_cast<float>(pane.y) + 0.5F * static_cast<float>(pane.height));
    glBindVertexArray(pipeline.vertexArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, pipeline.buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(records.size()), records.data(),
                 GL_STREAM_DRAW);
    pipeline.bytes = records.size();
    const auto instances = static_cast<GLsizei>(count - pipeline.window + 1);
    if (pipeline.instanced) glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
    else glDrawArrays(GL_TRIANGLES, 0, instances);
}

void Device::release() noexcept {
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glUseProgram(0);
}

}  // namespace knotwork::render::gl
