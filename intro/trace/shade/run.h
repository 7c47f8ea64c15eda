// Runs: hits that are shaded together, and the results of each stage of shading.
#pragma once

#include "trace/quality.h"
#include "trace/rays/stream.h"
#include "trace/shade/sample.h"

namespace odraz {

// Hits on one shape, or on balls of one material. The arrays are indexed by the hit's index in the run.
inline constexpr int kRun = kChunk + 8;
struct Run {
    int count;
    const int32_t *ray; // indices in the stream; the last one is repeated up to a multiple of eight
    int shape;          // the first hit's shape
    bool balls;         // whether the hits are on several balls
    // Surface points (arrive.h)
    float p[3][kRun], n[3][kRun];   // position; unit normal on the ray's side
    float d[3][kRun], spread[kRun]; // direction and spread of the ray, as in the stream
    float side[kRun];               // +1: the ray comes from outside, -1: from inside
    float error[kRun];              // see errorBound()
    // The cosine between ray and normal; the sample's width, world units; the share that fog leaves
    float cosine[kRun], width[kRun], clear[kRun];
    float curve[kRun];     // on a ball, the angle by which the normal turns within the width; else 0
    int32_t id[kRun];      // as Sample::id
    float weight[3][kRun]; // the ray's weight after fog and glass
    // Light that arrives (light.h)
    float diffuse[3][kRun], highlight[3][kRun];
    int32_t states[kRun]; // as Sample::lights
};

// What shading needs in addition to the run: the scene, the quality, and the samples to write.
struct Shading {
    const Scene &scene;
    const Quality &quality;
    Samples samples;
    int bounces; // number of bounces of the rays that are being shaded
};

} // namespace odraz
