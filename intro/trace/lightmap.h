// Light kept on the surfaces: every chart is a rectangle with a grid of elements of its own, so that nothing
// is interpolated across an edge.
//
// Light is counted as the tracer's diffuse light: irradiance / pi, so that radiance = albedo * light. The
// elements' values stand at their middles, rows of `across` along u; around each chart lies a ring of texels
// that repeats its border, so that bilinear lookups need no case distinction.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct Chart {
    Vec3 corner;                   // world; where u = v = 0
    Vec3 u, v, n;                  // unit and orthogonal; n points to the side that is lit and seen
    float width, height;           // world units along u and v
    int16_t across, down;          // elements along u and v, 1 ..
    int8_t patchAcross, patchDown; // elements of a patch along u and v
    uint8_t material;
    bool open;      // a window: seen by the hemicubes, passed by rays
    int firstTexel; // of the ring's first corner
    int firstPatch;

    int stride() const { return across + 2; }
    int texels() const { return stride() * (down + 2); }
    int texel(int i, int j) const { return firstTexel + (j + 1) * stride() + i + 1; } // of element (i, j)
    int patchesAcross() const { return across / patchAcross; }
    int patchesDown() const { return down / patchDown; }
    Vec3 at(float s, float t) const { return fmadd(u, s, fmadd(v, t, corner)); } // s, t in world units
};

struct Lightmap {
    const Chart *charts;
    const float *plane[3]; // red, green, blue of every texel
    float sharpness;       // 1: bilinear; more: elements are told apart, up to kFlat, a mosaic
};
inline constexpr float kFlat = 1e4f;

// The light of a chart at points of its plane.
Rgb8 lightAt(const Lightmap &map, const Chart &chart, const Vec3x8 &p);

// Which patch points lie in, as a number for comparisons, and how much of a sample `width` wide lies clear of
// the lines between patches: 1 .. 0.
Int8 patchAt(const Chart &chart, const Vec3x8 &p, Float8 width, Float8 &clear);

} // namespace odraz
