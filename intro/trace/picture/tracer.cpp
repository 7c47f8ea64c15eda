#include "trace/picture/tracer.h"

#include "trace/picture/adaptive.h"

namespace odraz {

namespace {

// Finds what the tile's primary rays may meet; a pixel around it keeps roundings out.
void aimTile(Tile &t) {
    float x0 = (float)t.x0 - 1, y0 = (float)t.y0 - 1, x1 = (float)(t.x0 + kTile + 1),
          y1 = (float)(t.y0 + kTile + 1);
    const View &v = t.view;
    gather(t.scene,
           beamThrough(v.eye,
                       {v.direction(x0, y0), v.direction(x1, y0), v.direction(x1, y1), v.direction(x0, y1)}),
           t.s.among);
}

// The same number of samples in every pixel.
void traceGrid(Tile &t) {
    TileScratch &s = t.s;
    int side = t.quality.grid, perPixel = side * side, batch = kChunk / perPixel;
    for (uint32_t i = 0; i < kChunk; ++i) s.index[i] = i;
    for (int first = 0; first < t.width * t.height; first += batch) {
        int pixels = min(batch, t.width * t.height - first), count = 0;
        for (int p = first; p < first + pixels; ++p)
            for (int k = 0; k < perPixel; ++k) {
                s.x[count] = (float)(t.x0 + p % t.width) + ((float)(k % side) + 0.5f) / (float)side;
                s.y[count++] = (float)(t.y0 + p / t.width) + ((float)(k / side) + 0.5f) / (float)side;
            }
        traceSamples(t.scene, t.view, t.quality, s.trace, s.among, 1 / (float)side, count, s.x, s.y, s.index,
                     s.samples);
        s.sampleCount += count;
        for (int p = 0, i = 0; p < pixels; ++p) {
            __m128 sum = _mm_setzero_ps();
            for (int k = 0; k < perPixel; ++k) sum += radianceOf(s.samples[i++]);
            int px = t.x0 + (first + p) % t.width, py = t.y0 + (first + p) / t.width;
            for (int k = 0; k < 3; ++k) t.frame.plane[k][py * t.frame.stride + px] = sum[k] / (float)perPixel;
        }
    }
}

} // namespace

const size_t kTileScratchBytes = sizeof(TileScratch) + 64;

bool makeTracer(Tracer &tracer, Arena &arena, int workers) {
    if (workers > kMaxWorkers) return false;
    tracer.workers = workers;
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i] = arena.take<TileScratch>(1);
    return !arena.full;
}

void traceFrame(Tracer &tracer, Workers &workers, const Scene &scene, const View &view,
                const Quality &quality, Frame &frame) {
    for (int i = 0; i < tracer.workers; ++i) tracer.scratch[i]->sampleCount = 0;
    int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
    parallelFor(workers, across * down, [&](int piece, int worker) {
        int x = piece % across * kTile, y = piece / across * kTile;
        Tile tile = {
            *tracer.scratch[worker],     scene, view, quality, frame, x, y, min(kTile, frame.width - x),
            min(kTile, frame.height - y)};
        aimTile(tile);
        if (quality.grid > 0)
            traceGrid(tile);
        else
            traceAdaptive(tile);
    });
}

int64_t tracedSamples(const Tracer &tracer) {
    int64_t samples = 0;
    for (int i = 0; i < tracer.workers; ++i) samples += tracer.scratch[i]->sampleCount;
    return samples;
}

} // namespace odraz
