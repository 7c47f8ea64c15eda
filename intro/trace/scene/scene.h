// A scene, posed for one frame: shapes, materials, lights, sky, and the tree over the shapes.
//
// show/ fills it anew for every frame (clear, add, finish); nothing here allocates. World units are metres by
// custom, y is up, coordinates right-handed. What does not fit takes the place of the last of its kind, and
// `overflow` tells so.
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

// A light at a point or, with a radius, a ball of light. Irradiance at distance r is intensity / r^2.
// Highlights of a ball of light are its image. Shadows are hard, cast from its middle; see
// Scene::ballsOcclude for soft ones.
struct Light {
    Vec3 position;
    Rgb intensity;
    float radius = 0;
};

// (What is small stands first in this and other large structs: its offsets are short.)
struct Scene {
    int shapeCount, materialCount, lightCount;
    float fog;      // how fast things turn into the horizon: share left = 2^(-fog distance)
    float exposure; // factor before tone mapping
    float lines;    // 0 .. 1: how dark the lines between patches are drawn
    // Balls take light away in closed form: ambient light around them; light of Lights with a radius, as soft
    // shadows, with caustics where a ball is of glass
    bool ballsOcclude;
    const Lightmap *lightmap;    // for shapes with a chart; may be null where none has
    Rgb ambientLow, ambientHigh; // irradiance on surfaces that face down and up
    // What there was too much of, as the constant to raise; null: all fits. The picture is not what was meant
    const char *overflow;
    int nodeCount, unboundedCount, occluderCount, glowingBallCount; // of what finish() makes
    Sky sky;
    Sunshafts shafts;
    Light lights[kMaxLights];
    Material materials[kMaxMaterials];
    Shape shapes[kMaxShapes];

    // Made by finish()
    Rgb mean[kMaxMaterials];                // each material's average diffuse reflectance
    uint16_t unbounded[kMaxUnbounded];      // the shapes that no box holds
    uint16_t glowingBall[kMaxGlowingBalls]; // the balls that only glow
    Vec3 occluder[kMaxOccluders];           // the balls that occlude, see ballsOcclude
    float occluderRadius[kMaxOccluders];
    uint16_t occluderShape[kMaxOccluders];
    Bounds box[kMaxShapes]; // of each bounded shape
    uint16_t order[kMaxShapes];
    Node nodes[kMaxShapes];

    void clear();
    int add(const Material &m); // its index
    Shape *add(const Shape &s);
    void add(const Light &l);
    // All of a table; materials by their addresses.
    template <class T, int N> void addAll(const T (&table)[N]) {
        for (const T &one : table) add(one);
    }
    // Sorts the shapes and builds the tree; after it the scene may be traced.
    void finish();

private:
    void add(const Material *m) { add(*m); }
    int next(int &count, int most, const char *limit);
};

} // namespace odraz
