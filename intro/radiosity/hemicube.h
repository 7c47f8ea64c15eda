// Hemicubes: the patches visible from a patch, drawn by OpenGL as patch ids.
//
// OpenGL draws facets instead of patches. The processor transforms them, clips them to the five faces and
// lays them out. A fragment computes its patch id from its position on the facet. Many hemicubes share one
// picture (an atlas) and one read-back. A hemicube has px columns and 3 px rows: the top face (px x px), then
// four half faces (px x px/2) towards +x, +y, -x, -y of its frame, with the horizon in their first row. Depth
// is a reversed float, which fragments write. The depth of vertices is in the middle of OpenGL's range, so
// nothing is clipped however near it is.
//
// Source: Cohen and Greenberg, "The Hemi-Cube", SIGGRAPH 1985. form_factor.h has the pixels' form factors.
#pragma once

#include "base/gl.h"
#include "radiosity/model.h"

namespace odraz {

inline constexpr int kHemicubeBatch = 256; // the most hemicubes in one picture
inline constexpr int kMaxHemicube = 1024;  // the most pixels along a top face's side; even

// Ids in the pictures: a patch's index plus one, or one of these.
inline constexpr uint32_t kNothing = 0, kBackSide = 0xffffffff;

// The position and orientation of a hemicube: local = frame * (world - p); frame.w is the surface's normal.
struct Eye {
    Vec3 p;
    Mat3 frame;
};

// Returns a hemicube around the unit normal n. It is rotated about n by an angle that is random but fixed for
// each number; otherwise all neighbouring hemicubes would have the same aliasing.
Eye hemicubeEye(const Vec3 &p, const Vec3 &n, uint32_t number);

struct Hemicubes {
    const Gl *gl;
    int px, columns, lines; // the picture has columns x lines hemicubes
    int batch;              // columns * lines
    GLuint framebuffer, vertexArray, buffer, program, images[2];
    float *vertices;
    uint32_t *ids; // the atlas as read back: columns * px wide
};

// Creates the OpenGL objects in the current context. Returns false if the arena is full or the context cannot
// render ids. px: even, 4 .. kMaxHemicube.
bool openHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px);
size_t hemicubeBytes(int px);

// Draws up to h.batch hemicubes into h.ids. Changes the context's framebuffer and viewport.
void drawHemicubes(Hemicubes &h, const Model &model, const Eye *eyes, int count);
void closeHemicubes(Hemicubes &h);

// The first pixel of a hemicube in h.ids, and the stride from row to row.
inline const uint32_t *hemicubeIds(const Hemicubes &h, int index) {
    int row = index / h.columns, column = index % h.columns;
    return h.ids + (size_t)row * 3 * (size_t)h.px * (size_t)(h.columns * h.px) + (size_t)(column * h.px);
}
inline int hemicubeStride(const Hemicubes &h) { return h.columns * h.px; }

} // namespace odraz
