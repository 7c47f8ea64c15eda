// A scene, posed for one frame: shapes, materials, lights, sky, and the tree over the shapes.
//
// show/ fills it for every frame (clear, add, finish); nothing here allocates. By convention world units
// are metres. y is up, coordinates are right-handed. What does not fit replaces the last item of its kind,
// and `overflow` reports it.
#pragma once

#include "trace/scene/bounds.h"
#include "trace/scene/lightmap.h"
#include "trace/scene/material.h"
#include "trace/scene/shape.h"
#include "trace/scene/sky.h"
#include "trace/scene/sunshafts.h"
#include "trace/scene/tree.h"

namespace odraz {

inline constexpr int kMaxShapes = 65500, kMaxMaterials = 32, kMaxLights = 8, kMaxUnbounded = 8,
                     kMaxOccluders = 24, kMaxGlowingBalls = 16;
static_assert(kMaxShapes <= 0x10000 && kMaxMaterials <= 0x100, "numbers of them are kept in 16 and 8 bits");

// A point light or, with a radius, a ball of light. Irradiance / pi at distance r is intensity / r^2. A
// highlight shows a ball of light at its size. Shadows are hard, cast from the ball's middle by what is
// outside it; see Scene::ballsOcclude for soft ones.
struct Light {
    Vec3 position;
    Rgb intensity;
    float radius = 0;
    float tilt = 0; // 0 .. 1: how much it is of two colours, amber towards -x and blue towards +x
};

// (Here and in other large structs the small members stand first: then their offsets are short.)
struct Scene {
    int shapeCount, materialCount, lightCount;
    float fog;      // of a surface's light 2^(-fog * distance) is left; the rest is the sky's
    float exposure; // factor before tone mapping
    float lines;    // how dark the lines between patches are drawn, up to 1; below 0: how bright
    // Balls block light in closed form: the light from all around near them, and that of Lights with a
    // radius. The latter gives soft shadows, with caustics behind balls of glass
    bool ballsOcclude;
    const Lightmap *lightmap;    // for shapes with a chart; null if there are none
    Rgb ambientLow, ambientHigh; // irradiance / pi on surfaces that face down and up
    // Null, or the name of the constant to raise, because something did not fit: the picture is then wrong
    const char *overflow;
    int nodeCount, unboundedCount, occluderCount, glowingBallCount; // of what finish() fills in
    Sky sky;
    Sunshafts shafts;
    Light lights[kMaxLights];
    Material materials[kMaxMaterials];
    Shape shapes[kMaxShapes];

    // Filled in by finish()
    Rgb mean[kMaxMaterials];                // each material's average diffuse reflectance
    uint16_t unbounded[kMaxUnbounded];      // the shapes without a bounding box
    uint16_t glowingBall[kMaxGlowingBalls]; // the balls that only glow
    float occluder[3][kMaxOccluders];       // the balls that occlude, see ballsOcclude
    float occluderRadius[kMaxOccluders];
    uint16_t occluderShape[kMaxOccluders];
    Bounds box[kMaxShapes]; // of each bounded shape
    // Indices of the bounded shapes; those of a subtree of the tree are neighbours
    uint16_t order[kMaxShapes];
    Node nodes[kMaxShapes];

    void clear();
    int add(const Material &m); // its index
    Shape *add(const Shape &s);
    void add(const Light &l);
    // Adds all rows of a table. Tables of materials hold their addresses.
    template <class T, int N> void addAll(const T (&table)[N]) {
        for (const T &one : table) add(one);
    }
    // Sorts the shapes and builds the tree. After that the scene can be traced.
    void finish();

private:
    void add(const Material *m) { add(*m); }
    int next(int &count, int most, const char *limit);
};

} // namespace odraz
