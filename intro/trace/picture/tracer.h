// Traces a picture tile by tile, on all workers.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "trace/picture/frame.h"
#include "trace/quality.h"
#include "trace/rays/view.h"

namespace odraz {

struct TileScratch;

// What tracing needs in addition to the scene: scratch for every worker, allocated once.
struct Tracer {
    TileScratch *scratch[kMaxWorkers];
    int workers;
};

extern const size_t kTileScratchBytes; // arena bytes for each worker
// Returns false if the arena is full, or if there are more workers than kMaxWorkers.
bool makeTracer(Tracer &tracer, Arena &arena, int workers);

// Traces the whole frame. The picture does not depend on the number of workers.
void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame);

// The number of samples that the last frame took.
int64_t tracedSamples(const Tracer &tracer);

} // namespace odraz
