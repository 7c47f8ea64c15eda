// A scene, posed for one frame: shapes, materials, lights, sky, and the tree over the shapes.
//
// show/ fills it for every frame (clear, add, finish); nothing here allocates. World units are metres by
// convention; y is up, coordinates are right-handed. What does not fit replaces the last item of its kind;
// `overflow` reports it.
#pragma once

#include "trace/scene/bounds.h"
#include "trace/scene/lightmap.h"
#include "trace/scene/material.h"
#include "trace/scene/shape.h"
#include "trace/scene/sky.h"
#include "trace/scene/sunshafts.h"
#include "trace/scene/tree.h"

namespace odraz {

// (kMaxShapes: a scene of the benchmarks has 7,382.)
inline constexpr int kMaxShapes = 8000, kMaxMaterials = 32, kMaxLights = 8, kMaxUnbounded = 8,
                     kMaxOccluders = 24, kMaxGlowingBalls = 16;
static_assert(kMaxShapes <= 0x10000 && kMaxMaterials <= 0x100, "their indices have 16 and 8 bits");

// A point light or, with a radius, a ball of light. Irradiance / pi at distance r is intensity / r^2.
// Highlights show a ball of light at its size. Shadows are hard, as from its middle. With
// Scene::ballsOcclude, balls have soft shadows instead, and other shapes inside the ball of light have none.
struct Light {
    Vec3 position;
    Rgb intensity;
    float radius = 0;
    float tilt = 0; // 0 .. 1: how strongly its light is amber towards -x and blue towards +x
};

// (In large structs small members are first: then their offsets are short.)
struct Scene {
    int shapeCount, materialCount, lightCount;
    float fog;      // a surface keeps the share 2^(-fog * distance) of its light; the rest is the sky's
    float exposure; // factor before tone mapping
    float lines;    // darkness of the lines between patches, up to 1; below 0: their brightness
    // Whether balls block light in closed form: the ambient light near them, and the light of Lights with a
    // radius, which gives soft shadows, with caustics behind balls of glass
    bool ballsOcclude;
    const Lightmap *lightmap;    // for shapes with a chart; null if there are none
    Rgb ambientLow, ambientHigh; // irradiance / pi on surfaces that face down and up
    // Null, or a line that names the constant to raise: something did not fit, and the picture is wrong
    const char *overflow;
    int nodeCount, unboundedCount, occluderCount, glowingBallCount; // sizes of arrays that finish() fills
    Sky sky;
    Sunshafts shafts;
    Light lights[kMaxLights];
    Material materials[kMaxMaterials];
    Shape shapes[kMaxShapes];

    // Filled in by finish()
    Rgb mean[kMaxMaterials];                // each material's average diffuse reflectance
    uint16_t unbounded[kMaxUnbounded];      // indices of the shapes without a bounding box
    uint16_t glowingBall[kMaxGlowingBalls]; // indices of the balls that only glow
    float occluder[3][kMaxOccluders];       // centres of the balls that occlude, see ballsOcclude
    float occluderRadius[kMaxOccluders];
    uint16_t occluderShape[kMaxOccluders];
    Bounds box[kMaxShapes];     // the box of each bounded shape
    uint16_t order[kMaxShapes]; // indices of the bounded shapes; a subtree's are contiguous
    Node nodes[kMaxShapes];

    void clear();
    int add(const Material &m); // returns its index
    Shape *add(const Shape &s);
    void add(const Light &l);
    // Adds all rows of a table. Rows of a table of materials are pointers.
    template <class T, int N> void addAll(const T (&table)[N]) {
        for (const T &one : table) add(one);
    }
    // Lists the shapes by kind and builds the tree. After that the scene can be traced.
    void finish();

private:
    void add(const Material *m) { add(*m); }
    int next(int &count, int most, const char *limit);
};

} // namespace odraz
