// Whitted ray tracing by waves over streams of rays.
//
// A wave of rays is intersected; its hits are sorted by what they hit, so that they are shaded together: by
// shape, balls of one plain colour by their material. Lights are tried for all of a run at once, by rays from
// the light. What reflects and refracts is packed to form the next wave. Recursion ends at a depth, and where
// a ray's share of the picture falls below a cutoff. Phong shading with clamped cosines, hard shadows dimmed
// by glass, exact Fresnel weights and total internal reflection in glass. Source: Whitted, "An Improved
// Illumination Model for Shaded Display", CACM 23(6), 1980.
#pragma once

#include "trace/quality.h"
#include "trace/rays/beam.h"
#include "trace/rays/stream.h"
#include "trace/rays/view.h"

namespace odraz {

// What a primary ray brought: radiance = albedo * light + rest, and the marks by which neighbours are
// compared.
struct alignas(16) Sample {
    Rgb albedo;      // diffuse colour at the primary hit
    uint32_t id;     // primary hit: 1 + 8 shape + face; 0: the sky
    Rgb light;       // diffuse light on it
    uint32_t lights; // two bits a light: 0 dark, 1 lit, 2 lit with a highlight, 3 dimmed by glass; kTextured
    Rgb rest;        // highlights, emission, sky, and all that secondary rays brought
    uint32_t secondary; // sum of hashes of what every secondary ray hit, and of the texture cell there

    uint32_t shape() const { return (id - 1) / 8; } // where id != 0
    Rgb radiance() const { return albedo * light + rest; }
};
// A colour of a sample as four floats, the last one 0: the mark that lies there would be a denormal number,
// and those cost a hundred cycles.
ODRAZ_INLINE __m128 fourOf(const Rgb &c) { return _mm_blend_ps(_mm_load_ps(&c.x), _mm_setzero_ps(), 8); }
ODRAZ_INLINE __m128 radianceOf(const Sample &s) {
    return fourOf(s.albedo) * fourOf(s.light) + fourOf(s.rest);
}
// In Sample::lights: a secondary ray of weight met a texture, whose detail corners cannot tell.
inline constexpr uint32_t kTextured = 1u << 31;

// Hits that are shaded together, by place in the run: of one shape, or of balls of one material.
inline constexpr int kRun = kChunk + 8;
struct Run {
    int count;
    const int32_t *ray;           // places in the stream; behind the last one it is repeated
    int shape;                    // the first one's
    bool balls;                   // of several shapes
    float p[3][kRun], n[3][kRun]; // where, and the unit normal on the ray's side
    float side[kRun];             // +1: the ray comes from outside, -1: from inside
    float error[kRun];            // see errorBound()
    float cosine[kRun], width[kRun], clear[kRun];
    int32_t id[kRun];                           // as Sample::id
    float weight[3][kRun];                      // what is left of the ray's by fog and glass
    float diffuse[3][kRun], highlight[3][kRun]; // light that arrives
    int32_t states[kRun];                       // as Sample::lights
};

struct TraceScratch {
    RayStream streams[kMaxDepth + 2];
    Run run;
    int32_t counts[kMaxShapes + kMaxMaterials + 1]; // by what is hit, while sorting; all zero in between
};

// Traces count rays through the picture points (x, y), pixels from the top left, into samples[index]. The
// arrays can be read up to the next multiple of eight. `size`: the side of what a sample stands for, in
// pixels. `among`: candidates of a beam from the eye in which all these points lie.
void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  const Candidates &among, float size, int count, const float *x, const float *y,
                  const uint32_t *index, Sample *samples);

// The diffuse colour that eight picture points show of one shape's surface, to samples `size` pixels wide.
Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y, float size);

// --- between whitted.cpp, shade.cpp and light.cpp ---

struct Context {
    const Scene &scene;
    const Quality &quality;
    TraceScratch &scratch;
    Sample *samples;
    int bounces; // so far, of the rays that are being shaded
};

// Adds what the sky gives to rays of the stream that meet nothing.
void shadeSky(const Context &c, const RayStream &in);
// Shades scratch.run: adds to the samples, and appends to `out` what goes on.
void shade(const Context &c, const RayStream &in, RayStream &out);
// Fills run.diffuse, highlight and states.
void illuminate(const Context &c, const RayStream &in, Run &run);

} // namespace odraz
