// Whitted ray tracing over streams of rays.
//
// A stream of primary rays is intersected in packets of eight; its hits are sorted by shape, so that a packet
// is shaded by one shape and one material; the rays that reflect and refract there form the next stream.
// Recursion ends at a depth, and where a ray's share of the picture falls below a cutoff. Phong shading with
// clamped cosines, hard shadows dimmed by glass, exact Fresnel weights and total internal reflection in
// glass. Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
#pragma once

#include "trace/quality.h"
#include "trace/view.h"

namespace odraz {

// What a primary ray brought: radiance = albedo * light + rest, and the marks by which neighbours are
// compared.
struct Sample {
    Rgb albedo;         // diffuse colour at the primary hit
    Rgb light;          // diffuse light on it
    Rgb rest;           // highlights, emission, sky, and all that secondary rays brought
    uint32_t id;        // primary hit: 1 + 8 shape + face; 0: the sky
    uint32_t lights;    // two bits a light: 0 dark, 1 lit, 2 lit with a highlight, 3 dimmed by glass
    uint32_t secondary; // sum of hashes of what every secondary ray hit, and of the texture cell there

    bool textured; // a secondary ray of weight met a texture, whose detail corners cannot tell

    uint32_t shape() const { return (id - 1) / 8; } // where id != 0
    Rgb radiance() const { return albedo * light + rest; }
};

inline constexpr int kChunk = 256;         // rays shaded together
inline constexpr int kStream = 2 * kChunk; // each may leave two

struct RayStream {
    int count;
    float o[3][kStream], d[3][kStream];    // origin, unit direction
    float weight[3][kStream];              // share of the picture per channel
    float width[kStream], spread[kStream]; // of the sample at the origin, and its growth per unit
    uint32_t sample[kStream];              // index of the Sample it adds to
    uint32_t path[kStream];                // 1, then a bit for every bounce: 0 reflected, 1 refracted
};

struct TraceScratch {
    RayStream streams[kMaxDepth + 2];
    int blocker[kMaxLights];       // what last stood before each light
    int shapeRays[kMaxShapes + 1]; // counts while sorting; all zero in between
};

// Traces count rays through the picture points (x, y), pixels from the top left, into samples[index].
void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  int count, const float *x, const float *y, const uint32_t *index, Sample *samples);

// The diffuse colour that eight picture points show of one shape's surface.
Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y);

} // namespace odraz
