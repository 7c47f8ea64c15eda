// Adaptive anti-aliasing: squares of 8 pixels that share corners, split where their corners differ.
//
// After the intro thesis: every corner is traced once; a square splits when its corners differ in (a) the
// object hit, (b) the state of any light there, (c) what secondary rays hit, level by level, (d) the
// intensities. What need not split is filled by bilinear interpolation. Beyond it: only light is
// interpolated, the diffuse colour is taken at every pixel; a square that a small shape may touch splits
// whether a corner met the shape or not; and a one-pixel square whose corners still differ in colour is
// super-sampled, 2x2 and then 4x4.
#pragma once

#include "base/arena.h"
#include "trace/frame.h"
#include "trace/whitted.h"

namespace odraz {

inline constexpr int kTile = 64;

struct TileScratch;

inline constexpr int kMaxWorkers = 64;

// What tracing needs beyond the scene: scratch for every worker, taken once.
struct Tracer {
    TileScratch *scratch[kMaxWorkers];
    int workers;
};

extern const size_t kTileScratchBytes; // for each worker
bool makeTracer(Tracer &tracer, Arena &arena, int workers);

// Traces the whole frame. The picture does not depend on the number of workers.
void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame);

// Samples that the last frame took.
int64_t tracedSamples(const Tracer &tracer);

} // namespace odraz
