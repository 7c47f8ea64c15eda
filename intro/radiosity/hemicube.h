// Hemicubes: the patches visible from a patch, as a picture of patch ids. OpenGL draws it, or rays through
// its pixels find the ids (traced_hemicube.cpp).
//
// OpenGL draws facets instead of patches. The processor transforms them, clips them to the five faces and
// lays them out. A fragment computes its patch id from its position on the facet. Many hemicubes share one
// picture (an atlas) and one read-back. A hemicube has px columns and 3 px rows: the top face (px x px), then
// four half faces (px x px/2) towards +x, +y, -x, -y of its frame, with the horizon in their first row. Depth
// is a reversed float, which fragments compute from the facet's plane. The depth of vertices is in the middle
// of OpenGL's range, so nothing is clipped however near it is.
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
    int px, columns, lines; // the picture has columns x lines hemicubes
    int batch;              // columns * lines
    uint32_t *ids;          // the atlas: columns * px wide
    const Scene *scene;     // for rays
    const Gl *gl;           // for OpenGL, as is the rest
    GLuint framebuffer, vertexArray, buffer, program, images[2];
    void *vertices; // for a draw call
};

// How the ids are found.
struct HemicubeMethod {
    // Prepares hemicubes of px pixels. Returns false if the arena is full
    bool (*open)(Hemicubes &h, const Gl *gl, const Scene &scene, Arena &arena, int px);
    // Fills `ids` with up to `batch` hemicubes. Returns false if not all of them are ids of the
    // model, kNothing or kBackSide
    bool (*fill)(Hemicubes &h, const Model &model, const Eye *eyes, int count);
    void (*close)(Hemicubes &h);
};

// OpenGL draws the ids in the current context, whose table is `gl`; `scene` is not used. px: even, 4 ..
// kMaxHemicube. fill() changes its framebuffer and viewport. It fails if ids cannot be read back.
extern const HemicubeMethod kDrawnHemicubes;
bool openHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px);
size_t hemicubeBytes(int px);
bool drawHemicubes(Hemicubes &h, const Model &model, const Eye *eyes, int count);
void closeHemicubes(Hemicubes &h);

// Rays through the pixels' centres find the ids in `scene`, the posed and finished model, which must be
// closed. They need no OpenGL, and find the same ids on every machine. px: a multiple of 8.
extern const HemicubeMethod kTracedHemicubes;

// Sets the atlas's size: about 750,000 pixels, or one hemicube if that is more.
void shapeAtlas(Hemicubes &h, int px);

// The first pixel of a hemicube in h.ids, and the stride from row to row.
inline const uint32_t *hemicubeIds(const Hemicubes &h, int index) {
    int row = index / h.columns, column = index % h.columns;
    return h.ids + (size_t)row * 3 * (size_t)h.px * (size_t)(h.columns * h.px) + (size_t)(column * h.px);
}
inline int hemicubeStride(const Hemicubes &h) { return h.columns * h.px; }

} // namespace odraz
