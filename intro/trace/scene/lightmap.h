// Light stored on surfaces. Every chart is a rectangle with its own grid of cells, so that nothing is
// interpolated across a chart's edges.
//
// "Light" is the tracer's diffuse light: irradiance / pi, so that radiance = albedo * light. Its values, the
// texels, are at the corners of cells, which neighbouring cells share. Within a cell it is bilinear.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct Chart {
    Vec3 corner;                        // world; where u = v = 0
    Vec3 u, v, n;                       // unit and orthogonal; n points to the side that is lit and seen
    float width, height;                // world units along u and v
    int16_t across, down;               // cells along u and v, at least 1
    int16_t patchesAcross, patchesDown; // patches along u and v, each of whole cells
    uint16_t material;
    bool open;                  // a window: hemicubes see it, rays pass through it
    int firstCell;              // index of its first cell; cells are in rows of `across`
    int firstTexel;             // index of its first texel; texels are in rows of across + 1
    int firstPatch;             // index of its first patch; patches are in rows of patchesAcross
    int firstFacet, facetCount; // facets: the parts of the rectangle that exist

    int texel(int i, int j) const { return firstTexel + j * (across + 1) + i; } // 0 .. across, 0 .. down
    int texels() const { return (across + 1) * (down + 1); }
    int patchAcross() const { return across / patchesAcross; } // cells of a patch along u and v
    int patchDown() const { return down / patchesDown; }
    // Distance from the plane, in world units, at which a point is certain to lie on one side of it
    float off() const { return (sumAbs(corner) + width + height) * 2e-6f; }
    Vec3 at(float s, float t) const { return fmadd(u, s, fmadd(v, t, corner)); } // s, t in world units
};

struct Lightmap {
    const Chart *charts;
    const float *plane[3]; // red, green, blue of every texel
    // A picture of the patches, mixed with the light. mosaic: its share, 0 .. 1; patch: the patches' colours;
    // sharpness: 1 interpolates between their centres, kFlat shows each patch in one colour
    float mosaic;
    const float *patch[3];
    float sharpness;
    // The chart with gloss, or null; its gloss towards the eye, for squares in rows of glossAcross
    const Chart *glossy;
    int glossAcross, glossDown;
    const float *gloss[3];
};
inline constexpr float kFlat = 1e4f;

// The light of a chart at points of its plane.
Rgb8 lightAt(const Lightmap &map, const Chart &chart, const Vec3x8 &p);

// The gloss of map.glossy at points of its plane: the radiance that it reflects as well as diffuse light.
Rgb8 glossAt(const Lightmap &map, const Vec3x8 &p);

// Returns the index of the patch at each point p. `clear` gets the share (0 .. 1) of a sample that no line
// between patches covers. The sample is `width` world units wide and seen along the unit direction d;
// `cosine` is between d and the normal.
Int8 patchAt(const Chart &chart, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine, Float8 width,
             Float8 &clear);

} // namespace odraz
