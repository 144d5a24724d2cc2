// The programs of lines, points and flat triangles. Everywhere `view` holds the pane's width and
// height and the position of its middle in the framebuffer; positions are pixels from that middle;
// `pass` is a gl::Pass; colours leave premultiplied. Vertex shaders stand behind
// gl::recordReading, whose functions they use.
#pragma once

#include <string_view>

namespace knotwork::render {

// A quad round each segment, wide enough for half a pixel of antialiasing beyond its edge.
// Four records to a segment: before, start (with the style), end, after.
inline constexpr std::string_view lineVertexShader = R"(uniform vec4 view;
uniform vec4 pass;
flat out vec4 ends;
flat out vec4 neighbours;
flat out vec4 arcs;
flat out vec2 stroke;
flat out vec4 paint;

float known(float arc) { return arc >= 0.0 || arc < -1.5 ? 1.0 : 0.0; }

void main() {
    int first = 2 * quad();
    int corner = quadCorner();
    vec4 before = floatsAt(first);
    vec4 start = floatsAt(first + 2);
    uvec4 looks = wordsAt(first + 3);
    vec4 end = floatsAt(first + 4);
    vec4 after = floatsAt(first + 6);
    vec2 style = uintBitsToFloat(looks.xy);
    vec4 colour = colourOf(looks.z);
    float radius = 0.5 * max(style.x, 1.0) + pass.y;
    vec2 along = end.xy - start.xy;
    float span = length(along);
    float back = pass.z + pass.w * abs(end.z - start.z) / max(span, 1e-3);
    vec2 forward = span > 0.0 ? along / span : vec2(1.0, 0.0);
    vec2 sideways = vec2(-forward.y, forward.x);
    bool atEnd = (corner & 1) == 1;
    float side = (corner & 2) == 2 ? 1.0 : -1.0;
    float reach = radius + 1.0;
    vec2 tip = atEnd ? end.xy + reach * forward : start.xy - reach * forward;
    vec2 place = tip + side * reach * sideways;
    bool drawn = start.w >= 0.0 && end.w >= 0.0;
    gl_Position = drawn ? vec4(place / (0.5 * view.xy), (atEnd ? end.z : start.z) + back, 1.0)
                        : vec4(2.0);
    ends = vec4(start.xy, end.xy);
    neighbours = vec4(before.xy, after.xy);
    arcs = vec4(start.w, end.w, known(before.w), known(after.w));
    stroke = vec2(radius, style.y);
    paint = vec4(colour.rgb, colour.a * min(style.x, 1.0) * pass.x);
}
)";

// Every pixel belongs to the nearest of neighbouring segments; were it blended once for each that
// reaches it, joins would darken and the edges of finely divided curves would lose their
// antialiasing. What is equally far from both (the wedge outside a join, the bisector inside)
// belongs to the earlier one; `tie` is the rounding of distances of up to some tens of pixels.
inline constexpr std::string_view lineFragmentShader = R"(#version 300 es
precision highp float;
uniform vec4 view;
flat in vec4 ends;
flat in vec4 neighbours;
flat in vec4 arcs;
flat in vec2 stroke;
flat in vec4 paint;
out vec4 fragment;

// parameter of the foot of p on the line through a and b, and distance of p from the segment
vec2 nearest(vec2 p, vec2 a, vec2 b) {
    vec2 ab = b - a;
    float t = dot(p - a, ab) / max(dot(ab, ab), 1e-12);
    return vec2(t, length(t <= 0.0 ? p - a : t >= 1.0 ? p - b : p - a - t * ab));
}

void main() {
    vec2 p = gl_FragCoord.xy - view.zw;
    vec2 own = nearest(p, ends.xy, ends.zw);
    if (own.y >= stroke.x + 0.5) discard;
    bool hasBefore = arcs.z > 0.5;
    bool hasAfter = arcs.w > 0.5;
    const float tie = 5e-5;
    if (hasBefore) {
        if (own.x <= 0.0) discard;
        vec2 earlier = nearest(p, neighbours.xy, ends.xy);
        if (earlier.x < 1.0 && earlier.y < own.y + tie) discard;
    }
    if (hasAfter) {
        if (own.x >= 1.0 && dot(p - ends.zw, neighbours.zw - ends.zw) > 0.0) discard;
        if (own.x < 1.0 && nearest(p, ends.zw, neighbours.zw).y < own.y - tie) discard;
    }
    float away = own.y;
    float period = stroke.y;
    if (period > 0.0) {
        float solid = max(0.55 * period - 2.0 * stroke.x, 0.05 * period);
        float at = mod(mix(arcs.x, arcs.y, clamp(own.x, 0.0, 1.0)), period);
        away = length(vec2(max(0.0, min(at - solid, period - at)), own.y));
    }
    float alpha = paint.a * clamp(stroke.x + 0.5 - away, 0.0, 1.0);
    fragment = vec4(paint.rgb * alpha, alpha);
}
)";

inline constexpr std::string_view pointVertexShader = R"(uniform vec4 view;
uniform vec4 pass;
flat out vec2 middle;
flat out vec4 looks;
flat out vec4 fill;
flat out vec4 border;
flat out vec4 halo;

vec4 premultiplied(vec4 c) { return vec4(c.rgb * c.a, c.a) * pass.x; }

void main() {
    int first = 3 * quad();
    int corner = quadCorner();
    vec4 centre = floatsAt(first);  // and the radius
    uvec4 rest = wordsAt(first + 1);
    uvec4 rims = wordsAt(first + 2);
    looks = vec4(centre.w, uintBitsToFloat(rest.xyz));
    float reach = looks.x + looks.y + looks.z + 1.0;
    vec2 direction = vec2((corner & 1) == 1 ? 1.0 : -1.0, (corner & 2) == 2 ? 1.0 : -1.0);
    gl_Position = vec4((centre.xy + reach * direction) / (0.5 * view.xy), centre.z, 1.0);
    middle = centre.xy;
    fill = premultiplied(colourOf(rest.w));
    border = premultiplied(colourOf(rims.x));
    halo = premultiplied(colourOf(rims.y));
}
)";

inline constexpr std::string_view pointFragmentShader = R"(#version 300 es
precision highp float;
uniform vec4 view;
flat in vec2 middle;
flat in vec4 looks;
flat in vec4 fill;
flat in vec4 border;
flat in vec4 halo;
out vec4 fragment;

float outsideDisc(vec2 p, float radius) { return length(p) - radius; }

float outsideSquare(vec2 p, float half_) {
    float rounding = 0.25 * half_;
    vec2 beyond = abs(p) - (half_ - rounding);
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - rounding;
}

float coverage(float outside) { return clamp(0.5 - outside, 0.0, 1.0); }

void main() {
    vec2 p = gl_FragCoord.xy - view.zw - middle;
    float outside = looks.w > 0.5 ? outsideSquare(p, looks.x) : outsideDisc(p, looks.x);
    vec4 c = vec4(0.0);
    if (looks.z > 0.0) c = halo * coverage(outside - looks.y - looks.z);
    if (looks.y > 0.0) c = mix(c, border, coverage(outside - looks.y));
    c = mix(c, fill, coverage(outside));
    if (c.a <= 0.0) discard;
    fragment = c;
}
)";

inline constexpr std::string_view triangleVertexShader = R"(uniform vec4 view;
uniform vec4 pass;
flat out vec4 paint;

void main() {
    uvec4 words = wordsAt(gl_VertexID);
    vec3 position = uintBitsToFloat(words.xyz);
    vec4 colour = colourOf(words.w);
    gl_Position = vec4(position.xy / (0.5 * view.xy), position.z, 1.0);
    paint = vec4(colour.rgb * colour.a, colour.a) * pass.x;
}
)";

inline constexpr std::string_view triangleFragmentShader = R"(#version 300 es
precision mediump float;
flat in vec4 paint;
out vec4 fragment;

void main() { fragment = paint; }
)";

}  // namespace knotwork::render
