// Runs: hits that are shaded together, and what is found out about them, stage by stage.
#pragma once

#include "trace/quality.h"
#include "trace/rays/stream.h"
#include "trace/shade/sample.h"

namespace odraz {

// By place in the run: hits of one shape, or of balls of one material.
inline constexpr int kRun = kChunk + 8;
struct Run {
    int count;
    const int32_t *ray; // places in the stream; behind the last one it is repeated
    int shape;          // the first one's
    bool balls;         // of several shapes
    // Where they are (arrive.h)
    float p[3][kRun], n[3][kRun]; // and the unit normal on the ray's side
    float side[kRun];             // +1: the ray comes from outside, -1: from inside
    float error[kRun];            // see errorBound()
    float cosine[kRun], width[kRun], clear[kRun];
    float curve[kRun];     // of a ball: by how much the normal turns within the width
    int32_t id[kRun];      // as Sample::id
    float weight[3][kRun]; // the ray's weight after fog and glass
    // The light that arrives there (light.h)
    float diffuse[3][kRun], highlight[3][kRun];
    int32_t states[kRun]; // as Sample::lights
};

// What a run is shaded for.
struct Context {
    const Scene &scene;
    const Quality &quality;
    Samples samples;
    int bounces; // so far, of the rays that are being shaded
};

} // namespace odraz
