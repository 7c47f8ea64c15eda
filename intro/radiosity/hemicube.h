// Hemicubes: what a patch sees, as numbers of patches, drawn by OpenGL.
//
// The large rectangles are drawn, not the patches: they are transformed, clipped to the five faces and laid
// out on the processor, and a fragment finds its patch's number from where it lies on the rectangle. Many
// hemicubes share one picture (an atlas) and one read-back. A hemicube is a column of px columns and 3 px
// rows: the top face (px x px), then four half faces (px x px/2) looking to +x, +y, -x, -y of its frame, the
// horizon at their first row. Depth is reversed floats with GL_DEPTH_CLAMP, so that nothing is cut off
// however near it is. Without ARB_clip_control a fragment writes its depth itself.
//
// Source: Cohen and Greenberg, "The Hemi-Cube", SIGGRAPH 1985; delta form factors are form_factor.h's.
#pragma once

#include "base/gl.h"
#include "radiosity/model.h"

namespace odraz {

inline constexpr int kHemicubeBatch = 256; // no picture holds more of them
inline constexpr int kMaxHemicube = 1024;  // pixels of a top face's side; even

// Numbers in the pictures: a patch's plus one; or these.
inline constexpr uint32_t kNothing = 0, kBackSide = 0xffffffff;

// Where a hemicube stands: local = frame * (world - p); frame.w is the surface's normal.
struct Eye {
    Vec3 p;
    Mat3 frame;
};

// About the unit normal n, turned by an angle that is random but fixed for each number: else the grids of
// neighbours alias together.
Eye hemicubeEye(const Vec3 &p, const Vec3 &n, uint32_t number);

struct Hemicubes {
    const Gl *gl;
    int px, columns, lines; // the picture holds columns x lines hemicubes
    int batch;              // that many
    uint32_t turn;          // another number turns all of them otherwise
    int turns; // so many hemicubes for each patch, turned otherwise, whose mean counts: 1 .. batch
    GLuint framebuffer, vertexArray, buffer, program, images[2];
    bool clipControl;
    float *vertices;
    uint32_t *ids; // the atlas as read back: columns * px wide
};

// Makes what drawing needs on the context that is current; false when the arena is full or the context cannot
// do it. Pixels: even, 4 .. kMaxHemicube.
bool openHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px);
size_t hemicubeBytes(int px);

// Draws up to h.batch hemicubes; h.ids then holds them. The context's framebuffer and viewport are
// changed.
void drawHemicubes(Hemicubes &h, const Model &model, const Eye *eyes, int count);
void closeHemicubes(Hemicubes &h);

// The first pixel of a hemicube in h.ids, and what lies from row to row.
inline const uint32_t *hemicubeIds(const Hemicubes &h, int index) {
    int row = index / h.columns, column = index % h.columns;
    return h.ids + (size_t)row * 3 * (size_t)h.px * (size_t)(h.columns * h.px) + (size_t)(column * h.px);
}
inline int hemicubeStride(const Hemicubes &h) { return h.columns * h.px; }

} // namespace odraz
