// Light kept on the surfaces: every chart is a rectangle with a grid of cells of its own, divided as
// quadtrees where light asks for it, so that nothing is interpolated across an edge.
//
// Light is counted as the tracer's diffuse light: irradiance / pi, so that radiance = albedo * light. Its
// values, the texels, stand at the cells' corners, which neighbours share; light is bilinear in every cell. A
// texel in the middle of a larger neighbour's side has the value that the neighbour has there: light is
// continuous over the whole chart.
#pragma once

#include "base/vec3.h"

namespace odraz {

inline constexpr int kFinest = 3; // how often a cell may be divided
inline constexpr int kSteps = 1 << kFinest;

struct Chart {
    Vec3 corner;                        // world; where u = v = 0
    Vec3 u, v, n;                       // unit and orthogonal; n points to the side that is lit and seen
    float width, height;                // world units along u and v
    int16_t across, down;               // cells along u and v, 1 ..
    int16_t patchesAcross, patchesDown; // whole cells each
    uint16_t material;
    bool open;                   // a window: seen by the hemicubes, passed by rays
    int firstCell;               // rows of `across`
    int firstTexel;              // of the corners of cells that are not divided: rows of across + 1
    int firstPatch;              // of the patches over its cells
    int firstFacet, facetsCount; // the parts of it that are there

    int texel(int i, int j) const { return firstTexel + j * (across + 1) + i; } // 0 .. across, 0 .. down
    int texels() const { return (across + 1) * (down + 1); }
    int patchAcross() const { return across / patchesAcross; } // cells of a patch along u and v
    int patchDown() const { return down / patchesDown; }
    // How far off the plane points lie surely on its side
    float off() const { return (sumAbs(corner) + width + height) * 2e-6f; }
    Vec3 at(float s, float t) const { return fmadd(u, s, fmadd(v, t, corner)); } // s, t in world units
};

// Its corners lie at (0, 0), (1, 0), (0, 1) and (1, 1). Where it is divided, corner[0] is ~ the first of four
// children in the same order.
struct Cell {
    int corner[4]; // texels
    int patch, chart;
    float area; // world units
    int level;  // how often it comes from a division, 0 .. kFinest

    bool divided() const { return corner[0] < 0; }
};

struct Lightmap {
    const Chart *charts;
    const Cell *cells;
    const float *plane[3]; // red, green, blue of every texel
    // A picture of the patches that is laid over the light. mosaic: its share, 0 .. 1; patch: the patches'
    // colours; sharpness: 1 is bilinear between their middles, kFlat shows each patch in one colour
    float mosaic;
    const float *patch[3];
    float sharpness;
    // The chart that also has gloss, or null. Its gloss towards the eye is kept in squares, in rows of
    // glossAcross
    const Chart *glossy;
    int glossAcross, glossDown;
    const float *gloss[3];
};
inline constexpr float kFlat = 1e4f;

// The light of a chart at points of its plane.
Rgb8 lightAt(const Lightmap &map, const Chart &chart, const Vec3x8 &p);

// The same of what it throws back besides.
Rgb8 glossAt(const Lightmap &map, const Vec3x8 &p);

// Which patch points lie in, as a number for comparisons, and how much of a sample `width` wide lies clear of
// the lines between patches: 1 .. 0.
Int8 patchAt(const Chart &chart, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine, Float8 width,
             Float8 &clear);

} // namespace odraz
