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
#include "trace/scene/tree.h"

namespace odraz {

inline constexpr int kMaxShapes = 65500, kMaxMaterials = 32, kMaxLights = 8, kMaxOutline = 1024,
                     kMaxUnbounded = 8, kMaxOccluders = 24;
static_assert(kMaxShapes <= 0x10000 && kMaxMaterials <= 0x100 && kMaxOutline <= 0x10000,
              "numbers of shapes, materials and points are kept in 16, 8 and 16 bits");

// A point or spot light, with a hard shadow. Irradiance at distance r is intensity / r^2.
struct Light {
    Vec3 position;
    Rgb intensity;
    Vec3 direction; // unit, where a spot looks
    float cosOuter; // no light beyond this angle; -2: a point light
    float cosInner; // full light within this angle, cosOuter < cosInner
};

inline Light pointLight(Vec3 position, Rgb intensity) { return {position, intensity, {0, -1, 0}, -2, -1.5f}; }

struct Scene {
    Shape shapes[kMaxShapes];
    Material materials[kMaxMaterials];
    Light lights[kMaxLights];
    float outline[kMaxOutline * 2]; // the polygons' points
    int shapeCount, materialCount, lightCount, outlineCount;

    Sky sky;
    Rgb ambientLow, ambientHigh; // irradiance on surfaces that face down and up
    float fog;                   // how fast things turn into the horizon: share left = 2^(-fog distance)
    float exposure;              // factor before tone mapping
    const Lightmap *lightmap;    // for shapes with a chart; may be null where none has
    float lines;                 // 0 .. 1: how dark the lines between patches are drawn
    bool contact;                // balls darken what ambient light reaches around them

    // Made by finish()
    Node nodes[kMaxShapes];
    uint16_t order[kMaxShapes];
    uint16_t unbounded[kMaxUnbounded]; // the shapes that no box holds
    int nodeCount, unboundedCount;
    Bounds box[kMaxShapes];       // of each bounded shape
    Vec3 occluder[kMaxOccluders]; // the balls of `contact`
    float occluderRadius[kMaxOccluders];
    int occluderCount;
    Rgb mean[kMaxMaterials]; // each material's average diffuse reflectance

    // What there was too much of, as the constant to raise; null: all fits. The picture is not what was meant
    const char *overflow;

    void clear();
    int add(const Material &m); // its index
    Shape *add(const Shape &s);
    void add(const Light &l);
    // A polygon in the plane through `centre` with frame's v as its normal; `points` are `count` pairs (x,
    // z).
    Shape *addPolygon(Vec3 centre, const Mat3 &frame, const float *points, int count, int material);
    // Sorts the shapes and builds the tree; after it the scene may be traced.
    void finish();

private:
    int next(int &count, int most, const char *limit);
};

} // namespace odraz
