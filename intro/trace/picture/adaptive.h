// Adaptive anti-aliasing: one quadtree of squares that share corners, from 8 pixels down to a quarter.
//
// After the intro thesis: every corner is traced once; a square splits when its corners differ in (a) the
// object hit, (b) the state of any light there, (c) what secondary rays hit, level by level, and the cell of
// a texture there, (d) the intensities. What need not split is filled by bilinear interpolation. Beyond it:
// only light is interpolated, the diffuse colour is taken at every pixel; a square splits too where a shape
// may show in it that shows at no corner, and where a neighbour's corner on its side tells of something new;
// below a pixel the difference of colours alone decides.
#pragma once

#include "base/arena.h"
#include "trace/picture/frame.h"
#include "trace/shade/whitted.h"

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
