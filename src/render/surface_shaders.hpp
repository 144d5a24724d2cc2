// The program of lit surfaces. The light is fixed to the eye: a broad sky above, a key light over the
// left shoulder, and a soft gleam. Sums are made in linear light and encoded as sRGB at the end.
#pragma once

#include <string_view>

namespace knotwork::render {

inline constexpr std::string_view surfaceVertexShader = R"(#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
uniform mat4 clip;
uniform mat3 orientation;
out vec3 facing;
out vec4 tint;

void main() {
    gl_Position = clip * vec4(position, 1.0);
    facing = orientation * normal;
    tint = colour;
}
)";

// The side from which triangles go clockwise is the inside of what is closed: a little darker and
// less colourful, so that an open surface can be read.
inline constexpr std::string_view surfaceFragmentShader = R"(#version 300 es
precision highp float;
uniform vec4 paint;
in vec3 facing;
in vec4 tint;
out vec4 fragment;

const vec3 key = vec3(-0.37, 0.54, 0.755);
const vec3 halfway = vec3(-0.198, 0.288, 0.937);

vec3 toLinear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 toSrgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

void main() {
    vec3 base = toLinear(paint.rgb * tint.rgb);
    vec3 n = normalize(facing);
    if (!gl_FrontFacing) {
        n = -n;
        float grey = dot(base, vec3(0.2126, 0.7152, 0.0722));
        base = mix(base, vec3(grey), 0.35) * vec3(0.72, 0.76, 0.82);
    }
    float sky = 0.5 + 0.5 * n.y;
    float lit = max(0.0, (dot(n, key) + 0.25) / 1.25);
    vec3 light = mix(vec3(0.17, 0.165, 0.16), vec3(0.36, 0.38, 0.41), sky) + 0.68 * lit;
    float gleam = 0.10 * pow(max(0.0, dot(n, halfway)), 48.0);
    float alpha = paint.a * tint.a;
    fragment = vec4(toSrgb(min(base * light + gleam, 1.0)) * alpha, alpha);
}
)";

}  // namespace knotwork::render
