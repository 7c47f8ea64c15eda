// A scene, posed for one frame: shapes, materials, lights, sky, and the tree over the shapes.
//
// show/ fills it anew for every frame (clear, add, finish); nothing here allocates. World units are metres by
// custom, y is up, coordinates right-handed. A scene that outgrows its arrays drops what does not fit.
#pragma once

#include "trace/scene/lightmap.h"
#include "trace/scene/material.h"
#include "trace/scene/shape.h"
#include "trace/scene/sky.h"

namespace odraz {

inline constexpr int kMaxShapes = 65500, kMaxMaterials = 32, kMaxLights = 8, kMaxOutline = 1024,
                     kMaxOccluders = 24;

// A point or spot light, with a hard shadow. Irradiance at distance r is intensity / r^2.
struct Light {
    Vec3 position;
    Rgb intensity;
    Vec3 direction; // unit, where a spot looks
    float cosOuter; // no light beyond this angle; -2: a point light
    float cosInner; // full light within this angle, cosOuter < cosInner
};

inline Light pointLight(Vec3 position, Rgb intensity) { return {position, intensity, {0, -1, 0}, -2, -1.5f}; }

// A tree of bounding boxes with up to eight children a node, side by side for eight-wide tests. A node whose
// children are all balls holds the balls themselves in place of their boxes.
struct Node {
    float lo[3][8]; // or the balls' centres
    union {
        float hi[3][8];
        float radius[8];
    };
    int child[8]; // a node, or ~shape
    int count;    // boxes behind it are empty
    bool balls;
};
inline constexpr int kTreeDepth = 20; // most nodes above one another

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
    uint16_t unbounded[8]; // the planes
    int nodeCount, unboundedCount;
    Bounds box[kMaxShapes];       // of each shape but the planes
    Vec3 occluder[kMaxOccluders]; // the balls of `contact`
    float occluderRadius[kMaxOccluders];
    int occluderCount;
    Rgb mean[kMaxMaterials]; // each material's average diffuse reflectance

    void clear();
    int add(const Material &m) {
        if (materialCount < kMaxMaterials) materials[materialCount++] = m;
        return materialCount - 1;
    }
    Shape *add(const Shape &s);
    void add(const Light &l) {
        if (lightCount < kMaxLights) lights[lightCount++] = l;
    }
    // A polygon in the plane through `centre` with frame's v as its normal; `points` are `count` pairs (x,
    // z).
    Shape *addPolygon(Vec3 centre, const Mat3 &frame, const float *points, int count, int material);
    // Builds the tree (tree.cpp); after it the scene may be traced.
    void finish();
};

} // namespace odraz
