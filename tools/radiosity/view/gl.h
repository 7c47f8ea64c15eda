// The OpenGL functions that `view` needs in addition to the engine's (base/gl.h), and its shaders.
#pragma once

#include "base/gl.h"

namespace odraz::radiosity {

// clang-format off
#define ODRAZ_VIEW_GL(F) \
    F(glUniform1i) F(glUniform1f) F(glUniform3f) F(glUniform2f) F(glDrawElements) F(glPolygonOffset) F(glDeleteTextures) \
    F(glBufferSubData) F(glPixelStorei) F(glGetIntegerv) F(glGetStringi) F(glCheckFramebufferStatus) \
    F(glGetProgramiv) F(glGetUniformLocation) F(glVertexAttribIPointer)
// clang-format on

struct ViewGl : Gl {
#define ODRAZ_GL_MEMBER(name) decltype(&::name) name;
    ODRAZ_VIEW_GL(ODRAZ_GL_MEMBER)
    decltype(&::glClipControl) glClipControl; // looked up separately; null if missing
#undef ODRAZ_GL_MEMBER
};

// A pixel of the scene has linear red, green and blue, and a number: the number of its patch, negative on an
// element's outline, or one of these.
inline constexpr float kViewNothing = 0, kViewBack = 0.25f, kViewEdge = -0.5f, kViewFrame = 0.75f;

// Lines are one-sided like surfaces, and are drawn a little nearer. Depth is reversed.
inline constexpr char kSceneVertex[] = R"(
layout(location=0) in vec3 p;
layout(location=1) in vec4 n;
layout(location=2) in uint patch;
layout(location=3) in vec3 light;
uniform vec3 eye, right, up, ahead;
uniform float near;
uniform int lines, backs;
out vec3 shown;
flat out float number;
void main() {
    vec3 q = p - eye;
    vec3 c = vec3(dot(right, q), dot(up, q), dot(ahead, q));
    float d = lines != 0 ? near * 1.001 : near;
#ifdef Z
    gl_Position = vec4(c.xy, d, c.z);
#else
    gl_Position = vec4(c.xy, c.z - 2.0 * d, c.z);
#endif
    if (lines != 0 && backs == 0 && dot(n.xyz, q) >= 0.0) gl_Position = vec4(0.0, 0.0, -9.0, 1.0);
    shown = light;
    number = float(patch);
})";

inline constexpr char kSceneFragment[] = R"(
uniform int lines, backs;
in vec3 shown;
flat in float number;
out vec4 o;
void main() {
    if (lines == 0 && !gl_FrontFacing) {
        if (backs == 0) discard;
        o = vec4(0.0, 0.0, 0.0, 0.25);
    } else
        o = lines == 2 ? vec4(0.0, 0.0, 0.0, -0.5) : vec4(shown, lines == 1 ? -number : number);
})";

inline constexpr char kShowVertex[] = R"(
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); })";

// Writes the mean light of a pixel's samples. The output may have fewer pixels.
inline constexpr char kMeanFragment[] = R"(
uniform sampler2D scene;
uniform int samples;
uniform vec2 step;
out vec4 o;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy * step) * samples;
    vec4 light = vec4(0.0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) light += texelFetch(scene, at + ivec2(x, y), 0);
    o = light / float(samples * samples);
})";

// The film's curve matches trace/picture/development.cpp, and the logarithm matches export/render.cpp.
inline constexpr char kShowFragment[] = R"(
uniform sampler2D scene;
uniform int samples, logarithmic, patches;
uniform float exposure, marked;
uniform vec2 range, corner;
out vec4 o;
vec3 srgb(vec3 x) { return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x)); }
vec3 tone(vec3 c) {
    if (logarithmic == 0) {
        vec3 x = clamp(c * exposure, 0.0, 1e6);
        return srgb(clamp(x * (x * 2.51 + 0.03) / (x * (x * 2.51 + 0.59) + 0.14), 0.0, 1.0));
    }
    float most = max(c.r, max(c.g, c.b));
    if (!(most > 0.0)) return vec3(0.0);
    float rank = (log(most) - range.x) / max(range.y - range.x, 1e-3);
    return (0.1 + 0.9 * clamp(rank, 0.0, 1.0)) * pow(max(c, 0.0) / most, vec3(1.0 / 2.2));
}
vec3 colourOf(float number) {
    uint x = uint(number) * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;
    x = (x >> 22) ^ x;
    return 0.2 + 0.75 * vec3(x & 255u, x >> 8 & 255u, x >> 16 & 255u) / 255.0;
}
void main() {
    ivec2 at = (ivec2(gl_FragCoord.xy) - ivec2(corner)) * samples;
    vec3 light = vec3(0.0), flat_ = vec3(0.0);
    float outlines = 0.0, edges = 0.0, backs = 0.0, frame = 0.0, found = 0.0;
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            vec4 t = texelFetch(scene, at + ivec2(x, y), 0);
            light += t.rgb;
            float number = abs(t.a);
            if (number >= 1.0) flat_ += colourOf(number);
            found += float(number == marked);
            outlines += float(t.a <= -1.0);
            edges += float(t.a == -0.5);
            backs += float(t.a == 0.25);
            frame += float(t.a == 0.75);
        }
    float all = float(samples * samples);
    vec3 shown = patches != 0 ? flat_ / all : tone(light / all);
    shown += vec3(0.10, 0.11, 0.14) * (backs / all) + vec3(0.2) * (frame / all);
    shown = mix(shown, vec3(1.0, 0.5, 0.1), 0.5 * found / all);
    shown = mix(shown, vec3(0.55, 0.75, 1.0), 0.5 * min(1.0, outlines / float(samples)));
    shown = mix(shown, vec3(0.9), min(1.0, edges / float(samples)));
    o = vec4(shown, 1.0);
})";

} // namespace odraz::radiosity
