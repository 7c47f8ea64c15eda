// Runs: hits that are shaded together, and the results of each stage of shading.
#pragma once

#include "trace/quality.h"
#include "trace/rays/stream.h"
#include "trace/shade/sample.h"

namespace odraz {

// Hits on one shape, or on balls of one material. The arrays are indexed by the place in the run.
inline constexpr int kRun = kChunk + 8;
struct Run {
    int count;
    const int32_t *ray; // places in the stream; the last one is repeated up to a multiple of eight
    int shape;          // the first one's
    bool balls;         // the hits are on several balls
    // Where they are (arrive.h)
    float p[3][kRun], n[3][kRun];   // and the unit normal on the ray's side
    float d[3][kRun], spread[kRun]; // the rays', as in the stream
    float side[kRun];               // +1: the ray comes from outside, -1: from inside
    float error[kRun];              // see errorBound()
    // The cosine between ray and normal; the sample's width, world units; the share that fog leaves
    float cosine[kRun], width[kRun], clear[kRun];
    float curve[kRun];     // of a ball: by how much the normal turns within the width
    int32_t id[kRun];      // as Sample::id
    float weight[3][kRun]; // the ray's weight after fog and glass
    // The light that arrives there (light.h)
    float diffuse[3][kRun], highlight[3][kRun];
    int32_t states[kRun]; // as Sample::lights
};

// What shading needs besides the run: the scene, the quality, and where its results go.
struct Shading {
    const Scene &scene;
    const Quality &quality;
    Samples samples;
    int bounces; // that the rays being shaded have made so far
};

} // namespace odraz
