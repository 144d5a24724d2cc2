// How vertex shaders read the records of a list: what stands before each of them.
#pragma once

#include <cstddef>
#include <string_view>

namespace knotwork::render::gl {

/// A texel holds 16 bytes; a row of the texture has so many, as the shader's shift and mask say.
inline constexpr std::size_t texelBytes = 16;
inline constexpr std::size_t texelsPerRow = 1024;

// unpackUnorm4x8 came to the language only later.
inline constexpr std::string_view recordReading = R"(#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform usampler2D records;

uvec4 wordsAt(int texel) { return texelFetch(records, ivec2(texel & 1023, texel >> 10), 0); }
vec4 floatsAt(int texel) { return uintBitsToFloat(wordsAt(texel)); }
vec4 colourOf(uint word) {
    return vec4(word & 255u, (word >> 8) & 255u, (word >> 16) & 255u, word >> 24) / 255.0;
}
// the quad that a vertex belongs to, and which of its corners 0 1 / 2 3 it is
int quad() { return gl_VertexID / 6; }
int quadCorner() {
    int corner = gl_VertexID - 6 * quad();
    return corner < 3 ? corner : corner == 3 ? 2 : corner == 4 ? 1 : 3;
}
)";

}  // namespace knotwork::render::gl
